#include "geometry/files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "geometry/files/input_file.h"

namespace xnewell {

namespace {

[[noreturn]] void fail(int error, const std::string& file) {
  throw std::system_error{error, std::generic_category(), file};
}

/// Writes the bytes and closes the descriptor, even after an error. Returns 0 or the errno of the first
/// error. `toDisk` also waits until a disk has them.
int writeAndClose(int descriptor, std::string_view bytes, bool toDisk = false) {
  int error = 0;
  while (!error && !bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n >= 0)
      bytes.remove_prefix(n);
    else if (errno != EINTR)
      error = errno;
  }
  if (!error && toDisk && ::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) error = errno;
  // Some file systems report a full disk only here.
  if (::close(descriptor) != 0 && !error && errno != EINTR) error = errno;
  return error;
}

/// Gives a new file the owner, the group and the mode of the one that it replaces. What this user may not
/// give is left out; then no other user gets a right that comes with an owner.
void takeAfter(int descriptor, const struct ::stat& old) {
  const bool owned = ::fchown(descriptor, old.st_uid, old.st_gid) == 0;
  const bool grouped = owned || ::fchown(descriptor, ::uid_t(-1), old.st_gid) == 0;
  mode_t mode = old.st_mode & 07777;
  if (!owned) mode &= ~mode_t{S_ISUID};
  if (!grouped) mode &= ~mode_t{S_ISGID | S_IRWXG};
  (void)::fchmod(descriptor, mode);
}

/// Opens a new file of this mode beside `target` and sets `name` to its name.
int openTemporary(const std::string& target, mode_t mode, std::string& name) {
  const std::size_t slash = target.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
  for (int attempt = 0;; ++attempt) {
    name = folder + ".xnewell-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

/// True if the bytes are written directly. A standard stream may lead to a regular file that another process
/// holds open; that file must not be replaced.
bool goesStraightIn(const std::string& file) {
  if (file == "/dev/stdout" || file == "/dev/stderr" || file.starts_with("/dev/fd/")) return true;
  struct ::stat status {};
  return ::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

void writeStraight(const std::string& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (descriptor < 0) fail(errno, file);
  if (const int error = writeAndClose(descriptor, bytes)) fail(error, file);
}

/// A complete file under a temporary name. It is renamed by takeName(), or removed.
class Replacement {
 public:
  Replacement(std::string file, std::string_view bytes) : file_{std::move(file)}, target_{endOfLinks(file_)} {
    if (::access(file_.c_str(), F_OK) == 0 && ::faccessat(AT_FDCWD, file_.c_str(), W_OK, AT_EACCESS) != 0)
      fail(errno, file_);
    struct ::stat old {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    // Nobody else may open the new file before it has the mode of the old one.
    const int descriptor = openTemporary(target_, replaces ? 0600 : 0666, temporary_);
    if (descriptor < 0) fail(errno, file_);
    if (replaces) takeAfter(descriptor, old);
    if (const int error = writeAndClose(descriptor, bytes, true)) {
      ::unlink(temporary_.c_str());
      fail(error, file_);
    }
  }
  Replacement(Replacement&& o) noexcept
      : file_{std::move(o.file_)},
        target_{std::move(o.target_)},
        temporary_{std::exchange(o.temporary_, std::string{})} {}
  ~Replacement() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  void takeName() {
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno, file_);
    temporary_.clear();
  }

 private:
  std::string file_, target_, temporary_;
};

/// The signals that would end the program, and whether each came in a section.
constexpr std::array kEnding{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU};
std::array<std::atomic<bool>, kEnding.size()> came;
static_assert(std::atomic<bool>::is_always_lock_free);

/// Lets signals that would end the program wait until the end of the object's lifetime, whichever thread they
/// come to.
class Uninterrupted {
 public:
  Uninterrupted() {
    struct ::sigaction wait {};
    wait.sa_handler = [](int signal) {
      came[std::find(kEnding.begin(), kEnding.end(), signal) - kEnding.begin()] = true;
    };
    wait.sa_flags = SA_RESTART;
    for (std::size_t k = 0; k < kEnding.size(); ++k) ::sigaction(kEnding[k], &wait, &before_[k]);
  }
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
  ~Uninterrupted() {
    for (std::size_t k = 0; k < kEnding.size(); ++k) ::sigaction(kEnding[k], &before_[k], nullptr);
    for (std::size_t k = 0; k < kEnding.size(); ++k)
      if (came[k].exchange(false)) ::raise(kEnding[k]);
  }

 private:
  inline static std::mutex one;  ///< another section would take our handler for the one before
  const std::scoped_lock<std::mutex> alone_{one};
  std::array<struct ::sigaction, kEnding.size()> before_{};
};

/// Refuses to write what was read, and two files at one place.
void refuseLoss(std::span<const std::string> files) {
  std::set<std::string> places;
  for (const std::string& file : files) {
    if (isInput(file))
      throw std::invalid_argument{file + ": it was read, so it would be lost: name another file"};
    if (!goesStraightIn(file) && !places.insert(placeOf(file)).second)
      throw std::invalid_argument{file + ": two outputs would be this one file"};
  }
}

/// Refuses a file that surely cannot be written.
void refuseUnwritable(const std::string& file) {
  const auto check = [&](const std::string& path, int access) {
    if (::faccessat(AT_FDCWD, path.c_str(), access, AT_EACCESS) != 0) fail(errno, file);
  };
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (std::filesystem::is_directory(status)) fail(EISDIR, file);
  const bool exists = std::filesystem::exists(status);
  if (exists) check(file, W_OK);
  // A new file is made in the folder.
  if (!goesStraightIn(file))
    check((std::filesystem::path{placeOf(file)}.parent_path() / ".").string(), W_OK | X_OK);
}

/// Writes what nothing speaks against.
void write(std::span<const OutputFile> files) {
  std::vector<const OutputFile*> whole;
  for (const OutputFile& file : files) {
    if (goesStraightIn(file.name))
      writeStraight(file.name, file.bytes);
    else
      whole.push_back(&file);
  }
  const Uninterrupted section;
  std::vector<Replacement> replacements;
  replacements.reserve(whole.size());
  for (const OutputFile* file : whole) replacements.emplace_back(file->name, file->bytes);
  for (Replacement& replacement : replacements) replacement.takeName();
}

}  // namespace

void writeFiles(std::span<const OutputFile> files) {
  std::vector<std::string> names;
  for (const OutputFile& file : files) names.push_back(file.name);
  refuseLoss(names);
  write(files);
}

void writeFile(const std::string& file, std::string_view bytes) {
  writeFiles(std::array{OutputFile{file, bytes}});
}

void rewriteFile(const std::string& file, std::string_view bytes) {
  write(std::array{OutputFile{file, bytes}});
}

void checkOutputs(std::span<const std::string> files) {
  refuseLoss(files);
  for (const std::string& file : files) refuseUnwritable(file);
}

void makeFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::system_error{error, folder};
}

}  // namespace xnewell
