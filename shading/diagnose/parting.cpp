#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/face_images.h"

namespace xnewell {

/// The pixel that tells two mistakes apart.

/// What a row shows at each sample, as far as a face or the ground is all around it.
std::vector<std::optional<Diagnoser::Predicted>> Diagnoser::insideFaces(const Hypothesis& h) {
  const std::vector<Predicted>& shown = known(h);
  const Approach way = approachWith(h);
  const std::vector<int>& faces = facesOf(way);
  const OtherProgram program{model_, way};
  std::vector<std::optional<Predicted>> all;
  all.reserve(samples_.size());
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const int face = faces[indexOf(samples_[k].i, samples_[k].j)];
    const bool isKnown =
        isInside(faces, samples_[k].i, samples_[k].j) && (face == kNothing || program.canShow(face));
    all.push_back(isKnown ? std::optional{shown[k]} : std::nullopt);
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
