#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"
#include "shading/scene/json_text.h"

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

/// Is a painting order right? The faces and pieces are painted one over the other, and each sample is
/// compared with the nearest face there. A step that shows where another face is nearer makes a wrong pair
/// with the step that should show. The first wrong pair is that of the earliest step.

/// True if the place lies inside a polygon, by the number of its sides to the right.
[[nodiscard]] bool isInside(const std::vector<glm::dvec2>& polygon, const glm::dvec2& at);
/// The square of the distance to the border of a polygon.
[[nodiscard]] double distanceToBorder(const std::vector<glm::dvec2>& polygon, const glm::dvec2& at);

/// A face whose pieces cover a sample not once, away from the borders of its pieces.
struct BadCover {
  int face = 0, i = 0, j = 0;  ///< a sample
  int times = 0;               ///< how often it is covered there
  int samples = 0;             ///< how many samples are so
};

/// A piece that reaches outside of its face, by more than a pixel.
struct OutsidePiece {
  int step = 0;      ///< index into the steps
  int i = 0, j = 0;  ///< a pixel that it fills
  int samples = 0;   ///< how many are so
};

struct WrongPair {
  int shown = 0, hidden = 0;  ///< steps: what shows, and what should; indices into the steps
  int i = 0, j = 0;           ///< a sample where it shows
  int samples = 0;            ///< how many samples show this pair
  /// The textbook's test that says that `shown` may be painted before `hidden`; no value if none of 3 and 4
  /// does, as 1, 2 and 5 cannot. Overlap where only their common area tells.
  std::optional<Test> told = {};
  bool needsCut = false;  ///< each is in front of the other somewhere, so no order of both is right
  std::vector<int> cycle =
      {};  ///< numbers of faces, each to be painted before the next, which ends where it begins
};

struct OrderReport {
  int steps = 0;
  std::vector<int> missing;   ///< faces that should show somewhere and are not painted
  std::vector<int> unseen;    ///< faces that are not painted, and that nobody would see
  std::vector<int> repeated;  ///< faces that are painted whole more than once, or whole and in pieces
  std::vector<BadCover> covers;
  std::vector<OutsidePiece> outside;
  int wrongSamples = 0, wrongPairs = 0;
  /// Samples that show the other of two faces in one plane: depth does not say which, so both are right.
  int inOnePlane = 0;
  std::optional<WrongPair> first;
  [[nodiscard]] bool isRight() const {
    return missing.empty() && repeated.empty() && covers.empty() && outside.empty() && wrongSamples == 0;
  }
};

/// `picture` has planes (Picture::withPlanes()).
[[nodiscard]] OrderReport judgeOrder(const Picture& picture, std::span<const PaintStep> steps);

/// Says of a pair which test would have told, or that only a cut helps, as judgeOrder() does. Of the pair,
/// the two steps are known; `shown` and `hidden` are their faces, indices into picture.snapped().faces.
void tellPair(const Picture& picture, std::span<const PaintStep> steps, WrongPair& pair, int shown,
              int hidden);

/// A step's face or piece in the world, in the units of the scene's file; nothing if it is not in view.
[[nodiscard]] std::vector<glm::dvec3> stepInWorld(const Picture& picture, const PaintStep& step);

}  // namespace xnewell
