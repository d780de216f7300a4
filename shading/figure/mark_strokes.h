#pragma once

#include "shading/figure/figure.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Adds the edges, lines and labels of a scene to the figure of its picture: what faces in front do not hide.
/// With ModelEdges::All, hidden edges and lines are dashed. The picture has planes if the scene has any.
void addMarks(const Picture& picture, VectorFigure& figure);

}  // namespace xnewell
