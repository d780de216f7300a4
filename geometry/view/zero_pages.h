#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace xnewell {

/// Memory that is 0. A page of it costs nothing until something is written there.
template <class T>
struct ZeroPages {
  using value_type = T;
  ZeroPages() = default;
  template <class U>
  explicit(false) ZeroPages(const ZeroPages<U>&) {}
  [[nodiscard]] T* allocate(std::size_t count) {
    if (void* const memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
    throw std::bad_alloc{};
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  void construct(T*) const {}  // an element that is given no value stays 0
  bool operator==(const ZeroPages&) const = default;
};

/// A vector of a trivial type. The elements that its first resize() adds are 0.
template <class T>
using SparseVector = std::vector<T, ZeroPages<T>>;

}  // namespace xnewell
