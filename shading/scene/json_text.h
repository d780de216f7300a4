#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <memory>
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

/// All JSON that the program reads is parsed here.

/// The text is not JSON.
struct NotJson : ParseError {
  using ParseError::ParseError;
};

/// Parses a text that begins on this line of the file. @throws NotJson with the line; ParseError if a number
/// is too large, if an object has a key twice, or if lists and objects are nested too deeply
[[nodiscard]] Node::Json parsedJson(std::string_view text, const std::string& file, int line = 1);

/// Calls use(json, line) for the object on each line of a text. Empty lines count for nothing. The error says
/// what such an object is by the `example`. @throws ParseError with the line, also for a std::runtime_error
/// of `use`
void forEachJsonLine(std::string_view text, const std::string& file, std::string_view example,
                     const std::function<void(const Node::Json&, int line)>& use);

/// A file's text as JSON.
class JsonText {
 public:
  /// @throws as parsedJson()
  JsonText(std::string_view text, std::string name);
  /// Reads only these keys of the top-level object, and stops as soon as it has them all. They hold texts or
  /// numbers.
  JsonText(std::string_view text, std::string name, std::initializer_list<std::string_view> keys);
  ~JsonText();
  JsonText(const JsonText&) = delete;
  JsonText& operator=(const JsonText&) = delete;

  /// The top-level value. It is valid as long as this object lives.
  [[nodiscard]] Node root() const;

 private:
  std::string name_;
  std::unique_ptr<const Node::Json> value_;
};

/// How the numbers below each key "polygons" of a text are rounded, in the order of the file. JSON values no
/// longer tell how many decimals they were written with. The text is one that was parsed.
[[nodiscard]] std::vector<RoundingOfNumbers> roundingOfPolygons(std::string_view text);

}  // namespace xnewell
