#include "shading/light/depth_shading.h"

#include <algorithm>
#include <limits>

namespace xnewell {

std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view) {
  const glm::dmat3 rotation = vrcRotation(view);
  std::vector<double> z(snapped.faces.size());  // larger is nearer
  double near = -std::numeric_limits<double>::infinity(), far = -near;
  for (std::size_t f = 0; f < z.size(); ++f) {
    const std::span<const int> corners = mesh.face(snapped.faces[f].number);
    for (const int c : corners) z[f] += (rotation * (mesh.points[c] - view.vrp)).z;
    z[f] /= static_cast<double>(corners.size());
    near = std::max(near, z[f]);
    far = std::min(far, z[f]);
  }
  for (double& v : z) v = near > far ? 1.0 - (near - v) / (near - far) : 1.0;
  return z;
}

}  // namespace xnewell
