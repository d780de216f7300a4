#include "shading/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace {

[[noreturn]] void fail(int error, const std::string& file) {
  throw std::system_error{error, std::generic_category(), file};
}

/// 0, or what went wrong. Closes the descriptor in either case.
int writeAndClose(int descriptor, std::string_view bytes) {
  int error = 0;
  while (!error && !bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n >= 0)
      bytes.remove_prefix(n);
    else if (errno != EINTR)
      error = errno;
  }
  // Some file systems tell of a full disk only here.
  if (::close(descriptor) != 0 && !error && errno != EINTR) error = errno;
  return error;
}

/// Where the bytes finally are: the end of a chain of symbolic links.
std::string resolved(const std::string& file) {
  const std::unique_ptr<char, decltype(&std::free)> real{::realpath(file.c_str(), nullptr), &std::free};
  return real ? real.get() : file;
}

/// A new file beside `target`; `name` is set to what it is called.
int openTemporary(const std::string& target, std::string& name) {
  const std::size_t slash = target.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
  for (int attempt = 0;; ++attempt) {
    name = folder + ".xnewell-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

}  // namespace

void writeFile(const std::string& file, std::string_view bytes) {
  // A standard stream may lead to a regular file that somebody else holds open: it must not be replaced.
  const bool stream = file == "/dev/stdout" || file == "/dev/stderr" || file.starts_with("/dev/fd/");
  struct ::stat status {};
  const bool exists = ::stat(file.c_str(), &status) == 0;
  if (stream || (exists && !S_ISREG(status.st_mode))) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor < 0) fail(errno, file);
    if (const int error = writeAndClose(descriptor, bytes)) fail(error, file);
    return;
  }
  if (exists && ::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) != 0) fail(errno, file);

  const std::string target = resolved(file);
  std::string temporary;
  const int descriptor = openTemporary(target, temporary);
  if (descriptor < 0) fail(errno, file);
  int error = writeAndClose(descriptor, bytes);
  if (!error && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error) {
    ::unlink(temporary.c_str());
    fail(error, file);
  }
}
