#include "shading/laboratory/profile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>

#include "depthsort/oracle.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

constexpr double kOneSurface = 0.9998476951563913;  // cos 1 degree
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Tells which faces belong to one smooth surface.
class Surface {
 public:
  explicit Surface(const Picture& picture)
      : mesh_{picture.scene().mesh},
        made_{picture.shading().vertices().vertices.empty()
                  ? smoothVertices(picture.scene(), picture.settings())
                  : Vertices{}},
        vertices_{made_.vertices.empty() ? picture.shading().vertices() : made_},
        side_(mesh_.faceCount(), 0) {
    for (const SnappedFace& face : picture.snapped().faces) side_[face.number] = face.back ? -1 : 1;
    cornersAt_.resize(mesh_.points.size());
    for (int f = 0; f < mesh_.faceCount(); ++f)
      for (int c = mesh_.firstCorner[f]; c < mesh_.firstCorner[f + 1]; ++c)
        cornersAt_[mesh_.corners[c]].push_back({f, c});
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
  /// The faces that join `face` at a point, and the face itself; ascending. A face may occur more than once.
  [[nodiscard]] std::vector<int> neighbours(int face) const {
    std::vector<int> result;
    for (int c = mesh_.firstCorner[face]; c < mesh_.firstCorner[face + 1]; ++c)
      for (const FaceCorner& other : cornersAt_[mesh_.corners[c]])
        if (side_[other.face] == side_[face] && dot(normal(c), normal(other.corner)) >= kOneSurface)
          result.push_back(other.face);
    std::ranges::sort(result);
    return result;
  }

  const Mesh& mesh_;
  Vertices made_;  ///< empty unless the picture needed no normals
  const Vertices& vertices_;
  std::vector<int> side_;                           ///< of each face: 1 front, -1 back, 0 not in the picture
  std::vector<std::vector<FaceCorner>> cornersAt_;  ///< the corners at each point
};

/// True if both give every intensity on every material the same cell.
bool sameTables(const SceneColors& a, const SceneColors& b, std::size_t materials) {
  for (int m = -1; m < static_cast<int>(materials); ++m)
    if (a.tableOf(m).settings() != b.tableOf(m).settings() || a.tableOf(m).first() != b.tableOf(m).first())
      return false;
  return true;
}

}  // namespace

int defaultScanline(const Picture& picture) {
  const int W = picture.settings().width, H = picture.settings().height;
  const SeenRows seen = picture.seen(0, H);
  const auto shown = [&](int j) {
    const auto row = seen.faces.begin() + std::ptrdiff_t(j) * W;
    return W - std::count(row, row + W, kNothing);
  };
  int best = H / 2;
  if (shown(best) == 0)
    for (int j = 0; j < H; ++j)
      if (shown(j) > shown(best)) best = j;
  return best;
}

void addSlopes(Profile& profile, const std::vector<bool>& joined) {
  const std::size_t pixels = profile.I.size();
  profile.slope.assign(pixels - 1, kUnknown);
  for (std::size_t i = 0; i + 1 < pixels; ++i) {
    if (!joined[i]) continue;
    profile.slope[i] = profile.I[i + 1] - profile.I[i];
    profile.largestJump = std::max(profile.largestJump, std::abs(profile.slope[i]));
  }
  // At pixel i: the change from the slope before the pixel to the slope after it.
  std::vector<double> kinks(pixels, kUnknown);
  for (std::size_t i = 1; i + 1 < pixels; ++i) {
    kinks[i] = std::abs(profile.slope[i] - profile.slope[i - 1]);
    if (kinks[i] > profile.largestKink) profile.largestKink = kinks[i];  // false for NaN
  }
}

namespace {

/// Intensity and slope of a face at its edge, which is `half` beyond its last sample. The face's own curve
/// goes on to there with its curvature, so what a smooth steep curve does by itself is no jump and no kink.
struct AtEdge {
  double I, slope;
  /// From the last sample towards the other end of the run.
  AtEdge(const std::vector<double>& all, int last, int end, double half) : I{all[last]}, slope{0.0} {
    constexpr int kReach = 4;  // samples over which a slope is measured
    const int inward = end < last ? -1 : 1, length = std::abs(end - last);
    const int reach = std::clamp(length / 2, std::min(1, length), kReach);
    if (reach == 0) return;
    const auto slopeFrom = [&](int at) { return (all[at] - all[at + inward * reach]) / (-inward * reach); };
    slope = slopeFrom(last);
    const double curvature =
        2 * reach <= length ? (slope - slopeFrom(last + inward * reach)) / (-inward * reach) : 0.0;
    slope += curvature * -inward * (reach / 2.0);
    I += -inward * half * slope + curvature * half * half / 2.0;
    slope += curvature * -inward * half;
  }
};

}  // namespace

std::vector<double> bandsOf(const std::vector<double>& I, const std::vector<FaceRun>& runs, double width) {
  std::vector<double> bands;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
    if (!runs[k].joinsNext) continue;
    const int left = runs[k].end - 1, right = runs[k + 1].begin;
    const double half = (right - left) / 2.0;  // from the outermost samples to the edge between the faces
    const AtEdge before{I, left, runs[k].begin, half}, after{I, right, runs[k + 1].end - 1, half};
    const double steep = std::max(std::abs(before.slope), std::abs(after.slope)),
                 kink = std::abs(after.slope - before.slope);
    if (std::abs(after.I - before.I) >= std::max(kBandJump, steep) ||
        (kink * width >= kBandKink && kink >= kBandShare * steep))
      bands.push_back((left + right + 1) / 2.0);
  }
  return bands;
}

namespace {

/// One row of a picture, of about kFineWidth samples, at the same height as another picture's row.
class FineRow {
 public:
  FineRow(const Picture& picture, int row) : cache_{picture}, settings_{picture.settings()} {
    const double scale =
        std::min(double(kFineWidth) / settings_.width, double(kMaxPicture) / settings_.height);
    const std::int64_t height = settings_.height;
    settings_.width = std::max(1, static_cast<int>(std::lround(settings_.width * scale)));
    settings_.height = std::max(1, static_cast<int>(std::lround(settings_.height * scale)));
    row_ = static_cast<int>((2 * row + 1) * std::int64_t{settings_.height} / (2 * height));
    const Picture fine = cache_.make(settings_);
    seen_ = fine.seen(row_, row_ + 1);
    findRuns(fine);
  }
  [[nodiscard]] int edges() const {
    return static_cast<int>(std::ranges::count(runs_, true, &FaceRun::joinsNext));
  }
  /// As pixels of a row of `width`.
  [[nodiscard]] std::vector<int> bands(Shading method, int width) {
    settings_.shading = method;
    std::vector<int> pixels;
    for (const double x : bandsOf(cache_.make(settings_).intensities(seen_), runs_, shown_))
      pixels.push_back(std::min(width - 1, static_cast<int>(x * width / settings_.width)));
    return pixels;
  }

 private:
  void findRuns(const Picture& fine) {
    const Surface surface{fine};
    const auto number = [&](int at) { return fine.snapped().faces[seen_.faces[at]].number; };
    std::optional<int> first;
    for (int i = 0, end = 0; i < seen_.width; i = end) {
      const int face = seen_.faces[i];
      for (end = i; end < seen_.width && seen_.faces[end] == face; ++end) continue;
      if (face == kNothing) continue;
      if (!first) first = i;
      shown_ = end - *first;
      if (end - i < kLeastRun) continue;
      if (!runs_.empty() && number(runs_.back().begin) == number(i) && runs_.back().end == i) {
        runs_.back().end = end;  // a piece of the same face
        continue;
      }
      if (!runs_.empty() && i - runs_.back().end < kLeastRun && showsAll(runs_.back().end, i))
        runs_.back().joinsNext = surface.joined(number(runs_.back().begin), number(i));
      runs_.push_back({i, end});
    }
  }
  [[nodiscard]] bool showsAll(int begin, int end) const {
    return std::none_of(seen_.faces.begin() + begin, seen_.faces.begin() + end,
                        [](int face) { return face == kNothing; });
  }

  PictureCache cache_;
  PictureSettings settings_;
  int row_ = 0;
  double shown_ = 0;  ///< samples from the first to the last that shows something
  SeenRows seen_;
  std::vector<FaceRun> runs_;
};

}  // namespace

Scanline scanlineOf(const Picture& picture, int row, std::uint8_t ground) {
  Scanline line;
  line.row = row;
  PictureCache cache{picture};
  PictureSettings method = picture.settings();
  method.shading = Shading::Phong;  // it uses the normals at the vertices
  method.colors = picture.colors().plan();
  const Picture phong = cache.make(method);
  const SeenRows seen = phong.seen(row, row + 1);
  const Surface surface{phong};
  std::vector<bool> joined(std::size_t(seen.width) - 1, false);
  for (int i = 0; i < seen.width; ++i) {
    line.samples += seen.faces[i] != kNothing;
    if (i == 0 || seen.faces[i - 1] == kNothing || seen.faces[i] == kNothing) continue;
    const auto number = [&](int at) { return phong.snapped().faces[seen.faces[at]].number; };
    joined[i - 1] = surface.joined(number(i - 1), number(i));
    line.outlines += !joined[i - 1];
  }
  FineRow fine{phong, row};
  line.edges = fine.edges();

  for (std::size_t k = 0; k < kProfiled.size(); ++k) {
    Profile& profile = line.profiles[k];
    profile.method = method.shading = kProfiled[k];
    const Picture shown = cache.make(method, ground);
    profile.I = shown.intensities(seen);
    addSlopes(profile, joined);
    profile.bands = fine.bands(profile.method, seen.width);
    if (sameTables(shown.colors(), picture.colors(), picture.scene().mesh.materials.size())) {
      profile.cells.assign(shown.image().row(row), shown.image().row(row) + shown.image().width);
      continue;
    }
    // Another method divides the shades among the hues in another way. The strip has the shades of the
    // picture.
    const std::vector<int>& material = phong.shading().mesh(phong.scene()).material;
    profile.cells.assign(seen.faces.size(), ground);
    for (std::size_t i = 0; i < seen.faces.size(); ++i) {
      if (seen.faces[i] == kNothing) continue;
      const int face = phong.snapped().faces[seen.faces[i]].number;
      const ColorTable& table = picture.colors().tableOf(material[face]);
      profile.cells[i] = static_cast<std::uint8_t>(table.cell(profile.I[i]));
    }
  }
  return line;
}

}  // namespace xnewell
