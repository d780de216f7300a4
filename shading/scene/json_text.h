#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/number.h"
#include "shading/scene/json_node.h"

namespace xnewell {

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
