#include "shading/figure/shades.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "depthsort/oracle.h"
#include "geometry/view/at_source.h"
#include "shading/figure/shown_polygons.h"
#include "shading/figure/side_table.h"
#include "shading/fill/fill.h"
#include "shading/picture/surface_evaluator.h"

namespace xnewell {

namespace {

using Color = FigureColor;

/// The cells of a ramp in groups of nearly one colour. A group is a band of each triangle, and its parts in
/// all triangles meet, since its ends are the same everywhere.
struct Group {
  double start;  ///< the least value
  Color color;
};

/// Cuts polygons along the lines where another group of cells begins.
class Bands {
 public:
  Bands(const Picture& picture, const Palette& palette, int tolerance)
      : picture_{picture}, snapped_{picture.snapped()}, ramps_{picture.colors().ramps()} {
    for (const Ramp& ramp : ramps_) {
      const bool byTable =
          ramp.table != nullptr && picture.settings().interpolated == Interpolated::Intensity;
      std::vector<Group>& groups = groups_.emplace_back();
      ColorBox box;
      const auto add = [&](double start, std::uint8_t cell) {
        ColorBox wider = box;
        wider.add(figureColorOf(palette[cell]));
        if (groups.empty() || wider.radius() > tolerance) {
          groups.push_back({start, {}});
          wider = {};
          wider.add(figureColorOf(palette[cell]));
        }
        box = wider;
        groups.back().color = box.middle();
        off_ = std::max(off_, box.radius());
      };
      if (byTable)
        ramp.table->bySteps().forEach(
            [&](std::uint32_t steps, std::uint8_t cell) { add(steps * 0x1p-24, cell); });
      else
        for (int k = 0; k < ramp.shades; ++k) add(ramp.first + k, static_cast<std::uint8_t>(ramp.first + k));
      groups.front().start = 0;
    }
  }

  /// How far a colour may be off.
  [[nodiscard]] int off() const { return off_; }

  /// Gives the polygon the colour of its least group. Adds what lies above the start of each other one, with
  /// the rank of the group: the later ones are painted over the earlier ones.
  void split(FigurePolygon& polygon, int index, std::vector<FigurePolygon>& to,
             std::vector<int>& ranks) const {
    const std::vector<Triangle> triangles = trianglesOf(polygon);
    const std::vector<Group>& groups = groupsOf(polygon);
    const std::ptrdiff_t first = groupOf(groups, leastOf(triangles));
    polygon.color = groups[first].color;
    for (const Triangle& t : triangles)
      for (std::ptrdiff_t g = first + 1; g < std::ssize(groups) && groups[g].start < t.most; ++g) {
        const SideLine line{SideLine::Kind::Shade, static_cast<std::uint64_t>(index),
                            static_cast<std::uint64_t>(g)};
        LinearOver above = t.value;
        above.c -= groups[g].start;
        addRounded(clipped(t.part, above, line), polygon.face, groups[g].color, to);
        ranks.resize(to.size(), static_cast<int>(g));
      }
  }

  /// Gives the polygon the colour of its least group. Adds triangles whose corners have the colours of their
  /// groups.
  /// @return  how far a colour on the way between two corners is at most from that of its group
  int smooth(FigurePolygon& polygon, std::vector<FigureTriangle>& to) const {
    const std::vector<Triangle> triangles = trianglesOf(polygon);
    const std::vector<Group>& groups = groupsOf(polygon);
    polygon.color = groups[groupOf(groups, leastOf(triangles))].color;
    int off = 0;
    std::vector<FigurePolygon> rounded;
    for (const Triangle& t : triangles) {
      rounded.clear();
      addRounded(t.part, polygon.face, {}, rounded);
      for (const FigurePolygon& p : rounded)
        for (std::size_t k = 2; k < p.corners.size(); ++k) {
          const std::array<glm::ivec2, 3> corners{p.corners[0], p.corners[k - 1], p.corners[k]};
          const glm::dvec2 first = corners[0];
          if (cross(glm::dvec2{corners[1]} - first, glm::dvec2{corners[2]} - first) == 0) continue;
          std::array<double, 3> values;
          std::array<Color, 3> colors;
          for (int c = 0; c < 3; ++c) {
            values[c] = std::clamp(t.value(glm::dvec2{corners[c]}), t.least, t.most);
            colors[c] = groups[groupOf(groups, values[c])].color;
          }
          for (int c = 0; c < 3; ++c)
            off = std::max(
                off, offBetween(groups, {values[c], values[(c + 1) % 3]}, {colors[c], colors[(c + 1) % 3]}));
          to.push_back({corners, colors});
        }
    }
    return off;
  }

 private:
  /// What a polygon has of a triangle of its face, and the values there.
  struct Triangle {
    SidedPart part;
    LinearOver value;
    double least = HUGE_VAL, most = -HUGE_VAL;
  };

  [[nodiscard]] int rampOf(const FigurePolygon& polygon) const {
    return picture_.scene().mesh.material[snapped_.faces[polygon.face].number] + 1;
  }
  [[nodiscard]] const std::vector<Group>& groupsOf(const FigurePolygon& polygon) const {
    return groups_[rampOf(polygon)];
  }
  static std::ptrdiff_t groupOf(const std::vector<Group>& groups, double value) {
    const auto next = std::ranges::upper_bound(groups, value, {}, &Group::start);
    return std::max<std::ptrdiff_t>(1, next - groups.begin()) - 1;
  }
  static double leastOf(const std::vector<Triangle>& triangles) {
    double least = HUGE_VAL;
    for (const Triangle& t : triangles) least = std::min(least, t.least);
    return least;
  }

  [[nodiscard]] std::vector<Triangle> trianglesOf(const FigurePolygon& polygon) const {
    const SnappedFace& face = snapped_.faces[polygon.face];
    std::vector<Triangle> triangles;
    forEachTriangle(snapped_, face, [&](const FaceTriangle& t) {
      Triangle of{sided(polygon), {}};
      std::array<double, 3> v;
      std::array<glm::dvec2, 3> at;
      for (int k = 0; k < 3; ++k) v[k] = valueAt(face, rampOf(polygon), t.vertex[k]), at[k] = inSteps(t.p[k]);
      for (int k = 0; face.count > 3 && k < 3; ++k) {
        const int next = k == 2 ? 0 : k + 1;
        of.part = clipped(of.part, LinearOver::besides(at[k], at[next]), edgeOf(t.p[k], t.p[next]));
      }
      if (of.part.size() < 3) return;
      of.value = LinearOver::through(at, v);
      for (const SidedCorner& c : of.part) {
        of.least = std::min(of.least, of.value(c.at)), of.most = std::max(of.most, of.value(c.at));
      }
      triangles.push_back(std::move(of));
    });
    return triangles;
  }

  /// How far a colour that is linear between two values is at most from those of the groups between them. It
  /// is farthest where a group begins or ends.
  static int offBetween(const std::vector<Group>& groups, std::array<double, 2> values,
                        std::array<Color, 2> colors) {
    if (values[0] > values[1]) std::swap(values[0], values[1]), std::swap(colors[0], colors[1]);
    const std::ptrdiff_t last = groupOf(groups, values[1]);
    double most = 0;
    for (std::ptrdiff_t g = groupOf(groups, values[0]) + 1; g <= last; ++g) {
      const double share = (groups[g].start - values[0]) / (values[1] - values[0]);
      for (const std::ptrdiff_t of : {g - 1, g})
        for (int c = 0; c < 3; ++c)
          most = std::max(
              most, std::abs(std::lerp(1.0 * colors[0][c], 1.0 * colors[1][c], share) - groups[of].color[c]));
    }
    return static_cast<int>(std::ceil(most));
  }

  static glm::dvec2 inSteps(const glm::ivec3& v) {
    return glm::dvec2{v.x, v.y} * (static_cast<double>(kFigureSteps) / kGrid);
  }
  /// The value at a vertex, as the fillers interpolate it.
  [[nodiscard]] double valueAt(const SnappedFace& face, int ramp, int vertex) const {
    const SceneShading& shading = picture_.shading();
    const auto intensity = [&](int corner) {
      return shading.intensities(0).I[shading.vertices().ofCorner[corner]].seen(face.back);
    };
    if (picture_.settings().interpolated == Interpolated::Cell)
      return atSource(snapped_, snapped_.source[vertex],
                      [&](int corner) { return ramps_[ramp].cell(intensity(corner)) + 0.5; });
    return ramps_[ramp].value(atSource(snapped_, snapped_.source[vertex], intensity));
  }

  const Picture& picture_;
  const SnappedScene& snapped_;
  std::vector<Ramp> ramps_;
  std::vector<std::vector<Group>> groups_;  ///< by ramp
  int off_ = 0;
};

/// The colour that covers the largest area.
Color mostOf(const std::vector<FigurePolygon>& parts) {
  std::map<Color, std::int64_t> areas;
  for (const FigurePolygon& part : parts) areas[part.color] += doubleArea(part.corners);
  return std::ranges::max_element(areas, {}, [](const auto& of) { return of.second; })->first;
}

}  // namespace

ShadesOver shadesOver(const Picture& picture, const SnappedFace& face) {
  const PictureSettings& s = picture.settings();
  const bool rgb = channelsOf(picture.colors().plan()) == Channels::Rgb;
  if (SurfaceEvaluator{picture.surfaces(), 0}.evaluates(face)) return ShadesOver::Samples;
  if (!rowOf(s.shading).interpolates) return ShadesOver::Face;
  const bool rows = s.polygons == Polygons::Rows && face.count > 3;
  return s.shading == Shading::Gouraud && !rgb && !rows ? ShadesOver::Bands : ShadesOver::Samples;
}

bool needsSamples(const Picture& picture) {
  return std::ranges::any_of(picture.snapped().faces, [&](const SnappedFace& face) {
    return shadesOver(picture, face) == ShadesOver::Samples;
  });
}

ShownSamples shownSamples(const Picture& painted, const Palette& palette) {
  const int width = painted.settings().width, height = painted.settings().height;
  ShownSamples samples{width, height, painted.seen(0, height).faces, {}};
  for (const std::uint8_t cell : painted.image().pixels)
    samples.colors.push_back(figureColorOf(palette[cell]));
  return samples;
}

ShadeParts shadePartsOf(std::vector<FigurePolygon>& polygons, const std::vector<int>& levels,
                        const Picture& picture, const Palette& palette, const ShownSamples& samples,
                        int tolerance, bool smooth) {
  ShadeParts all;
  const Bands bands{picture, palette, smooth ? 0 : tolerance};
  std::vector<FigurePolygon> parts;
  std::vector<int> ranks;
  for (int k = 0; k < static_cast<int>(polygons.size()); ++k) {
    const ShadesOver over = shadesOver(picture, picture.snapped().faces[polygons[k].face]);
    if (over == ShadesOver::Face) continue;
    parts.clear(), ranks.clear();
    if (over == ShadesOver::Bands && smooth) {
      all.off = std::max(all.off, bands.smooth(polygons[k], all.smooth[levels[k]]));
    } else if (over == ShadesOver::Bands) {
      bands.split(polygons[k], k, parts, ranks);
      all.off = std::max(all.off, bands.off());
    } else {
      all.off = std::max(all.off, splitIntoRuns(polygons[k], k, samples, tolerance, parts));
      if (parts.empty()) continue;
      polygons[k].color = mostOf(parts);
      std::erase_if(parts, [&](const FigurePolygon& part) { return part.color == polygons[k].color; });
    }
    ranks.resize(parts.size(), 0);
    for (const int rank : ranks) all.levels.push_back(levels[k] * kRanks + rank);
    std::ranges::move(parts, std::back_inserter(all.polygons));
  }
  return all;
}

}  // namespace xnewell
