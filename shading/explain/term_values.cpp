#include "shading/explain/term_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "depthsort/oracle.h"
#include "geometry/exact/scale.h"
#include "geometry/view/at_source.h"
#include "shading/explain/pixel_history.h"
#include "shading/fill/affine.h"
#include "shading/fill/lanes.h"
#include "shading/fill/row_values.h"

namespace xnewell {

std::vector<double> roundedTerms(const std::vector<double>& terms, int decimals) {
  const double unit = power(10.0, decimals);
  std::vector<double> whole;
  for (const double term : terms) whole.push_back(std::floor(term * unit));
  const double sum = std::floor(std::accumulate(terms.begin(), terms.end(), 0.0) * unit + 0.5);
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return terms[k] * unit - whole[k]; });
  double missing = sum - std::accumulate(whole.begin(), whole.end(), 0.0);
  for (const std::size_t k : order)
    if (missing-- > 0.0) ++whole[k];
  for (double& value : whole) value /= unit;
  return whole;
}

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The values of one face.
class ValuesOnFace {
 public:
  ValuesOnFace(const Picture& picture, EquationOf& equations, int face, Term term)
      : s_{picture.surfaces()},
        on_{s_, s_.snapped.faces[face]},
        equation_{equations(on_.face().number)},
        term_{term},
        channels_{s_.shading.lighting().channels} {
    if (s_.settings.shading == Shading::Gouraud) evaluateAtVertices();
    if (s_.settings.shading == Shading::Flat && !textured())
      everywhere_ = of(equation_(on_.centroid().P, on_.centroid().N));
  }

  [[nodiscard]] double at(int i, int j) {
    const Shading method = s_.settings.shading;
    if (method == Shading::Flat && !textured()) return everywhere_;
    on_.moveTo(i, j);
    const ByChannel texel = textured() ? on_.texel(channels_).share : ByChannel{1, 1, 1};
    if (method == Shading::Flat) return of(equation_(on_.centroid().P, on_.centroid().N, texel));
    if (method == Shading::Phong) return of(equation_(on_.place(), on_.normal(), texel));
    ByChannel here{};
    for (int c = 0; c < channelsHere(); ++c)
      here[c] = (textured() ? texel[c] : 1.0) * on_.valueHere([&](std::size_t k) {
        return atVertices_[static_cast<std::size_t>(on_.vertices()[k] - on_.face().first)][c];
      });
    return channelsHere() == 3 ? luminance({here[0], here[1], here[2]}) : here[0];
  }

 private:
  /// Only the diffuse term has the texel.
  [[nodiscard]] bool textured() const { return term_ == Term::Diffuse && on_.isTextured(); }
  /// The texel has three channels, so the luminance is taken after it.
  [[nodiscard]] int channelsHere() const { return textured() ? channels_ : 1; }
  [[nodiscard]] double of(const ExplainedEquation& at) const { return valueOf(at, term_, channels_); }

  void evaluateAtVertices() {
    for (int k = 0; k < on_.face().count; ++k) {
      ByChannel v{};
      for (int c = 0; c < channelsHere(); ++c)
        v[c] = on_.atVertex(on_.face().first + k, [&](int corner) {
          const ExplainedEquation at = equation_(on_.placeOf(corner), on_.normalOf(corner));
          return textured() ? at.diffuse(c) : of(at);
        });
      atVertices_.push_back(v);
    }
  }

  Surfaces s_;
  OnFace on_;
  const EquationAt& equation_;
  Term term_;
  int channels_;
  double everywhere_ = kNoValue;
  std::vector<ByChannel> atVertices_;
};

}  // namespace

std::string_view cosineName(Form form) {
  return form == Form::Textbook ? "R.V" : form == Form::HalfVector ? "N.H" : "N.L";
}

double valueOf(const ExplainedEquation& at, Term term, int channels) {
  if (rowOf(term).isCosine) {
    if (at.lights.empty()) return kNoValue;
    return term == Term::NdotL ? at.lights.front().NdotL : at.lights.front().cosine;
  }
  const auto inChannel = [&](int c) {
    return term == Term::Ambient ? at.ambient[c] : term == Term::Diffuse ? at.diffuse(c) : at.specular(c);
  };
  return channels == 3 ? luminance({inChannel(0), inChannel(1), inChannel(2)}) : inChannel(0);
}

bool hasTerms(const PictureSettings& settings) {
  return rowOf(settings.shading).lit && settings.shading != Shading::Environment;
}

std::vector<double> termValues(const Picture& picture, const SeenRows& seen, Term term) {
  std::vector<double> values(seen.faces.size(), kNoValue);
  std::vector<std::size_t> samples(seen.faces.size());  // those of each face together
  std::iota(samples.begin(), samples.end(), std::size_t{0});
  std::erase_if(samples, [&](std::size_t k) { return seen.faces[k] == kNothing; });
  std::ranges::stable_sort(samples, {}, [&](std::size_t k) { return seen.faces[k]; });
  EquationOf equations{picture.surfaces()};
  for (std::size_t k = 0; k < samples.size();) {
    const int face = seen.faces[samples[k]];
    ValuesOnFace onFace{picture, equations, face, term};
    for (; k < samples.size() && seen.faces[samples[k]] == face; ++k)
      values[samples[k]] = onFace.at(static_cast<int>(samples[k]) % seen.width,
                                     seen.firstRow + static_cast<int>(samples[k]) / seen.width);
  }
  return values;
}

namespace {

bool owns(const glm::ivec3* outline, int count, int i, int j) {
  bool owned = false;
  forEachSpan(outline, count, j, i + 1, j + 1, [&](int, int from, int to) { owned = from <= i && i < to; });
  return owned;
}

class Loop {
 public:
  Loop(const Picture& picture, int face, int channel, int i, int j)
      : picture_{picture},
        s_{picture.surfaces()},
        face_{s_.snapped.faces[face]},
        channel_{channel},
        i_{i},
        j_{j},
        ramp_{picture.colors().ramps()[s_.mesh.material[face_.number] + 1]},
        evaluator_{s_, channel} {}

  Loop(const Picture& picture, int face, int channel) : Loop{picture, face, channel, 0, 0} {}

  [[nodiscard]] double gouraudValueAt(int vertex) const {
    const std::vector<int>& vertexOf = s_.shading.vertices().ofCorner;
    const auto intensity = [&](int corner) {
      return s_.shading.intensities(channel_).I[vertexOf[corner]].seen(face_.back);
    };
    const auto cell = [&](int corner) { return ramp_.cell(intensity(corner)) + 0.5; };
    const int source = s_.snapped.source[vertex];
    return s_.settings.interpolated == Interpolated::Cell
               ? atSource(s_.snapped, source, cell)
               : ramp_.value(atSource(s_.snapped, source, intensity));
  }
  [[nodiscard]] glm::dvec3 mapPlaceAt(int vertex) const {
    return kMapCentre +
           s_.side(face_) * kMapScale * atSource(s_.snapped, s_.snapped.source[vertex], [&](int corner) {
             return s_.shading.mapped(channel_)[s_.shading.vertices().ofCorner[corner]];
           });
  }

  [[nodiscard]] LoopValue value() const {
    LoopValue value = asInLoop();
    const SceneColors& colors = picture_.colors();
    if (channelsOf(colors.plan()) == Channels::Rgb) return value;
    // The loop may round an intensity that is as near as that to another shade.
    const ColorTable& table = colors.tableOf(s_.mesh.material[face_.number]);
    value.I = table.picked(value.cell - table.first()).nearest(value.I);
    return value;
  }

 private:
  [[nodiscard]] LoopValue asInLoop() const {
    if (evaluator_.evaluates(face_)) return evaluated();
    if (s_.settings.shading == Shading::Gouraud) return gouraud();
    if (s_.settings.shading == Shading::Environment) return environment();
    SeenRows here{s_.settings.width, j_, std::vector<int>(static_cast<std::size_t>(s_.settings.width), -1)};
    here.faces[static_cast<std::size_t>(i_)] = static_cast<int>(&face_ - s_.snapped.faces.data());
    const double I = picture_.intensities(here, channel_)[static_cast<std::size_t>(i_)];
    return {I, ramp_.cell(I)};
  }

  /// Phong shading and textures: one pixel of the loop.
  [[nodiscard]] LoopValue evaluated() const {
    LoopValue value;
    evaluator_.forEachEvaluated(face_, [&](const FaceTriangle& t, auto triangle) {
      if (!owns(t.p.data(), 3, i_, j_)) return;
      std::int64_t clamped = 0;
      triangle.ramp = ramp_, triangle.clamped = &clamped;
      triangle.span(&value.cell, i_, j_, 1);
      value.I = std::clamp(intensityOf(triangle), 0.0, 1.0);
    });
    return value;
  }
  template <class Triangle>
  [[nodiscard]] double intensityOf(const Triangle& triangle) const {
    double I = 0;
    triangle.intensities(&I, i_, j_, 1);
    return I;
  }
  template <class Triangle>
  [[nodiscard]] double intensityOf(const LuminanceTriangle<Triangle>& triangle) const {
    glm::dvec3 I{0};
    for (int c = 0; c < 3; ++c) I[c] = std::clamp(intensityOf(triangle.channel[c]), 0.0, 1.0);
    return luminance(I);
  }

  [[nodiscard]] LoopValue gouraud() const {
    const bool cells = s_.settings.interpolated == Interpolated::Cell;
    const auto steps = [&](int vertex) { return valueSteps(gouraudValueAt(vertex)); };
    AffineValue plane;
    if (s_.settings.polygons == Polygons::Rows && face_.count > 3) {
      std::vector<double> v;
      for (int k = face_.first; k < face_.first + face_.count; ++k) v.push_back(steps(k) * 0x1p-24);
      plane = RowValues{&s_.snapped.vertices[face_.first], face_.count, std::move(v)}.along(j_);
    } else {
      const FaceTriangle t = triangleAt(s_.snapped, face_, i_, j_);
      plane = AffineOver{t.p.data()}(
          std::array{steps(t.vertex[0]), steps(t.vertex[1]), steps(t.vertex[2])}.data());
    }
    const std::uint32_t at = plane.at(i_, j_);
    const auto cell = static_cast<std::uint8_t>(at >> 24);
    if (ramp_.table == nullptr) return {ramp_.intensity(at * 0x1p-24), cell};
    if (cells) return {picture_.colors().intensityOf(cell), cell};
    return {ramp_.intensity(at * 0x1p-24), ramp_.table->bySteps()(at)};
  }

  [[nodiscard]] LoopValue environment() const {
    const FaceTriangle t = triangleAt(s_.snapped, face_, i_, j_);
    std::array<std::array<std::uint32_t, 3>, 3> steps{};
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 place = mapPlaceAt(t.vertex[k]);
      for (int axis = 0; axis < 3; ++axis) steps[axis][k] = valueSteps(place[axis]);
    }
    const AffineOver over{t.p.data()};
    const auto at = [&](int axis) { return over(steps[axis].data()).at(i_, j_); };
    const Environment& map = s_.shading.environments(channel_)[s_.mesh.material[face_.number] + 1];
    LoopValue value;
    value.place = glm::ivec2{at(0) >> 24, at(1) >> 24};
    value.away = map.twoMaps && at(2) >> 31 == 0;
    const float I =
        (value.away ? map.away : map.front)[256 * static_cast<std::size_t>(value.place->y) + value.place->x];
    value.I = std::min(1.0F, I);
    value.cell = ramp_.cell(value.I);
    return value;
  }

  const Picture& picture_;
  Surfaces s_;
  const SnappedFace& face_;
  int channel_, i_, j_;
  Ramp ramp_;
  SurfaceEvaluator evaluator_;
};

}  // namespace

LoopValue loopValueOf(const Picture& picture, int face, int channel, int i, int j) {
  return Loop{picture, face, channel, i, j}.value();
}

double gouraudValueAt(const Picture& picture, int face, int channel, int vertex) {
  return Loop{picture, face, channel}.gouraudValueAt(vertex);
}

glm::dvec3 mapPlaceAt(const Picture& picture, int face, int channel, int vertex) {
  return Loop{picture, face, channel}.mapPlaceAt(vertex);
}

FaceTriangle triangleAt(const SnappedScene& scene, const SnappedFace& face, int i, int j) {
  FaceTriangle at{};
  forEachTriangle(scene, face, [&](const FaceTriangle& t) {
    if (owns(t.p.data(), 3, i, j)) at = t;
  });
  return at;
}

double alongRow(const SnappedScene& scene, const SnappedFace& face, const std::vector<double>& v, int i,
                int j) {
  return RowValues{&scene.vertices[face.first], face.count, v}.at(i, j);
}

}  // namespace xnewell
