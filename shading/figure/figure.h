#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace xnewell {

/// A picture as areas with smooth borders, for paper and for the web: what SVG, PDF and EPS files hold. It is
/// a list of paths. Each is filled with one colour, and later paths are painted over earlier ones.

/// Steps of a figure's coordinates in a pixel of the picture. Renderers have no finer ones.
inline constexpr int kFigureSteps = 256;

/// A polygon in the steps of kFigureSteps: origin top left, y down.
using FigureLoop = std::vector<glm::ivec2>;

struct FigurePath {
  std::array<std::uint8_t, 3> color;  ///< red, green, blue
  std::vector<FigureLoop> loops;      ///< filled together, by the rule of nonzero winding
};

/// What was done to the fragments of the painting order to make the paths.
struct FigureStatistics {
  std::int64_t fragments = 0;  ///< in the painting order
  std::int64_t outside = 0;    ///< outside of the page, or without an area in the steps of kFigureSteps
  std::int64_t hidden = 0;     ///< covered by what is painted later
  std::int64_t levels = 0;     ///< polygons of one level do not overlap
  std::int64_t loops = 0, corners = 0;
};

struct VectorFigure {
  int width = 0, height = 0;  ///< of the page, in pixels of the picture; the figure is cut off at its border
  std::vector<FigurePath> paths;
  std::vector<std::array<std::uint8_t, 3>> paper;  ///< one colour behind all paths, or none
  std::string note;                                ///< a comment in the file, one line of UTF-8; "" for none
  FigureStatistics statistics;
};

}  // namespace xnewell
