#pragma once

#include "geometry/view/project.h"

namespace xnewell {

/// What `get` gives for a corner of the mesh, and between two of them for a vertex that clipping made.
template <class Get>
[[nodiscard]] auto atSource(const SnappedScene& scene, int source, const Get& get) -> decltype(get(0)) {
  if (source >= 0) return get(source);
  const Between& made = scene.between[~source];
  const auto a = atSource(scene, made.a, get), b = atSource(scene, made.b, get);
  return a + made.t * (b - a);
}

}  // namespace xnewell
