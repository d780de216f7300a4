#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/model_view.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Faces that cross

using Outline = std::vector<glm::dvec3>;

glm::dvec3 normalOf(const Outline& p) {
  return p.size() == 3 ? glm::cross(p[1] - p[0], p[2] - p[0]) : glm::cross(p[2] - p[0], p[3] - p[1]);
}

/// The part of the line at + t along that lies in the convex polygon whose plane holds it.
std::pair<double, double> within(const Outline& p, glm::dvec3 at, glm::dvec3 along) {
  const glm::dvec3 N = normalOf(p);
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const glm::dvec3 inward = glm::cross(N, p[(k + 1) % p.size()] - p[k]);
    const double height = glm::dot(inward, at - p[k]), rise = glm::dot(inward, along);
    if (rise > 0)
      from = std::max(from, -height / rise);
    else if (rise < 0)
      to = std::min(to, -height / rise);
    else if (height < 0)
      return {0, 0};
  }
  return {from, to};
}

/// The part that two polygons have of the line where their planes meet, in space, without any view: from `at`
/// by `length`, which is negative if they have none.
struct Crossing {
  glm::dvec3 at, along;  ///< `along` is a unit vector
  double length;
};
std::optional<Crossing> crossingOf(const Outline& p, const Outline& q) {
  const glm::dvec3 N = normalOf(p), M = normalOf(q), along = glm::cross(N, M);
  const double square = glm::dot(along, along), length = std::sqrt(square);
  if (square == 0.0) return {};
  const double n = glm::dot(N, p[0]), m = glm::dot(M, q[0]);
  const glm::dvec3 at = (n * glm::cross(M, along) + m * glm::cross(along, N)) / square;
  const auto [p0, p1] = within(p, at, along);
  const auto [q0, q1] = within(q, at, along);
  const double from = std::max(p0, q0), to = std::min(p1, q1);
  return Crossing{at + from * along, along / length, (to - from) * length};
}

/// Whether a polygon's plane meets a crossing between its ends, or so near to one that rounding may tell.
bool cutsCrossing(const Outline& r, const Crossing& c) {
  const glm::dvec3 N = normalOf(r);
  const double from = glm::dot(N, c.at - r[0]), rise = glm::dot(N, c.along) * c.length,
               near = 1e-3 * std::abs(rise);
  return std::min(from, from + rise) <= near && std::max(from, from + rise) >= -near;
}

/// The splits of a run, as pairs of faces: the one that was split, and the one whose plane did it.
std::vector<std::pair<int, int>> splitsOf(const SortedScene& sorted, const SnappedScene& snapped) {
  std::vector<int> faceOf(snapped.planes.size(), -1);
  for (int f = 0; f < std::ssize(snapped.faces); ++f) faceOf[snapped.faces[f].plane] = f;
  std::vector<std::pair<int, int>> splits;
  for (std::size_t k = 0; k < sorted.pieces.size(); k += 2) {
    const Piece& piece = sorted.pieces[k];
    const CutLine& line = sorted.cuts[piece.firstCut + piece.cuts - 1];
    const int own = snapped.faces[piece.face].plane;
    splits.emplace_back(piece.face, faceOf[line.over == own ? line.under : line.over]);
  }
  return splits;
}

/// The same projection, of the whole scene from one side or another.
CameraSettings wholeScene(const CameraSettings& camera, unsigned seed) {
  CameraSettings whole;
  whole.parallel = camera.parallel;
  whole.oblique = camera.oblique;
  whole.vpn = glm::dvec3{std::cos(seed * 2.0), std::sin(seed * 2.0), std::sin(seed)};
  return whole;
}

// Where two tori cross, faces are split no more often than they must. Two faces meet in a segment, and a
// split at this segment settles the pair as far as the two pieces reach along it. So other splits of the two
// faces divide the segment, and a pair is split at most once for each part: once, and once more for each
// other plane that split one of the two and meets the segment. Any other split broke a cycle, one for each.
// The segments are computed in space, from the faces' corners.
TEST(Crossing, ToriSplitOnceForEachPartOfACrossing) {
  const Seeds seeds{12};
  long twice = 0, broken = 0;  // runs that split a pair twice, splits that broke a cycle
  for (const int across : {24, 36, 48, 64}) {
    SCOPED_TRACE(across);
    const std::string torus = R"({"solid": "torus", "around": )" + std::to_string(2 * across) +
                              R"(, "across": )" + std::to_string(across);
    PictureCache pictures{
        parsed(R"({"up": "z", "objects": [)" + torus + "}, " + torus + R"(, "move": [0.9, 0.1, 0.25]}]})")};
    const ConvexParts& parts = pictures.scene().parts;
    std::vector<Outline> outlines;
    for (int k = 0; k < parts.count(); ++k) {
      Outline& outline = outlines.emplace_back();
      for (const int corner : parts.part(k)) outline.push_back(pictures.scene().mesh.points[corner]);
    }
    for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
      SCOPED_TRACE(seed);
      PictureSettings s = randomView(pictures.scene(), seed, 1000, 800);
      s.cull = Cull::Keep;
      s.camera = wholeScene(s.camera, seed);
      pictures.make(s);
      const Picture complete = pictures.last().withPlanes();
      const SnappedScene& snapped = complete.snapped();
      ASSERT_EQ(snapped.faces.size(), parts.face.size());
      const auto splits = splitsOf(pictures.last().sorted(), snapped);
      const SortStatistics& statistics = pictures.last().sorted().statistics;
      ASSERT_EQ(std::ssize(splits), statistics.splits);
      std::map<std::pair<int, int>, int> times;    // by pair, the smaller number first
      std::map<int, std::set<int>> planesThrough;  // by face, the faces whose planes split it
      for (const auto& [P, Q] : splits) {
        ++times[std::minmax(P, Q)];
        planesThrough[P].insert(Q);
      }
      long unexplained = 0;
      for (const auto& [pair, count] : times) {
        const auto [P, Q] = pair;
        std::set<int> others = planesThrough[P];
        others.insert(planesThrough[Q].begin(), planesThrough[Q].end());
        others.erase(P), others.erase(Q);
        const std::optional<Crossing> crossing = crossingOf(outlines[P], outlines[Q]);
        const bool meet = crossing && crossing->length > 0;
        const auto stretches =
            meet ? 1 + std::ranges::count_if(others,
                                             [&](int R) { return cutsCrossing(outlines[R], *crossing); })
                 : 0;
        unexplained += std::max<long>(0, count - stretches);
      }
      EXPECT_LE(unexplained, statistics.cycles);
      EXPECT_GT(statistics.splits, 200);
      twice += statistics.splits > std::ssize(times);
      broken += unexplained;
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(twice, 40);
  EXPECT_GT(broken, 0);
}

/// ---- Far places

// A scene that is moved far from the origin, together with its lights and its eye, keeps its picture. All
// coordinates are multiples of 2^-7, so the file of the moved scene has no rounding of its own, and nothing
// but the program can make a difference.

using nlohmann::json;

constexpr std::array kDistances{1e3, 1e6, 1e9};
constexpr int kWidth = 160, kHeight = 120;

double dyadic(double v) { return std::round(v * 128.0) / 128.0; }

json list(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// A ball and a floor that passes through the front plane, all with texture coordinates. `light` has its
/// places as if d were 0.
Scene sceneAt(double d, json light) {
  const glm::dvec3 move{d, -d, d};
  json polygons = json::array(), uv = json::array();
  const Mesh ball = sphere(14, 9);
  for (int f = 0; f < ball.faceCount(); ++f) {
    const auto corners = ball.face(f);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      json polygon = json::array(), places = json::array();
      for (const int c : {corners[0], corners[k], corners[k + 1]}) {
        const glm::dvec3 p = ball.points[c];
        polygon.push_back(list(move + glm::dvec3{dyadic(p.x), dyadic(p.y), dyadic(p.z)}));
        places.push_back({dyadic(p.x + p.z), dyadic(p.y)});
      }
      polygons.push_back(polygon);
      uv.push_back(places);
    }
  }
  polygons.push_back({list(move + glm::dvec3{-6, -1, -6}), list(move + glm::dvec3{-6, -1, 6}),
                      list(move + glm::dvec3{6, -1, 6}), list(move + glm::dvec3{6, -1, -6})});
  uv.push_back({{0, 0}, {0, 3}, {3, 3}, {3, 0}});
  for (const char* key : {"at", "look_at"})
    if (light.contains(key))
      for (int axis = 0; axis < 3; ++axis) light[key][axis] = light[key][axis].get<double>() + move[axis];
  light["Ip"] = 0.7;
  const json scene{{"up", "y"},
                   {"camera",
                    {{"eye", list(move + glm::dvec3{3, 2.25, 4})},
                     {"look_at", list(move)},
                     {"fov", 38},
                     {"front", -1},
                     {"back", -12}}},
                   {"ambient", 0.25},
                   {"lights", {light}},
                   {"objects", {{{"polygons", polygons}, {"uv", uv}}}}};
  return parsed(scene.dump());
}

/// A directional light, and a point light and a spot with each attenuation.
std::vector<json> lights() {
  std::vector<json> all{{{"kind", "directional"}, {"towards", {1, 2, 1.5}}}};
  for (const char* kind : {"point", "spot"})
    for (const AttenuationRow& row : kAttenuations) {
      json light{{"kind", kind}, {"at", {0.75, 1.5, 1.0}}, {"attenuation", std::string{row.name}}};
      if (light["kind"] == "spot") light.update({{"look_at", {0.25, 0, 0}}, {"inner", 20}, {"outer", 50}});
      all.push_back(light);
    }
  all.push_back({{"kind", "point"}, {"at", {0.5, -0.9921875, 0.75}}});  // 2^-7 above the floor
  return all;
}

Texture checks() {
  Texture texture{.width = 16, .height = 16, .channel = {}, .gray = {}};
  for (int k = 0; k < 256; ++k) texture.gray.push_back((k / 16 / 4 + k % 16 / 4) % 2 ? 255 : 120);
  texture.channel = {texture.gray, texture.gray, texture.gray};
  return texture;
}

IndexImage pictureOf(Scene scene, Shading method, Form form, bool textured) {
  PictureSettings s = setUpOf(scene, kWidth, kHeight);
  s.shading = method;
  s.light.form = form;
  s.light.n = 40;
  if (textured) wear(scene, checks());
  PictureCache pictures{std::move(scene)};
  return pictures.make(s, 0).image();
}

TEST(FarPlaces, EveryMethodAndLightKeepsItsPicture) {
  int compared = 0, cases = 0;
  for (const json& light : lights())
    for (const bool textured : {false, true})
      for (const ShadingRow& method : kShadings)
        for (const FormRow& form : kForms) {
          if (!method.lit && (form.id != Form::Textbook || textured)) continue;
          if (method.id == Shading::Environment && (form.id != Form::Textbook || textured)) continue;
          if (kSanitized && cases++ % 5 != 0) continue;
          const IndexImage here = pictureOf(sceneAt(0, light), method.id, form.id, textured);
          ASSERT_GT(kWidth * kHeight - std::ranges::count(here.pixels, 0), kWidth * kHeight / 4);
          for (const double d : kDistances) {
            SCOPED_TRACE(light.dump() + " " + std::string{method.name} + " " + std::string{form.name} +
                         (textured ? " textured, at " : ", at ") + std::to_string(d));
            const IndexImage there = pictureOf(sceneAt(d, light), method.id, form.id, textured);
            int samples = 0;
            for (std::size_t k = 0; k < here.pixels.size(); ++k) {
              ASSERT_NEAR(here.pixels[k], there.pixels[k], 1);
              samples += here.pixels[k] != there.pixels[k];
            }
            EXPECT_LE(samples, kWidth * kHeight / 100);
            ++compared;
          }
        }
  EXPECT_GT(compared, kSanitized ? 120 : 600);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
