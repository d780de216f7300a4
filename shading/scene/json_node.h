#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"

namespace xnewell {

/// A value of a JSON file, with its place in the file, so that every error names the place:
/// `room.json: objects[2].scale: a number above 0 is needed`. Values are checked here, when they are read.
/// The readers throw ParseError if the value has another type or is out of range.
class Node {
 public:
  using Json = nlohmann::ordered_json;

  Node(const Json& value, const std::string& file, std::string path)
      : value_{value}, file_{file}, path_{std::move(path)} {}

  [[noreturn]] void fail(const std::string& what) const;
  /// The place of the value, for errors that are not a ParseError.
  [[nodiscard]] std::string place() const { return path_.empty() ? file_ : file_ + ": " + path_; }

  /// Checks that the value is an object whose keys are all in one of the two lists.
  void expectKeys(std::initializer_list<std::string_view> keys,
                  std::initializer_list<std::string_view> more = {}) const;
  void expectKeys(const std::vector<std::string_view>& keys) const;
  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] Node at(std::string_view key) const;
  /// The keys of an object, in the order of the file.
  [[nodiscard]] std::vector<std::string> keys() const;

  [[nodiscard]] bool isList() const;
  [[nodiscard]] bool isObject() const;
  [[nodiscard]] bool isNumber() const;
  [[nodiscard]] int size() const;
  [[nodiscard]] Node item(int i) const;

  [[nodiscard]] double number() const;
  [[nodiscard]] double numberAbove(double low) const;
  /// A number in [low, high].
  [[nodiscard]] double numberFrom(int low, int high) const;
  [[nodiscard]] int whole(int low, int high) const;
  [[nodiscard]] bool isTrue() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] std::string text() const;
  template <int N>
  [[nodiscard]] glm::vec<N, double> numbers() const {
    if (size() != N) fail("a list of " + std::to_string(N) + " numbers is needed");
    glm::vec<N, double> v;
    for (int k = 0; k < N; ++k) v[k] = item(k).number();
    return v;
  }
  [[nodiscard]] glm::dvec3 point() const { return numbers<3>(); }
  /// A vector that is not 0.
  [[nodiscard]] glm::dvec3 direction() const;
  /// [r, g, b], each in [0, 1].
  [[nodiscard]] glm::dvec3 color() const;
  /// A colour [r, g, b], or one number for a gray.
  [[nodiscard]] glm::dvec3 grayOrColor() const { return isList() ? color() : glm::dvec3{numberFrom(0, 1)}; }
  /// Finds the row of a table of choices that has this name, and returns its id.
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

}  // namespace xnewell
