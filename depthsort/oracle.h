#pragma once

#include <vector>

#include "geometry/project.h"

/// Which face is seen at each sample, decided there and nowhere else: every face that covers the sample
/// is compared with the nearest so far, in exact arithmetic. No order of faces is made, so there is nothing
/// to sort, to cut or to get wrong; it shares the snapped scene and the sample rule with the painter, and no
/// code. Work: one comparison for every sample of every face.
///
/// Returns an index into scene.faces for each sample, row by row from the top, or kNothing. Of faces in one
/// plane the later one of the scene wins.
inline constexpr int kNothing = -1;
[[nodiscard]] std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height);
