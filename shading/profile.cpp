#include "shading/profile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>

#include "depthsort/oracle.h"

namespace {

constexpr double kOneSurface = 0.9998476951563913;  // cos 1 degree

/// Which faces go on into each other.
class Surface {
 public:
  Surface(const Mesh& mesh, const Vertices& vertices) : mesh_{mesh}, vertices_{vertices} {
    cornersAt_.resize(mesh.points.size());
    for (int f = 0; f < mesh.faceCount(); ++f)
      for (int c = mesh.firstCorner[f]; c < mesh.firstCorner[f + 1]; ++c)
        cornersAt_[mesh.corners[c]].push_back({f, c});
  }

  [[nodiscard]] bool joined(int p, int q) const {
    if (p == q) return true;
    const std::vector<int> ofP = neighbours(p), ofQ = neighbours(q);
    return std::ranges::binary_search(ofP, q) ||
           std::ranges::any_of(ofP, [&](int f) { return std::ranges::binary_search(ofQ, f); });
  }

 private:
  struct FaceCorner {
    int face, corner;
  };
  [[nodiscard]] const glm::dvec3& normal(int corner) const {
    return vertices_.vertices[vertices_.ofCorner[corner]].N;
  }
  /// Ascending.
  [[nodiscard]] std::vector<int> neighbours(int face) const {
    std::vector<int> result;
    for (int c = mesh_.firstCorner[face]; c < mesh_.firstCorner[face + 1]; ++c)
      for (const FaceCorner& other : cornersAt_[mesh_.corners[c]])
        if (other.face != face && dot(normal(c), normal(other.corner)) >= kOneSurface)
          result.push_back(other.face);
    std::ranges::sort(result);
    return result;
  }

  const Mesh& mesh_;
  const Vertices& vertices_;
  std::vector<std::vector<FaceCorner>> cornersAt_;  ///< of each point
};

}  // namespace

int defaultScanline(const Picture& picture) {
  const int W = picture.settings().width, H = picture.settings().height;
  const SeenRows seen = picture.seen(0, H);
  int best = H / 2;
  std::ptrdiff_t most = -1;
  for (int j = 0; j < H; ++j) {
    const auto row = seen.faces.begin() + std::ptrdiff_t(j) * W;
    const std::ptrdiff_t shown = W - std::count(row, row + W, kNothing);
    if (shown > most || (shown == most && std::abs(j - H / 2) < std::abs(best - H / 2)))
      best = j, most = shown;
  }
  return best;
}

void addSlopes(Profile& profile, const std::vector<bool>& joined) {
  const std::size_t pixels = profile.I.size();
  profile.slope.assign(pixels - 1, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i + 1 < pixels; ++i) {
    if (!joined[i]) continue;
    profile.slope[i] = profile.I[i + 1] - profile.I[i];
    profile.largestJump = std::max(profile.largestJump, std::abs(profile.slope[i]));
  }
  bool within = false;  // a band that has begun
  for (std::size_t i = 0; i + 1 < profile.slope.size(); ++i) {
    const double kink = std::abs(profile.slope[i + 1] - profile.slope[i]);  // NaN compares as no
    if (kink > profile.largestKink) profile.largestKink = kink;
    profile.bands += kink >= kBand && !within;
    within = kink >= kBand;
  }
}

Scanline scanlineOf(Picture& picture, const PictureSettings& settings, int row, std::uint8_t ground) {
  Scanline line;
  line.row = row;
  PictureSettings method = settings;
  method.shading = Shading::Phong;  // it knows the normals at vertices
  picture.make(method);
  const SeenRows seen = picture.seen(row, row + 1);
  const Surface surface{picture.scene().mesh, picture.shading().vertices()};
  std::vector<bool> joined(std::size_t(seen.width) - 1, false);
  for (int i = 0; i < seen.width; ++i) {
    line.samples += seen.faces[i] != kNothing;
    if (i == 0 || seen.faces[i - 1] == kNothing || seen.faces[i] == kNothing) continue;
    const auto number = [&](int at) { return picture.snapped().faces[seen.faces[at]].number; };
    joined[i - 1] = surface.joined(number(i - 1), number(i));
    line.edges += !joined[i - 1];
  }

  for (std::size_t k = 0; k < kProfiled.size(); ++k) {
    Profile& profile = line.profiles[k];
    profile.method = method.shading = kProfiled[k];
    picture.make(method);
    profile.I = picture.intensities(seen);
    addSlopes(profile, joined);
    IndexImage image;
    picture.paint(image, ground);
    profile.cells.assign(image.row(row), image.row(row) + image.width);
  }
  picture.make(settings);
  return line;
}
