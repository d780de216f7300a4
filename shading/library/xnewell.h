#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace xnewell::library {

/// xnewell for other programs: exact painting orders of polygons, and shaded pictures. No X server is needed,
/// and no other header. Nothing here keeps a state, so threads may call these functions at the same time.
///
/// World coordinates are right-handed, with y up, in any unit. Screen coordinates are in pixels, with the
/// origin at the top left corner of the picture, x to the right and y down. The sample of pixel (i, j) is its
/// centre, (i + 1/2, j + 1/2).
///
/// What is stable: from version 1.0 on, names and meanings change only with the first number of the version.
/// Until then they may change with the second one.

using Point = std::array<double, 3>;

/// Polygons that share vertices.
struct Polygons {
  std::vector<Point> points;            ///< #points by 3, finite
  std::vector<std::vector<int>> faces;  ///< #faces; indices into points, from 0; at least three corners each
  /// Half a unit of the last decimal of the points. Faces that cross by less count as touching.
  double rounding = 0;
};

/// Reads the vertices and faces of an OBJ file. A face keeps its place in the file as its index.
/// @throws std::runtime_error  `teapot.obj:41: face index 0; OBJ counts from 1`
[[nodiscard]] Polygons readObj(const std::string& file);

/// The camera. What is not given frames the whole scene from a pleasant angle.
struct View {
  int width = 800, height = 600;  ///< of the picture in pixels, 1..8192
  std::optional<Point> eye = {}, lookAt = {}, up = {};
  std::optional<double> fov = {};       ///< of a perspective view: from bottom to top, degrees, in (0, 180)
  std::optional<double> parallel = {};  ///< makes the view parallel; the picture's height in world units
};

/// What is painted at once: a face, or a part of a face. It is convex.
struct Piece {
  int face;  ///< index into Polygons::faces
  /// Its corners on the screen, counter-clockwise as seen there. They are within 2^-16 pixel, and those of a
  /// cut are rounded to doubles. It may reach beyond the picture.
  std::vector<std::array<double, 2>> outline;
};

/// Polygons that cross each other so often that the order has more pieces than allowed.
struct TooManyPieces : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An order of painting, back to front: painted one over the other, the pieces show the nearest face at every
/// sample. It is Newell's depth sort with exact signs, on a grid of 1/65536 pixel, to which corners are
/// rounded. A face is cut where the sort finds no order without a cut.
/// Ties: of faces in one plane, the later one is painted later. Where faces only touch, within the rounding
/// of the input, either may show. Left out: faces without an area, faces out of view, and faces that show at
/// no sample because others hide them, if the sort finds that out. Faces with holes or dents come as several
/// convex pieces.
/// @throws std::invalid_argument  an index, a coordinate or a view that is not as described above; no faces
/// @throws TooManyPieces
[[nodiscard]] std::vector<Piece> paintingOrder(const Polygons& polygons, const View& view = {},
                                               int mostPieces = 5'000'000);

/// A picture of 8-bit colour indices.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> cells;                        ///< height by width, row by row from the top
  std::array<std::array<std::uint8_t, 3>, 256> colors{};  ///< red, green and blue of each cell
};

/// Draws a scene: an `.obj`, `.ply`, `.off`, `.bpt` or `.json` file. A `.json` file says how the scene is
/// lit, shaded and sorted, and where its eye is; `view` wins over it. It is the picture that `xnewell draw`
/// makes.
/// @throws std::runtime_error  a file that cannot be read, with its name, line and what is wrong in it
/// @throws std::invalid_argument  a view that is not as described above
[[nodiscard]] Picture draw(const std::string& sceneFile, const View& view = {});

/// Writes a palette PNG with 8 bits a pixel, completely or not at all.
/// @throws std::runtime_error
void writePng(const std::string& file, const Picture& picture);

}  // namespace xnewell::library
