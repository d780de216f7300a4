#include "shading/light/depth_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace xnewell {

namespace {

/// The z of points along the viewing direction; larger is nearer.
class DepthOf {
 public:
  DepthOf(const Mesh& mesh, const ViewSpec& view)
      : mesh_{mesh}, rotation_{vrcRotation(view)}, vrp_{view.vrp} {}
  [[nodiscard]] double corner(int c) const { return (rotation_ * (mesh_.points[c] - vrp_)).z; }
  /// The mean of the corners.
  [[nodiscard]] double face(int number) const {
    double sum = 0.0;
    for (const int c : mesh_.face(number)) sum += corner(c);
    return sum / static_cast<double>(mesh_.face(number).size());
  }
  /// How far that may be off.
  [[nodiscard]] double rounding(int number) const {
    double most = 0.0;
    for (const int c : mesh_.face(number)) most = std::max(most, sumOf(mesh_.points[c]) + sumOf(vrp_));
    return (static_cast<double>(mesh_.face(number).size()) + 9.0) * 0x1p-53 * most;
  }

 private:
  static double sumOf(const glm::dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

  const Mesh& mesh_;
  glm::dmat3 rotation_;
  glm::dvec3 vrp_;
};

/// Also sets z to the depths of snapped.faces.
DepthRange rangeOf(const DepthOf& depthOf, const SnappedScene& snapped, std::vector<double>& z) {
  z.reserve(snapped.faces.size());
  double near = -std::numeric_limits<double>::infinity(), far = -near, rounding = 0.0;
  for (const SnappedFace& face : snapped.faces) {
    z.push_back(depthOf.face(face.number));
    near = std::max(near, z.back()), far = std::min(far, z.back());
    rounding = std::max(rounding, depthOf.rounding(face.number));
  }
  return {near, near - far > 2.0 * rounding ? near - far : 0.0};
}

}  // namespace

DepthRange depthRange(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view) {
  std::vector<double> z;
  return rangeOf({mesh, view}, snapped, z);
}

std::vector<double> depthIntensities(const Mesh& mesh, const SnappedScene& snapped, const ViewSpec& view) {
  std::vector<double> z;
  const DepthRange range = rangeOf({mesh, view}, snapped, z);
  for (double& v : z) v = range.length > 0.0 ? 1.0 - (range.near - v) / range.length : 1.0;
  return z;
}

DepthTerms depthTerms(const Mesh& mesh, const ViewSpec& view, const DepthRange& range, int face) {
  const DepthOf depthOf{mesh, view};
  DepthTerms terms{.z = {}, .range = range.length};
  for (const int c : mesh.face(face)) terms.z.push_back(range.near - depthOf.corner(c));
  return terms;
}

}  // namespace xnewell
