#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shading/explain/equation_at.h"
#include "shading/explain/pixel_history.h"
#include "shading/light/depth_shading.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Why a pixel has its cell: the chain from a polygon to a cell of the colormap, with all numbers. Each link
/// is computed by the course's own definitions (equation.h, interpolation.h), in double precision, not by the
/// loops that painted the picture. What those loops have in the end stands beside it. So an explanation
/// cannot contradict the picture without saying so.

/// A vertex of the triangle around the sample; by rows (Polygons::Rows), of the whole polygon.
struct ExplainedVertex {
  glm::dvec2 at{0};                  ///< on the screen, in pixels
  double onScreen = 0, inWorld = 0;  ///< weights (interpolation.h); 0 by rows
  glm::dvec3 P{0};                   ///< world
  glm::dvec3 N{0};                   ///< towards the side that is lit; 0 where all light is ambient
  ByChannel I{};                     ///< Gouraud: the intensity there, clamped
  /// Gouraud: what I was computed by, an index into Explanation::equations; -1 for a vertex that clipping
  /// made: its I is interpolated along the edge.
  int equation = -1;
};

/// The place of an environment's map that is looked up.
struct ExplainedPlace {
  int column = 0, row = 0;
  bool away = false;  ///< in the map of normals that face away from the light
};

struct Explanation {
  int i = 0, j = 0;
  int face = 0;  ///< index into snapped().faces
  Shading method = Shading::Full;
  int channels = 1;        ///< 3: red, green and blue
  bool luminance = false;  ///< the cell is that of the luminance of the three
  std::vector<ExplainedVertex> vertices;
  glm::dvec3 sum{0};  ///< Phong: the weighted sum of the vertices' normals, before it is made a unit vector
  std::optional<ExplainedTexel> texel;
  std::optional<ExplainedPlace> place;
  std::optional<DepthTerms> depth;  ///< of shading by depth, in the units of the scene's file
  /// Flat, Phong: one. Gouraud: one for each vertex of the model.
  std::vector<ExplainedEquation> equations;
  ByChannel I{};  ///< at the sample, by the definitions; with Phong or a texture it may exceed 1
  bool clamped =
      false;  ///< a sum of terms is above 1, or below 0 by a mistake, at the sample or at what it comes from
  double intensity = 0;  ///< what the table gets: I, or the luminance of the three, clamped to [0, 1]
  double inLoop = 0;     ///< the same in the picture's own loop, as precise as that loop
  /// What the loop makes of it: the cell; where the cells hold colours, each channel's value, 1 to 255.
  std::array<int, 3> value{};
};

/// "1954.2": the number of a face, and of the convex part of it if it has several. `face` is an index into
/// snapped().faces.
[[nodiscard]] std::string nameOfFace(const Picture& picture, int face);
/// "1954.2, spout": with the name of its group, if it has one.
[[nodiscard]] std::string faceName(const Picture& picture, int face);

/// Explains pixels of one picture, which must outlive it. What all pixels share is prepared once.
class PixelExplainer {
 public:
  explicit PixelExplainer(const Picture& picture) : picture_{picture}, equations_{picture.surfaces()} {}

  /// Explains what a face shows at the sample of pixel (i, j), which it owns. `face` is an index into
  /// snapped().faces.
  [[nodiscard]] Explanation operator()(int face, int i, int j);

 private:
  const Picture& picture_;
  EquationOf equations_;
  std::optional<DepthRange> range_;
};

}  // namespace xnewell
