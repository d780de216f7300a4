#include "depthsort/record/landmarks.h"

#include <algorithm>

namespace xnewell {

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
