#include "x11/stepper/sort_run.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "depthsort/fragment_spans.h"
#include "x11/stepper/sort_picture.h"

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

std::string SortRun::shortName(int id) const {
  return !named_ && fragments().hasName(id) ? fragments().name(id) : number(id);
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

std::vector<RingLink> SortRun::ring() const {
  using Kind = Event::Kind;
  const std::vector<Event>& events = sorted_.events;
  int at = replay_.step();
  for (constexpr std::array kBreaking{Kind::Impossible, Kind::Vain, Kind::Void, Kind::Split};
       at > 0 && std::ranges::find(kBreaking, events[at - 1].kind) != kBreaking.end();)
    --at;
  if (at == 0 || events[at - 1].kind != Kind::Cycle) return {};
  const auto testBefore = [&](int step) {
    return static_cast<int>(comparisonAt(sorted_, step) - events.data()) + 1;
  };
  // Each move says that its Q is painted before its P. From P, the last that was moved, they lead back to Q.
  const Event& cycle = events[at - 1];
  std::vector<RingLink> ring;
  int id = cycle.P;
  for (int step = at; id != cycle.Q; --step)
    if (const Event& e = events[step - 1]; e.kind == Kind::Move && e.Q == id)
      ring.push_back({.id = id, .step = testBefore(step)}), id = e.P;
  ring.push_back({.id = id, .step = testBefore(at)});

  const Event& now = *replay_.event();
  const auto linkOf = [&](int member) { return std::ranges::find(ring, member, &RingLink::id); };
  if (now.kind == Kind::Void) linkOf(now.Q)->by = RingLink::By::Open;
  if (now.kind != Kind::Split) return ring;
  const auto cut = linkOf(now.P);
  const auto hides = [&](int nearer, int farther) {
    const CommonArea both = explainer_.commonArea(nearer, farther);
    return both.corners > 0 && both.aheadOfQ.high > both.doubt;
  };
  const int after = (cut + 1 == ring.end() ? ring.front() : cut[1]).id,
            before = (cut == ring.begin() ? ring.back() : cut[-1]).id;
  const auto stays = [&](int piece) { return hides(piece, before) && hides(after, piece); };
  int first = fragments().pieceOf(replay_.splits() - 1), second = first + 1;
  if (stays(second) || (hides(second, before) && !stays(first))) std::swap(first, second);
  (cut == ring.begin() ? ring.back() : cut[-1]).by = RingLink::By::Planes;
  cut->id = first, cut->by = RingLink::By::Planes;
  if (stays(first)) return ring;  // no cut that was tried opens it
  cut->by = RingLink::By::Open;
  ring.insert(cut + 1, {second, RingLink::By::Planes, cut->step});
  return ring;
}

std::optional<glm::ivec2> SortRun::roomFor(int id, glm::ivec2 size) {
  const auto [known, isNew] = rooms_.try_emplace({id, size.x, size.y});
  if (!isNew) return known->second;
  const int width = picture_.settings().width, height = picture_.settings().height;
  if (seen_.empty()) seen_ = picture_.seen(0, height).faces;
  const Fragment fragment = fragmentOf(scene(), sorted_, id);
  std::vector<int> high(width), last(width, -2);  // for each column: rows that end in row `last`
  std::vector<glm::ivec2> corners;
  glm::dvec2 sum{0.0};
  double samples = 0;
  forEachSpan(scene(), sorted_, fragment, width, height, [&](int row, int from, int to) {
    int wide = 0;
    for (int column = from; column < to; ++column) {
      if (seen_[std::size_t(row) * width + column] != fragment.face) {
        wide = 0;
        continue;
      }
      sum += glm::dvec2{column, row}, ++samples;
      high[column] = last[column] == row - 1 ? high[column] + 1 : 1, last[column] = row;
      wide = high[column] < size.y ? 0 : wide + 1;
      if (wide >= size.x) corners.emplace_back(column + 1 - size.x, row + 1 - size.y);
    }
  });
  const auto away = [&](glm::ivec2 corner) {
    const glm::dvec2 by = glm::dvec2{corner} + glm::dvec2{size - 1} / 2.0 - sum / samples;
    return by.x * by.x + by.y * by.y;
  };
  if (!corners.empty()) known->second = *std::ranges::min_element(corners, {}, away);
  return known->second;
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
