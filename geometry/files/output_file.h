#pragma once

#include <span>
#include <string>
#include <string_view>

namespace xnewell {

/// Writes a whole file: afterwards it is complete, or as it was before (absent, if it was absent).
/// The bytes go to a temporary file in the same folder, which takes the name when it is complete; a
/// symbolic link stays, and the file it leads to is replaced. Where that makes no sense (/dev/stdout,
/// /dev/fd/N, /dev/null, a pipe) they go straight in.
/// @throws std::system_error `FILE: No space left on device`
void writeFile(const std::string& file, std::string_view bytes);

/// Several whole files, all or none: each takes its name only when all are complete. What goes straight in
/// goes first. An interrupt (SIGINT, SIGTERM, SIGHUP, SIGQUIT) meanwhile waits, so that it leaves no
/// temporary file; one that is needed to end the wait for a pipe does not.
/// @throws std::system_error as writeFile()
struct OutputFile {
  std::string name;
  std::string_view bytes;
};
void writeFiles(std::span<const OutputFile> files);

}  // namespace xnewell
