#include "shading/scene/scene_marks.h"

#include <utility>

#include "geometry/exact/scale.h"

namespace xnewell {

namespace {

/// True if all characters are printable ones of Latin-1: what PDF and EPS show without a font file.
bool isLatin(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto c = static_cast<unsigned char>(text[k]);
    if (c >= 0x20 && c < 0x7F) continue;
    if ((c != 0xC2 && c != 0xC3) || k + 1 == text.size()) return false;
    const auto next = static_cast<unsigned char>(text[++k]);
    if (next < 0x80 || next > 0xBF || (c == 0xC2 && next < 0xA0)) return false;
  }
  return !text.empty();
}

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
    if (!isLatin(label.text)) node.at("text").fail("a label needs printable characters of Latin-1");
    label.size = sizeOf(node, "size", label.size);
    marks.labels.push_back(std::move(label));
  }
  return marks;
}

}  // namespace xnewell
