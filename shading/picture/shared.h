#pragma once

#include <memory>
#include <utility>

namespace xnewell {

/// An immutable value that all copies share. A copy costs one pointer, however large the value is.
template <class T>
class Shared {
 public:
  Shared() : Shared{T{}} {}
  Shared(T value) : value_{std::make_shared<const T>(std::move(value))} {}

  [[nodiscard]] const T& operator*() const { return *value_; }
  [[nodiscard]] const T* operator->() const { return value_.get(); }
  /// True if both are the same object, not merely of equal value.
  bool operator==(const Shared& other) const = default;

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace xnewell
