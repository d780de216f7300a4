#include "depthsort/newell_run.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "depthsort/box_grid.h"
#include "depthsort/free_polygons.h"
#include "depthsort/order.h"
#include "depthsort/region.h"
#include "geometry/exact/give_up.h"

namespace xnewell {

namespace {

constexpr int kNone = -1;
/// How many splits are tried to break a cycle: all of a cycle of eight polygons, and no more of a longer one.
constexpr int kMostTries = 56;

/// True for a face and itself, and for parts of one model face in one plane. They show the same picture in
/// any order.
[[nodiscard]] bool oneSurface(const SnappedScene& scene, int f, int g) {
  const SnappedFace &F = scene.faces[f], &G = scene.faces[g];
  return F.number == G.number && F.plane == G.plane;
}

/// Where the polygons of a run stand in its list: cell by cell of a grid, and by farthest z within a cell.
struct ListOrder {
  BoxGrid grid;
  std::vector<int> cellBegin;  ///< #cells + 1, places in the list
  /// #cells: a face, if all faces of the cell are of one surface with it; otherwise -1
  std::vector<int> cellSurface;
  std::vector<int> byDepth;  ///< the polygons by farthest z, at equal z in scene order
  std::vector<int> place;    ///< #polygons, in the list
  std::vector<int> turns;    ///< #polygons: the places by farthest z
};

/// If `fine` is false, the grid has one cell.
ListOrder listOrder(const SnappedScene& scene, std::span<const Polygon> polygons, bool fine) {
  std::vector<ScreenBox> boxes;
  boxes.reserve(polygons.size());
  for (const Polygon& P : polygons) boxes.push_back(P.extents.box);
  ListOrder order{BoxGrid{boxes, fine}, {}, {}, {}, std::vector<int>(polygons.size()), {}};
  order.cellBegin.assign(order.grid.cells() + 1, 0);
  for (std::size_t i = 0; i < polygons.size(); ++i)
    ++order.cellBegin[(order.place[i] = order.grid.cellOf(boxes[i])) + 1];
  std::partial_sum(order.cellBegin.begin(), order.cellBegin.end(), order.cellBegin.begin());

  std::vector<std::uint32_t> keys(polygons.size());
  std::ranges::transform(polygons, keys.begin(), [](const Polygon& P) {
    return static_cast<std::uint32_t>(P.extents.zFar) ^ 0x80000000u;
  });
  order.byDepth = sortedByKey(keys);
  std::vector<int> next = order.cellBegin;
  order.turns.reserve(polygons.size());
  for (const int i : order.byDepth)
    order.turns.push_back(order.place[i] = next[order.place[i]]++);  // the place was the cell until here

  order.cellSurface.assign(order.grid.cells(), kNone);
  std::vector<int> inList(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) inList[order.place[i]] = polygons[i].face;
  for (int c = 0; c < order.grid.cells(); ++c) {
    const auto begin = inList.begin() + order.cellBegin[c], end = inList.begin() + order.cellBegin[c + 1];
    if (begin != end && std::all_of(begin, end, [&](int f) { return oneSurface(scene, f, *begin); }))
      order.cellSurface[c] = *begin;
  }
  return order;
}

/// What is read only for P: its place in the tree of pieces and in the walk over the Q's. All Q's before that
/// place are settled for good, for P and for all pieces of P.
struct Progress {
  /// list: the polygon that the walk has reached; Q: that polygon or a piece of it
  int list = 0, end = 0, Q = 0;
  BoxGrid::Place place;
  bool walking = false;
  int depth = 0;      ///< in the stack, while marked
  int piece = kNone;  ///< index into pieces_; kNone for a whole face
  int parent = kNone;
  int pieces = kNone;  ///< for a split polygon, the first of its two pieces: behind, then in front
};

/// One run. The list holds the given polygons first, pieces of them after. The given ones are in the grid's
/// order: cell by cell, and by farthest z within a cell.
class NewellRun {
 public:
  NewellRun(const SnappedScene& scene, const SortSettings& settings, const RunLimits& limits,
            PairTests& tests, SortedScene& sorted)
      : scene_{scene},
        settings_{settings},
        limits_{limits},
        tests_{tests},
        sorted_{sorted},
        firstPiece_{static_cast<int>(sorted.pieces.size())} {}

  bool sort(const PolygonList& list) {
    enter(list);
    GiveUpNowAndThen giveUp;
    for (int turn = 0; turn < given_; ++turn) {
      if (turn + 8 < given_) __builtin_prefetch(&list_[turns_[turn + 8]]);  // memory at random
      if (paintFree(turn)) continue;
      for (int P; (P = nextOpen(turns_[turn])) != kNone;) {
        note(Event::Kind::Take, P);
        mark(P);
        while (!stack_.empty()) {
          giveUp();
          step();
          if (splits_ > limits_.splits + turn * limits_.perPainted) return false;
        }
      }
    }
    return true;
  }

 private:
  using State = Polygon::State;

  // The list.

  void enter(const PolygonList& list);

  /// The polygon or piece after Q in the order of the list. It skips the pieces of Q.
  [[nodiscard]] int after(int Q) const {
    for (;;) {
      const int parent = progress_[Q].parent;
      if (parent == kNone) return kNone;
      if (progress_[parent].pieces == Q) return Q + 1;
      Q = parent;
    }
  }
  /// The first polygon that is neither painted nor split, among a face and its pieces.
  [[nodiscard]] int nextOpen(int root) const {
    for (int P = root; P != kNone;) {
      if (list_[P].state == State::Waiting) return P;
      P = list_[P].state == State::Split ? progress_[P].pieces : after(P);
    }
    return kNone;
  }

  /// Moves P's walk to the next Q against which P is not settled. Returns that Q or kNone.
  [[nodiscard]] int candidate(int P);
  [[nodiscard]] int openWithin(int Q, int P) const;
  /// Settles P against the Q at which its walk stands.
  void settle(int P) {
    Progress& p = progress_[P];
    p.Q = after(p.Q);
    if (p.Q == kNone) p.Q = ++p.list;
  }

  // The algorithm.

  /// Paints the polygon whose turn it is if it is free and waits. Returns false if not.
  bool paintFree(int turn) {
    const int P = turns_[turn];
    if (free_.empty() || !free_[turn] || list_[P].state != State::Waiting) return false;
    note(Event::Kind::Take, P);
    note(Event::Kind::Paint, P);
    sorted_.fragments.push_back({list_[P].face});
    list_[P].state = State::Painted;
    ++sorted_.statistics.free;
    sorted_.statistics.deepest = std::max(sorted_.statistics.deepest, 1);
    return true;
  }
  void step();
  void mark(int P) {
    list_[P].state = State::Marked;
    progress_[P].depth = static_cast<int>(stack_.size());
    stack_.push_back(P);
    sorted_.statistics.deepest = std::max(sorted_.statistics.deepest, static_cast<int>(stack_.size()));
  }
  void paint(int P);
  /// Leaves out a polygon that no one sees. What hides it is never left out unless something hides that.
  void leaveOut(int P);
  void close(int P);
  [[nodiscard]] bool isHidden(int P, int Q) {
    return splits_ > settings_.keepHidden && tests_.hides(shapeOf(Q), shapeOf(P));
  }
  void breakCycle(int P, int R);
  void splitCrossing(int P, int R);
  /// Unmarks all polygons from this depth of the stack on. Their walks keep what is settled.
  void unwind(int depth) {
    while (static_cast<int>(stack_.size()) > depth) {
      list_[stack_.back()].state = State::Waiting;
      stack_.pop_back();
    }
  }
  /// Splits P by Q's plane, which properly crosses it.
  void split(int P, int Q);
  void addPiece(int P, Region region);
  /// Enters a region as the next piece of a face. Returns its index into pieces_.
  int enterRegion(Region region, const Polygon& polygon, int parent);

  [[nodiscard]] Shape shapeOf(int P) const {
    const int face = list_[P].face, piece = progress_[P].piece;
    return {scene_.faces[face], face, list_[P].extents.box, piece == kNone ? nullptr : &pieces_[piece]};
  }
  /// Frees a region that is painted or split: it is never compared again.
  void forget(int P) {
    if (progress_[P].piece != kNone) Region{}.swap(pieces_[progress_[P].piece]);
  }

  [[nodiscard]] int idOf(int P) const {
    const int piece = progress_[P].piece;
    return piece == kNone ? list_[P].face : static_cast<int>(scene_.faces.size()) + firstPiece_ + piece;
  }
  void note(const Event& event) {
    if (sorted_.events.size() >= settings_.mostEvents)
      throw TooManyEvents{"the run has more than " + std::to_string(settings_.mostEvents) + " steps"};
    sorted_.events.push_back(event);
  }
  void note(Event::Kind kind, int P, int Q = kNone) {
    if (settings_.record)
      note({kind, Test::SamePlane, Verdict::PFirst, false, idOf(P), Q == kNone ? kNone : idOf(Q)});
  }

  const SnappedScene& scene_;
  const SortSettings& settings_;
  const RunLimits& limits_;
  PairTests& tests_;
  SortedScene& sorted_;
  int firstPiece_;  ///< of this run, in SortedScene::pieces
  int given_ = 0;   ///< number of polygons that were given
  std::int64_t splits_ = 0;
  std::vector<Polygon> list_;
  std::vector<int> turns_;          ///< the list by farthest z: the order in which its polygons become P
  std::vector<bool> free_;          ///< freePolygons() of the list
  std::vector<Progress> progress_;  ///< one for each polygon of the list
  std::vector<Region> pieces_;
  std::optional<BoxGrid> grid_;
  /// #cells + 1 and #cells: first polygon, first polygon not painted
  std::vector<int> cellBegin_, cellOpen_;
  /// #cells: a face, if all faces of the cell are of one surface with it; otherwise kNone
  std::vector<int> cellSurface_;
  std::vector<int> stack_;
};

// The list.

void NewellRun::enter(const PolygonList& list) {
  const std::vector<Polygon>& unsorted = list.polygons;
  given_ = static_cast<int>(unsorted.size());
  ListOrder order = listOrder(scene_, unsorted, settings_.grid && !settings_.textbook);
  list_.resize(given_);
  progress_.resize(given_);
  for (const int i : order.byDepth) {
    const int P = order.place[i];
    list_[P] = unsorted[i];
    if (!list.regions.empty() && !list.regions[i].empty())
      progress_[P].piece = enterRegion(list.regions[i], list_[P], list_[P].face);
  }
  if (!settings_.textbook && !settings_.inPixels && settings_.samples && list.regions.empty())
    free_ = freePolygons(scene_, unsorted, order.byDepth, settings_.width, settings_.height);
  turns_ = std::move(order.turns);
  grid_ = std::move(order.grid);
  cellBegin_ = std::move(order.cellBegin);
  cellOpen_.assign(cellBegin_.begin(), cellBegin_.end() - 1);
  cellSurface_ = std::move(order.cellSurface);
  if (settings_.record) {
    for (const int P : turns_) sorted_.list.push_back(list_[P].face);
    // Reserve room for most runs; memory that is never written costs nothing. Moving the events at every
    // doubling took a fifth of the time of a run.
    sorted_.events.reserve(std::min(std::size_t{16} * given_, settings_.mostEvents));
  }
}

int NewellRun::candidate(int P) {
  Progress& p = progress_[P];
  const Polygon& polygon = list_[P];
  auto& [apartInX, apartInY] = sorted_.statistics.boxesApart;
  for (;;) {
    for (; p.list < p.end; p.Q = ++p.list) {
      const Polygon& q = list_[p.list];
      if (q.extents.zFar > polygon.extents.zNear) break;  // so are all after it in this cell
      if (q.state == State::Painted) continue;
      if (!settings_.textbook && !polygon.extents.box.overlaps(q.extents.box)) {
        ++(polygon.extents.box.overlapsInX(q.extents.box) ? apartInY : apartInX);
        continue;
      }
      if (const int Q = openWithin(p.Q, P); Q != kNone) return p.Q = Q;
    }
    if (p.walking) ++p.place.column;
    p.walking = true;
    if (!grid_->settle(polygon.extents.box, p.place)) return kNone;
    const int cell = grid_->cell(p.place);
    p.end = cellBegin_[cell + 1];
    if (cellSurface_[cell] != kNone && oneSurface(scene_, cellSurface_[cell], polygon.face)) {
      p.list = p.end;
      continue;
    }
    int& open = cellOpen_[cell];
    while (open < p.end && list_[open].state == State::Painted) ++open;
    p.list = p.Q = open;
  }
}

/// The first polygon against which P must be tested, among Q and what follows it in its face: Q, its pieces
/// and the pieces after Q. Or kNone.
int NewellRun::openWithin(int Q, int P) const {
  const Polygon& p = list_[P];
  while (Q != kNone) {
    const Polygon& q = list_[Q];
    const bool reaches =
        q.extents.zFar <= p.extents.zNear && (settings_.textbook || p.extents.box.overlaps(q.extents.box));
    if (q.state != State::Painted && reaches && !oneSurface(scene_, p.face, q.face)) {
      if (q.state != State::Split) return Q;
      Q = progress_[Q].pieces;
    } else {
      Q = after(Q);
    }
  }
  return kNone;
}

// The algorithm.

void NewellRun::step() {
  const int P = stack_.back(), Q = candidate(P);
  if (Q == kNone) return paint(P);
  const Relation relation = tests_.compare(shapeOf(P), shapeOf(Q));
  ++sorted_.statistics.settled[static_cast<int>(relation.test)];
  sorted_.statistics.contacts += relation.contact;
  if (settings_.record)
    note({Event::Kind::Compare, relation.test, relation.verdict, relation.contact, idOf(P), idOf(Q)});
  switch (relation.verdict) {
    case Verdict::PFirst:
      return isHidden(P, Q) ? leaveOut(P) : settle(P);
    case Verdict::QFirst:
      if (list_[Q].state == State::Marked) return breakCycle(P, Q);
      ++sorted_.statistics.moves;
      note(Event::Kind::Move, P, Q);
      return mark(Q);
    case Verdict::Crossing:
      return splitCrossing(P, Q);
  }
}

void NewellRun::paint(int P) {
  note(Event::Kind::Paint, P);
  stack_.pop_back();
  const int piece = progress_[P].piece;
  sorted_.fragments.push_back({list_[P].face, piece == kNone ? kNone : firstPiece_ + piece});
  close(P);
}

void NewellRun::leaveOut(int P) {
  if (list_[P].state == State::Marked) unwind(progress_[P].depth);
  ++sorted_.statistics.hidden;
  close(P);
}

void NewellRun::close(int P) {
  list_[P].state = State::Painted;
  forget(P);
  // A split polygon is painted when both its pieces are.
  for (int parent = progress_[P].parent; parent != kNone; parent = progress_[parent].parent) {
    const int first = progress_[parent].pieces;
    if (list_[first].state != State::Painted || list_[first + 1].state != State::Painted) break;
    list_[parent].state = State::Painted;
  }
}

/// Breaks a cycle. R is marked. In the stack from R on, each polygon is nearer than the next one somewhere,
/// and the last one, P, is nearer than R somewhere. If one of these pairs is only a contact, that pair does
/// not count. If none is, a polygon is split.
void NewellRun::breakCycle(int P, int R) {
  ++sorted_.statistics.cycles;
  note(Event::Kind::Cycle, P, R);
  const int first = progress_[R].depth, last = static_cast<int>(stack_.size()) - 1;
  const auto next = [&](int depth) { return stack_[depth == last ? first : depth + 1]; };
  for (int depth = last; depth >= first; --depth) {
    const int A = stack_[depth], B = next(depth);
    if (tests_.overlapCounts(shapeOf(A), shapeOf(B))) continue;
    ++sorted_.statistics.voids;
    note(Event::Kind::Void, A, B);
    unwind(depth + 1);
    return settle(A);
  }

  // Try the textbook's choice, then P by the plane of each of the others, then the others. Of the proper
  // splits, take the first one that breaks the cycle, or the first one if none of those tried does. P's plane
  // properly crosses one of the others.
  std::optional<std::pair<int, int>> proper;
  const auto tries = [&](int depth, int Q) {
    const int A = stack_[depth];
    if (list_[A].face == list_[Q].face) return false;
    if (!tests_.crosses(shapeOf(A), shapeOf(Q))) {
      ++sorted_.statistics.impossible;
      note(Event::Kind::Impossible, A, Q);
      return false;
    }
    if (!proper) proper = {A, Q};
    const int before = stack_[depth == first ? last : depth - 1];
    if (tests_.separates(shapeOf(before), shapeOf(A), shapeOf(next(depth)), shapeOf(Q)))
      return split(A, Q), true;
    ++sorted_.statistics.vain;
    note(Event::Kind::Vain, A, Q);
    return false;
  };
  int left = kMostTries;
  for (int depth = last; depth >= first && left > 0; --depth)
    for (int by = first; by <= last && left > 0; ++by)
      if (by != depth && --left >= 0 && tries(depth, stack_[by])) return;
  for (int depth = last - 1; depth >= first && !proper; --depth)
    if (tries(depth, P)) return;
  if (!proper) throw std::logic_error{"a cycle without a proper split"};
  split(proper->first, proper->second);
}

/// P and Q cross where they overlap. Each one's plane properly crosses the other polygon.
void NewellRun::splitCrossing(int P, int Q) {
  const auto area = [&](int i) {
    const ScreenBox& b = list_[i].extents.box;
    return std::int64_t{b.x1 - b.x0} * (b.y1 - b.y0);
  };
  const bool splitQ = list_[Q].state != State::Marked &&
                      (settings_.crossing == SortSettings::Split::Second ||
                       (settings_.crossing == SortSettings::Split::Smaller && area(Q) < area(P)));
  const int cut = splitQ ? Q : P, by = splitQ ? P : Q;
  if (!tests_.crosses(shapeOf(cut), shapeOf(by))) throw std::logic_error{"a crossing without a proper split"};
  split(cut, by);
}

void NewellRun::split(int P, int Q) {
  ++sorted_.statistics.splits, ++splits_;
  note(Event::Kind::Split, P, Q);
  if (list_[P].state == State::Marked) unwind(progress_[P].depth);

  PairTests::Parts parts = tests_.split(shapeOf(P), shapeOf(Q));
  forget(P);
  list_[P].state = State::Split;
  progress_[P].pieces = static_cast<int>(list_.size());
  addPiece(P, std::move(parts.behind));
  addPiece(P, std::move(parts.front));
  if (const int behind = progress_[P].pieces; isHidden(behind, Q)) leaveOut(behind);
}

void NewellRun::addPiece(int P, Region region) {
  Polygon piece = list_[P];
  piece.state = State::Waiting;
  Progress progress = progress_[P];
  progress.parent = P;
  progress.pieces = kNone;
  piece.extents = extentsOf(scene_, scene_.faces[piece.face], region, piece.extents);
  progress.piece = enterRegion(std::move(region), piece, idOf(P));
  list_.push_back(piece);
  progress_.push_back(progress);
}

int NewellRun::enterRegion(Region region, const Polygon& polygon, int parent) {
  if (std::ssize(sorted_.pieces) >= settings_.mostPieces)
    throw tooManyPieces("the depth sort", settings_.mostPieces);
  enterPiece(sorted_, {polygon.face, parent}, region,
             rowsOf(polygon.extents.box, limits_.area, settings_.inPixels));
  pieces_.push_back(std::move(region));
  return static_cast<int>(pieces_.size()) - 1;
}

}  // namespace

bool runNewell(const PolygonList& list, const SnappedScene& scene, const SortSettings& settings,
               const RunLimits& limits, PairTests& tests, SortedScene& sorted) {
  return NewellRun{scene, settings, limits, tests, sorted}.sort(list);
}

}  // namespace xnewell
