#include "shading/light/depth_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace xnewell {

namespace {

/// The depths of a snapped scene's faces along the viewing direction; larger is nearer.
class Depths {
 public:
  Depths(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view)
      : z(snapped.faces.size()), mesh_{mesh}, rotation_{vrcRotation(view)}, vrp_{view.vrp} {
    double rounding = 0.0;
    for (std::size_t f = 0; f < z.size(); ++f) {
      const std::span<const int> corners = mesh.face(snapped.faces[f].number);
      const auto n = static_cast<double>(corners.size());
      double most = 0.0;
      for (const int c : corners) {
        z[f] += corner(c);
        most = std::max(most, sumOf(mesh.points[c]) + sumOf(vrp_));
      }
      z[f] /= n;
      near = std::max(near, z[f]), far = std::min(far, z[f]);
      rounding = std::max(rounding, (n + 9.0) * 0x1p-53 * most);
    }
    range = near - far > 2.0 * rounding ? near - far : 0.0;
  }
  [[nodiscard]] double corner(int c) const { return (rotation_ * (mesh_.points[c] - vrp_)).z; }
  [[nodiscard]] double intensity(double mean) const {
    return range > 0.0 ? 1.0 - (near - mean) / range : 1.0;
  }

  std::vector<double> z;  ///< of each face: the mean of its corners
  double near = -std::numeric_limits<double>::infinity(), far = -near;
  double range = 0.0;  ///< from the nearest to the farthest; 0 if they count as the same

 private:
  static double sumOf(const glm::dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

  const Mesh& mesh_;
  glm::dmat3 rotation_;
  glm::dvec3 vrp_;
};

}  // namespace

std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view) {
  Depths depths{mesh, snapped, view};
  for (double& z : depths.z) z = depths.intensity(z);
  return std::move(depths.z);
}

DepthTerms depthTerms(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view, int face) {
  const Depths depths{mesh, snapped, view};
  DepthTerms terms{.z = {}, .range = depths.range, .I = depths.intensity(depths.z[face])};
  for (const int c : mesh.face(snapped.faces[face].number)) terms.z.push_back(depths.near - depths.corner(c));
  return terms;
}

}  // namespace xnewell
