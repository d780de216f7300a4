#include "shading/picture/surface_painter.h"

#include <algorithm>
#include <utility>

#include "depthsort/fragment_spans.h"
#include "geometry/exact/give_up.h"
#include "geometry/view/at_source.h"
#include "shading/fill/fill.h"
#include "shading/fill/gouraud.h"
#include "shading/fill/row_values.h"

namespace xnewell {

SurfacePainter::SurfacePainter(const Surfaces& surfaces, int channel, std::vector<Ramp> ramps,
                               std::span<const std::uint8_t> cells)
    : s_{surfaces},
      mesh_{s_.mesh},
      snapped_{s_.snapped},
      evaluator_{surfaces, channel},
      channel_{channel},
      ramps_{std::move(ramps)},
      cells_{cells} {
  if (s_.settings.shading == Shading::Gouraud) interpolateIntensity();
  if (s_.settings.shading != Shading::Environment) return;
  interpolateNormals();
  const std::vector<Environment>& environments = s_.shading.environments(channel_);
  for (std::size_t m = 0; m < environments.size(); ++m) {
    const CellOnRamp cellOf{ramps_[m]};
    const std::uint8_t mark = 0;  // no ramp has this cell
    const auto cellsOf = [&](const std::vector<float>& intensities) {
      std::vector<std::uint8_t> result(intensities.size());
      std::ranges::transform(intensities, result.begin(),
                             [&](float I) { return I > 1.0F ? mark : cellOf(I); });
      return result;
    };
    maps_.push_back({cellsOf(environments[m].front), cellsOf(environments[m].away), mark, cellOf(1.0)});
  }
}

void SurfacePainter::interpolateIntensity() {
  // First once for each vertex of the model, then for the vertices of the outlines.
  const bool cells = s_.settings.interpolated == Interpolated::Cell;
  const auto valueOf = [&](const Ramp& ramp, double of) {
    return cells ? ramp.cell(of) + 0.5 : ramp.value(of);  // of a cell, its middle
  };
  const ShadingPoints& points = s_.shading.points();
  const std::vector<FrontBack<double>>& I = s_.shading.intensities(channel_).I;
  std::vector<std::uint32_t> ofFront(I.size()), ofBack(I.size());
  for (std::size_t v = 0; v < I.size(); ++v) {
    const Ramp& ramp = ramps_[points.material[v] + 1];
    ofFront[v] = valueSteps(valueOf(ramp, I[v].front)), ofBack[v] = valueSteps(valueOf(ramp, I[v].back));
  }
  const std::vector<int>& vertexOf = s_.shading.vertices().ofCorner;
  const auto between = [&](const SnappedFace& face, int source) {
    const Ramp& ramp = ramps_[mesh_.material[face.number] + 1];
    const auto intensity = [&](int corner) { return I[vertexOf[corner]].seen(face.back); };
    const auto cell = [&](int corner) { return valueOf(ramp, intensity(corner)); };
    return valueSteps(cells ? atSource(snapped_, source, cell)
                            : ramp.value(atSource(snapped_, source, intensity)));
  };
  steps_.resize(snapped_.vertices.size());
  std::uint32_t* const steps = steps_.data();
  for (const SnappedFace& face : snapped_.faces) {
    const std::uint32_t* const ofVertex = (face.back ? ofBack : ofFront).data();
    for (int k = face.first; k < face.first + face.count; ++k) {
      const int source = snapped_.source[k];
      steps[k] = source >= 0 ? ofVertex[vertexOf[source]] : between(face, source);
    }
  }
}

void SurfacePainter::interpolateNormals() {
  const std::vector<int>& vertexOf = s_.shading.vertices().ofCorner;
  mapSteps_.resize(snapped_.vertices.size());
  for (const SnappedFace& face : snapped_.faces) {
    const double side = s_.side(face);
    for (int k = face.first; k < face.first + face.count; ++k) {
      const glm::dvec3 N = side * kMapScale * atSource(snapped_, snapped_.source[k], [&](int corner) {
                             return s_.shading.mapped(channel_)[vertexOf[corner]];
                           });
      mapSteps_[k] = {valueSteps(kMapCentre + N.x), valueSteps(kMapCentre + N.y),
                      valueSteps(kMapCentre + N.z)};
    }
  }
}

template <class Fill>
void SurfacePainter::gouraud(const SnappedFace& face, const Ramp& ramp, Fill&& fill) {
  const glm::ivec3* const outline = &snapped_.vertices[face.first];
  const auto shaded = [&] [[gnu::always_inline]] (const glm::ivec3* p, int count, const AffineValue& plane,
                                                  auto&& wrap) {
    if (ramp.table != nullptr && s_.settings.interpolated == Interpolated::Intensity)
      fill(p, count, wrap(GouraudTable{plane, &ramp.table->bySteps()}));
    else
      fill(p, count, wrap(GouraudLinear{plane}));
  };
  const auto asItIs = [](const auto& shader) { return shader; };
  if (face.count == 3) return shaded(outline, 3, AffineOver{outline}(&steps_[face.first]), asItIs);
  if (s_.settings.polygons == Polygons::Rows) {
    std::vector<double> v;
    for (int k = face.first; k < face.first + face.count; ++k) v.push_back(steps_[k] * 0x1p-24);
    const RowValues rows{outline, face.count, std::move(v)};
    return shaded(outline, face.count, {}, [&](const auto& shader) { return ByRows{rows, shader}; });
  }
  forEachTriangle(snapped_, face, [&](const FaceTriangle& t) {
    const std::array steps{steps_[t.vertex[0]], steps_[t.vertex[1]], steps_[t.vertex[2]]};
    shaded(t.p.data(), 3, AffineOver{t.p.data()}(steps.data()), asItIs);
  });
}

template <class Fill>
void SurfacePainter::environment(const SnappedFace& face, Fill&& fill) {
  constexpr std::uint32_t kZero = static_cast<std::uint32_t>(kMapCentre) << 24;
  const Maps& maps = maps_[mesh_.material[face.number] + 1];
  forEachTriangle(snapped_, face, [&](const FaceTriangle& t) {
    const MapSteps &a = mapSteps_[t.vertex[0]], &b = mapSteps_[t.vertex[1]], &c = mapSteps_[t.vertex[2]];
    const AffineOver over{t.p.data()};
    const auto atVertices = [&](std::uint32_t MapSteps::*of) { return std::array{a.*of, b.*of, c.*of}; };
    const std::array columns = atVertices(&MapSteps::column), rows = atVertices(&MapSteps::row);
    const AffineValue column = over(columns.data()), row = over(rows.data());
    const int facing = (a.facing >= kZero) + (b.facing >= kZero) + (c.facing >= kZero);
    const bool inFront = maps.away.empty() || facing > 0, inAway = !maps.away.empty() && facing < 3;
    const bool clamps =
        (inFront && maps.frontBox.meets(columns, rows)) || (inAway && maps.awayBox.meets(columns, rows));
    const auto filled = [&](const auto& shown) {
      if (clamps)
        fill(t.p.data(), 3, Counted{shown, maps.mark, maps.full, &clamped_});
      else
        fill(t.p.data(), 3, shown);
    };
    const EnvironmentMap front{column, row, maps.front.data()}, away{column, row, maps.away.data()};
    if (!inAway) return filled(front);
    if (!inFront) return filled(away);
    filled(EitherSide{front, away, over(atVertices(&MapSteps::facing).data())});
  });
}

template <class Fill>
void SurfacePainter::forEachShader(int f, Fill&& fill) {
  const SnappedFace& face = snapped_.faces[f];
  if (evaluator_.evaluates(face))
    evaluator_.forEachEvaluated(face, [&](const FaceTriangle& t, auto evaluated) {
      evaluated.ramp = ramps_[mesh_.material[face.number] + 1];
      evaluated.clamped = &clamped_;
      fill(t.p.data(), 3, evaluated);
    });
  else if (s_.settings.shading == Shading::Gouraud)
    gouraud(face, ramps_[mesh_.material[face.number] + 1], fill);
  else if (s_.settings.shading == Shading::Environment)
    environment(face, fill);
  else
    fill(&snapped_.vertices[face.first], face.count, FlatCell{cells_[f]});
}

void SurfacePainter::paint(IndexImage& image, const SortedScene& sorted, const Fragment& fragment) {
  forEachShader(fragment.face, [&]<class S>(const glm::ivec3* outline, int count, const S& shader) {
    if constexpr (Shader<S>)
      if (fragment.piece < 0) return fillConvex(image, outline, count, shader);
    forEachSpan(snapped_, sorted, fragment, outline, count, image.width, image.height,
                [&](int row, int from, int to) { shader.span(image.row(row) + from, from, row, to - from); });
  });
}

SurfacePainter::CellEnds SurfacePainter::cellEnds(int face, int width, int height) {
  CellEnds ends;
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(width));
  forEachShader(face, [&](const glm::ivec3* outline, int count, const auto& shader) {
    forEachSpan(outline, count, width, height, [&](int row, int from, int to) {
      shader.span(cells.data(), from, row, to - from);
      const auto [least, greatest] = std::ranges::minmax_element(cells.begin(), cells.begin() + (to - from));
      ends = {std::min<int>(ends.least, *least), std::max<int>(ends.greatest, *greatest)};
    });
  });
  return ends;
}

void SurfacePainter::paintVisible(IndexImage& image, const std::vector<int>& visible) {
  std::vector<bool> seen(snapped_.faces.size(), false);
  for (const int f : visible)
    if (f >= 0) seen[f] = true;
  for (int f = 0; f < static_cast<int>(seen.size()); ++f) {
    if (!seen[f]) continue;
    forEachShader(f, [&](const glm::ivec3* outline, int count, const auto& shader) {
      forEachSpan(outline, count, image.width, image.height, [&](int row, int from, int to) {
        const int* const at = visible.data() + std::ptrdiff_t(row) * image.width;
        for (int i = from; i < to;) {
          const int begin = i;
          while (i < to && at[i] == f) ++i;
          if (i > begin) shader.span(image.row(row) + begin, begin, row, i - begin);
          while (i < to && at[i] != f) ++i;
        }
      });
    });
  }
}

void SurfacePainter::paintAll(IndexImage& image, const SortedScene& sorted) {
  // In depth order, consecutive faces are scattered in memory. Fetch a face while those before it are filled.
  const std::vector<Fragment>& fragments = sorted.fragments;
  const std::size_t count = fragments.size();
  const auto ahead = [&](std::size_t k) -> const SnappedFace& {
    return snapped_.faces[fragments[std::min(k, count - 1)].face];
  };
  // Most faces need two cache lines of each array.
  const auto fetch = [](const auto* from, int items) {
    __builtin_prefetch(from);
    __builtin_prefetch(reinterpret_cast<const char*>(from + items) - 1);
  };
  GiveUpNowAndThen giveUp;
  for (std::size_t k = 0; k < count; ++k) {
    giveUp();
    fetch(&ahead(k + 16), 1);
    const SnappedFace& next = ahead(k + 8);
    fetch(&snapped_.vertices[next.first], 3);
    __builtin_prefetch(&mesh_.material[next.number]);
    if (!steps_.empty()) fetch(&steps_[next.first], 3);
    paint(image, sorted, fragments[k]);
  }
}

}  // namespace xnewell
