#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace xnewell {

/// A painting order that somebody hands in, back to front: a JSON object a line, {"face": 17} or
/// {"face": 17, "piece": [[x, y], ...]}. Faces have their numbers in the scene, from 0, as `trace` and the
/// face image (minus 1) have them. A piece is a convex or concave polygon of places on the screen, in pixels.
struct PaintStep {
  int face = 0;
  std::vector<glm::dvec2> piece = {};  ///< empty for the whole face
  int line = 0;                        ///< of the file, from 1
};

/// Empty lines count for nothing. @throws std::system_error; ParseError for what is no such line, for a face
/// that the scene of `faces` faces does not have, and for a file of more than 64 MB
[[nodiscard]] std::vector<PaintStep> readPaintSteps(const std::string& file, int faces);

/// The same as a file has it.
[[nodiscard]] std::string paintStepsText(std::span<const PaintStep> steps);

}  // namespace xnewell
