#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/face_images.h"

namespace xnewell {

/// The pixel that tells two mistakes apart.

/// What a row shows at the pixel of each sample: kNothing has no value, an edge between faces is nothing at
/// all. A row that turns the picture has another face there than the sample.
std::vector<std::optional<Diagnoser::Predicted>> Diagnoser::atPixels(const Hypothesis& h) {
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
    if (!isInside(i, j) || (face != kNothing && !program.canShow(face))) {
      all.emplace_back();
    } else if (way.turn == TurnWay::Upright) {
      all.emplace_back(known(h)[k]);
    } else {
      Predicted p;
      p.shows = face != kNothing;
      if (p.shows) {
        const ShownHere shown = program.at(face, i, j);
        for (int c = 0; c < 3; ++c) p.value[c] = static_cast<float>(shown.value[c]);
        p.step = static_cast<float>(shown.step), p.cell = static_cast<std::int16_t>(shown.cell);
      }
      all.emplace_back(p);
    }
  }
  return all;
}

std::optional<Parting> Diagnoser::partingOf(std::string_view a, std::string_view b) {
  using Shown = std::vector<std::optional<Predicted>>;
  std::vector<Shown> first, second;
  for (const Hypothesis& h : hypotheses()) {
    if (!applies(h) || (h.key == "direct-colours" && !model_.colors)) continue;
    if (h.key == a) first.push_back(atPixels(h));
    if (h.key == b) second.push_back(atPixels(h));
  }
  if (first.empty() || second.empty()) return std::nullopt;
  const Shown right = atPixels(hypotheses().front());
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
