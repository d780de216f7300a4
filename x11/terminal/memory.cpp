#include "x11/terminal/terminal.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __GLIBC__

namespace xnewell {

void keepFreedMemory() {
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that glibc allows
  ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

}  // namespace xnewell

#ifndef __SANITIZE_ADDRESS__
namespace {

/// Asks for huge pages in the pages that lie wholly in a block. It changes nothing if the system has none.
void askForHugePages(void* block, std::size_t size) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto start = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t first = (start + page - 1) / page * page, end = (start + size) / page * page;
  ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace

/// That of the C++ library, which frees with free(), with huge pages for blocks that can hold one.
void* operator new(std::size_t size) {
  constexpr std::size_t kLarge = 4 << 20;
  for (;;) {
    if (void* const block = std::malloc(size > 0 ? size : 1)) {
      if (size >= kLarge) askForHugePages(block, size);
      return block;
    }
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc{};
    handler();
  }
}
#endif

#else

void xnewell::keepFreedMemory() {}

#endif
