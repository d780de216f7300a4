#include "shading/surface_painter.h"

#include <algorithm>
#include <cmath>

#include "shading/at_source.h"
#include "shading/environment_map.h"
#include "shading/fill.h"
#include "shading/fragment_spans.h"
#include "shading/gouraud.h"
#include "shading/row_values.h"

namespace {

double component(const Sides<double>& sides, bool back) { return back ? sides.back : sides.front; }

}  // namespace

SurfacePainter::SurfacePainter(const Surfaces& surfaces) : s_{surfaces}, mesh_{s_.scene.mesh} {
  if (s_.settings.shading != Shading::Environment) return;
  const std::vector<Environment>& environments = s_.shading.environments(s_.channel);
  for (std::size_t m = 0; m < environments.size(); ++m) {
    const Ramp& ramp = s_.ramps[m];
    const auto cells = [&](const std::vector<float>& intensities) {
      std::vector<std::uint8_t> result(intensities.size());
      std::ranges::transform(intensities, result.begin(), [&](float I) { return ramp.cell(I); });
      return result;
    };
    maps_.push_back({cells(environments[m].front), cells(environments[m].away)});
  }
}

/// Along the viewing direction from the eye; 1 in a parallel view.
double SurfacePainter::depthOf(int source) const {
  if (s_.view.projection == Projection::Parallel) return 1.0;
  const glm::dmat3 rotation = vrcRotation(s_.view);
  return atSource(s_.snapped, source, [&](int corner) {
    return s_.view.prp.z - (rotation * (mesh_.points[mesh_.corners[corner]] - s_.view.vrp)).z;
  });
}

bool SurfacePainter::textured(const SnappedFace& face) const {
  const int material = mesh_.material[face.number];
  if (material < 0 || mesh_.materials[material].texture < 0 || mesh_.uvOfCorner.empty()) return false;
  const int *const first = mesh_.uvOfCorner.data() + mesh_.firstCorner[face.number],
                   *const end = mesh_.uvOfCorner.data() + mesh_.firstCorner[face.number + 1];
  return std::find(first, end, -1) == end;
}

bool SurfacePainter::evaluates(const SnappedFace& face) const {
  return rowOf(s_.settings.shading).lit && s_.settings.shading != Shading::Environment &&
         (s_.settings.shading == Shading::Phong || textured(face));
}

template <class Fill>
void SurfacePainter::gouraud(const SnappedFace& face, const Ramp& ramp, Fill&& fill) {
  const auto value = [&](int source) {
    return ramp.value(atSource(s_.snapped, source, [&](int corner) {
      return component(s_.shading.shades(s_.channel).I[s_.shading.vertices().ofCorner[corner]], face.back);
    }));
  };
  if (s_.settings.polygons == Polygons::Rows && face.count > 3) {
    std::vector<double> v;
    for (int k = face.first; k < face.first + face.count; ++k) v.push_back(value(s_.snapped.source[k]));
    const glm::ivec3* const outline = &s_.snapped.vertices[face.first];
    const RowValues rows{outline, face.count, std::move(v)};
    if (ramp.table != nullptr)
      fill(outline, face.count, ByRows<GouraudTable>{rows, {{}, ramp.table}});
    else
      fill(outline, face.count, ByRows<GouraudLinear>{rows, {}});
    return;
  }
  forEachTriangle(s_.snapped, face, [&](const FaceTriangle& t) {
    const AffineValue plane =
        affineOver(t.p.data(), {value(t.source[0]), value(t.source[1]), value(t.source[2])});
    if (ramp.table != nullptr)
      fill(t.p.data(), 3, GouraudTable{plane, ramp.table});
    else
      fill(t.p.data(), 3, GouraudLinear{plane});
  });
}

template <class Fill>
void SurfacePainter::environment(const SnappedFace& face, Fill&& fill) {
  const int material = mesh_.material[face.number] + 1;
  const double side = face.back && s_.shading.lighting().twoSided ? -1.0 : 1.0;
  forEachTriangle(s_.snapped, face, [&](const FaceTriangle& t) {
    std::array<glm::dvec3, 3> N;
    for (int k = 0; k < 3; ++k)
      N[k] = side * atSource(s_.snapped, t.source[k], [&](int corner) {
               return s_.shading.mapped()[s_.shading.vertices().ofCorner[corner]];
             });
    const AffineOver over{t.p.data()};
    const auto plane = [&](int axis) {
      return over({kMapCentre + kMapScale * N[0][axis], kMapCentre + kMapScale * N[1][axis],
                   kMapCentre + kMapScale * N[2][axis]});
    };
    const AffineValue column = plane(0), row = plane(1);
    const EnvironmentMap front{column, row, maps_[material].front.data()};
    const int facing = (N[0].z >= 0.0) + (N[1].z >= 0.0) + (N[2].z >= 0.0);
    if (maps_[material].away.empty() || facing == 3) return fill(t.p.data(), 3, front);
    const EnvironmentMap away{column, row, maps_[material].away.data()};
    if (facing == 0) return fill(t.p.data(), 3, away);
    fill(t.p.data(), 3, EitherSide{front, away, plane(2)});
  });
}

EvaluatedTriangle SurfacePainter::evaluated(const SnappedFace& face, const FaceTriangle& t) {
  EvaluatedTriangle e;
  const PixelPlanes planes{t.p};
  const auto plane = [&](const auto& ofCorner) {
    std::array<double, 3> v;
    for (int k = 0; k < 3; ++k) v[k] = atSource(s_.snapped, t.source[k], ofCorner);
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
    const double side = face.back && s_.shading.lighting().twoSided ? -1.0 : 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      e.N[axis] = plane([&](int corner) {
        return side * s_.shading.points().N[s_.shading.vertices().ofCorner[corner]][axis];
      });
      if (s_.shading.lighting().needsPlaces())
        e.at[axis] = plane([&](int corner) { return mesh_.points[mesh_.corners[corner]][axis]; });
    }
  } else if (s_.settings.shading == Shading::Gouraud) {
    const auto term = [&](const std::vector<Sides<double>>& terms) {
      return plane(
          [&](int corner) { return component(terms[s_.shading.vertices().ofCorner[corner]], face.back); });
    };
    e.diffuse = term(s_.shading.shades(s_.channel).diffuse);
    e.rest = term(s_.shading.shades(s_.channel).specular);
    e.rest.c += ambient;
  } else {
    e.diffuse.c = component(s_.shading.shades(s_.channel).diffuse[face.number], face.back);
    e.rest.c = ambient + component(s_.shading.shades(s_.channel).specular[face.number], face.back);
  }
  if (textured(face)) {
    e.texture = &s_.scene.textures[mesh_.materials[material - 1].texture];
    const bool rgb = s_.shading.lighting().channels == 3;
    e.texels = (rgb ? e.texture->channel[s_.channel] : e.texture->gray).data();
    addTexture(e, planes, t);
  }
  return e;
}

void SurfacePainter::addTexture(EvaluatedTriangle& e, const PixelPlanes& planes,
                                const FaceTriangle& t) const {
  std::array<double, 3> u, v, q;
  for (int k = 0; k < 3; ++k) {
    const auto at =
        atSource(s_.snapped, t.source[k], [&](int corner) { return mesh_.uv[mesh_.uvOfCorner[corner]]; });
    u[k] = at.x, v[k] = at.y;
    q[k] = s_.settings.mapping == TextureMapping::Perspective ? 1.0 / depthOf(t.source[k]) : 1.0;
  }
  // Textures repeat: the nearest copy keeps numbers small.
  for (std::array<double, 3>* w : {&u, &v}) {
    const double whole = std::floor(std::min({(*w)[0], (*w)[1], (*w)[2]}));
    for (int k = 0; k < 3; ++k) (*w)[k] = ((*w)[k] - whole) * q[k];
  }
  e.u = planes(u), e.v = planes(v), e.q = planes(q);
}

template <class Fill>
void SurfacePainter::shade(int f, Fill&& fill) {
  const SnappedFace& face = s_.snapped.faces[f];
  if (evaluates(face))
    forEachTriangle(s_.snapped, face,
                    [&](const FaceTriangle& t) { fill(t.p.data(), 3, evaluated(face, t)); });
  else if (s_.settings.shading == Shading::Gouraud)
    gouraud(face, s_.ramps[mesh_.material[face.number] + 1], fill);
  else if (s_.settings.shading == Shading::Environment)
    environment(face, fill);
  else
    fill(&s_.snapped.vertices[face.first], face.count, FlatCell{s_.cells[f]});
}

void SurfacePainter::paint(IndexImage& image, const Fragment& fragment) {
  shade(fragment.face, [&]<class S>(const glm::ivec3* outline, int count, const S& shader) {
    if constexpr (Shader<S>)
      if (fragment.piece < 0) return fillConvex(image, outline, count, shader);
    forEachSpan(s_.snapped, s_.sorted, fragment, outline, count, image.width, image.height,
                [&](int row, int from, int to) { shader.span(image.row(row) + from, from, row, to - from); });
  });
}

void SurfacePainter::paintVisible(IndexImage& image) {
  std::vector<bool> seen(s_.snapped.faces.size(), false);
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
    return s_.snapped.faces[fragments[std::min(k, count - 1)].face];
  };
  for (std::size_t k = 0; k < count; ++k) {
    __builtin_prefetch(&ahead(k + 16));
    __builtin_prefetch(&s_.snapped.vertices[ahead(k + 8).first]);
    paint(image, fragments[k]);
  }
}
