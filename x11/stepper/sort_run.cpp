#include "x11/stepper/sort_run.h"

#include <limits>
#include <utility>

#include "x11/stepper/fragment_tint.h"

namespace xnewell {

namespace {

SortedScene recorded(const Picture& picture) {
  return depthSort(picture.snapped(), {.width = picture.settings().width,
                                       .height = picture.settings().height,
                                       .textbook = true,
                                       .record = true,
                                       .mostEvents = SortRun::kMostEvents});
}

}  // namespace

SortRun::SortRun(const Picture& picture, std::uint8_t ground)
    : SortRun{picture.withPlanes(), std::nullopt, ground, kCopies} {}

SortRun::SortRun(const Picture& picture, SortedScene sorted, std::uint8_t ground)
    : SortRun{picture.withPlanes(), std::optional{std::move(sorted)}, ground, 0} {}

SortRun::SortRun(Picture withPlanes, std::optional<SortedScene> sorted, std::uint8_t ground,
                 std::size_t copies)
    : picture_{std::move(withPlanes)},
      sorted_{sorted ? *std::move(sorted) : recorded(picture_)},
      explainer_{picture_.scene().mesh, picture_.snapped(), sorted_, true},
      landmarks_{sorted_},
      replay_{picture_.snapped(), sorted_},
      soFar_{picture_, sorted_, ground, copies} {
  explainer_.call(Called::PAndQ);
  const int fragments = static_cast<int>(scene().faces.size() + sorted_.pieces.size());
  zExtents_.reserve(fragments);
  for (int id = 0; id < fragments; ++id) zExtents_.push_back(explainer_.zExtent(id));
  // This makes all copies at once, so that no later step has to wait for them.
  static_cast<void>(soFar_.at(static_cast<int>(sorted_.fragments.size())));
}

std::vector<int> SortRun::waiting() const {
  std::vector<int> ids;
  for (const auto& [id, marked] : replay_.list(std::numeric_limits<int>::max())) ids.push_back(id);
  return ids;
}

int SortRun::paintedId(int n) const {
  const Fragment& fragment = sorted_.fragments[n];
  return fragment.piece < 0 ? fragment.face : static_cast<int>(scene().faces.size()) + fragment.piece;
}

int SortRun::fragmentAt(int column, int row) const {
  const auto found = [&](int n) { return owns(scene(), sorted_, sorted_.fragments[n], column, row); };
  const int painted = replay_.painted(), all = static_cast<int>(sorted_.fragments.size());
  for (int n = painted; n-- > 0;)
    if (found(n)) return paintedId(n);
  for (int n = painted; n < all; ++n)
    if (found(n)) return paintedId(n);
  return -1;
}

std::optional<Event> SortRun::asTested() const {
  const Event* const event = replay_.event();
  if (!event) return std::nullopt;
  Event named = *event;
  const Event* const tests = comparisonAt(sorted_, replay_.step());
  if (tests && tests->P == event->Q && tests->Q == event->P) std::swap(named.P, named.Q);
  return named;
}

StepAbout SortRun::about(int step) const {
  const Event& e = sorted_.events[static_cast<std::size_t>(step - 1)];
  return {e.kind, fragments().face(e.P).number, e.Q < 0 ? -1 : fragments().face(e.Q).number};
}

std::optional<int> SortRun::stepAbout(const StepAbout& wanted) const {
  std::optional<int> withBoth, withP;
  for (int step = 1; step <= steps(); ++step) {
    const StepAbout found = about(step);
    if (found.P != wanted.P) continue;
    if (!withP) withP = step;
    if (found.Q != wanted.Q) continue;
    if (!withBoth) withBoth = step;
    if (found.kind == wanted.kind) return step;
  }
  return withBoth ? withBoth : withP;
}

}  // namespace xnewell
