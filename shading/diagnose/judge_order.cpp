#include "shading/diagnose/judge_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "depthsort/oracle.h"
#include "depthsort/pair_tests.h"
#include "geometry/files/text_file.h"
#include "shading/course/course.h"
#include "shading/laboratory/errors.h"
#include "shading/scene/json_text.h"

namespace xnewell {

namespace {

using Json = Node::Json;

constexpr std::size_t kMostBytes = 64 << 20;
constexpr std::size_t kMostCorners = 1000;
constexpr double kFarthestPlace = 1e6;  ///< pixels

glm::dvec2 placeOf(const Json& corner) {
  if (!corner.is_array() || corner.size() != 2 || !corner[0].is_number() || !corner[1].is_number())
    throw std::runtime_error{"a corner of a piece is [x, y], in pixels"};
  const glm::dvec2 place{corner[0].get<double>(), corner[1].get<double>()};
  if (!(std::abs(place.x) <= kFarthestPlace && std::abs(place.y) <= kFarthestPlace))
    throw std::runtime_error{"a corner of a piece is more than a million pixels away"};
  return place;
}

}  // namespace

glm::ivec2 pictureSizeOf(const Node::Json& size) {
  const auto isSide = [](const Json& side) {
    return side.is_number_integer() && side >= kLeastOrderSize && side <= kMostOrderSize;
  };
  if (!size.is_array() || size.size() != 2 || !isSide(size[0]) || !isSide(size[1]))
    throw std::runtime_error{"the size is {\"size\": [width, height]}, each from " +
                             std::to_string(kLeastOrderSize) + " to " + std::to_string(kMostOrderSize) +
                             " pixels"};
  return {size[0].get<int>(), size[1].get<int>()};
}

std::vector<glm::dvec2> outlineOf(const Node::Json& piece, std::string_view key) {
  if (!piece.is_array() || piece.size() < 3 || piece.size() > kMostCorners)
    throw std::runtime_error{'"' + std::string{key} + "\" is a list of 3 to 1000 corners [x, y]"};
  std::vector<glm::dvec2> outline;
  for (const auto& corner : piece) outline.push_back(placeOf(corner));
  return outline;
}

namespace {

PaintStep stepOf(const Json& json, int faces) {
  if (json.contains("size")) throw std::runtime_error{"the size stands once, before all faces"};
  const auto face = json.find("face");
  if (face == json.end() || !face->is_number_integer())
    throw std::runtime_error{"\"face\" is the number of a face, from 0"};
  PaintStep step;
  const auto number = face->get<std::int64_t>();
  if (number < 0 || number >= faces)
    throw std::runtime_error{"the scene has no face " + std::to_string(number) + ": its faces are 0 to " +
                             std::to_string(faces - 1)};
  step.face = static_cast<int>(number);
  for (const auto& [key, value] : json.items())
    if (key != "face" && key != "piece") throw std::runtime_error{"unknown key " + inQuotes(key)};
  const auto piece = json.find("piece");
  if (piece != json.end()) step.piece = outlineOf(*piece, "piece");
  return step;
}

}  // namespace

PaintOrder readPaintOrder(const std::string& file, int faces) {
  PaintOrder order;
  forEachJsonLine(readTextFile(file, kMostBytes), file, "{\"face\": 17}", [&](const Json& json, int line) {
    if (json.contains("size") && order.steps.empty() && !order.size) {
      order.size = pictureSizeOf(json.size() == 1 ? json["size"] : json);
    } else {
      order.steps.push_back(stepOf(json, faces));
      order.steps.back().line = line;
    }
  });
  if (order.steps.empty()) throw ParseError{file, 0, "no line paints a face"};
  return order;
}

std::string paintOrderText(std::span<const PaintStep> steps, std::optional<glm::ivec2> size) {
  std::string text;
  if (size) text += Json{{"size", {size->x, size->y}}}.dump() + '\n';
  for (const PaintStep& step : steps) {
    Json line{{"face", step.face}};
    for (const glm::dvec2& corner : step.piece) line["piece"].push_back({corner.x, corner.y});
    text += line.dump() + '\n';
  }
  return text;
}

bool isInside(const std::vector<glm::dvec2>& polygon, const glm::dvec2& at) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y <= at.y) == (b.y <= at.y)) continue;
    if (a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) > at.x) inside = !inside;
  }
  return inside;
}

double distanceToBorder(const std::vector<glm::dvec2>& polygon, const glm::dvec2& at) {
  double least = 1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 a = polygon[k], d = polygon[(k + 1) % polygon.size()] - a;
    const double length = d.x * d.x + d.y * d.y;
    const double t =
        length > 0 ? std::clamp(((at.x - a.x) * d.x + (at.y - a.y) * d.y) / length, 0.0, 1.0) : 0.0;
    const glm::dvec2 off = at - a - t * d;
    least = std::min(least, off.x * off.x + off.y * off.y);
  }
  return least;
}

namespace {

constexpr std::int64_t kMostCompared = 300'000;  ///< pairs, while a cycle is looked for

/// True if the outline is convex, has an area, and runs counter-clockwise on the screen.
bool isConvex(const std::vector<glm::ivec3>& outline) {
  const std::size_t n = outline.size();
  if (n < 3 || doubleArea(outline.data(), static_cast<int>(n)) <= 0) return false;
  double turned = 0.0;  // once around
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 a{outline[k].x, outline[k].y}, b{outline[(k + 1) % n].x, outline[(k + 1) % n].y},
        c{outline[(k + 2) % n].x, outline[(k + 2) % n].y};
    const glm::dvec2 u = b - a, v = c - b;
    const double cross = u.y * v.x - u.x * v.y, dot = u.x * v.x + u.y * v.y;
    if (cross < 0.0 || (u.x == 0.0 && u.y == 0.0)) return false;
    turned += std::atan2(cross, dot);
  }
  return turned < 7.0;
}

class Judge {
 public:
  Judge(const Picture& picture, std::span<const PaintStep> steps)
      : scene_{picture.snapped()},
        width_{picture.settings().width},
        height_{picture.settings().height},
        steps_{steps},
        tests_{scene_, {.width = width_, .height = height_, .textbook = true}} {
    for (std::size_t f = 0; f < scene_.faces.size(); ++f)
      facesOf_[scene_.faces[f].number].push_back(static_cast<int>(f));
    for (const SnappedFace& face : scene_.faces) boxes_.push_back(extentsOf(scene_, face).box);
  }

  OrderReport report() {
    r_.steps = static_cast<int>(steps_.size());
    const std::size_t samples = static_cast<std::size_t>(width_) * height_;
    shown_.assign(samples, {kNothing, -1});
    findRepeated();
    for (std::size_t s = 0; s < steps_.size(); ++s) paint(static_cast<int>(s));
    checkCovers();
    for (std::size_t s = 0; s < steps_.size(); ++s) checkInside(static_cast<int>(s));
    compareAll();
    return std::move(r_);
  }

  void decide(WrongPair& wrong, int A, int B) {
    const PaintStep &a = steps_[wrong.shown], &b = steps_[wrong.hidden];
    const SnappedScene two = withPieces(a, A, b, B);
    PairTests tests{two, {.width = width_, .height = height_, .textbook = true}};
    const ScreenBox boxA = extentsOf(two, two.faces[0]).box, boxB = extentsOf(two, two.faces[1]).box;
    const Shape P{two.faces[0], 0, boxA, nullptr}, Q{two.faces[1], 1, boxB, nullptr};
    const Relation relation = tests.compare(P, Q);
    if (relation.verdict == Verdict::PFirst) wrong.told = relation.test;
    if (relation.verdict == Verdict::Crossing) {
      wrong.needsCut = true;
      wrong.cycle = {a.face, b.face, a.face};
      return;
    }
    if (!a.piece.empty() || !b.piece.empty()) return;
    std::vector<int> way = wayBack(B, A);
    if (way.empty()) return;
    wrong.needsCut = true;
    wrong.cycle = {a.face};
    for (const int face : way) wrong.cycle.push_back(scene_.faces[face].number);
  }

 private:
  struct Top {
    int face, step;
  };

  template <class Use>
  void forEachSample(int face, const Use& use) const {
    const SnappedFace& f = scene_.faces[face];
    const std::span outline{scene_.vertices.data() + f.first, static_cast<std::size_t>(f.count)};
    for (const ScanSpan& span : spansOf(edgesOf(outline)))
      if (span.row >= 0 && span.row < height_)
        for (int i = std::max(0, span.from); i < std::min(width_, span.to); ++i) use(i, span.row);
  }
  [[nodiscard]] std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * width_ + i; }

  void findRepeated() {
    std::map<int, std::pair<int, int>> times;  // whole, pieces
    for (const PaintStep& step : steps_)
      ++(step.piece.empty() ? times[step.face].first : times[step.face].second);
    for (const auto& [face, n] : times)
      if (n.first > 1 || (n.first == 1 && n.second > 0)) r_.repeated.push_back(face);
  }

  void paint(int s) {
    const PaintStep& step = steps_[s];
    const auto faces = facesOf_.find(step.face);
    if (faces == facesOf_.end()) return;
    for (const int face : faces->second)
      forEachSample(face, [&](int i, int j) {
        if (step.piece.empty() || isInside(step.piece, {i + 0.5, j + 0.5})) shown_[at(i, j)] = {face, s};
      });
  }

  /// Each sample of a face that is painted in pieces belongs to one of them. Within a pixel of a border it
  /// may be rounded either way.
  void checkCovers() {
    std::map<int, std::vector<const PaintStep*>> pieces;
    for (const PaintStep& step : steps_)
      if (!step.piece.empty()) pieces[step.face].push_back(&step);
    for (const auto& [number, all] : pieces) {
      BadCover bad{.face = number};
      const auto faces = facesOf_.find(number);
      if (faces == facesOf_.end()) continue;
      for (const int face : faces->second)
        forEachSample(face, [&](int i, int j) {
          const glm::dvec2 place{i + 0.5, j + 0.5};
          int times = 0;
          double border = 1e300;
          for (const PaintStep* piece : all) {
            times += isInside(piece->piece, place);
            border = std::min(border, distanceToBorder(piece->piece, place));
          }
          if (times == 1 || border <= 1.0) return;
          if (bad.samples++ == 0) bad.i = i, bad.j = j, bad.times = times;
        });
      if (bad.samples > 0) r_.covers.push_back(bad);
    }
  }

  /// A piece is a part of its face: whoever fills it paints nothing outside. Within a pixel and a half of the
  /// face's border it may be rounded.
  void checkInside(int s) {
    constexpr double kRounded = 1.5 * 1.5;
    const PaintStep& step = steps_[s];
    const auto faces = facesOf_.find(step.face);
    if (step.piece.empty() || faces == facesOf_.end()) return;
    std::vector<std::vector<glm::dvec2>> outlines;
    for (const int face : faces->second) {
      const SnappedFace& f = scene_.faces[face];
      std::vector<glm::dvec2>& outline = outlines.emplace_back();
      for (int k = f.first; k < f.first + f.count; ++k)
        outline.push_back(glm::dvec2{scene_.vertices[k]} / double{kGrid});
    }
    const auto belongs = [&](const std::vector<glm::dvec2>& outline, const glm::dvec2& at) {
      return isInside(outline, at) || distanceToBorder(outline, at) <= kRounded;
    };
    const auto [left, right] = std::ranges::minmax(step.piece, {}, &glm::dvec2::x);
    const auto [top, bottom] = std::ranges::minmax(step.piece, {}, &glm::dvec2::y);
    const auto within = [](double at, int most) {
      return static_cast<int>(std::clamp(at, 0.0, double(most)));
    };
    OutsidePiece outside{.step = s};
    for (int j = within(top.y, height_); j < within(bottom.y + 1, height_); ++j)
      for (int i = within(left.x, width_); i < within(right.x + 1, width_); ++i) {
        const glm::dvec2 at{i + 0.5, j + 0.5};
        if (!isInside(step.piece, at)) continue;
        if (std::ranges::any_of(outlines, [&](const auto& outline) { return belongs(outline, at); }))
          continue;
        if (outside.samples++ == 0) outside.i = i, outside.j = j;
      }
    if (outside.samples > 0) r_.outside.push_back(outside);
  }

  void compareAll() {
    const std::vector<int> nearest = visibleFaces(scene_, width_, height_);
    for (std::size_t s = 0; s < steps_.size(); ++s) stepsOf_[steps_[s].face].push_back(static_cast<int>(s));
    struct Seen {
      int samples = 0, i = 0, j = 0, shown = 0, hidden = 0;
    };
    std::map<std::pair<int, int>, Seen> pairs;
    std::set<int> missing;
    for (int j = 0; j < height_; ++j)
      for (int i = 0; i < width_; ++i) {
        const int should = nearest[at(i, j)];
        const Top top = shown_[at(i, j)];
        if (should == kNothing || should == top.face) continue;
        const int number = scene_.faces[should].number;
        if (!stepsOf_.contains(number)) {
          missing.insert(number);
          continue;
        }
        if (top.face == kNothing) continue;  // a piece too few: checkCovers() tells
        const SampleCheck check = checkOf(scene_, top.face, should, i, j);
        r_.inOnePlane += check == SampleCheck::Earlier;
        if (check != SampleCheck::Wrong) continue;
        ++r_.wrongSamples;
        const int hidden = stepAt(number, i, j);
        Seen& pair = pairs[{top.step, hidden}];
        if (pair.samples++ == 0) pair = {1, i, j, top.face, should};
      }
    r_.missing.assign(missing.begin(), missing.end());
    std::set<int> unseen;
    for (const SnappedFace& face : scene_.faces)
      if (!stepsOf_.contains(face.number) && !missing.contains(face.number)) unseen.insert(face.number);
    r_.unseen.assign(unseen.begin(), unseen.end());
    r_.wrongPairs = static_cast<int>(pairs.size());
    if (pairs.empty()) return;
    const auto& [key, seen] = *pairs.begin();  // the earliest step that shows wrongly
    WrongPair wrong{
        .shown = key.first, .hidden = key.second, .i = seen.i, .j = seen.j, .samples = seen.samples};
    decide(wrong, seen.shown, seen.hidden);
    r_.first = wrong;
  }

  /// The step of a face that covers a sample: its piece there, or its first step.
  [[nodiscard]] int stepAt(int number, int i, int j) const {
    const std::vector<int>& steps = stepsOf_.at(number);
    for (const int s : steps)
      if (steps_[s].piece.empty() || isInside(steps_[s].piece, {i + 0.5, j + 0.5})) return s;
    return steps.front();
  }

  /// The faces, or their pieces, as the tests of the depth sort see them.
  [[nodiscard]] Shape shapeOf(const SnappedFace& face, int index, const ScreenBox& box) const {
    return {face, index, box, nullptr};
  }

  /// A copy of the scene in which the two steps are faces of their own, so that the exact tests see pieces,
  /// too.
  [[nodiscard]] SnappedScene withPieces(const PaintStep& a, int faceA, const PaintStep& b, int faceB) const {
    SnappedScene two;
    two.planes = scene_.planes, two.zShift = scene_.zShift;
    for (const auto& [step, index] : {std::pair{&a, faceA}, {&b, faceB}}) {
      SnappedFace face = scene_.faces[index];
      face.throughVertices = false;
      std::vector<glm::ivec3> outline(scene_.vertices.begin() + face.first,
                                      scene_.vertices.begin() + face.first + face.count);
      if (!step->piece.empty()) {
        std::vector<glm::ivec3> piece;
        for (const glm::dvec2& p : step->piece)
          piece.push_back({static_cast<int>(std::lround(std::clamp(p.x, -4e3, 1.2e4) * kGrid)),
                           static_cast<int>(std::lround(std::clamp(p.y, -4e3, 1.2e4) * kGrid)), 0});
        if (doubleArea(piece.data(), static_cast<int>(piece.size())) < 0) std::ranges::reverse(piece);
        if (isConvex(piece)) outline = std::move(piece);
      }
      face.first = static_cast<int>(two.vertices.size()), face.count = static_cast<int>(outline.size());
      two.vertices.insert(two.vertices.end(), outline.begin(), outline.end());
      two.source.resize(two.vertices.size(), -1);
      two.planes.setDoubt(static_cast<int>(two.faces.size()), scene_.doubtOf(scene_.faces[index]), 2);
      two.faces.push_back(face);
    }
    return two;
  }

  /// Faces from B to A, each of which must be painted before the next; empty if there are none. As A must be
  /// painted before B, that is a cycle.
  [[nodiscard]] std::vector<int> wayBack(int B, int A) {
    std::vector<int> from(scene_.faces.size(), kNothing);
    std::deque<int> open{B};
    from[B] = B;
    std::int64_t compared = 0;
    while (!open.empty()) {
      const int P = open.front();
      open.pop_front();
      for (int Q = 0; Q < static_cast<int>(scene_.faces.size()); ++Q) {
        if (from[Q] != kNothing || !boxes_[P].overlaps(boxes_[Q])) continue;
        if (++compared > kMostCompared) return {};
        if (!tests_.overlapCounts(shapeOf(scene_.faces[Q], Q, boxes_[Q]),
                                  shapeOf(scene_.faces[P], P, boxes_[P])))
          continue;
        from[Q] = P;
        if (Q == A) {
          std::vector<int> way{A};
          while (way.back() != B) way.push_back(from[way.back()]);
          std::ranges::reverse(way);
          return way;
        }
        open.push_back(Q);
      }
    }
    return {};
  }

  const SnappedScene& scene_;
  int width_, height_;
  std::span<const PaintStep> steps_;
  PairTests tests_;
  std::map<int, std::vector<int>> facesOf_, stepsOf_;  ///< by number of a face
  std::vector<ScreenBox> boxes_;
  std::vector<Top> shown_;
  OrderReport r_;
};

}  // namespace

OrderReport judgeOrder(const Picture& picture, std::span<const PaintStep> steps) {
  return Judge{picture, steps}.report();
}

void tellPair(const Picture& picture, std::span<const PaintStep> steps, WrongPair& pair, int shown,
              int hidden) {
  Judge{picture, steps}.decide(pair, shown, hidden);
}

std::vector<glm::dvec3> stepInWorld(const Picture& picture, const PaintStep& step) {
  const Scene& scene = picture.scene();
  const double unit = std::ldexp(1.0, scene.exponent);
  std::vector<glm::dvec3> world;
  if (step.piece.empty()) {
    for (const int point : scene.mesh.face(step.face)) world.push_back(unit * scene.mesh.points[point]);
    return world;
  }
  // Where the ray through each corner of the piece meets the plane of the face: of three corners of the face
  // the homogeneous weights are found on the screen.
  const SnappedScene& snapped = picture.snapped();
  const auto face = std::ranges::find_if(snapped.faces, [&](const SnappedFace& f) {
    return f.number == step.face && snapped.source[f.first] >= 0 && snapped.source[f.first + 1] >= 0 &&
           snapped.source[f.first + 2] >= 0;
  });
  if (face == snapped.faces.end()) return {};
  std::array<glm::dvec2, 3> screen{};
  std::array<glm::dvec3, 3> place{};
  std::array<double, 3> depth{};
  const bool parallel = picture.camera().view.projection == Projection::Parallel;
  const glm::dvec3 n = glm::normalize(picture.camera().view.vpn);
  for (int k = 0; k < 3; ++k) {
    const glm::ivec3& p = snapped.vertices[face->first + k];
    screen[k] = glm::dvec2{p.x, p.y} / double{kGrid};
    place[k] = scene.mesh.points[scene.mesh.corners[snapped.source[face->first + k]]];
    depth[k] = parallel ? 1.0 : glm::dot(picture.camera().eye - place[k], n);
  }
  for (const glm::dvec2& at : step.piece) {
    glm::dvec3 sum{0.0};
    double weight = 0.0;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 a = screen[(k + 1) % 3] - at, b = screen[(k + 2) % 3] - at;
      const double w = (a.x * b.y - a.y * b.x) / depth[k];
      sum += w * place[k], weight += w;
    }
    if (weight == 0.0) return {};
    world.push_back(unit * sum / weight);
  }
  return world;
}

}  // namespace xnewell
