#include "x11/terminal/check_writable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace xnewell {

void checkWritable(const std::string& file) {
  const auto check = [&](const std::string& path, int access) {
    if (::faccessat(AT_FDCWD, path.c_str(), access, AT_EACCESS) != 0)
      throw std::system_error{errno, std::generic_category(), file};
  };
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (std::filesystem::is_directory(status)) throw std::system_error{EISDIR, std::generic_category(), file};
  const bool exists = std::filesystem::exists(status);
  if (exists) check(file, W_OK);
  if (exists && !std::filesystem::is_regular_file(status)) return;
  // writeFile() makes a new file in the folder.
  const std::filesystem::path folder = std::filesystem::weakly_canonical(file, none).parent_path();
  check((folder.empty() ? "." : folder / ".").string(), W_OK | X_OK);
}

}  // namespace xnewell
