#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "depthsort/fragment_spans.h"
#include "shading/laboratory/exactness.h"

namespace xnewell {

/// Calls use(i, j) for each sample that two fragments share and where R must be painted before P:
/// P is nearer there, and rounding alone does not part them.
template <class Use>
void forEachHidden(const SnappedScene& scene, const SortedScene& sorted, const Fragment& P, const Fragment& R,
                   int width, int height, Use&& use) {
  std::map<int, std::vector<Columns>> rows;
  forEachSpan(scene, sorted, P, width, height, [&](int row, int from, int to) {
    rows[row].push_back({from, to});
  });
  const ScreenPlane &p = scene.planes[scene.faces[P.face].plane],
                    &r = scene.planes[scene.faces[R.face].plane];
  forEachSpan(scene, sorted, R, width, height, [&](int row, int from, int to) {
    const auto at = rows.find(row);
    if (at == rows.end()) return;
    for (const Columns& columns : at->second)
      for (int i = std::max(from, columns.from); i < std::min(to, columns.to); ++i)
        if (nearer(p, r, i, row) > 0 && checkOf(scene, R.face, P.face, i, row) == SampleCheck::Wrong)
          use(i, row);
  });
}

}  // namespace xnewell
