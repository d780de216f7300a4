#pragma once

#include <span>
#include <string>
#include <string_view>

namespace xnewell {

/// Writes a whole file. Afterwards the file is complete, or it is as it was before (absent, if it was
/// absent). The bytes go to a temporary file in the same folder, which is renamed when a disk has all of
/// them. It keeps the mode, the owner and the group of the file that it replaces, as far as this user may
/// give them. A symbolic link stays, and the file that it points to is replaced or made. A hard link ends:
/// the file's other names keep the old bytes. If all this makes no sense (/dev/stdout, /dev/fd/N, /dev/null,
/// a pipe), the bytes are written directly.
/// @throws std::system_error `FILE: No space left on device`; std::invalid_argument if the program has read
/// the file
void writeFile(const std::string& file, std::string_view bytes);

/// The same for a file that the program keeps for the user. It may have read what it replaces.
void rewriteFile(const std::string& file, std::string_view bytes);

/// Writes several whole files, all or none: each is renamed only when all are complete. Files that are
/// written directly come first. After that, a signal that would end the program waits until the end, so that
/// no temporary file is left behind. While the program waits for a pipe, an interrupt still ends
/// it.
/// @throws as writeFile() does, and std::invalid_argument if two are one file
struct OutputFile {
  std::string name;
  std::string_view bytes;
};
void writeFiles(std::span<const OutputFile> files);

/// Finds out early whether writeFiles() surely refuses these files, before a command works for a long time.
/// @throws as writeFiles() does
void checkOutputs(std::span<const std::string> files);

/// Makes a folder that does not exist, with those above it. @throws std::system_error
void makeFolder(const std::string& folder);

}  // namespace xnewell
