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

}  // namespace xnewell
