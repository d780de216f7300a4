#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/parse_error.h"
#include "geometry/text_file.h"

/// A value of a JSON file and where it stands, so that every complaint names the place:
/// `room.json: objects[2].scale: a number above 0 is needed`. What is read is checked here, once.
class Node {
 public:
  using Json = nlohmann::ordered_json;

  Node(const Json& value, const std::string& file, std::string path)
      : value_{value}, file_{file}, path_{std::move(path)} {}

  [[noreturn]] void fail(const std::string& what) const {
    throw ParseError{file_, 0, path_.empty() ? what : path_ + ": " + what};
  }
  /// Where it stands, for complaints that are no ParseError.
  [[nodiscard]] std::string place() const { return path_.empty() ? file_ : file_ + ": " + path_; }

  /// An object with no key but these, of one list and another.
  void expectKeys(std::initializer_list<std::string_view> keys,
                  std::initializer_list<std::string_view> more = {}) const {
    if (!value_.is_object()) fail("an object { } is needed");
    for (const auto& [key, unused] : value_.items())
      if (std::ranges::find(keys, key) == keys.end() && std::ranges::find(more, key) == more.end()) {
        std::string all;
        for (const auto& list : {keys, more})
          for (const std::string_view k : list) all += (all.empty() ? "" : ", ") + std::string{k};
        fail("unknown key " + inQuotes(key) + "; there are " + all);
      }
  }
  [[nodiscard]] bool has(std::string_view key) const { return value_.is_object() && value_.contains(key); }
  [[nodiscard]] Node at(std::string_view key) const {
    return {value_.at(key), file_, path_.empty() ? std::string{key} : path_ + "." + std::string{key}};
  }
  /// The keys of an object, in the file's order.
  [[nodiscard]] std::vector<std::string> keys() const {
    if (!value_.is_object()) fail("an object { } is needed");
    std::vector<std::string> all;
    for (const auto& [key, unused] : value_.items()) all.push_back(key);
    return all;
  }

  [[nodiscard]] bool isList() const { return value_.is_array(); }
  [[nodiscard]] bool isObject() const { return value_.is_object(); }
  [[nodiscard]] int size() const {
    if (!value_.is_array()) fail("a list [ ] is needed");
    return static_cast<int>(value_.size());
  }
  [[nodiscard]] Node item(int i) const {
    return {value_[static_cast<std::size_t>(i)], file_, path_ + "[" + std::to_string(i) + "]"};
  }

  [[nodiscard]] double number() const {
    if (!value_.is_number()) fail("a number is needed");
    const double v = value_.get<double>();
    if (!std::isfinite(v)) fail("the number is too large");
    return v;
  }
  [[nodiscard]] double numberAbove(double low) const {
    const double v = number();
    if (!(v > low)) fail("a number above " + std::to_string(static_cast<int>(low)) + " is needed");
    return v;
  }
  /// In [low, high], both whole.
  [[nodiscard]] double numberFrom(int low, int high) const {
    const double v = number();
    if (v < low || v > high)
      fail("a number from " + std::to_string(low) + " to " + std::to_string(high) + " is needed");
    return v;
  }
  [[nodiscard]] int whole(int low, int high) const {
    if (!value_.is_number_integer() || value_.get<std::int64_t>() < low || value_.get<std::int64_t>() > high)
      fail("a whole number from " + std::to_string(low) + " to " + std::to_string(high) + " is needed");
    return value_.get<int>();
  }
  [[nodiscard]] bool truth() const {
    if (!value_.is_boolean()) fail("true or false is needed");
    return value_.get<bool>();
  }
  [[nodiscard]] std::string text() const {
    if (!value_.is_string()) fail("a string is needed");
    return value_.get<std::string>();
  }
  template <int N>
  [[nodiscard]] glm::vec<N, double> numbers() const {
    if (size() != N) fail("a list of " + std::to_string(N) + " numbers is needed");
    glm::vec<N, double> v;
    for (int k = 0; k < N; ++k) v[k] = item(k).number();
    return v;
  }
  [[nodiscard]] glm::dvec3 point() const { return numbers<3>(); }
  /// A point that is not 0.
  [[nodiscard]] glm::dvec3 direction() const {
    const glm::dvec3 v = point();
    if (v == glm::dvec3{0.0}) fail("0, 0, 0 is no direction");
    return v;
  }
  /// r, g, b, each in [0, 1].
  [[nodiscard]] glm::dvec3 color() const {
    const glm::dvec3 c = point();
    if (std::min({c.r, c.g, c.b}) < 0.0 || std::max({c.r, c.g, c.b}) > 1.0)
      fail("r, g, b from 0 to 1 are needed");
    return c;
  }
  /// A colour, or one number for a gray.
  [[nodiscard]] glm::dvec3 grayOrColor() const { return isList() ? color() : glm::dvec3{numberFrom(0, 1)}; }
  /// One row of a table of choices, by its name.
  template <class Rows>
  [[nodiscard]] auto choice(const Rows& rows) const {
    const std::string name = text();
    std::string all;
    for (const auto& row : rows) {
      if (row.name == name) return row.id;
      all += (all.empty() ? "" : ", ") + std::string{row.name};
    }
    fail(inQuotes(name) + " is not one of " + all);
  }

 private:
  const Json& value_;
  const std::string& file_;
  std::string path_;
};
