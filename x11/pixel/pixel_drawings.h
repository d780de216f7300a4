#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "shading/explain/explain.h"
#include "x11/drawing/painter.h"

namespace xnewell {

struct PixelStory;

/// The drawings of view 8: the pixels around, the terms, the vectors of the equation on a ball, and the map
/// of an environment.

inline constexpr int kAround = 7;  ///< pixels on each side in the neighbourhood

/// The pixels around, each as a square, and the outline of a polygon where it is inside. `face` is an index
/// into snapped().faces; -1 for none.
void drawNeighbourhood(Pen& pen, const Rect& area, const PixelStory& story, int face);

/// How the ball of the vectors is turned: degrees around N, and down towards the viewer.
struct BallTurn {
  double around = 0, down = 20;
  bool operator==(const BallTurn&) const = default;
};

/// From the world to the ball's axes: right, up, towards the viewer. At around = 0 and down = 0, N is up, and
/// L and R are in the plane of the paper, so that N, L, V and R stand apart.
[[nodiscard]] glm::dmat3 ballFromWorld(const ExplainedEquation& at, const BallTurn& turn);

/// A ball of the pixel's material in the light of an equation, with V everywhere that of the pixel. On the
/// place that has the pixel's N stand N, the L and R of the first light, and V, as arrows of one length.
/// Where the cells hold single colours, the ball has only an outline.
void drawBall(Pen& pen, const Rect& area, const PixelStory& story, const Explanation& e,
              const ExplainedEquation& at, int channel, const BallTurn& turn);

/// N, the L and R of the first light in the picture, as arrows of one length seen along the view's axis, from
/// the place of an equation.
void drawVectors(Pen& pen, const Rect& area, glm::ivec2 place, const PixelStory& story,
                 const ExplainedEquation& at);

/// A bar of length 1: ambient light dark, diffuse dotted, specular hatched; what exceeds 1 is red.
void drawTerms(Pen& pen, const Rect& area, const std::array<double, 3>& terms);

/// The map that an environment is looked up in, and the place that is looked up.
void drawMap(Pen& pen, const Rect& area, const PixelStory& story, const Explanation& e, int channel);

}  // namespace xnewell
