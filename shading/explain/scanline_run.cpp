#include "shading/explain/scanline_run.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact/scale.h"
#include "shading/explain/pixel_history.h"
#include "shading/explain/term_values.h"
#include "shading/fill/row_values.h"

namespace xnewell {

namespace {

/// The rows and columns that the picture has.
std::vector<ScanSpan> inPicture(std::vector<ScanSpan> spans, const PictureSettings& settings) {
  for (ScanSpan& span : spans)
    span.from = std::max(0, span.from), span.to = std::min(settings.width, span.to);
  std::erase_if(spans, [&](const ScanSpan& span) {
    return span.row < 0 || span.row >= settings.height || span.from >= span.to;
  });
  return spans;
}

}  // namespace

ScanlineRun::ScanlineRun(const Picture& picture, int face, int bits)
    : picture_{picture},
      s_{picture.surfaces()},
      face_{face},
      bits_{bits},
      ramp_{picture.colors().ramps()[s_.mesh.material[s_.snapped.faces[face].number] + 1]},
      equations_{s_} {
  const SnappedFace& f = s_.snapped.faces[face];
  const OnFace on{s_, f};
  textured_ = on.isTextured();
  const Shading method = s_.settings.shading;
  if (!rowOf(method).interpolates && !textured_)
    kind_ = Kind::Constant;
  else if (method == Shading::Gouraud && !textured_)
    kind_ = on.byRows() ? Kind::Rows : Kind::Values;
  else if (method == Shading::Phong && !textured_ && !on.onlyAmbient())
    kind_ = Kind::Normals;
  addParts();
  std::int64_t count = 0;
  for (const ScanPart& part : parts_)
    for (const ScanSpan& span : part.spans) count += span.to - span.from;
  tooLarge_ = count > kMostSamples;
  if (tooLarge_) return;
  PixelExplainer explain{picture_};
  for (int k = 0; k < static_cast<int>(parts_.size()); ++k) addQuantities(explain, k);
  addSamples(explain);
  mark();
}

void ScanlineRun::addParts() {
  const SnappedFace& face = s_.snapped.faces[face_];
  const auto add = [&](ScanPart part) {
    part.edges = edgesOf(part.outline);
    part.spans = inPicture(spansOf(part.edges), s_.settings);
    parts_.push_back(std::move(part));
  };
  if (kind_ == Kind::Constant || kind_ == Kind::Rows) {
    ScanPart whole;
    for (int k = face.first; k < face.first + face.count; ++k)
      whole.vertex.push_back(k), whole.outline.push_back(s_.snapped.vertices[k]);
    return add(std::move(whole));
  }
  forEachTriangle(s_.snapped, face, [&](const FaceTriangle& t) {
    add({{t.vertex.begin(), t.vertex.end()}, {t.p.begin(), t.p.end()}, {}, {}});
  });
}

void ScanlineRun::addQuantities(PixelExplainer& explain, int k) {
  const ScanPart& part = parts_[static_cast<std::size_t>(k)];
  std::vector<ScanQuantity>& all = quantities_.emplace_back();
  const auto add = [&](std::string_view name, const auto& atVertex) {
    ScanQuantity& quantity = all.emplace_back(ScanQuantity{name, {}});
    for (std::size_t v = 0; v < part.vertex.size(); ++v) quantity.atVertex.push_back(atVertex(v));
  };
  const auto corners = [](const ScanQuantity& q) {
    return std::array{q.atVertex[0], q.atVertex[1], q.atVertex[2]};
  };
  planes_.emplace_back(), normals_.emplace_back();
  if (kind_ == Kind::Constant) return;
  if (stepsValues()) {
    std::vector<double> I(part.vertex.size(), 0.0);
    if (!part.spans.empty()) {
      const Explanation e = explain(face_, part.spans.front().from, part.spans.front().row);
      for (std::size_t v = 0; v < I.size(); ++v) {
        const ByChannel& at = e.vertices[v].I;
        I[v] = e.luminance ? luminance({at[0], at[1], at[2]}) : at[0];
      }
    }
    add("I", [&](std::size_t v) { return I[v]; });
    add("value", [&](std::size_t v) { return gouraudValueAt(picture_, face_, 0, part.vertex[v]); });
    if (kind_ == Kind::Values)
      planes_.back() =
          steppedOver({part.outline[0], part.outline[1], part.outline[2]}, corners(all.back()), bits_);
    return;
  }
  OnFace on{s_, s_.snapped.faces[face_]};
  const FaceTriangle t{{part.outline[0], part.outline[1], part.outline[2]},
                       {part.vertex[0], part.vertex[1], part.vertex[2]}};
  const std::array<double, 3> q = SurfaceEvaluator{s_, 0}.overDepths(t);
  if (textured_) {
    const auto uv = [&](std::size_t v) {
      return on.atVertex(part.vertex[v], [&](int corner) { return s_.mesh.uv[s_.mesh.uvOfCorner[corner]]; });
    };
    add("u/w", [&](std::size_t v) { return q[v] * uv(v).x; });
    add("v/w", [&](std::size_t v) { return q[v] * uv(v).y; });
    add("1/w", [&](std::size_t v) { return q[v]; });
  } else if (kind_ == Kind::Normals) {
    const bool kept = keepsLengthOfN(s_.settings);
    for (int axis = 0; axis < 3; ++axis) {
      constexpr std::array<std::string_view, 3> kNames{"Nx/w", "Ny/w", "Nz/w"};
      add(kept ? kNames[axis].substr(0, 2) : kNames[axis], [&](std::size_t v) {
        const glm::dvec3 N = on.atVertex(part.vertex[v], [&](int corner) { return on.normalOf(corner); });
        return (kept ? 1.0 : q[v]) * N[axis];
      });
      normals_.back()[static_cast<std::size_t>(axis)] = steppedOver(t.p, corners(all.back()), bits_);
    }
  } else if (s_.settings.shading == Shading::Environment) {
    add("column", [&](std::size_t v) { return mapPlaceAt(picture_, face_, 0, part.vertex[v]).x; });
    add("row", [&](std::size_t v) { return mapPlaceAt(picture_, face_, 0, part.vertex[v]).y; });
  }
}

std::uint8_t ScanlineRun::cellOf(double value) const {
  const double counts = std::clamp(value, kLeastValue, kLargestValue);
  const bool table = ramp_.table != nullptr && s_.settings.interpolated == Interpolated::Intensity;
  return table ? ramp_.table->bySteps()(static_cast<std::uint32_t>(counts * 0x1p24))
               : static_cast<std::uint8_t>(counts);
}

ScanSample ScanlineRun::stepped(int part, int i, int j) const {
  const SteppedPlane& plane = planes_[static_cast<std::size_t>(part)];
  const ScanPart& p = parts_[static_cast<std::size_t>(part)];
  const std::vector<double>& v = quantities_[static_cast<std::size_t>(part)].back().atVertex;
  ScanSample sample;
  sample.stepped = plane.number(plane.at(i, j));
  sample.direct = interpolated(weightsOnScreen({p.outline[0], p.outline[1], p.outline[2]}, i, j),
                               std::array{v[0], v[1], v[2]});
  return sample;
}

ScanSample ScanlineRun::byRows(int part, int i, int j) const {
  const SnappedFace& face = s_.snapped.faces[face_];
  const std::vector<double>& v = quantities_[static_cast<std::size_t>(part)].back().atVertex;
  const int cutOff = 24 - bits_;
  ScanSample sample;
  sample.direct = alongRow(s_.snapped, face, v, i, j);
  // The picture has 24 bits for the row's first value and its increment; fewer are cut off.
  std::vector<double> rounded;
  for (const double value : v) rounded.push_back(valueSteps(value) * 0x1p-24);
  const AffineValue row =
      RowValues{&s_.snapped.vertices[face.first], face.count, std::move(rounded)}.along(j);
  const std::int64_t c = static_cast<std::int32_t>(row.c) >> cutOff,
                     gx = static_cast<std::int32_t>(row.gx) >> cutOff;
  const auto steps = static_cast<std::uint32_t>((c + gx * i) * (std::int64_t{1} << cutOff));
  sample.stepped = steps * 0x1p-24;
  return sample;
}

ScanSample ScanlineRun::sampled(const Explanation& e) const {
  return {.stepped = ramp_.value(e.inLoop),
          .direct = ramp_.value(e.intensity),
          .steppedCell = static_cast<std::uint8_t>(e.value[0]),
          .directCell = ramp_.cell(e.intensity)};
}

double ScanlineRun::ofSteppedNormal(int part, const Explanation& e) {
  glm::dvec3 N{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const SteppedPlane& plane = normals_[static_cast<std::size_t>(part)][static_cast<std::size_t>(axis)];
    N[axis] = plane.number(plane.at(e.i, e.j));
  }
  if (!keepsLengthOfN(s_.settings)) N = unit(N);
  ByChannel I = equations_(s_.snapped.faces[face_].number)(e.equations.front().P, N).I;
  for (double& one : I) one = std::clamp(one, 0.0, 1.0);
  return e.luminance ? luminance({I[0], I[1], I[2]}) : I[0];
}

void ScanlineRun::addSamples(PixelExplainer& explain) {
  std::optional<ScanSample> everywhere;
  for (int k = 0; k < static_cast<int>(parts_.size()); ++k) {
    const std::vector<ScanSpan>& spans = parts_[static_cast<std::size_t>(k)].spans;
    for (int s = 0; s < static_cast<int>(spans.size()); ++s)
      for (int i = spans[static_cast<std::size_t>(s)].from; i < spans[static_cast<std::size_t>(s)].to; ++i) {
        const int j = spans[static_cast<std::size_t>(s)].row;
        ScanSample sample;
        if (stepsValues()) {
          sample = kind_ == Kind::Values ? stepped(k, i, j) : byRows(k, i, j);
          sample.steppedCell = cellOf(sample.stepped), sample.directCell = cellOf(sample.direct);
        } else if (everywhere) {
          sample = *everywhere;
        } else {
          const Explanation e = explain(face_, i, j);
          sample = sampled(e);
          if (kind_ == Kind::Constant) everywhere = sample;
          if (kind_ == Kind::Normals && bits_ < 24) {
            const double I = ofSteppedNormal(k, e);
            sample.stepped = ramp_.value(I), sample.steppedCell = ramp_.cell(I);
          }
        }
        sample.part = k, sample.span = s, sample.column = i;
        samples_.push_back(sample);
      }
  }
}

void ScanlineRun::mark() {
  const auto add = [&](ScanMark kind, int step) { marks_[static_cast<std::size_t>(kind)].push_back(step); };
  const ScanSample* before = nullptr;
  for (int k = 0; k < steps(); ++k) {
    const ScanSample& now = samples_[static_cast<std::size_t>(k)];
    const int step = k + 1;
    add(ScanMark::Pixel, step);
    const bool samePart = before && before->part == now.part, sameRow = samePart && before->span == now.span;
    if (!sameRow) {
      add(ScanMark::Row, step);
      const ScanSpan& span = spanOf(now);
      if (!samePart || spanOf(*before).left != span.left || spanOf(*before).right != span.right)
        add(ScanMark::Edge, step);
    } else if (before->steppedCell != now.steppedCell) {
      add(ScanMark::Shade, step);
    }
    if (now.steppedCell != now.directCell) add(ScanMark::Differs, step);
    mostDrift_ = std::max(mostDrift_, std::abs(now.stepped - now.direct));
    before = &now;
  }
}

double ScanlineRun::onEdge(int part, int edge, int row, const ScanQuantity& quantity) const {
  const ScanEdge& e = parts_[static_cast<std::size_t>(part)].edges[static_cast<std::size_t>(edge)];
  const std::vector<glm::ivec3>& p = parts_[static_cast<std::size_t>(part)].outline;
  const double y = (row + 0.5) * kGrid, from = p[static_cast<std::size_t>(e.from)].y,
               to = p[static_cast<std::size_t>(e.to)].y;
  const double a = quantity.atVertex[static_cast<std::size_t>(e.from)],
               b = quantity.atVertex[static_cast<std::size_t>(e.to)];
  return a + (y - from) / (to - from) * (b - a);
}

ScanlineRun::TexturePlaces ScanlineRun::texturePlaces(const ScanSample& sample) const {
  const auto at = [&](TextureMapping mapping) {
    PictureSettings settings = s_.settings;
    settings.mapping = mapping;
    const Surfaces surfaces{s_.scene, s_.mesh, s_.snapped, s_.view, settings, s_.shading};
    OnFace on{surfaces, s_.snapped.faces[face_]};
    on.moveTo(sample.column, spanOf(sample).row);
    const ExplainedTexel texel = on.texel(1);
    return glm::dvec2{texel.u, texel.v};
  };
  return {at(TextureMapping::Affine), at(TextureMapping::Perspective)};
}

double ScanlineRun::at(const ScanSample& sample, const ScanQuantity& quantity) const {
  const std::vector<glm::ivec3>& p = parts_[static_cast<std::size_t>(sample.part)].outline;
  const std::vector<double>& v = quantity.atVertex;
  const int i = sample.column, j = spanOf(sample).row;
  if (p.size() > 3) return alongRow(s_.snapped, s_.snapped.faces[face_], v, i, j);
  return interpolated(weightsOnScreen({p[0], p[1], p[2]}, i, j), std::array{v[0], v[1], v[2]});
}

ScanlineRun::ByTriangles ScanlineRun::byTriangles(const ScanSample& sample) const {
  const int i = sample.column, j = spanOf(sample).row;
  const FaceTriangle t = triangleAt(s_.snapped, s_.snapped.faces[face_], i, j);
  std::array<double, 3> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = gouraudValueAt(picture_, face_, 0, t.vertex[k]);
  const SteppedPlane plane = steppedOver(t.p, v, bits_);
  const double value = plane.number(plane.at(i, j));
  return {value, cellOf(value)};
}

Explanation ScanlineRun::explained(const ScanSample& sample) const {
  return PixelExplainer{picture_}(face_, sample.column, spanOf(sample).row);
}

}  // namespace xnewell
