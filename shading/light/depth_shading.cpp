#include "shading/light/depth_shading.h"

#include <algorithm>
#include <numeric>

namespace xnewell {

namespace {

/// The z of a point along the viewing direction; larger is nearer.
class DepthOf {
 public:
  DepthOf(const Mesh& mesh, const ViewSpec& view)
      : mesh_{mesh}, rotation_{vrcRotation(view)}, vrp_{view.vrp} {}
  [[nodiscard]] double corner(int c) const { return (rotation_ * (mesh_.points[c] - vrp_)).z; }
  /// The mean of the corners of each face of a snapped scene.
  [[nodiscard]] std::vector<double> faces(const SnappedScene& snapped) const {
    std::vector<double> z(snapped.faces.size());
    for (std::size_t f = 0; f < z.size(); ++f) {
      const std::span<const int> corners = mesh_.face(snapped.faces[f].number);
      for (const int c : corners) z[f] += corner(c);
      z[f] /= static_cast<double>(corners.size());
    }
    return z;
  }

 private:
  const Mesh& mesh_;
  glm::dmat3 rotation_;
  glm::dvec3 vrp_;
};

}  // namespace

std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view) {
  std::vector<double> z = DepthOf{mesh, view}.faces(snapped);
  if (z.empty()) return z;
  const auto [least, most] = std::ranges::minmax_element(z);
  const double far = *least, near = *most;
  for (double& v : z) v = near > far ? 1.0 - (near - v) / (near - far) : 1.0;
  return z;
}

DepthTerms depthTerms(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view, int face) {
  const DepthOf depthOf{mesh, view};
  const std::vector<double> all = depthOf.faces(snapped);
  const auto [far, near] = std::ranges::minmax_element(all);
  DepthTerms terms;
  for (const int c : mesh.face(snapped.faces[face].number)) terms.z.push_back(*near - depthOf.corner(c));
  terms.a = static_cast<double>(terms.z.size()) * (*near - *far);
  if (terms.a > 0.0) terms.I = 1.0 - std::accumulate(terms.z.begin(), terms.z.end(), 0.0) / terms.a;
  return terms;
}

}  // namespace xnewell
