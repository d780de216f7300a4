#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

// Linked before the C library: allocations fail as $XNEWELL_SCARCE says, for scarce_memory_test.cpp.
// This is `N`, for the N-th alone; `N+`, for the N-th and all that follow; or a file, to which the program
// writes how many it made. They count from 1, those before main() too.
//
// The address sanitizer has its own malloc(). There, only operator new fails.

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
