#pragma once

#include <memory>
#include <utility>

namespace xnewell {

/// An immutable value. All copies share it, so a copy costs a pointer, however large the value is.
template <class T>
class Shared {
 public:
  Shared() : Shared{T{}} {}
  Shared(T value) : value_{std::make_shared<const T>(std::move(value))} {}

  [[nodiscard]] const T& operator*() const { return *value_; }
  [[nodiscard]] const T* operator->() const { return value_.get(); }
  /// True if both are one object, not only equal.
  [[nodiscard]] bool isOneWith(const Shared& other) const { return value_ == other.value_; }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace xnewell
