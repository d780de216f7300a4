#pragma once

#include "geometry/view/project.h"

namespace xnewell {

/// Returns a value at a vertex. For a corner of the mesh, it is get(corner). For a vertex that clipping made,
/// it is interpolated between the values at the two vertices of the cut edge.
template <class Get>
[[nodiscard]] auto atSource(const SnappedScene& scene, int source, const Get& get) -> decltype(get(0)) {
  if (source >= 0) return get(source);
  const Between& made = scene.between[~source];
  const auto a = atSource(scene, made.a, get), b = atSource(scene, made.b, get);
  return a + made.t * (b - a);
}

}  // namespace xnewell
