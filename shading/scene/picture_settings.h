#pragma once

#include "depthsort/order.h"
#include "geometry/model/vertex_normals.h"
#include "geometry/view/camera.h"
#include "geometry/view/project.h"
#include "shading/color/color_plan.h"
#include "shading/color/color_table.h"
#include "shading/fill/texture.h"
#include "shading/light/environment.h"
#include "shading/light/illumination.h"
#include "shading/light/method.h"

namespace xnewell {

/// Everything that a picture of a scene can be asked for.

struct PictureSettings {
  int width = 800, height = 600;  ///< pixels, 1..kMaxPicture
  CameraSettings camera;          ///< in the scene's units
  Illumination light;
  Shading shading = Shading::Flat;
  NormalRule normals = NormalRule::Exact;
  double crease = 180;  ///< degrees, as smoothVertices() has it
  Polygons polygons = Polygons::Triangles;
  double adapt = 0;  ///< RefineSettings::tolerance of flat and Gouraud shading; 0: no polygon is divided
  EnvironmentForm environment = EnvironmentForm::Rotated;
  TextureMapping mapping = TextureMapping::Perspective;
  Order order = Order::Newell;
  Cull cull = Cull::Keep;
  bool inPixels = false;  ///< an X server will fill the polygons (SortSettings::inPixels)
  ColorPlan colors = ColorPlan::Needed;
  bool dither = false;  ///< where the plan is of colours, not of hues
  TableSettings table;
  bool operator==(const PictureSettings&) const = default;
};

}  // namespace xnewell
