#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

namespace xnewell {

/// What the program reads. It remembers each file, and never writes one of them (output_file.h).

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using InputFile = std::unique_ptr<std::FILE, CloseFile>;

/// Opens a file to read it. It must be a regular file: nobody may ever write to a pipe, and a device may have
/// no end.
/// @throws std::system_error `FILE: No such file or directory`; ParseError `FILE: not a regular file`
[[nodiscard]] InputFile openInput(const std::string& file);

/// True if there is such a file or folder. A name that the system refuses names none.
[[nodiscard]] bool isThere(const std::filesystem::path& file);

/// Remembers a file that the program is going to read.
void rememberInput(const std::string& file);

/// The places of all remembered files.
[[nodiscard]] std::set<std::string> inputs();

/// True for a remembered file, by any of its names, and for what is at its place now.
[[nodiscard]] bool isInput(const std::string& file);

/// The file at the end of a chain of symbolic links. It need not exist. @throws std::system_error ELOOP
[[nodiscard]] std::string endOfLinks(const std::string& file);

/// The one name of a place for a file: absolute and without links. The file need not exist.
[[nodiscard]] std::string placeOf(const std::string& file);

}  // namespace xnewell
