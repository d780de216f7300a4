#pragma once

#include "shading/figure/figure.h"
#include "shading/figure/hiding_faces.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Adds the lines and labels of a scene to its figure: what faces in front do not hide. With
/// FigureEdges::All, hidden lines are dashed.
void addMarks(const SceneMarks& marks, const Picture& picture, const HidingFaces& faces, FigureEdges edges,
              VectorFigure& figure);

}  // namespace xnewell
