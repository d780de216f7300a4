#include "x11/stepper/sort_run.h"

#include <algorithm>
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

/// What their run does in the picture. It has been judged, so it can be read.
std::unique_ptr<NamedRun> played(const Picture& picture, const JudgedRun& theirs) {
  auto run = std::make_unique<NamedRun>(picture.withPlanes(), theirs.picture.snapped(), true);
  theirs.file.forEach([&](const RunStep& step) { run->step(step); });
  for (const int face : theirs.report.unnamed) static_cast<void>(run->polygonOfFace(face));
  return run;
}

}  // namespace

SortRun::SortRun(const Picture& picture, std::uint8_t ground)
    : SortRun{picture.withPlanes(), std::nullopt, ground, kCopies} {}

SortRun::SortRun(const Picture& picture, SortedScene sorted, std::uint8_t ground)
    : SortRun{picture.withPlanes(), std::optional{std::move(sorted)}, ground, 0} {}

SortRun::SortRun(const Picture& picture, std::shared_ptr<const JudgedRun> theirs, std::uint8_t ground)
    : SortRun{picture.withPlanes(), std::nullopt, ground, kCopies, theirs, played(picture, *theirs)} {}

SortRun::SortRun(Picture withPlanes, std::optional<SortedScene> sorted, std::uint8_t ground,
                 std::size_t copies, std::shared_ptr<const JudgedRun> theirs, std::unique_ptr<NamedRun> named)
    : picture_{std::move(withPlanes)},
      theirs_{std::move(theirs)},
      named_{std::move(named)},
      sorted_{named_   ? named_->record.sorted()
              : sorted ? *std::move(sorted)
                       : recorded(picture_)},
      explainer_{picture_.scene().mesh, picture_.snapped(), sorted_, !named_},
      landmarks_{sorted_, falseSteps()},
      replay_{picture_.snapped(), sorted_},
      soFar_{picture_, sorted_, ground, copies} {
  explainer_.call(Called::PAndQ);
  const int fragments = static_cast<int>(scene().faces.size() + sorted_.pieces.size());
  zExtents_.reserve(fragments);
  for (int id = 0; id < fragments; ++id) zExtents_.push_back(explainer_.zExtent(id));
  // This makes all copies at once, so that no later step has to wait for them.
  static_cast<void>(soFar_.at(static_cast<int>(sorted_.fragments.size())));
}

std::optional<std::vector<int>> SortRun::falseSteps() {
  if (!named_) return std::nullopt;
  const std::vector<int>& lines = named_->lines();
  std::vector<int> steps;
  for (const auto* const all : {&theirs_->report.wrong, &theirs_->report.others})
    for (const FalseStep& wrong : *all) {
      // The last step of the line, or the one before it: nothing of it may be visible.
      const auto after = wrong.line == 0 ? lines.end() : std::ranges::upper_bound(lines, wrong.line);
      const int step =
          std::min(std::max(1, static_cast<int>(after - lines.begin())), static_cast<int>(lines.size()));
      wrong_.emplace(step, &wrong);
      if (!wrong.follows) steps.push_back(step);
    }
  std::ranges::sort(steps);
  steps.erase(std::ranges::unique(steps).begin(), steps.end());
  return steps;
}

std::vector<const FalseStep*> SortRun::wrongAt(int step) const {
  std::vector<const FalseStep*> all;
  const auto [first, end] = wrong_.equal_range(step);
  for (auto at = first; at != end; ++at) all.push_back(at->second);
  std::ranges::stable_sort(all, {}, &FalseStep::follows);
  return all;
}

Event SortRun::compared(int P, int Q) const {
  const Relation r = named_->record.compare(P, Q);
  return {.kind = Event::Kind::Compare,
          .test = r.test,
          .verdict = r.verdict,
          .contact = r.contact,
          .P = P,
          .Q = Q};
}

Verdict SortRun::verdict() const {
  const Event& e = *replay_.event();
  return named_ ? compared(e.P, e.Q).verdict : e.verdict;
}

const NamedRun::Polygon* SortRun::named(int id) const {
  const int polygon = named_ ? named_->polygonOf(id) : -1;
  return polygon < 0 ? nullptr : &(*named_)[polygon];
}

std::string SortRun::number(int id) const {
  const NamedRun::Polygon* const polygon = named(id);
  return polygon && polygon->own ? std::to_string(*polygon->own) : fragments().number(id);
}

std::string SortRun::part(int id) const {
  const NamedRun::Polygon* const polygon = named(id);
  if (!polygon || !polygon->own) return fragments().part(id);
  const std::string face = named_->nameOfFace(polygon->face);
  return "of" + face.substr(face.find(' '));
}

std::string SortRun::name(int id) const {
  if (const NamedRun::Polygon* const polygon = named(id)) return polygon->name;
  if (named_) return named_->nameOfFace(fragments().face(id).number);
  const std::string part = fragments().part(id);
  if (fragments().hasName(id)) return part;
  return fragments().number(id) + (part.empty() ? "" : " " + part);
}

bool SortRun::isAdded() const {
  const Event* const e = replay_.event();
  const int step = replay_.step();
  return named_ && e && e->kind == Event::Kind::Take && step < steps() &&
         named_->lines()[step] == named_->lines()[step - 1];
}

double SortRun::scale() const {
  return theirs_ ? 1.0 * theirs_->picture.settings().height / picture_.settings().height : 1.0;
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
