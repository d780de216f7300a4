#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/scene/json_node.h"

namespace xnewell {

/// A painting order that somebody hands in, back to front: a JSON object a line, {"face": 17} or
/// {"face": 17, "piece": [[x, y], ...]}. Faces have their numbers in the scene, from 0, as `trace` and the
/// face image (minus 1) have them. A piece is a convex or concave polygon of places on the screen, in pixels.
/// The first line may say of which picture: {"size": [800, 600]}.
struct PaintStep {
  int face = 0;
  std::vector<glm::dvec2> piece = {};  ///< empty for the whole face
  int line = 0;                        ///< of the file, from 1
  std::string name = {};               ///< what sentences call it; "" for `face 17`. No file has it
};

struct PaintOrder {
  std::vector<PaintStep> steps;
  std::optional<glm::ivec2> size;  ///< of the picture, in pixels; none if the file does not say it
};
/// What a size may be. A picture of a few pixels would show no mistake.
inline constexpr int kLeastOrderSize = 64, kMostOrderSize = 4096;

/// Both throw std::runtime_error for what is none: the size of a picture; the corners of a piece, at the key.
[[nodiscard]] glm::ivec2 pictureSizeOf(const Node::Json& size);
[[nodiscard]] std::vector<glm::dvec2> outlineOf(const Node::Json& piece, std::string_view key);

/// Empty lines count for nothing. @throws std::system_error; ParseError for what is no such line, for a face
/// that the scene of `faces` faces does not have, and for a file of more than 64 MB
[[nodiscard]] PaintOrder readPaintOrder(const std::string& file, int faces);

/// The same as a file has it. The n-th step is its line n + 1 if there is a size.
[[nodiscard]] std::string paintOrderText(std::span<const PaintStep> steps, std::optional<glm::ivec2> size);

}  // namespace xnewell
