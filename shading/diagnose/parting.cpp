#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/face_images.h"

namespace xnewell {

/// The pixel that tells two mistakes apart.

std::optional<Diagnoser::Predicted> Diagnoser::atPixel(OtherProgram& program, const Approach& way,
                                                       std::size_t k) {
  const auto [i, j] = turned(way.turn, samples_[k].i, samples_[k].j, settings_.width, settings_.height);
  const int face = facesOf(way.paint)[static_cast<std::size_t>(j) * settings_.width + i];
  if (face != kNothing && !program.canShow(face)) return std::nullopt;
  if (face != kNothing) return Predicted{program.at(face, i, j)};
  Predicted ground;
  ground.shows = false;
  return ground;
}

std::vector<Diagnoser::Predicted> Diagnoser::atPixels(const Approach& way) {
  std::vector<Predicted> all = predicted(way);
  if (way.turn == TurnWay::Upright) return all;
  OtherProgram program{model_, way};
  Predicted unknown;
  unknown.shows = false;
  for (std::size_t k = 0; k < samples_.size(); ++k) all[k] = atPixel(program, way, k).value_or(unknown);
  return all;
}

/// What a row shows at the pixel of each sample, as far as a face or the ground is all around it.
std::vector<std::optional<Diagnoser::Predicted>> Diagnoser::insideFaces(const Hypothesis& h) {
  const Approach way = approachWith(h);
  const std::vector<int>& faces = facesOf(way.paint);
  const int w = settings_.width;
  const auto isInside = [&](int i, int j) {
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (faces[static_cast<std::size_t>(j + y) * w + i + x] != faces[static_cast<std::size_t>(j) * w + i])
          return false;
    return true;
  };
  std::vector<std::optional<Predicted>> all;
  all.reserve(samples_.size());
  OtherProgram program{model_, way};
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const auto [i, j] = turned(way.turn, samples_[k].i, samples_[k].j, w, settings_.height);
    const int face = faces[static_cast<std::size_t>(j) * w + i];
    if (!isInside(i, j) || (face != kNothing && !program.canShow(face)))
      all.emplace_back();
    else if (way.turn == TurnWay::Upright)
      all.emplace_back(known(h)[k]);
    else
      all.push_back(atPixel(program, way, k));
  }
  return all;
}

std::optional<Parting> Diagnoser::partingOf(std::string_view a, std::string_view b) {
  using Shown = std::vector<std::optional<Predicted>>;
  std::vector<Shown> first, second;
  for (const Hypothesis& h : hypotheses()) {
    if (!applies(h)) continue;
    if (h.key == a) first.push_back(insideFaces(h));
    if (h.key == b) second.push_back(insideFaces(h));
  }
  if (first.empty() || second.empty()) return std::nullopt;
  const Shown right = insideFaces(hypotheses().front());
  const auto valueOf = [](const Predicted& p) -> std::optional<double> {
    if (!p.shows) return std::nullopt;
    return p.value[0];
  };
  Parting best;
  best.shades = best.cells = -1.0;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    Parting here;
    here.i = samples_[k].i, here.j = samples_[k].j;
    here.shades = here.cells = 1e300;
    bool edge = !right[k];
    for (const Shown& f : first)
      for (const Shown& s : second) {
        if (edge || !f[k] || !s[k]) {
          edge = true;
          continue;
        }
        const Predicted &x = *f[k], &y = *s[k];
        const double shades = apart(x, y), cells = cellsApart(x.cell, y);
        if (std::pair{shades, cells} >= std::pair{here.shades, here.cells}) continue;
        here.shades = shades, here.cells = cells;
        here.first = valueOf(x), here.second = valueOf(y), here.right = valueOf(*right[k]);
        here.firstCell = x.cell, here.secondCell = y.cell, here.rightCell = right[k]->cell;
      }
    if (edge || std::pair{here.shades, here.cells} <= std::pair{best.shades, best.cells}) continue;
    best = here;
    best.face = picture_.snapped().faces[samples_[k].face].number;
  }
  if (best.shades < 0.0) return std::nullopt;
  return best;
}

}  // namespace xnewell
