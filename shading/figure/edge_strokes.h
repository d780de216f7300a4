#pragma once

#include <vector>

#include "shading/figure/figure.h"
#include "shading/figure/hiding_faces.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The edges of the model's faces as strokes: what shows of them, and dashed what does not, if all are asked
/// for. Sides that only a division of a face, a clip or a split made are no edges.
[[nodiscard]] std::vector<FigureStroke> edgeStrokes(const SnappedScene& scene, const HidingFaces& faces,
                                                    ModelEdges edges);

/// Adds the parts of a line between two places of the snapped scene that faces do not hide, and to `unseen`
/// the others.
void addLine(const HidingFaces& faces, const glm::dvec3& a, const glm::dvec3& b, FigureStroke& seen,
             FigureStroke& unseen);

}  // namespace xnewell
