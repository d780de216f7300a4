#include "depthsort/pair_tests.h"

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/view/scene_planes.h"

namespace xnewell {

PairTests::PairTests(const SnappedScene& scene, const SortSettings& settings)
    : scene_{scene},
      width_{settings.width},
      height_{settings.height},
      textbook_{settings.textbook},
      planes_{settings.planes},
      regions_{scene} {}

Relation PairTests::compare(const Shape& P, const Shape& Q) {
  if (textbook_) {
    if (!P.box.overlapsInX(Q.box)) return {Test::XExtents, Verdict::PFirst};
    if (!P.box.overlaps(Q.box)) return {Test::YExtents, Verdict::PFirst};
  } else if (projectionsApart(P, Q)) {
    return {Test::Projections, Verdict::PFirst};
  }
  const Signs pOverQ = signsOver(P, Q);
  if (pOverQ.none()) {
    if (textbook_ && projectionsApart(P, Q)) return {Test::Projections, Verdict::PFirst};
    return {Test::SamePlane, P.index < Q.index ? Verdict::PFirst : Verdict::QFirst};
  }
  if (!pOverQ.positive) return {Test::PBehindQ, Verdict::PFirst};
  const Signs qOverP = signsOver(Q, P);
  if (!qOverP.negative) return {Test::QInFrontOfP, Verdict::PFirst};
  if (textbook_ && projectionsApart(P, Q)) return {Test::Projections, Verdict::PFirst};
  if (!qOverP.positive) return {Test::QBehindP, Verdict::QFirst};
  if (!pOverQ.negative) return {Test::PInFrontOfQ, Verdict::QFirst};
  return nearerInOverlap(P, Q);
}

bool PairTests::passes(Test test, const Shape& P, const Shape& Q) {
  switch (test) {
    case Test::XExtents:
      return !P.box.overlapsInX(Q.box);
    case Test::YExtents:
      return !P.box.overlapsInY(Q.box);
    case Test::PBehindQ: {
      const Signs signs = signsOver(P, Q);
      return !signs.none() && !signs.positive;
    }
    case Test::QInFrontOfP: {
      const Signs signs = signsOver(Q, P);
      return !signs.none() && !signs.negative;
    }
    case Test::Projections:
      return projectionsApart(P, Q);
    default:
      return false;
  }
}

const ScreenPlane& PairTests::planeOf(const SnappedFace& face) {
  if (planes_) planes_->make(face);
  return scene_.planes[face.plane];
}

Signs PairTests::signsOver(const Shape& P, const Shape& Q) {
  const SnappedFace &p = P.face, &q = Q.face;
  if (p.plane == q.plane) return {};
  if (P.piece) return regions_.signs(nearer(p, q), *P.piece);
  const ScreenPlane& planeQ = planeOf(q);
  Signs signs;
  const glm::ivec3* const v = &scene_.vertices[p.first];
  if (p.throughVertices) {
    for (int k = 0; k < 3; ++k) {
      const Int128 above = Int128{planeQ.C} * v[k].z - Int128{planeQ.A} * v[k].x - Int128{planeQ.B} * v[k].y -
                           planeQ.D;  // below 2^95
      signs.add(above < 0 ? -1 : above > 0);
    }
  } else {
    const ScreenPlane& planeP = planeOf(p);
    for (int k = 0; k < p.count; ++k) signs.add(compareDepths(planeP, planeQ, v[k].x, v[k].y));
  }
  return signs;
}

bool PairTests::projectionsApart(const Shape& P, const Shape& Q) {
  if (!P.piece && !Q.piece) return apartAlongEdges(P.face, Q.face) || apartAlongEdges(Q.face, P.face);
  const Region &p = regionOf(P, bufferP_), &q = regionOf(Q, bufferQ_);
  return apartAlongSides(p, q) || apartAlongSides(q, p);
}

bool PairTests::apartAlongEdges(const SnappedFace& P, const SnappedFace& Q) const {
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

// All polygons of a run lie in its area, so the sides of the area part none.
bool PairTests::apartAlongSides(const Region& P, const Region& Q) const {
  return std::ranges::any_of(
      P, [&](const Side& side) { return !side.line.isOfArea() && !regions_.reaches(Q, side.line); });
}

Relation PairTests::nearerInOverlap(const Shape& P, const Shape& Q) {
  overlap(P, Q);
  const Line line = nearer(P.face, Q.face);
  const Signs signs = regions_.signs(line, both_);
  if (!signs.both()) return {Test::Overlap, signs.positive ? Verdict::QFirst : Verdict::PFirst};

  part_ = both_;
  regions_.clip(part_, line);
  const bool pOverQ = counts(part_, P.face, Q.face);
  regions_.clip(both_, Regions::flipped(line));
  const bool qOverP = counts(both_, Q.face, P.face);
  if (pOverQ && qOverP) return {Test::Overlap, Verdict::Crossing};
  const bool qFirst = pOverQ || (!qOverP && P.index > Q.index);
  return {Test::Overlap, qFirst ? Verdict::QFirst : Verdict::PFirst, true};
}

/// The depths are linear over the screen, and the doubt is linear in the depth. So the excess of the
/// difference over the doubt is greatest in a corner.
bool PairTests::isDeep(const Region& part, const SnappedFace& front, const SnappedFace& behind) const {
  return std::ranges::any_of(part, [&](const Side& side) {
    return !mayTouch(scene_, front, behind, std::llrint(side.corner.x), std::llrint(side.corner.y));
  });
}

bool PairTests::counts(const Region& part, const SnappedFace& front, const SnappedFace& behind) const {
  const bool doubted = scene_.doubtOf(front).atBack + scene_.doubtOf(behind).atBack > 0.0f;
  if (doubted && !regions_.samePlane(front.plane, behind.plane) && !isDeep(part, front, behind)) return false;
  return isWide(part) || ownsSample(scene_, part, width_, height_);
}

bool PairTests::hides(const Shape& Q, const Shape& P) {
  const Signs signs = signsOver(P, Q);
  if (signs.positive || !signs.negative) return false;
  const Region& p = regionOf(P, bufferP_);
  regions_.outline(Q.face, bufferQ_);
  return std::ranges::none_of(bufferQ_,
                              [&](const Side& side) { return regions_.signs(side.line, p).negative; });
}

bool PairTests::overlapCounts(const Shape& P, const Shape& Q) {
  overlap(P, Q);
  return !both_.empty() && counts(both_, P.face, Q.face);
}

bool PairTests::separates(const Shape& before, const Shape& A, const Shape& next, const Shape& Q) {
  const Parts parts = split(A, Q);
  const auto stays = [&](const Region& part) {
    const Shape piece{A.face, A.index, A.box, &part};
    return overlapCounts(before, piece) && overlapCounts(piece, next);
  };
  return !stays(parts.behind) && !stays(parts.front);
}

PairTests::Parts PairTests::split(const Shape& P, const Shape& Q) {
  const Line line = nearer(P.face, Q.face);
  Parts parts{regionOf(P, bufferP_), regionOf(P, bufferP_)};
  regions_.clip(parts.behind, Regions::flipped(line));
  regions_.clip(parts.front, line);
  return parts;
}

const Line& PairTests::nearer(const SnappedFace& p, const SnappedFace& q) {
  if (line_.p == q.plane && line_.q == p.plane)
    line_ = Regions::flipped(line_);
  else if (line_.p != p.plane || line_.q != q.plane)
    planeOf(p), planeOf(q), line_ = regions_.cut(p.plane, q.plane);
  return line_;
}

const Region& PairTests::regionOf(const Shape& P, Region& buffer) const {
  if (P.piece) return *P.piece;
  regions_.outline(P.face, buffer);
  return buffer;
}

void PairTests::overlap(const Shape& P, const Shape& Q) {
  both_ = regionOf(P, bufferP_);
  for (const Side& side : regionOf(Q, bufferQ_))
    if (!side.line.isOfArea()) regions_.clip(both_, side.line);
}

}  // namespace xnewell
