#include <dlfcn.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <thread>

// Linked before the C library, for the tests of files that are written. $XNEWELL_HINDER says what happens to
// regular files other than standard streams: `full`, the disk has room for 100 bytes in each; `late`, it says
// only at fsync() that it is full; or the number of a signal, which comes when a file is half written and
// again when it is whole and not yet renamed. With `alone`, the system refuses threads.

namespace {

constexpr std::size_t kRoom = 100;  // bytes

bool isFile(int descriptor) {
  struct ::stat status {};
  return descriptor > STDERR_FILENO && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

const char* hindrance() {
  const char* const said = std::getenv("XNEWELL_HINDER");
  return said == nullptr ? "" : said;
}

/// Sends the signal that the environment names, if any.
void interrupt() {
  if (const int signal = std::atoi(hindrance())) ::kill(::getpid(), signal);
}

/// A thread that takes signals, like one that measures.
[[gnu::constructor]] void begin() {
  if (*hindrance() != '\0' && *hindrance() != 'a')
    std::thread{[] {
      for (;;) ::pause();
    }}.detach();
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*work)(void*), void* of) {
  if (*hindrance() == 'a') return EAGAIN;
  static auto* const real = reinterpret_cast<decltype(&pthread_create)>(::dlsym(RTLD_NEXT, "pthread_create"));
  return real(thread, how, work, of);
}

extern "C" ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  const auto put = [&](std::size_t n) -> ssize_t { return ::syscall(SYS_write, descriptor, bytes, n); };
  if (*hindrance() == '\0' || !isFile(descriptor)) return put(size);
  if (*hindrance() == 'f') {
    if (::lseek(descriptor, 0, SEEK_CUR) < static_cast<off_t>(kRoom)) return put(size < kRoom ? size : kRoom);
    errno = ENOSPC;
    return -1;
  }
  if (size < 2 || ::lseek(descriptor, 0, SEEK_CUR) > 0) return put(size);
  const ssize_t half = put(size / 2);
  interrupt();
  return half;
}

extern "C" int fsync(int descriptor) {
  interrupt();
  if (*hindrance() != 'l') return static_cast<int>(::syscall(SYS_fsync, descriptor));
  errno = ENOSPC;
  return -1;
}
