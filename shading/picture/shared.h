#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace xnewell {

/// Measures the milliseconds since it was created.
class Stopwatch {
 public:
  [[nodiscard]] double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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

/// The result of a stage, with the key that it was made from: all that the result depends on. A key may have
/// the result of another stage as a member (Shared). Copies share the result.
template <class Key, class Value>
class Cached {
 public:
  /// Keeps the result if `key` equals the key that it was made from. Otherwise `make` makes it anew; if that
  /// throws, the old result stays.
  template <class Make>
  void update(Key key, Make&& make) {
    if (key_ == key) return;
    value_ = Value(make());
    key_ = std::move(key);
  }
  /// Forgets the result of a stage that is not required.
  void drop() {
    if (key_) *this = {};
  }

  [[nodiscard]] const Value& operator*() const { return *value_; }
  [[nodiscard]] const Value* operator->() const { return &*value_; }
  [[nodiscard]] const Shared<Value>& shared() const { return value_; }

 private:
  std::optional<Key> key_;
  Shared<Value> value_;
};

}  // namespace xnewell
