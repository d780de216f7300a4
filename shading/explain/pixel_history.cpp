#include "shading/explain/pixel_history.h"

#include <algorithm>
#include <set>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"

namespace xnewell {

namespace {

/// What owns the sample of pixel (i, j).
class OwnersHere {
 public:
  OwnersHere(const Picture& picture, int i, int j)
      : picture_{picture}, scene_{picture.snapped()}, i_{i}, j_{j} {}

  /// The columns of row j that a face owns.
  [[nodiscard]] Columns columnsOf(int face) const {
    const SnappedFace& f = scene_.faces[face];
    Columns columns{0, 0};
    forEachSpan(&scene_.vertices[f.first], f.count, j_, picture_.settings().width, j_ + 1,
                [&](int, int from, int to) {
                  columns = {from, to};
                });
    return columns;
  }
  [[nodiscard]] bool owns(const Columns& columns) const { return columns.from <= i_ && i_ < columns.to; }
  [[nodiscard]] bool owns(const Fragment& fragment) const {
    Columns columns = columnsOf(fragment.face);
    if (!owns(columns) || fragment.piece < 0) return owns(columns);
    const Piece& piece = picture_.sorted().pieces[fragment.piece];
    if (j_ < piece.area.top || j_ >= piece.area.bottom) return false;
    return owns(PieceWalk{scene_, picture_.sorted(), piece}.within(j_, columns));
  }
  [[nodiscard]] double z(int face) const {
    const SnappedFace& f = scene_.faces[face];
    const std::int64_t x = std::int64_t{i_} * kGrid + kGrid / 2, y = std::int64_t{j_} * kGrid + kGrid / 2;
    return std::ldexp(depthAt(scene_.planes[f.plane], x, y), scene_.zShift - kGridBits);
  }

 private:
  const Picture& picture_;
  const SnappedScene& scene_;
  int i_, j_;
};

}  // namespace

PixelHistory historyOf(const Picture& picture, int i, int j) {
  const Picture complete = picture.withPlanes();
  const OwnersHere here{complete, i, j};
  std::vector<int> all;
  const int faces = static_cast<int>(complete.snapped().faces.size());
  for (int f = 0; f < faces; ++f)
    if (here.owns(here.columnsOf(f))) all.push_back(f);

  PixelHistory history;
  const auto add = [&](const Fragment& fragment) {
    history.painted.push_back({fragment, here.z(fragment.face)});
  };
  const int seen = picture.seen(j, j + 1).faces[static_cast<std::size_t>(i)];
  if (rowOf(picture.settings().order).bySample) {
    for (const int f : all) add({f});
    const auto shown = std::ranges::find(all, seen);
    if (shown != all.end()) history.shown = static_cast<int>(shown - all.begin());
  } else {
    for (const Fragment& fragment : picture.sorted().fragments)
      if (here.owns(fragment)) add(fragment);
    history.shown = static_cast<int>(history.painted.size()) - 1;
    std::set<int> painted;
    for (const PaintedHere& one : history.painted) painted.insert(one.fragment.face);
    history.notPainted = static_cast<int>(all.size() - painted.size());
  }
  for (const int f : all)
    if (history.nearest < 0 ||
        !(nearer(complete.snapped().planes[complete.snapped().faces[history.nearest].plane],
                 complete.snapped().planes[complete.snapped().faces[f].plane], i, j) > 0))
      history.nearest = f;
  if (history.nearest >= 0) history.check = checkOf(complete.snapped(), seen, history.nearest, i, j);
  return history;
}

}  // namespace xnewell
