#include "shading/explain/term_values.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "depthsort/oracle.h"
#include "shading/explain/on_face.h"

namespace xnewell {

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

}  // namespace xnewell
