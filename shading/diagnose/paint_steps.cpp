#include "shading/diagnose/paint_steps.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/files/text_file.h"
#include "shading/scene/json_text.h"

namespace xnewell {

namespace {

using Json = Node::Json;

constexpr std::size_t kMostBytes = 64 << 20;
constexpr std::size_t kMostCorners = 1000;
constexpr double kFarthestPlace = 1e6;  ///< pixels

glm::dvec2 placeOf(const Json& corner) {
  if (!corner.is_array() || corner.size() != 2 || !corner[0].is_number() || !corner[1].is_number())
    throw std::runtime_error{"a corner of a piece is [x, y], in pixels"};
  const glm::dvec2 place{corner[0].get<double>(), corner[1].get<double>()};
  if (!(std::abs(place.x) <= kFarthestPlace && std::abs(place.y) <= kFarthestPlace))
    throw std::runtime_error{"a corner of a piece is more than a million pixels away"};
  return place;
}

}  // namespace

glm::ivec2 pictureSizeOf(const Node::Json& size) {
  const auto isSide = [](const Json& side) {
    return side.is_number_integer() && side >= kLeastOrderSize && side <= kMostOrderSize;
  };
  if (!size.is_array() || size.size() != 2 || !isSide(size[0]) || !isSide(size[1]))
    throw std::runtime_error{"the size is {\"size\": [width, height]}, each from " +
                             std::to_string(kLeastOrderSize) + " to " + std::to_string(kMostOrderSize) +
                             " pixels"};
  return {size[0].get<int>(), size[1].get<int>()};
}

std::vector<glm::dvec2> outlineOf(const Node::Json& piece, std::string_view key) {
  if (!piece.is_array() || piece.size() < 3 || piece.size() > kMostCorners)
    throw std::runtime_error{'"' + std::string{key} + "\" is a list of 3 to 1000 corners [x, y]"};
  std::vector<glm::dvec2> outline;
  for (const auto& corner : piece) outline.push_back(placeOf(corner));
  return outline;
}

namespace {

PaintStep stepOf(const Json& json, int faces) {
  if (json.contains("size")) throw std::runtime_error{"the size stands once, before all faces"};
  const auto face = json.find("face");
  if (face == json.end() || !face->is_number_integer())
    throw std::runtime_error{"\"face\" is the number of a face, from 0"};
  PaintStep step;
  const auto number = face->get<std::int64_t>();
  if (number < 0 || number >= faces)
    throw std::runtime_error{"the scene has no face " + std::to_string(number) + ": its faces are 0 to " +
                             std::to_string(faces - 1)};
  step.face = static_cast<int>(number);
  for (const auto& [key, value] : json.items())
    if (key != "face" && key != "piece") throw std::runtime_error{"unknown key " + inQuotes(key)};
  const auto piece = json.find("piece");
  if (piece != json.end()) step.piece = outlineOf(*piece, "piece");
  return step;
}

}  // namespace

PaintOrder readPaintOrder(const std::string& file, int faces) {
  PaintOrder order;
  forEachJsonLine(readTextFile(file, kMostBytes), file, "{\"face\": 17}", [&](const Json& json, int line) {
    if (json.contains("size") && order.steps.empty() && !order.size) {
      order.size = pictureSizeOf(json.size() == 1 ? json["size"] : json);
    } else {
      order.steps.push_back(stepOf(json, faces));
      order.steps.back().line = line;
    }
  });
  if (order.steps.empty()) throw ParseError{file, 0, "no line paints a face"};
  return order;
}

std::string paintOrderText(std::span<const PaintStep> steps, std::optional<glm::ivec2> size) {
  std::string text;
  if (size) text += Json{{"size", {size->x, size->y}}}.dump() + '\n';
  for (const PaintStep& step : steps) {
    Json line{{"face", step.face}};
    for (const glm::dvec2& corner : step.piece) line["piece"].push_back({corner.x, corner.y});
    text += line.dump() + '\n';
  }
  return text;
}

}  // namespace xnewell
