#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>

// Linked before the C library, for written_files_test.cpp. $XNEWELL_HINDER says what happens to
// regular files other than standard streams: `full`, the disk has room for 100 bytes in each; `late`, it says
// only at fsync() that it is full; or the number of a signal, which comes when a file is half written and
// again when it is whole and not yet renamed. With `alone`, the system refuses threads.
//
// Allocations fail as $XNEWELL_SCARCE says. This is `N`, for the N-th alone; `N+`, for the N-th and all that
// follow; or a file, to which the program writes how many it made. They count from 1, those before main()
// too.
//
// The address sanitizer has its own malloc(). There, only operator new fails.

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

namespace {

struct Scarcity {
  long first = 0;  ///< the first that fails; 0 for none
  bool stays = false;
  const char* file = nullptr;

  Scarcity() {
    const char* const said = std::getenv("XNEWELL_SCARCE");
    if (said == nullptr) return;
    char* end = nullptr;
    first = std::strtol(said, &end, 10);
    stays = *end == '+';
    if (end == said) file = said;
  }
};

std::atomic<long> made = 0;

/// True if this allocation fails.
bool fails() {
  static const Scarcity scarcity;
  const long number = ++made;
  const bool fail =
      scarcity.first > 0 && (scarcity.stays ? number >= scarcity.first : number == scarcity.first);
  if (fail) errno = ENOMEM;
  return fail;
}

struct TellHowMany {
  ~TellHowMany() {
    const Scarcity scarcity;
    if (scarcity.file == nullptr) return;
    char text[24];
    const int length = std::snprintf(text, sizeof text, "%ld", made.load());
    const int file = ::open(scarcity.file, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    if (::write(file, text, static_cast<std::size_t>(length)) != length) std::abort();
    ::close(file);
  }
} const tellHowMany;

}  // namespace

#ifndef __SANITIZE_ADDRESS__

extern "C" {

void* __libc_malloc(std::size_t size);                           // NOLINT: names of the C library
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT
void* __libc_realloc(void* old, std::size_t size);               // NOLINT
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT

void* malloc(std::size_t size) noexcept { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) noexcept {
  return fails() ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept { return fails() ? nullptr : __libc_realloc(old, size); }
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  *result = fails() ? nullptr : __libc_memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}
}

#else

void* operator new(std::size_t size) {
  void* const block = fails() ? nullptr : std::malloc(size);
  if (block == nullptr) throw std::bad_alloc{};
  return block;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return fails() ? nullptr : std::malloc(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  void* const block = fails() ? nullptr : std::aligned_alloc(std::size_t(alignment), size);
  if (block == nullptr) throw std::bad_alloc{};
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }

#endif
