#include "depthsort/depth_sort.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "depthsort/box_grid.h"
#include "depthsort/extents.h"
#include "depthsort/order.h"
#include "depthsort/region.h"
#include "depthsort/samples.h"

namespace {

constexpr int kNone = -1;

/// A polygon of the list, whole or a piece: what is asked of every Q, two to a cache line.
struct Polygon {
  enum class State : std::uint8_t { Waiting, Marked, Split, Painted };
  Extents extents;
  int face = 0;  ///< index into the scene's faces
  State state = State::Waiting;
};
static_assert(sizeof(Polygon) == 32);

/// What is only asked of P: its place in the tree of pieces and in the walk over the Q's. Those before are
/// settled, for good and for all pieces of P.
struct Progress {
  int list = 0, end = 0, Q = 0;  ///< list: the polygon the walk has come to, Q: it or a piece of it
  BoxGrid::Place place;
  bool walking = false;
  int depth = 0;      ///< in the stack, where marked
  int piece = kNone;  ///< index into pieces_, or a whole face
  int parent = kNone;
  int pieces = kNone;  ///< of a split one, the first of its two: behind, in front
};

/// The run. The list (whole faces first, pieces after them) is in the grid's order, cell by cell and in each
/// cell by farthest z.
class DepthSort {
 public:
  DepthSort(const SnappedScene& scene, const SortSettings& settings)
      : scene_{scene}, settings_{settings}, regions_{scene}, shared_{facesOfPlanes(scene)} {
    enterFaces();
  }

  SortedScene run() {
    for (int root = 0; root < faces_; ++root)
      for (int P; (P = nextOpen(root)) != kNone;) {
        note(Event::Kind::Take, P);
        mark(P);
        while (!stack_.empty()) step();
      }
    return std::move(sorted_);
  }

 private:
  using State = Polygon::State;

  // The list.

  void enterFaces();
  [[nodiscard]] Polygon enter(int face) const;
  [[nodiscard]] bool shows(const SnappedFace& face, const Box& box) const {
    const int width = settings_.width, height = settings_.height;
    return mayOwnSample(scene_, face, box, width, height) ||
           (settings_.inPixels && box.overlaps({0, 0, width * kGrid, height * kGrid}) &&
            hasAreaInPixels(scene_, face));
  }

  /// The polygon or piece after Q in the order of the list, without the pieces of Q.
  [[nodiscard]] int after(int Q) const {
    for (;;) {
      const int parent = progress_[Q].parent;
      if (parent == kNone) return kNone;
      if (progress_[parent].pieces == Q) return Q + 1;
      Q = parent;
    }
  }
  /// A face and itself, or parts of one model face in one plane: they show the same, whatever their order.
  [[nodiscard]] bool oneSurface(int f, int g) const {
    const SnappedFace &F = scene_.faces[f], &G = scene_.faces[g];
    return F.number == G.number && F.plane == G.plane;
  }
  /// The first of a face's pieces, or the face, that is neither painted nor split.
  [[nodiscard]] int nextOpen(int root) const {
    for (int P = root; P != kNone;) {
      if (list_[P].state == State::Waiting) return P;
      P = list_[P].state == State::Split ? progress_[P].pieces : after(P);
    }
    return kNone;
  }

  /// The next Q against which P is not settled, or kNone: P's walk stands there.
  [[nodiscard]] int candidate(int P);
  [[nodiscard]] int openWithin(int Q, int P) const;
  /// P is settled against the Q where its walk stands.
  void settle(int P) {
    Progress& p = progress_[P];
    p.Q = after(p.Q);
    if (p.Q == kNone) p.Q = ++p.list;
  }

  // The algorithm.

  void step();
  void mark(int P) {
    list_[P].state = State::Marked;
    progress_[P].depth = static_cast<int>(stack_.size());
    stack_.push_back(P);
    sorted_.statistics.deepest = std::max(sorted_.statistics.deepest, static_cast<int>(stack_.size()));
  }
  void paint(int P);
  void breakCycle(int P, int R);
  void splitCrossing(int P, int R);
  /// Unmarks all polygons above the place in the stack; their walks keep what is settled.
  void unwind(int depth) {
    while (static_cast<int>(stack_.size()) > depth) {
      list_[stack_.back()].state = State::Waiting;
      stack_.pop_back();
    }
  }
  /// Splits P by Q's plane, if that crosses it properly.
  bool split(int P, int Q);
  void addPiece(int P, Region region);

  // The tests.

  struct Relation {
    Test test;
    Verdict verdict;
    bool contact = false;
  };
  [[nodiscard]] Relation compare(int P, int Q);
  [[nodiscard]] bool projectionsApart(int P, int Q);
  [[nodiscard]] bool apartAlongEdges(const SnappedFace& P, const SnappedFace& Q) const;
  [[nodiscard]] bool apartAlongSides(const Region& P, const Region& Q) const;
  /// Regions::cut(), which remembers the last one: a pair asks for it again and again.
  [[nodiscard]] const Line& nearer(int p, int q) {
    if (line_.p == q && line_.q == p)
      line_ = Regions::flipped(line_);
    else if (line_.p != p || line_.q != q)
      line_ = regions_.cut(p, q);
    return line_;
  }
  /// Signs of zP - zQ all over P.
  [[nodiscard]] Signs signsOver(int P, int Q);
  [[nodiscard]] Relation overlap(int P, int Q);
  /// Whether a part of the overlap, or all of it, is more than a contact: deeper than the doubt of both
  /// (asked only if they are in two planes), and wide or owner of a sample.
  [[nodiscard]] bool counts(const Region& part, int P, int Q) const;
  /// Whether zP and zQ are further apart than both may be off, somewhere in the part.
  [[nodiscard]] bool isDeep(const Region& part, const SnappedFace& p, const SnappedFace& q) const;
  /// The polygon's region: of a piece the one that is kept, of a whole face made in `buffer`.
  [[nodiscard]] const Region& regionOf(int P, Region& buffer) const {
    if (progress_[P].piece != kNone) return pieces_[progress_[P].piece];
    regions_.outline(scene_.faces[list_[P].face], buffer);
    return buffer;
  }
  /// What is painted or split is compared no more.
  void forget(int P) {
    if (progress_[P].piece != kNone) Region{}.swap(pieces_[progress_[P].piece]);
  }
  void overlapOf(int P, int Q, Region& both) {
    both = regionOf(P, bufferP_);
    for (const Side& side : regionOf(Q, bufferQ_)) regions_.clip(both, side.line);
  }

  [[nodiscard]] const SnappedFace& faceOf(int P) const { return scene_.faces[list_[P].face]; }
  [[nodiscard]] int idOf(int P) const {
    return P < faces_ ? list_[P].face : static_cast<int>(scene_.faces.size()) + P - faces_;
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
  SortSettings settings_;
  Regions regions_;
  std::vector<std::uint8_t> shared_;  ///< facesOfPlanes()
  int faces_ = 0;                     ///< whole ones in the list
  std::vector<Polygon> list_;
  std::vector<Progress> progress_;  ///< of each in the list
  std::vector<Region> pieces_;
  std::optional<BoxGrid> grid_;
  std::vector<int> cellBegin_, cellOpen_;  ///< #cells + 1, #cells: first polygon, first not painted one
  std::vector<int> stack_;
  Region bufferP_, bufferQ_, both_, part_;
  Line line_;
  SortedScene sorted_;
};

// The list.

Polygon DepthSort::enter(int face) const {
  const SnappedFace& f = scene_.faces[face];
  Polygon P;
  P.extents = extentsOf(scene_, f, vertexDepthsAreExact(f, shared_));
  P.face = face;
  return P;
}

void DepthSort::enterFaces() {
  std::vector<Polygon> unsorted;
  unsorted.reserve(scene_.faces.size());
  const Box picture{0, 0, settings_.width * kGrid, settings_.height * kGrid};
  for (int f = 0; f < static_cast<int>(scene_.faces.size()); ++f) {
    unsorted.push_back(enter(f));
    if (settings_.textbook) continue;
    Box& box = unsorted.back().extents.box;
    if (!shows(scene_.faces[f], box))
      unsorted.pop_back();
    else  // outside the picture nothing is compared
      box = {std::max(box.x0, picture.x0), std::max(box.y0, picture.y0), std::min(box.x1, picture.x1),
             std::min(box.y1, picture.y1)};
  }

  std::vector<Box> boxes;
  boxes.reserve(unsorted.size());
  for (const Polygon& P : unsorted) boxes.push_back(P.extents.box);
  grid_.emplace(boxes, settings_.grid && !settings_.textbook);
  faces_ = static_cast<int>(unsorted.size());
  cellBegin_.assign(grid_->cells() + 1, 0);
  std::vector<int> cell(faces_);
  for (int i = 0; i < faces_; ++i) ++cellBegin_[(cell[i] = grid_->cellOf(boxes[i])) + 1];
  std::partial_sum(cellBegin_.begin(), cellBegin_.end(), cellBegin_.begin());
  cellOpen_.assign(cellBegin_.begin(), cellBegin_.end() - 1);

  // By farthest z, in scene order where that is equal; then cell by cell.
  std::vector<std::uint32_t> keys(faces_);
  std::ranges::transform(unsorted, keys.begin(), [](const Polygon& P) {
    return static_cast<std::uint32_t>(P.extents.zFar) ^ 0x80000000u;
  });
  list_.resize(faces_);
  progress_.resize(faces_);
  std::vector<int> next = cellOpen_;
  for (const int i : sortedByKey(keys)) list_[next[cell[i]]++] = unsorted[i];
  if (settings_.record) {
    for (const Polygon& P : list_) sorted_.list.push_back(P.face);
    // Room for most runs; what is never written to costs no memory. Moving the events whenever there are
    // twice as many took a fifth of the time of the run.
    sorted_.events.reserve(std::min(std::size_t{16} * faces_, settings_.mostEvents));
  }
}

int DepthSort::candidate(int P) {
  Progress& p = progress_[P];
  const Polygon& polygon = list_[P];
  auto& [apartInX, apartInY] = sorted_.statistics.boxesApart;
  for (;;) {
    for (; p.list < p.end; p.Q = ++p.list) {
      const Polygon& q = list_[p.list];
      if (q.extents.zFar > polygon.extents.zNear) break;  // as are all after it in this cell
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
    int& open = cellOpen_[cell];
    while (open < p.end && list_[open].state == State::Painted) ++open;
    p.list = p.Q = open;
  }
}

/// Q, or the first after it of the pieces of its face, against which P is to be tested.
int DepthSort::openWithin(int Q, int P) const {
  const Polygon& p = list_[P];
  while (Q != kNone) {
    const Polygon& q = list_[Q];
    const bool reaches =
        q.extents.zFar <= p.extents.zNear && (settings_.textbook || p.extents.box.overlaps(q.extents.box));
    if (q.state != State::Painted && reaches && !oneSurface(p.face, q.face)) {
      if (q.state != State::Split) return Q;
      Q = progress_[Q].pieces;
    } else {
      Q = after(Q);
    }
  }
  return kNone;
}

// The algorithm.

void DepthSort::step() {
  const int P = stack_.back(), Q = candidate(P);
  if (Q == kNone) return paint(P);

  const Relation relation = compare(P, Q);
  ++sorted_.statistics.settled[static_cast<int>(relation.test)];
  sorted_.statistics.contacts += relation.contact;
  if (settings_.record)
    note({Event::Kind::Compare, relation.test, relation.verdict, relation.contact, idOf(P), idOf(Q)});
  switch (relation.verdict) {
    case Verdict::PFirst:
      return settle(P);
    case Verdict::QFirst:
      if (list_[Q].state == State::Marked) return breakCycle(P, Q);
      ++sorted_.statistics.moves;
      note(Event::Kind::Move, P, Q);
      return mark(Q);
    case Verdict::Crossing:
      return splitCrossing(P, Q);
  }
}

void DepthSort::paint(int P) {
  note(Event::Kind::Paint, P);
  stack_.pop_back();
  sorted_.fragments.push_back({list_[P].face, progress_[P].piece});
  list_[P].state = State::Painted;
  forget(P);
  // Of a split polygon all is painted when both pieces are.
  for (int parent = progress_[P].parent; parent != kNone; parent = progress_[parent].parent) {
    const int first = progress_[parent].pieces;
    if (list_[first].state != State::Painted || list_[first + 1].state != State::Painted) break;
    list_[parent].state = State::Painted;
  }
}

/// R is marked, and each polygon from there on in the stack is nearer than the next one somewhere; the last
/// one, P, than R. An edge of this cycle that is only a contact is void; without one, a polygon is split.
void DepthSort::breakCycle(int P, int R) {
  ++sorted_.statistics.cycles;
  note(Event::Kind::Cycle, P, R);
  const int first = progress_[R].depth, last = static_cast<int>(stack_.size()) - 1;
  const auto next = [&](int depth) { return stack_[depth == last ? first : depth + 1]; };
  for (int depth = last; depth >= first; --depth) {
    const int A = stack_[depth], B = next(depth);
    overlapOf(A, B, both_);
    if (counts(both_, A, B)) continue;
    ++sorted_.statistics.voids;
    note(Event::Kind::Void, A, B);
    unwind(depth + 1);
    return settle(A);
  }

  // The textbook's choice, then neighbours, last any: P's plane properly crosses one of them.
  if (split(P, R) || split(R, P)) return;
  for (int depth = last - 1; depth >= first; --depth)
    if (split(stack_[depth], next(depth)) || split(next(depth), stack_[depth])) return;
  for (int depth = last - 1; depth >= first; --depth)
    if (split(stack_[depth], P)) return;
  throw std::logic_error{"a cycle without a proper split"};
}

/// P and Q cross where they overlap: either plane properly crosses the other polygon.
void DepthSort::splitCrossing(int P, int Q) {
  const auto area = [&](int i) {
    const Box& b = list_[i].extents.box;
    return std::int64_t{b.x1 - b.x0} * (b.y1 - b.y0);
  };
  const bool splitQ = list_[Q].state != State::Marked &&
                      (settings_.crossing == SortSettings::Split::Second ||
                       (settings_.crossing == SortSettings::Split::Smaller && area(Q) < area(P)));
  if (!(splitQ ? split(Q, P) : split(P, Q))) throw std::logic_error{"a crossing without a proper split"};
}

bool DepthSort::split(int P, int Q) {
  if (!signsOver(P, Q).both()) {
    ++sorted_.statistics.impossible;
    note(Event::Kind::Impossible, P, Q);
    return false;
  }
  ++sorted_.statistics.splits;
  note(Event::Kind::Split, P, Q);
  if (list_[P].state == State::Marked) unwind(progress_[P].depth);

  const Line line = nearer(faceOf(P).plane, faceOf(Q).plane);
  Region front = regionOf(P, bufferP_), behind = front;
  forget(P);
  regions_.clip(behind, Regions::flipped(line));
  regions_.clip(front, line);
  list_[P].state = State::Split;
  progress_[P].pieces = static_cast<int>(list_.size());
  addPiece(P, std::move(behind));
  addPiece(P, std::move(front));
  return true;
}

void DepthSort::addPiece(int P, Region region) {
  Polygon piece = list_[P];
  piece.state = State::Waiting;
  Progress progress = progress_[P];
  progress.parent = P;
  progress.pieces = kNone;
  progress.piece = static_cast<int>(pieces_.size());
  Piece record{piece.face, static_cast<int>(sorted_.cuts.size()), 0, 0, 0, idOf(P)};

  for (const Side& side : region)
    if (side.line.kind == Line::Kind::Cut) {
      sorted_.cuts.push_back({side.line.p, side.line.q});
      ++record.cuts;
    }
  piece.extents = extentsOf(scene_, faceOf(P), region, piece.extents);
  const Box& box = piece.extents.box;
  record.firstRow = std::max(0, box.y0 >> kGridBits);
  record.rows = std::max(0, std::min(settings_.height, (box.y1 >> kGridBits) + 1) - record.firstRow);
  list_.push_back(piece);
  progress_.push_back(progress);
  pieces_.push_back(std::move(region));
  sorted_.pieces.push_back(record);
}

// The tests.

DepthSort::Relation DepthSort::compare(int P, int Q) {
  const Polygon &p = list_[P], &q = list_[Q];
  if (settings_.textbook) {
    if (p.extents.box.x1 <= q.extents.box.x0 || q.extents.box.x1 <= p.extents.box.x0)
      return {Test::XExtents, Verdict::PFirst};
    if (p.extents.box.y1 <= q.extents.box.y0 || q.extents.box.y1 <= p.extents.box.y0)
      return {Test::YExtents, Verdict::PFirst};
  } else if (projectionsApart(P, Q)) {
    return {Test::Projections, Verdict::PFirst};
  }
  const Signs pOverQ = signsOver(P, Q);
  if (pOverQ.none()) {
    if (settings_.textbook && projectionsApart(P, Q)) return {Test::Projections, Verdict::PFirst};
    return {Test::SamePlane, p.face < q.face ? Verdict::PFirst : Verdict::QFirst};
  }
  if (!pOverQ.positive) return {Test::PBehindQ, Verdict::PFirst};
  const Signs qOverP = signsOver(Q, P);
  if (!qOverP.negative) return {Test::QInFrontOfP, Verdict::PFirst};
  if (settings_.textbook && projectionsApart(P, Q)) return {Test::Projections, Verdict::PFirst};
  if (!qOverP.positive) return {Test::QBehindP, Verdict::QFirst};
  if (!pOverQ.negative) return {Test::PInFrontOfQ, Verdict::QFirst};
  return overlap(P, Q);
}

Signs DepthSort::signsOver(int P, int Q) {
  const SnappedFace &p = faceOf(P), &q = faceOf(Q);
  if (p.plane == q.plane) return {};
  const ScreenPlane &planeP = scene_.planes[p.plane], &planeQ = scene_.planes[q.plane];
  if (progress_[P].piece != kNone)
    return regions_.signs(nearer(p.plane, q.plane), pieces_[progress_[P].piece]);
  Signs signs;
  const glm::ivec3* const v = &scene_.vertices[p.first];
  if (vertexDepthsAreExact(p, shared_)) {
    for (int k = 0; k < 3; ++k) {
      const Int128 above = Int128{planeQ.C} * v[k].z - Int128{planeQ.A} * v[k].x - Int128{planeQ.B} * v[k].y -
                           planeQ.D;  // below 2^95
      signs.add(above < 0 ? -1 : above > 0);
    }
  } else {
    for (int k = 0; k < p.count; ++k) signs.add(compareDepths(planeP, planeQ, v[k].x, v[k].y));
  }
  return signs;
}

bool DepthSort::projectionsApart(int P, int Q) {
  if (progress_[P].piece == kNone && progress_[Q].piece == kNone)
    return apartAlongEdges(faceOf(P), faceOf(Q)) || apartAlongEdges(faceOf(Q), faceOf(P));
  const Region &p = regionOf(P, bufferP_), &q = regionOf(Q, bufferQ_);
  return apartAlongSides(p, q) || apartAlongSides(q, p);
}

bool DepthSort::apartAlongEdges(const SnappedFace& P, const SnappedFace& Q) const {
  const glm::ivec3 *const p = &scene_.vertices[P.first], *const q = &scene_.vertices[Q.first];
  for (int k = 0; k < P.count; ++k) {
    const glm::ivec3 &a = p[k], &b = p[k + 1 == P.count ? 0 : k + 1];
    const std::int64_t A = b.y - a.y, B = a.x - b.x;
    bool outside = true;
    for (int i = 0; i < Q.count && outside; ++i)
      outside = A * (q[i].x - a.x) + B * (q[i].y - a.y) <= 0;  // below 2^61
    if (outside) return true;
  }
  return false;
}

bool DepthSort::apartAlongSides(const Region& P, const Region& Q) const {
  return std::ranges::any_of(P, [&](const Side& side) { return !regions_.signs(side.line, Q).positive; });
}

DepthSort::Relation DepthSort::overlap(int P, int Q) {
  overlapOf(P, Q, both_);
  const Line line = nearer(faceOf(P).plane, faceOf(Q).plane);
  const Signs signs = regions_.signs(line, both_);
  if (!signs.both()) return {Test::Overlap, signs.positive ? Verdict::QFirst : Verdict::PFirst};

  part_ = both_;
  regions_.clip(part_, line);
  const bool pOverQ = counts(part_, P, Q);
  regions_.clip(both_, Regions::flipped(line));
  const bool qOverP = counts(both_, P, Q);
  if (pOverQ && qOverP) return {Test::Overlap, Verdict::Crossing};
  const bool qFirst = pOverQ || (!qOverP && list_[P].face > list_[Q].face);
  return {Test::Overlap, qFirst ? Verdict::QFirst : Verdict::PFirst, true};
}

/// Along an edge the depths are linear and the doubt is a parabola, so how far they exceed it has one
/// maximum. Along lines of equal depth, within the part, all is linear: the edges tell of the whole.
bool DepthSort::isDeep(const Region& part, const SnappedFace& p, const SnappedFace& q) const {
  struct Depths {
    double p, q;
  };
  const auto depthsAt = [&](const Corner& corner) -> Depths {
    const auto x = std::llrint(corner.x), y = std::llrint(corner.y);
    return {depthAt(scene_.planes[p.plane], x, y), depthAt(scene_.planes[q.plane], x, y)};
  };
  const auto doubtAt = [&](const Depths& z) { return p.doubt.at(z.p) + q.doubt.at(z.q); };
  Depths a = depthsAt(part.back().corner);
  for (const Side& side : part) {
    const Depths b = depthsAt(side.corner);
    const double apart = a.p - a.q, growth = b.p - b.q - apart, doubt = doubtAt(a);
    const double bend = p.doubt.byZZ * (b.p - a.p) * (b.p - a.p) + q.doubt.byZZ * (b.q - a.q) * (b.q - a.q);
    const double rise = doubtAt(b) - doubt - bend;  // the doubt at a + s (b - a): doubt + rise s + bend s^2
    for (const double sign : {1.0, -1.0}) {
      const double ahead = sign * growth - rise;
      const double s = ahead <= 0.0 ? 0.0 : ahead >= 2.0 * bend ? 1.0 : ahead / (2.0 * bend);
      if (sign * apart - doubt + s * (ahead - s * bend) > 0.0) return true;
    }
    a = b;
  }
  return false;
}

bool DepthSort::counts(const Region& part, int P, int Q) const {
  const SnappedFace &p = faceOf(P), &q = faceOf(Q);
  const bool doubted = p.doubt.atBack + q.doubt.atBack > 0.0f;
  if (doubted && !regions_.samePlane(p.plane, q.plane) && !isDeep(part, p, q)) return false;
  return isWide(part) || ownsSample(scene_, part, settings_.width, settings_.height);
}

}  // namespace

SortedScene depthSort(const SnappedScene& scene, const SortSettings& settings) {
  return DepthSort{scene, settings}.run();
}
