#pragma once

#include <optional>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/order.h"
#include "geometry/model/vertex_normals.h"
#include "geometry/view/camera.h"
#include "geometry/view/project.h"
#include "shading/color/color_plan.h"
#include "shading/color/color_table.h"
#include "shading/fill/environment.h"
#include "shading/fill/texture.h"
#include "shading/light/illumination.h"
#include "shading/light/light.h"

namespace xnewell {

/// All settings of a picture of a scene. Lengths are in the units of the scene's file (units.h).
struct PictureSettings {
  int width = 800, height = 600;  ///< pixels, 1..kMaxPicture
  CameraSettings camera;
  Illumination light;
  /// In the place of the scene's own lights, and in its units (light.h); none: as the scene has them.
  std::optional<std::vector<Light>> lights = {};
  Shading shading = Shading::Flat;
  NormalRule normals = NormalRule::Exact;
  double crease = 180;  ///< degrees; see smoothVertices()
  Polygons polygons = Polygons::Triangles;
  Interpolated interpolated = Interpolated::Intensity;  ///< by Gouraud shading
  bool unnormalized = false;  ///< Phong's interpolated normals are not made unit vectors again
  /// RefineSettings::tolerance for flat and Gouraud shading; 0: no polygon is divided.
  double adapt = 0;
  EnvironmentForm environment = EnvironmentForm::Rotated;
  TextureMapping mapping = TextureMapping::Perspective;
  Order order = Order::Newell;
  Cull cull = Cull::Keep;
  int mostPieces = kMostPieces;  ///< SortSettings::mostPieces
  bool inPixels = false;         ///< true if an X server will fill the polygons (SortSettings::inPixels)
  ColorPlan colors = ColorPlan::Needed;
  bool dither = false;  ///< has an effect if the cells hold colours, not ramps
  TableSettings table;
  bool operator==(const PictureSettings&) const = default;
};

/// True if Phong shading takes the interpolated normals as they are.
[[nodiscard]] inline bool keepsLengthOfN(const PictureSettings& settings) {
  return settings.unnormalized || rowOf(settings.light.mistake).longN;
}

}  // namespace xnewell
