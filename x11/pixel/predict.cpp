#include "x11/pixel/predict.h"

#include <algorithm>
#include <cmath>

#include "shading/explain/rounded_terms.h"
#include "shading/explain/term_values.h"
#include "x11/kit/typed_number.h"

namespace xnewell {

namespace {

constexpr int kLeastDecimals = 2;

int typedDecimals(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return 0;
  const std::size_t end = text.find_first_not_of("0123456789", point + 1);
  return static_cast<int>(std::min(end, text.size()) - point - 1);
}

}  // namespace

std::vector<Prediction> predictionsOf(const PixelStory& story, const Explanation& e,
                                      const ExplainedEquation* at, int channel) {
  std::vector<Prediction> all;
  if (at && !at->lights.empty()) {
    const Illumination& user = story.picture.settings().light;
    const ExplainedLight& first = at->lights.front();
    const bool several = at->lights.size() > 1;
    const auto ofFirst = [&](std::string_view name) {
      return std::string{name} + (several ? " of the first light" : "");
    };
    const auto term = [&](std::string_view name) {
      return "the " + std::string{name} + " term" + (several ? ", of all lights" : "");
    };
    const double diffuse = at->diffuse(channel), specular = at->specular(channel);
    const std::vector<double> terms = roundedTerms({at->ambient[channel], diffuse, specular}, kPixelDecimals);
    all.push_back({Predicted::NdotL, ofFirst("N.L"), first.NdotL, first.NdotL});
    if (user.form != Form::Tutorial && first.NdotL > 0.0)
      all.push_back({Predicted::Cosine, ofFirst(cosineName(user.form)), first.cosine, first.cosine});
    all.push_back({Predicted::Diffuse, term("diffuse"), diffuse, terms[1]});
    all.push_back({Predicted::Specular, term("specular"), specular, terms[2]});
    all.push_back({Predicted::I, "I, the sum of the terms", at->I[channel], terms[0] + terms[1] + terms[2]});
  }
  if (story.inColors()) return all;
  const auto cell = static_cast<double>(e.value[0]);
  all.push_back({Predicted::Cell, "the cell", cell, cell, 0});
  return all;
}

Judged judged(const Prediction& asked, const std::string& text) {
  const std::optional<double> typed = typedNumber(text);
  if (!typed || !std::isfinite(*typed)) return {.complaint = "Type a number."};
  const int decimals = std::min(typedDecimals(text), asked.decimals);
  if (decimals < std::min(kLeastDecimals, asked.decimals))
    return {.complaint = "Type at least two decimals."};
  // Half of the last digit that is typed. The numbers that the page shows are rounded, so a result from them
  // may be off by a little more than half of the last digit that it could show.
  const double allowed =
      std::max(0.5 * std::pow(10.0, -decimals) * (1.0 + 1e-9), 0.75 * std::pow(10.0, -asked.decimals));
  return {.isRight = std::min(std::abs(*typed - asked.value), std::abs(*typed - asked.written)) <= allowed,
          .complaint = {}};
}

}  // namespace xnewell
