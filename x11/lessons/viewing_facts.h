#pragma once

#include "shading/picture/picture.h"
#include "x11/lessons/exhibit.h"

namespace xnewell {

/// The numbers of a stage of the viewing transformation that lessons tell: NaN where the exhibit shows none.
struct ViewingFacts {
  double worldNdotL, worldI, stageNdotL, stageI;  ///< of the vertex that is followed
  double cells;                                   ///< from the world's cell to the stage's, either way
  double facesOff;  ///< faces whose front has another cell if the light is computed where the exhibit says
  double w, z;      ///< of the vertex at the stage; z in units of the file up to the shear
  double outside;   ///< corners of faces outside the planes that clip
};
[[nodiscard]] ViewingFacts viewingFactsOf(const Picture& picture, const Exhibit& exhibit);

}  // namespace xnewell
