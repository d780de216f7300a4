#include "geometry/files/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>

#include "geometry/files/parse_error.h"

namespace xnewell {

namespace {

std::mutex inputsLock;  // a thread may read
std::set<std::string> inputPlaces;

}  // namespace

InputFile openInput(const std::string& file) {
  const auto failErrno = [&] {
    if (errno == ENOMEM) throw std::bad_alloc{};
    throw std::system_error{errno, std::generic_category(), file};
  };
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) failErrno();
  InputFile input{::fdopen(descriptor, "rb")};
  if (!input) {
    ::close(descriptor);
    failErrno();
  }
  struct ::stat status {};
  if (::fstat(descriptor, &status) != 0) failErrno();
  if (S_ISDIR(status.st_mode)) throw std::system_error{EISDIR, std::generic_category(), file};
  if (!S_ISREG(status.st_mode)) throw ParseError{file, 0, "not a regular file"};
  rememberInput(file);
  return input;
}

void rememberInput(const std::string& file) try {
  std::string place = placeOf(file);
  const std::scoped_lock lock{inputsLock};
  inputPlaces.insert(std::move(place));
} catch (const std::system_error&) {  // links in a circle lead to no file
}

bool isThere(const std::filesystem::path& file) {
  std::error_code none;
  return std::filesystem::exists(file, none);
}

std::set<std::string> inputs() {
  const std::scoped_lock lock{inputsLock};
  return inputPlaces;
}

bool isInput(const std::string& file) {
  const std::string place = placeOf(file);
  const std::scoped_lock lock{inputsLock};
  return inputPlaces.contains(place) || std::ranges::any_of(inputPlaces, [&](const std::string& input) {
           std::error_code none;  // true only for two names of one file that exists
           return std::filesystem::equivalent(input, file, none);
         });
}

std::string endOfLinks(const std::string& file) {
  constexpr int kMostLinks = 40;  // as in Linux
  std::filesystem::path end = file;
  std::error_code none;  // what is wrong with the name shows when the file is opened
  for (int k = 0; std::filesystem::is_symlink(end, none); ++k) {
    if (k == kMostLinks) throw std::system_error{ELOOP, std::generic_category(), file};
    end = end.parent_path() / std::filesystem::read_symlink(end, none);
  }
  return end;
}

std::string placeOf(const std::string& file) {
  std::error_code none;
  const std::string end = endOfLinks(file);
  const std::filesystem::path place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(end, none), none);
  return none ? end : place.string();
}

}  // namespace xnewell
