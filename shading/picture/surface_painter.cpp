#include "shading/picture/surface_painter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "shading/fill/fill.h"
#include "shading/fill/fragment_spans.h"
#include "shading/fill/gouraud.h"
#include "shading/fill/row_values.h"
#include "shading/picture/at_source.h"

namespace xnewell {

namespace {

double component(const FrontBack<double>& sides, bool back) { return back ? sides.back : sides.front; }

}  // namespace

SurfacePainter::SurfacePainter(const Surfaces& surfaces)
    : s_{surfaces},
      mesh_{s_.mesh},
      snapped_{s_.snapped},
      towardsViewer_{glm::transpose(vrcRotation(s_.view))[2]} {
  if (s_.settings.shading == Shading::Gouraud) interpolateIntensity();
  if (s_.settings.shading != Shading::Environment) return;
  interpolateNormals();
  const std::vector<Environment>& environments = s_.shading.environments(s_.channel);
  for (std::size_t m = 0; m < environments.size(); ++m) {
    const Ramp& ramp = s_.ramps[m];
    const auto mark =
        static_cast<std::uint8_t>(ramp.first > 0 ? ramp.first - 1 : ramp.shades);  // not its own
    const auto cells = [&](const std::vector<float>& intensities) {
      std::vector<std::uint8_t> result(intensities.size());
      std::ranges::transform(intensities, result.begin(),
                             [&](float I) { return I > 1.0F ? mark : ramp.cell(I); });
      return result;
    };
    maps_.push_back({cells(environments[m].front), cells(environments[m].away), mark, ramp.cell(1.0)});
  }
}

std::array<double, 3> SurfacePainter::overDepths(const FaceTriangle& t) const {
  if (s_.view.projection == Projection::Parallel || s_.settings.mapping == TextureMapping::Affine)
    return {1.0, 1.0, 1.0};
  std::array<double, 3> depth;
  for (int k = 0; k < 3; ++k)
    depth[k] = atSource(snapped_, snapped_.source[t.vertex[k]], [&](int corner) {
      return s_.view.prp.z - glm::dot(towardsViewer_, mesh_.points[mesh_.corners[corner]] - s_.view.vrp);
    });
  const double least = std::min({depth[0], depth[1], depth[2]});  // so that units do not matter
  return {least / depth[0], least / depth[1], least / depth[2]};
}

bool SurfacePainter::textured(const SnappedFace& face) const {
  if (s_.scene.textures.empty()) return false;
  const int material = mesh_.material[face.number];
  if (material < 0 || mesh_.materials[material].texture < 0 || mesh_.uvOfCorner.empty()) return false;
  const int *const first = mesh_.uvOfCorner.data() + mesh_.firstCorner[face.number],
                   *const end = mesh_.uvOfCorner.data() + mesh_.firstCorner[face.number + 1];
  return std::find(first, end, -1) == end;
}

void SurfacePainter::interpolateIntensity() {
  // Once for a vertex of the model, then for those of outlines.
  const ShadingPoints& points = s_.shading.points();
  const std::vector<FrontBack<double>>& I = s_.shading.intensities(s_.channel).I;
  std::vector<std::uint32_t> ofFront(I.size()), ofBack(I.size());
  for (std::size_t v = 0; v < I.size(); ++v) {
    const Ramp& ramp = s_.ramps[points.material[v] + 1];
    ofFront[v] = valueSteps(ramp.value(I[v].front)), ofBack[v] = valueSteps(ramp.value(I[v].back));
  }
  const std::vector<int>& vertexOf = s_.shading.vertices().ofCorner;
  const auto between = [&](const SnappedFace& face, int source) {
    const double value =
        atSource(snapped_, source, [&](int corner) { return component(I[vertexOf[corner]], face.back); });
    return valueSteps(s_.ramps[mesh_.material[face.number] + 1].value(value));
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
    const double side = face.back && s_.shading.lighting().twoSided ? -1.0 : 1.0;
    for (int k = face.first; k < face.first + face.count; ++k) {
      const glm::dvec3 N = side * kMapScale * atSource(snapped_, snapped_.source[k], [&](int corner) {
                             return s_.shading.mapped()[vertexOf[corner]];
                           });
      mapSteps_[k] = {valueSteps(kMapCentre + N.x), valueSteps(kMapCentre + N.y),
                      valueSteps(kMapCentre + N.z)};
    }
  }
}

bool SurfacePainter::evaluates(const SnappedFace& face) const {
  return rowOf(s_.settings.shading).lit && s_.settings.shading != Shading::Environment &&
         (s_.settings.shading == Shading::Phong || textured(face));
}

template <class Fill>
void SurfacePainter::gouraud(const SnappedFace& face, const Ramp& ramp, Fill&& fill) {
  const glm::ivec3* const outline = &snapped_.vertices[face.first];
  const auto shaded = [&] [[gnu::always_inline]] (const glm::ivec3* p, int count, const AffineValue& plane,
                                                  auto&& wrap) {
    if (ramp.table != nullptr)
      fill(p, count, wrap(GouraudTable{plane, ramp.table}));
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

EvaluatedTriangle SurfacePainter::evaluated(const SnappedFace& face, const FaceTriangle& t) {
  EvaluatedTriangle e;
  const PixelPlanes planes{t.p};
  const std::array<double, 3> one{1.0, 1.0, 1.0};
  const std::array<double, 3> q =
      s_.settings.shading == Shading::Phong || textured(face) ? overDepths(t) : one;
  e.q = planes(q);
  const auto plane = [&](const std::array<double, 3>& over, const auto& ofCorner) {
    std::array<double, 3> v;
    for (int k = 0; k < 3; ++k) v[k] = over[k] * atSource(snapped_, snapped_.source[t.vertex[k]], ofCorner);
    return planes(v);
  };
  const int material = mesh_.material[face.number] + 1;
  e.i0 = planes.i0(), e.j0 = planes.j0();
  e.lighting = &s_.shading.lighting();
  e.material = &s_.shading.lighting().materials[material];
  e.channel = s_.channel;
  e.ramp = s_.ramps[material];
  e.clamped = &clamped_;
  const double ambient = e.material->ambient[s_.channel];
  if (s_.settings.shading == Shading::Phong) {
    e.phong = true;
    e.placed = e.lighting->placed();
    e.variesV = e.lighting->variesV();
    const double side = face.back && s_.shading.lighting().twoSided ? -1.0 : 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      e.N[axis] = plane(q, [&](int corner) {
        return side * s_.shading.points().N[s_.shading.vertices().ofCorner[corner]][axis];
      });
      const auto at = [&](int corner) { return mesh_.points[mesh_.corners[corner]][axis]; };
      if (e.placed) e.at[axis] = plane(q, at);
      if (e.variesV) e.V[axis] = plane(q, [&](int corner) { return e.lighting->eye[axis] - at(corner); });
    }
  } else if (s_.settings.shading == Shading::Gouraud) {
    const auto term = [&](const std::vector<FrontBack<double>>& terms) {
      return plane(one, [&](int corner) {
        return component(terms[s_.shading.vertices().ofCorner[corner]], face.back);
      });
    };
    e.diffuse = term(s_.shading.diffuse(s_.channel));
    e.rest = term(s_.shading.specular(s_.channel));
    e.rest.c += ambient;
  } else {
    const int point = s_.shading.pointOf(face);
    e.diffuse.c = component(s_.shading.diffuse(s_.channel)[point], face.back);
    e.rest.c = ambient + component(s_.shading.specular(s_.channel)[point], face.back);
  }
  if (textured(face)) {
    e.texture = &s_.scene.textures[mesh_.materials[material - 1].texture];
    const bool rgb = s_.shading.lighting().channels == 3;
    e.texels = (rgb ? e.texture->channel[s_.channel] : e.texture->gray).data();
    // Textures repeat: the nearest copy keeps numbers small.
    e.repeats = false;
    for (int axis = 0; axis < 2; ++axis) {
      const auto coordinate = [&](int corner) { return mesh_.uv[mesh_.uvOfCorner[corner]][axis]; };
      const auto at = [&](int k) { return atSource(snapped_, snapped_.source[t.vertex[k]], coordinate); };
      const auto [least, most] = std::minmax({at(0), at(1), at(2)});
      const double copy = std::floor(least);
      e.repeats = e.repeats || most - copy > 1.0;
      (axis == 0 ? e.u : e.v) = plane(q, [&](int corner) { return coordinate(corner) - copy; });
    }
  }
  return e;
}

template <class Fill>
void SurfacePainter::shade(int f, Fill&& fill) {
  const SnappedFace& face = snapped_.faces[f];
  if (evaluates(face))
    forEachTriangle(snapped_, face, [&](const FaceTriangle& t) { fill(t.p.data(), 3, evaluated(face, t)); });
  else if (s_.settings.shading == Shading::Gouraud)
    gouraud(face, s_.ramps[mesh_.material[face.number] + 1], fill);
  else if (s_.settings.shading == Shading::Environment)
    environment(face, fill);
  else
    fill(&snapped_.vertices[face.first], face.count, FlatCell{s_.cells[f]});
}

void SurfacePainter::paint(IndexImage& image, const Fragment& fragment) {
  shade(fragment.face, [&]<class S>(const glm::ivec3* outline, int count, const S& shader) {
    if constexpr (Shader<S>)
      if (fragment.piece < 0) return fillConvex(image, outline, count, shader);
    forEachSpan(snapped_, s_.sorted, fragment, outline, count, image.width, image.height,
                [&](int row, int from, int to) { shader.span(image.row(row) + from, from, row, to - from); });
  });
}

SurfacePainter::CellEnds SurfacePainter::cellEnds(int face) {
  CellEnds ends;
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(s_.width));
  shade(face, [&](const glm::ivec3* outline, int count, const auto& shader) {
    forEachSpan(outline, count, s_.width, s_.height, [&](int row, int from, int to) {
      shader.span(cells.data(), from, row, to - from);
      const auto [least, greatest] = std::ranges::minmax_element(cells.begin(), cells.begin() + (to - from));
      ends = {std::min<int>(ends.least, *least), std::max<int>(ends.greatest, *greatest)};
    });
  });
  return ends;
}

void SurfacePainter::paintVisible(IndexImage& image) {
  std::vector<bool> seen(snapped_.faces.size(), false);
  for (const int f : s_.visible)
    if (f >= 0) seen[f] = true;
  for (int f = 0; f < static_cast<int>(seen.size()); ++f) {
    if (!seen[f]) continue;
    shade(f, [&](const glm::ivec3* outline, int count, const auto& shader) {
      forEachSpan(outline, count, image.width, image.height, [&](int row, int from, int to) {
        const int* const at = s_.visible.data() + std::ptrdiff_t(row) * image.width;
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

void SurfacePainter::paintAll(IndexImage& image) {
  if (!s_.visible.empty()) return paintVisible(image);
  // In depth order each face lies elsewhere in memory: fetch it while those before it are filled.
  const std::vector<Fragment>& fragments = s_.sorted.fragments;
  const std::size_t count = fragments.size();
  const auto ahead = [&](std::size_t k) -> const SnappedFace& {
    return snapped_.faces[fragments[std::min(k, count - 1)].face];
  };
  // Most need two lines of each array.
  const auto fetch = [](const auto* from, int items) {
    __builtin_prefetch(from);
    __builtin_prefetch(reinterpret_cast<const char*>(from + items) - 1);
  };
  for (std::size_t k = 0; k < count; ++k) {
    fetch(&ahead(k + 16), 1);
    const SnappedFace& next = ahead(k + 8);
    fetch(&snapped_.vertices[next.first], 3);
    __builtin_prefetch(&mesh_.material[next.number]);
    if (!steps_.empty()) fetch(&steps_[next.first], 3);
    paint(image, fragments[k]);
  }
}

}  // namespace xnewell
