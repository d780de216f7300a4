#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/number.h"
#include "shading/scene/json_node.h"

namespace xnewell {

/// A file's text as JSON, in which no object has a key twice.
class JsonText {
 public:
  /// @throws ParseError with the line where it is no JSON
  JsonText(std::string_view text, std::string name);
  ~JsonText();
  JsonText(const JsonText&) = delete;
  JsonText& operator=(const JsonText&) = delete;

  /// The whole of it; for as long as this lives.
  [[nodiscard]] Node root() const;

 private:
  std::string name_;
  std::unique_ptr<const Node::Json> value_;
};

/// How the numbers below each key "polygons" of a text are rounded, in the file's order: JSON's values no
/// longer tell with how many decimals they were written.
[[nodiscard]] std::vector<RoundingOfNumbers> roundingOfPolygons(std::string_view text);

}  // namespace xnewell
