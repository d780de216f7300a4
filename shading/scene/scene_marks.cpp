#include "shading/scene/scene_marks.h"

#include <algorithm>
#include <utility>

#include "geometry/exact/scale.h"
#include "shading/color/font.h"

namespace xnewell {

namespace {

glm::dvec3 colorOf(const Node& node) {
  return node.has("color") ? node.at("color").color() : glm::dvec3{0.0};
}

double sizeOf(const Node& node, std::string_view key, double usual) {
  if (!node.has(key)) return usual;
  const double size = node.at(key).numberAbove(0);
  if (size > 1000) node.at(key).fail("at most 1000 pixels are allowed");
  return size;
}

}  // namespace

SceneMarks readMarks(const Node& root, int exponent) {
  SceneMarks marks;
  for (int i = 0; root.has("lines") && i < root.at("lines").size(); ++i) {
    const Node node = root.at("lines").item(i);
    node.expectKeys({"points", "color", "width"});
    SceneLine line;
    for (int k = 0; k < node.at("points").size(); ++k)
      line.points.push_back(scaled(node.at("points").item(k).point(), -exponent));
    if (line.points.size() < 2) node.at("points").fail("a line needs at least 2 points");
    line.color = colorOf(node), line.width = sizeOf(node, "width", line.width);
    marks.lines.push_back(std::move(line));
  }
  for (int i = 0; root.has("labels") && i < root.at("labels").size(); ++i) {
    const Node node = root.at("labels").item(i);
    node.expectKeys({"text", "at", "color", "size"});
    SceneLabel label{node.at("text").text(), scaled(node.at("at").point(), -exponent), colorOf(node), 12};
    const std::u32string codes = codesOf(label.text);
    if (codes.empty() || std::ranges::count(codes, U'?') != std::ranges::count(label.text, '?'))
      node.at("text").fail("a label needs characters of Latin-1, Greek or mathematics");
    label.size = sizeOf(node, "size", label.size);
    marks.labels.push_back(std::move(label));
  }
  return marks;
}

}  // namespace xnewell
