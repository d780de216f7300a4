#include "depthsort/record/explain.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "geometry/view/scene_planes.h"

namespace xnewell {

namespace {

/// A name of bounded length. It is cut at a character's boundary.
std::string shortened(const std::string& name) {
  constexpr std::size_t kMost = 48;  // bytes
  if (name.size() <= kMost) return name;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  return name.substr(0, end) + "...";
}

}  // namespace

Fragments::Fragments(const Mesh& mesh, const SnappedScene& scene, const SortedScene& sorted)
    : mesh_{&mesh},
      scene_{&scene},
      sorted_{&sorted},
      faces_{static_cast<int>(scene.faces.size())},
      regions_{scene} {
  for (const Event& e : sorted.events)
    if (e.kind == Event::Kind::Split) splitter_.push_back(face(e.Q).plane);
  for (const int group : mesh.group) ++facesNamed_[mesh.groupNames[group]];
}

Region Fragments::region(int id) const {
  Region region;
  if (!isPiece(id)) {
    regions_.outline(scene_->faces[id], region);
    return region;
  }
  region = this->region(parent(id));
  const int k = (id - faces_) / 2;
  const Line nearer = regions_.cut(face(id).plane, splitter_[k]);
  regions_.clip(region, id == pieceOf(k) ? Regions::flipped(nearer) : nearer);
  return region;
}

Extents Fragments::extents(int id) const {
  if (!isPiece(id)) return extentsOf(*scene_, face(id));
  return extentsOf(*scene_, face(id), region(id), extents(parent(id)));
}

std::string Fragments::path(int id) const {
  std::string splits;
  while (isPiece(id)) {
    splits += (id - faces_) % 2 == 0 ? 'a' : 'b';
    id = parent(id);
  }
  std::ranges::reverse(splits);

  const int number = face(id).number;
  const auto numberOf = [&](int i) { return scene_->faces[i].number; };
  int part = 1;
  while (id - part >= 0 && numberOf(id - part) == number) ++part;
  if (part > 1 || (id + 1 < faces_ && numberOf(id + 1) == number)) return "." + std::to_string(part) + splits;
  return splits;
}

const std::string& Fragments::group(int id) const { return mesh_->groupNames[mesh_->group[face(id).number]]; }

bool Fragments::hasName(int id) const {
  // Sentences use these for the two polygons of a pair.
  constexpr std::array<std::string_view, 4> kRoles{"P", "Q", "p", "q"};
  const std::string& name = group(id);
  return !name.empty() && std::ranges::find(kRoles, name) == kRoles.end() && facesNamed_.at(name) == 1;
}

std::string Fragments::name(int id) const {
  const std::string name = hasName(id) ? shortened(group(id)) : "face " + std::to_string(face(id).number);
  const std::string path = this->path(id);
  const bool joins =
      path.empty() || path.front() == '.' || std::isdigit(static_cast<unsigned char>(name.back())) != 0;
  return name + (joins ? "" : ".") + path;
}

std::string Fragments::number(int id) const { return std::to_string(face(id).number) + path(id); }

std::string Fragments::part(int id) const { return hasName(id) ? name(id) : shortened(group(id)); }

namespace {

double onScreen(double grid) { return grid / kGrid; }

/// The text with {P} and {Q} replaced by names.
std::string filled(std::string_view text, const std::string& P, const std::string& Q) {
  std::string sentence;
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at, 3) == "{P}") {
      sentence += P;
      at += 3;
    } else if (text.substr(at, 3) == "{Q}") {
      sentence += Q;
      at += 3;
    } else {
      sentence += text[at++];
    }
  }
  return sentence;
}

/// Why a test settles a pair with P first, or if it is one of the last two, with Q first. In one plane and in
/// the overlap the verdict decides.
constexpr std::array<std::string_view, kTests> kReasons{
    "{P} and {Q} lie in one plane, where the later face of the scene counts as nearer: that is {Q}, so {P} "
    "may be "
    "painted first.",
    "the x-extents of {P} and {Q} do not overlap, so {P} cannot hide {Q} and may be painted first.",
    "the y-extents of {P} and {Q} do not overlap, so {P} cannot hide {Q} and may be painted first.",
    "{P} lies wholly behind the plane of {Q}, so it cannot hide {Q} and may be painted first.",
    "{Q} lies wholly in front of the plane of {P}, so {P} cannot hide it and may be painted first.",
    "the projections of {P} and {Q} do not overlap, so {P} cannot hide {Q} and may be painted first.",
    "{Q} lies wholly behind the plane of {P}, so it cannot hide {P} and may be painted before it.",
    "{P} lies wholly in front of the plane of {Q}, so {Q} cannot hide it and may be painted before it.",
    "where they overlap, {P} is nowhere nearer than {Q}, so it may be painted first."};

std::string_view reasonOf(Test test, Verdict verdict) {
  if (verdict == Verdict::Crossing)
    return "where they overlap, {P} is nearer in one part and {Q} in another: one of them must be split.";
  if (verdict == Verdict::QFirst && test == Test::SamePlane)
    return "{P} and {Q} lie in one plane, where the later face of the scene counts as nearer: that is {P}, "
           "so {Q} "
           "may be painted first.";
  if (verdict == Verdict::QFirst && test == Test::Overlap)
    return "where they overlap, {Q} is nowhere nearer than {P}, so it may be painted first.";
  return kReasons[static_cast<std::size_t>(test)];
}

/// Why a test does not prove what it asks for.
constexpr std::array<std::string_view, kTests> kRefutations{
    "{P} and {Q} lie in different planes.",
    "the x-extents of {P} and {Q} overlap.",
    "the y-extents of {P} and {Q} overlap.",
    "a part of {P} lies in front of the plane of {Q}.",
    "a part of {Q} lies behind the plane of {P}.",
    "the projections of {P} and {Q} overlap.",
    "a part of {Q} lies in front of the plane of {P}.",
    "a part of {P} lies behind the plane of {Q}.",
    ""};

CornerCounts countsOf(const Regions& regions, const Line& line, const Region& region) {
  CornerCounts counts;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const Side &side = region[k], &next = region[k + 1 == region.size() ? 0 : k + 1];
    const int sign = regions.sign(line, side.line, next.line, side.corner);
    ++(sign > 0 ? counts.inFront : sign < 0 ? counts.behind : counts.on);
  }
  return counts;
}

/// z at a corner, which need not lie on the grid: the rest is small, so doubles hold it.
double depthAtCorner(const ScreenPlane& p, const Corner& at) {
  const auto x = std::llrint(at.x), y = std::llrint(at.y);
  const double rest = static_cast<double>(p.A) * (at.x - static_cast<double>(x)) +
                      static_cast<double>(p.B) * (at.y - static_cast<double>(y));
  return depthAt(p, x, y) + rest / static_cast<double>(p.C);
}

}  // namespace

std::vector<CornerDistance> distancesFromPlane(const SnappedScene& scene, const Region& region,
                                               const SnappedFace& of, const SnappedFace& planeOf) {
  const Regions regions{scene};
  const bool same = regions.samePlane(of.plane, planeOf.plane);
  const Line nearer = same ? Line{} : regions.cut(of.plane, planeOf.plane);
  const ScreenPlane &own = scene.planes[of.plane], &other = scene.planes[planeOf.plane];
  std::vector<CornerDistance> distances;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const Side &side = region[k], &next = region[k + 1 == region.size() ? 0 : k + 1];
    const int sign = same ? 0 : regions.sign(nearer, side.line, next.line, side.corner);
    const SnappedFace &front = sign > 0 ? of : planeOf, &behind = sign > 0 ? planeOf : of;
    const double ahead = depthAtCorner(own, side.corner) - depthAtCorner(other, side.corner);
    distances.push_back({{onScreen(side.corner.x), onScreen(side.corner.y)},
                         std::ldexp(onScreen(ahead), scene.zShift),
                         sign,
                         sign == 0 || mayTouch(scene, front, behind, std::llrint(side.corner.x),
                                               std::llrint(side.corner.y))});
  }
  return distances;
}

std::optional<PlaneTest> planeTestOf(Test test) {
  if (test == Test::PBehindQ || test == Test::PInFrontOfQ)
    return PlaneTest{true, test == Test::PBehindQ ? -1 : 1};
  if (test == Test::QBehindP || test == Test::QInFrontOfP)
    return PlaneTest{false, test == Test::QBehindP ? -1 : 1};
  return std::nullopt;
}

std::string_view wordFor(Event::Kind kind) {
  constexpr std::array<std::string_view, 9> kWords{"take", "test",    "move", "cycle", "impossible",
                                                   "vain", "contact", "cut",  "paint"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::vector<Test> Explainer::testsMade(const Event& compare) const {
  using enum Test;
  static constexpr std::array kTextbook{XExtents,    YExtents, PBehindQ,    QInFrontOfP,
                                        Projections, QBehindP, PInFrontOfQ, Overlap};
  static constexpr std::array kQuick{Projections, PBehindQ, QInFrontOfP, QBehindP, PInFrontOfQ, Overlap};
  const std::span<const Test> order =
      textbook_ ? std::span<const Test>{kTextbook} : std::span<const Test>{kQuick};
  // If two faces in one plane overlap on the screen, only their numbers decide. Tests 3 and 4 are not made.
  const Test last = compare.test == SamePlane ? Projections : compare.test;
  std::vector<Test> made{order.begin(), std::ranges::find(order, last) + 1};
  if (regions_.samePlane(fragments_.face(compare.P).plane, fragments_.face(compare.Q).plane))
    std::erase_if(made, [](Test test) { return test == PBehindQ || test == QInFrontOfP; });
  if (compare.test == SamePlane) made.push_back(SamePlane);
  return made;
}

double Explainer::pixels(double zSteps) const { return std::ldexp(onScreen(zSteps), scene_->zShift); }

Range Explainer::xExtent(int id) const {
  const ScreenBox box = fragments_.extents(id).box;
  return {onScreen(box.x0), onScreen(box.x1)};
}

Range Explainer::yExtent(int id) const {
  const ScreenBox box = fragments_.extents(id).box;
  return {onScreen(box.y0), onScreen(box.y1)};
}

Range Explainer::zExtent(int id) const {
  const Extents extents = fragments_.extents(id);
  return {pixels(extents.zFar), pixels(extents.zNear)};
}

CornerCounts Explainer::corners(int of, int fromPlaneOf) const {
  const Line nearer = regions_.cut(fragments_.face(of).plane, fragments_.face(fromPlaneOf).plane);
  return countsOf(regions_, nearer, fragments_.region(of));
}

std::optional<SeparatingEdge> Explainer::separatingEdge(int P, int Q) const {
  const Region p = fragments_.region(P), q = fragments_.region(Q);
  for (const bool ofP : {true, false}) {
    const Region &mine = ofP ? p : q, &others = ofP ? q : p;
    for (std::size_t k = 0; k < mine.size(); ++k) {
      if (regions_.signs(mine[k].line, others).positive) continue;
      const Corner &from = mine[k == 0 ? mine.size() - 1 : k - 1].corner, &to = mine[k].corner;
      return SeparatingEdge{ofP, onScreen(from.x), onScreen(from.y), onScreen(to.x), onScreen(to.y)};
    }
  }
  return std::nullopt;
}

std::vector<CornerDistance> Explainer::distances(int of, int fromPlaneOf) const {
  return distancesFromPlane(*scene_, fragments_.region(of), fragments_.face(of),
                            fragments_.face(fromPlaneOf));
}

double Explainer::depth(int id, Place at) const {
  return pixels(depthAt(scene_->planes[fragments_.face(id).plane], std::llrint(at.x * kGrid),
                        std::llrint(at.y * kGrid)));
}

Region Explainer::common(int P, int Q) const {
  Region both = fragments_.region(P);
  for (const Side& side : fragments_.region(Q)) regions_.clip(both, side.line);
  return both;
}

std::vector<Place> Explainer::overlap(int P, int Q) const {
  std::vector<Place> corners;
  for (const Side& side : common(P, Q)) corners.push_back({onScreen(side.corner.x), onScreen(side.corner.y)});
  return corners;
}

CommonArea Explainer::commonArea(int P, int Q) const {
  const Region both = common(P, Q);
  const SnappedFace &p = fragments_.face(P), &q = fragments_.face(Q);
  CommonArea common;
  if (both.empty()) return common;

  common.corners = static_cast<int>(both.size());
  common.P = countsOf(regions_, regions_.cut(p.plane, q.plane), both);
  double low = std::numeric_limits<double>::infinity(), high = -low, doubt = 0.0;
  const Corner& anchor = both.front().corner;
  for (std::size_t k = 0; k < both.size(); ++k) {
    const Corner &a = both[k].corner, &b = both[k + 1 == both.size() ? 0 : k + 1].corner;
    common.area += (onScreen(b.x - anchor.x) * onScreen(a.y - anchor.y) -
                    onScreen(a.x - anchor.x) * onScreen(b.y - anchor.y)) /
                   2.0;
    const auto x = std::llrint(a.x), y = std::llrint(a.y);
    const double zP = depthAt(scene_->planes[p.plane], x, y), zQ = depthAt(scene_->planes[q.plane], x, y);
    low = std::min(low, zP - zQ), high = std::max(high, zP - zQ);
    doubt = std::max(doubt, scene_->doubtOf(p).at(zP) + scene_->doubtOf(q).at(zQ));
  }
  common.aheadOfQ = {pixels(low), pixels(high)};
  common.doubt = pixels(doubt);
  return common;
}

std::string Explainer::settled(const Event& e) const {
  std::string_view reason = reasonOf(e.test, e.verdict);
  if (e.contact)
    reason = e.verdict == Verdict::PFirst ? "where they overlap, {P} and {Q} cross, but one of the two "
                                            "parts, or both, is only a contact; {P} may be painted first."
                                          : "where they overlap, {P} and {Q} cross, but one of the two "
                                            "parts, or both, is only a contact; {Q} must be painted first.";
  return filled(reason, called(e.P, "P"), called(e.Q, "Q"));
}

std::string Explainer::failed(const Event& e, Test test) const {
  const bool aboutPlanes = test == Test::PBehindQ || test == Test::QInFrontOfP;
  if (aboutPlanes && regions_.samePlane(fragments_.face(e.P).plane, fragments_.face(e.Q).plane))
    return filled("{P} and {Q} lie in one plane.", called(e.P, "P"), called(e.Q, "Q"));
  return filled(kRefutations[static_cast<std::size_t>(test)], called(e.P, "P"), called(e.Q, "Q")) +
         (failsByRounding(e, test) ? " Within rounding, it lies on that plane." : "");
}

bool Explainer::failsByRounding(const Event& e, Test test) const {
  const std::optional<PlaneTest> plane = planeTestOf(test);
  if (!plane || test == e.test) return false;
  return std::ranges::all_of(plane->ofP ? distances(e.P, e.Q) : distances(e.Q, e.P),
                             [&](const CornerDistance& c) { return c.sign == plane->side || c.mayBeOn; });
}

std::string Explainer::sentence(const Event& e, Test test) const {
  const std::string title = (test == Test::SamePlane ? "Test of the " : "Test ") +
                            std::string{kTestRows[static_cast<std::size_t>(test)].name};
  return title + (test == e.test ? ": " + settled(e) : ": no, " + failed(e, test));
}

std::string Explainer::sentence(const Event& e, int splits, bool swapped) const {
  const bool taken = e.kind == Event::Kind::Take;
  const std::string P = taken ? name(e.P) : called(e.P, swapped ? "Q" : "P"),
                    Q = e.Q < 0 ? "" : called(e.Q, swapped ? "P" : "Q");
  switch (e.kind) {
    case Event::Kind::Take:
      if (fragments_.isPiece(e.P))
        return filled("Take: {P}, a piece of {Q}, is the first in the list; it becomes P and gets a mark.", P,
                      name(fragments_.parent(e.P)));
      return filled(textbook_ ? "Take: {P} reaches farthest back of all polygons that are left; it becomes P "
                                "and gets a mark."
                              : "Take: {P} is the first in the list; it becomes P and gets a mark.",
                    P, Q);
    case Event::Kind::Compare:
      return sentence(e, e.test);
    case Event::Kind::Move:
      return filled("Move: {Q} is moved to the far end of the list, marked, and becomes P.", P, Q);
    case Event::Kind::Cycle:
      return filled(
          "Cycle: {Q} should come before {P}, but it has a mark from when it became P: the order is a cycle.",
          P, Q);
    case Event::Kind::Impossible:
      return filled("Cut impossible: {P} lies on one side of the plane of {Q}.", P, Q);
    case Event::Kind::Vain:
      return filled("Cut in vain: the plane of {Q} would cut {P}, but a piece of it would stay in the cycle.",
                    P, Q);
    case Event::Kind::Void:
      return filled(
          "Contact: within the model's rounding, {P} and {Q} only touch; this breaks the cycle without a "
          "cut.",
          P, Q);
    case Event::Kind::Split: {
      const int behind = fragments_.pieceOf(splits);
      return filled("Cut: {P} is split by the plane of {Q} into ", P, Q) + listed(behind) +
             ", behind it, and " + listed(behind + 1) + ", in front.";
    }
    case Event::Kind::Paint:
      return filled("Paint: no polygon that is left must come before {P}.", P, Q);
  }
  return "";
}

}  // namespace xnewell
