#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"

namespace xnewell {

/// A picture as areas with smooth borders, for paper and for the web: what SVG, PDF and EPS files hold. It is
/// a list of paths. Each is filled with one colour, or holds triangles with a colour at each corner. Later
/// paths are painted over earlier ones.

/// Steps of a figure's coordinates in a pixel of the picture. Renderers have no finer ones.
inline constexpr int kFigureSteps = 256;

/// How far a colour is off at most unless the user asks for something else, in steps of 1/255 of a channel.
inline constexpr int kFigureTolerance = 2;

/// A polygon in the steps of kFigureSteps: origin top left, y down.
using FigureLoop = std::vector<glm::ivec2>;

using FigureColor = std::array<std::uint8_t, 3>;  ///< red, green, blue
/// What a server shows of a stored colour.
[[nodiscard]] inline FigureColor figureColorOf(const Rgb16& color) {
  return {static_cast<std::uint8_t>(color.r >> 8), static_cast<std::uint8_t>(color.g >> 8),
          static_cast<std::uint8_t>(color.b >> 8)};
}

/// The same of red, green, blue in [0, 1].
[[nodiscard]] inline FigureColor figureColorOf(const glm::dvec3& color) {
  const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(255 * v)); };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

/// "#0088fe"
[[nodiscard]] inline std::string hexOf(const FigureColor& color) {
  std::string hex = "#";
  for (const std::uint8_t byte : color)
    for (const int digit : {byte >> 4, byte & 15}) hex += "0123456789abcdef"[digit];
  return hex;
}

/// A triangle whose colour is linear between those of its corners. The corners are on no common line.
struct FigureTriangle {
  std::array<glm::ivec2, 3> corners;
  std::array<FigureColor, 3> colors;
};

struct FigurePath {
  FigureColor color;
  std::vector<FigureLoop> loops;            ///< filled together, by the rule of nonzero winding
  int level = 0;                            ///< of its polygons; it ascends
  std::vector<FigureTriangle> triangles{};  ///< painted instead of loops; only PDF files can hold them
};

/// Lines of one look, painted after all paths.
struct FigureStroke {
  FigureColor color{};
  int width = kFigureSteps;  ///< in steps
  bool dashed = false;
  std::vector<FigureLoop> lines;  ///< open; of two points or more
};

/// A text that begins at a place, on its base line.
struct FigureText {
  glm::ivec2 at{0};
  FigureColor color{};
  int size = 12 * kFigureSteps;  ///< of the font, in steps
  std::string text;              ///< UTF-8, of characters that the font has
};

/// What was done to the fragments of the painting order to make the paths.
struct FigureStatistics {
  std::int64_t fragments = 0;  ///< in the painting order
  std::int64_t outside = 0;    ///< outside of the page, or without an area in the steps of kFigureSteps
  std::int64_t hidden = 0;     ///< covered by what is painted later
  std::int64_t levels = 0;     ///< polygons of one level do not overlap
  std::int64_t loops = 0, corners = 0;
  int off = 0;  ///< how far a colour is at most from the picture's, in steps of 1/255 of a channel
};

struct VectorFigure {
  int width = 0, height = 0;  ///< of the page, in pixels of the picture; the figure is cut off at its border
  std::vector<FigurePath> paths;
  std::vector<FigureStroke> strokes;
  std::vector<FigureText> texts;   ///< painted last
  std::vector<FigureColor> paper;  ///< one colour behind all paths, or none
  std::string note;                ///< a comment in the file, one line of UTF-8; "" for none
  FigureStatistics statistics;
};

}  // namespace xnewell
