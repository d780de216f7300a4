#include "depthsort/record/replay.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace xnewell {

Replay::Replay(const SnappedScene& scene, const SortedScene& sorted)
    : sorted_{&sorted}, faces_{static_cast<int>(scene.faces.size())} {
  const std::size_t fragments = scene.faces.size() + sorted.pieces.size();
  ended_.assign(fragments, std::numeric_limits<int>::max());
  pieces_.assign(fragments, -1);
  checkpoints_.reserve(steps() / kCheckpoint + 1);
  State state;
  for (int k = 0; k < steps(); ++k) {
    if (k % kCheckpoint == 0) checkpoints_.push_back(state);
    const Event& e = sorted.events[k];
    // A run takes P when no polygon is marked. Who sorts by hand may take another P, which ends the marks.
    if (e.kind == Event::Kind::Take) marks_.push_back({e.P, -1});
    if (e.kind == Event::Kind::Move) marks_.push_back({e.Q, state.top});
    if (e.kind == Event::Kind::Split) pieces_[e.P] = faces_ + 2 * state.splits;
    if (e.kind == Event::Kind::Split || e.kind == Event::Kind::Paint) ended_[e.P] = std::min(ended_[e.P], k);
    advance(state, k);
  }
  if (checkpoints_.empty()) checkpoints_.push_back(state);
}

void Replay::advance(State& state, int index) const {
  const Event& e = sorted_->events[index];
  switch (e.kind) {
    case Event::Kind::Take:
    case Event::Kind::Move:
      state.top = state.marks++;
      break;
    case Event::Kind::Compare:
    case Event::Kind::Cycle:
    case Event::Kind::Impossible:
    case Event::Kind::Vain:
      break;
    case Event::Kind::Void:
      while (marks_[state.top].fragment != e.P) state.top = marks_[state.top].below;
      break;
    case Event::Kind::Split: {
      ++state.splits;
      // If a pair crosses, Q may be the one that is split. Then it is not marked.
      int marked = state.top;
      while (marked != -1 && marks_[marked].fragment != e.P) marked = marks_[marked].below;
      if (marked != -1) state.top = marks_[marked].below;
      break;
    }
    case Event::Kind::Paint:
      state.top = marks_[state.top].below;
      ++state.painted;
      break;
  }
}

void Replay::goTo(int step) {
  assert(step >= 0 && step <= steps());
  if (step < step_ || step - step_ > kCheckpoint) {
    const int checkpoint = std::min(step / kCheckpoint, static_cast<int>(checkpoints_.size()) - 1);
    state_ = checkpoints_[checkpoint];
    step_ = checkpoint * kCheckpoint;
  }
  while (step_ < step) advance(state_, step_++);
}

std::vector<int> Replay::marked() const {
  std::vector<int> ids;
  for (int at = state_.top; at != -1; at = marks_[at].below) ids.push_back(marks_[at].fragment);
  return ids;
}

std::vector<Replay::Listed> Replay::list(int most) const {
  std::vector<Listed> all;
  const auto full = [&] { return static_cast<int>(all.size()) >= most; };
  std::vector<int> stack = marked();
  for (const int id : stack) {
    if (full()) return all;
    all.push_back({id, true});
  }
  std::ranges::sort(stack);
  std::vector<int> next;  // a stack of one face's fragments still to visit
  for (const int face : sorted_->list) {
    next.push_back(face);
    while (!next.empty()) {
      const int id = next.back();
      next.pop_back();
      if (full()) return all;
      if (isThere(id)) {
        if (!std::ranges::binary_search(stack, id)) all.push_back({id, false});
      } else if (pieces_[id] != -1) {
        next.push_back(pieces_[id] + 1);
        next.push_back(pieces_[id]);
      }
    }
  }
  return all;
}

std::vector<int> stepsOf(const SortedScene& sorted, Every every) {
  std::vector<int> steps;
  for (int k = 0; k < static_cast<int>(sorted.events.size()); ++k)
    if (every == Every::Step || sorted.events[k].kind == kEvery[static_cast<int>(every)].kind)
      steps.push_back(k + 1);
  return steps;
}

std::optional<Landmark> landmarkOf(const Event& event) {
  switch (event.kind) {
    case Event::Kind::Compare:
      if (event.verdict == Verdict::PFirst) return std::nullopt;
      return Landmark::Failed;
    case Event::Kind::Move:
      return Landmark::Move;
    case Event::Kind::Cycle:
      return Landmark::Cycle;
    case Event::Kind::Split:
      return Landmark::Cut;
    case Event::Kind::Paint:
      return Landmark::Paint;
    case Event::Kind::Take:
    case Event::Kind::Impossible:
    case Event::Kind::Vain:
    case Event::Kind::Void:
      break;
  }
  return std::nullopt;
}

Landmarks::Landmarks(const SortedScene& sorted, std::optional<std::vector<int>> failed) : sorted_{&sorted} {
  int pairs = 0;
  for (int k = 0; k < static_cast<int>(sorted.events.size()); ++k) {
    const Event& e = sorted.events[k];
    if (k % kStride == 0) pairs_.push_back(pairs);
    pairs += e.kind == Event::Kind::Compare;
    if (const std::optional<Landmark> kind = landmarkOf(e)) of_[static_cast<int>(*kind)].push_back(k + 1);
  }
  pairs_.push_back(pairs);
  if (failed) of_[static_cast<int>(Landmark::Failed)] = *std::move(failed);
}

int Landmarks::count(Landmark kind, int step) const {
  const std::vector<int>& all = steps(kind);
  return static_cast<int>(std::ranges::upper_bound(all, step) - all.begin());
}

int Landmarks::pairs(int step) const {
  const auto from = sorted_->events.begin() + step / kStride * kStride;
  return pairs_[step / kStride] +
         static_cast<int>(std::count_if(from, sorted_->events.begin() + step,
                                        [](const Event& e) { return e.kind == Event::Kind::Compare; }));
}

std::optional<int> Landmarks::next(Landmark kind, int step) const {
  const auto after = std::ranges::upper_bound(steps(kind), step);
  return after == steps(kind).end() ? std::nullopt : std::optional{*after};
}

std::optional<int> Landmarks::previous(Landmark kind, int step) const {
  const auto from = std::ranges::lower_bound(steps(kind), step);
  return from == steps(kind).begin() ? std::nullopt : std::optional{*(from - 1)};
}

bool Landmarks::has(const SnappedScene& scene, int number, int step) const {
  if (step < 1) return false;
  const int faces = static_cast<int>(scene.faces.size());
  const auto isPart = [&](int id) {
    if (id < 0) return false;
    return scene.faces[id < faces ? id : sorted_->pieces[id - faces].face].number == number;
  };
  const Event& e = sorted_->events[step - 1];
  return isPart(e.P) || isPart(e.Q);
}

std::optional<int> Landmarks::nextWith(const SnappedScene& scene, int number, int step) const {
  for (int next = step + 1; next <= static_cast<int>(sorted_->events.size()); ++next)
    if (has(scene, number, next)) return next;
  return std::nullopt;
}

const Event* comparisonAt(const SortedScene& sorted, int step) {
  if (step < 1) return nullptr;
  const Event& last = sorted.events[step - 1];
  for (int k = step - 1; k >= 0; --k) {
    const Event& e = sorted.events[k];
    if (e.kind == Event::Kind::Take || e.kind == Event::Kind::Paint) return nullptr;
    if (e.kind != Event::Kind::Compare) continue;
    const bool same = (e.P == last.P && e.Q == last.Q) || (e.P == last.Q && e.Q == last.P);
    return same ? &e : nullptr;
  }
  return nullptr;
}

std::array<int, kTests> settledFor(const SortedScene& sorted, int step) {
  std::array<int, kTests> settled{};
  const int P = sorted.events[step - 1].P;
  for (int k = step - 1; k-- > 0;) {
    const Event& e = sorted.events[k];
    if (e.kind == Event::Kind::Compare && e.P == P) ++settled[static_cast<int>(e.test)];
    if ((e.kind == Event::Kind::Take && e.P == P) || (e.kind == Event::Kind::Move && e.Q == P)) break;
  }
  return settled;
}

}  // namespace xnewell
