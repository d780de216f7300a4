#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "geometry/model/solids.h"
#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/doubt.h"
#include "tests/support/model_view.h"
#include "tests/support/painted.h"
#include "tests/support/random_wall.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kWidth = 160, kHeight = 120;

/// The mesh as a file with so many decimals holds it, in the file's scale; 0: exactly.
Mesh written(Mesh mesh, int decimals, double scale) {
  const double unit = std::pow(10.0, decimals);
  for (glm::dvec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = scale * (decimals > 0 ? std::nearbyint(p[axis] * unit) / unit : p[axis]);
  mesh.rounding.clear();
  if (decimals > 0) mesh.rounding.assign(mesh.groupNames.size(), scale * 0.5 / unit);
  return mesh;
}

/// Turns the mesh out of the axes and scales it to size 1.
Mesh turned(Mesh mesh, unsigned seed) {
  std::mt19937 rng{seed};
  const Frame frame = randomFrame(rng);
  const glm::dvec3 a = glm::normalize(frame.a), b = glm::cross(frame.N, a);
  double size = 0.0;
  for (const glm::dvec3& p : mesh.points)
    size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  for (glm::dvec3& p : mesh.points) p = (p.x * a + p.y * b + p.z * frame.N) / size;
  return mesh;
}

void addBox(Mesh& mesh, glm::dvec3 low, glm::dvec3 high) {
  const Mesh unit = cube();
  const int first = static_cast<int>(mesh.points.size());
  for (const glm::dvec3& p : unit.points) mesh.points.push_back(low + (high - low) * (p + 1.0) / 2.0);
  for (int f = 0; f < unit.faceCount(); ++f) {
    std::vector<int> face;
    for (const int corner : unit.face(f)) face.push_back(first + corner);
    mesh.addFace(face, 0);
  }
}

/// Closed boxes on a floor, side by side, with a smaller one on each, in a corner or in the middle.
Mesh stackedBoxes() {
  Mesh mesh;
  mesh.groupNames = {""};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double height = 0.3 + 0.1 * ((i + 2 * j) % 3), inset = 0.15 * ((i + j) % 3);
      const glm::dvec3 corner{i, j, 0};
      addBox(mesh, corner, corner + glm::dvec3{1, 1, height});
      addBox(mesh, corner + glm::dvec3{inset, inset, height},
             corner + glm::dvec3{inset + 0.5, inset + 0.5, height + 0.4});
    }
  const int first = static_cast<int>(mesh.points.size());
  for (const glm::dvec3 p : {glm::dvec3{-1, -1, 0}, {4, -1, 0}, {4, 4, 0}, {-1, 4, 0}})
    mesh.points.push_back(p);
  mesh.addFace(std::array{first, first + 1, first + 2, first + 3}, 0);
  return mesh;
}

/// Rectangles whose z goes from `left` to `right`, in a file whose coordinates are rounded by u, seen from
/// above. Returns how many splits the depth sort makes.
struct Card {
  double x0, x1, y0, y1, left, right;
};
std::int64_t splitsOf(std::initializer_list<Card> cards, double u) {
  Mesh mesh;
  mesh.groupNames = {""};
  mesh.rounding = {u};
  for (const Card& c : cards) {
    const int first = static_cast<int>(mesh.points.size());
    for (const glm::dvec3 p :
         {glm::dvec3{c.x0, c.y0, c.left}, {c.x1, c.y0, c.right}, {c.x1, c.y1, c.right}, {c.x0, c.y1, c.left}})
      mesh.points.push_back(p);
    mesh.addFace(std::array{first, first + 1, first + 2, first + 3}, 0);
  }
  PictureCache pictures{makeScene("cards", mesh, UpAxis::Y)};
  PictureSettings s;
  s.width = s.height = kWidth;
  s.cull = Cull::Keep;
  s.camera.eye = glm::dvec3{1, 0, 20}, s.camera.lookAt = glm::dvec3{1, 0, 0};
  s.camera.parallel = true, s.camera.height = 5.0;
  pictures.make(s);
  EXPECT_EQ(exactnessOf(pictures.last()).wrong, 0);
  return pictures.last().sorted().statistics.splits;
}

/// Views within the room whose splits were due to planes through points near the eye.
constexpr std::array kPastFailures{747u, 891u, 1167u, 2463u, 3747u};

struct Solid {
  std::string_view name;
  Mesh mesh;
};

}  // namespace

// Faces that touch and do not cross are never split: a furnished room, boxes on and next to each other, a
// cube, a sphere. The scenes are turned out of the axes, rounded to 6 or 9 decimals or not at all, from 1e-6
// to 1e6 in size, in every projection, seen from outside and inside.
TEST(Contact, SplitsNothing) {
  const std::array solids{Solid{"room", readScene("room").mesh}, Solid{"stacked boxes", stackedBoxes()},
                          Solid{"cube", cube()}, Solid{"sphere", sphere(24, 12)}};
  for (const Solid& solid : solids) {
    SCOPED_TRACE(solid.name);
    long contacts = 0, samples = 0;
    std::vector<unsigned> seeds(200);
    std::iota(seeds.begin(), seeds.end(), 0u);
    seeds.insert(seeds.end(), kPastFailures.begin(), kPastFailures.end());
    for (const unsigned seed : seeds) {
      SCOPED_TRACE(seed);
      const double scale = std::pow(10.0, static_cast<int>(seed % 13) - 6);
      const Mesh mesh = seed % 5 ? turned(solid.mesh, seed) : solid.mesh;
      PictureCache pictures{
          makeScene("solid", written(mesh, kDecimals[seed % kDecimals.size()], scale), UpAxis::Z)};
      const PictureSettings s = randomView(pictures.scene(), seed, kWidth, kHeight);
      pictures.make(s);
      const SortStatistics& quick = pictures.last().sorted().statistics;
      EXPECT_EQ(quick.splits, 0);
      EXPECT_EQ(depthSort(pictures.last().withPlanes().snapped(), {kWidth, kHeight, true}).statistics.splits,
                0);
      contacts += quick.contacts;
      const Exactness e = exactnessOf(pictures.last());
      EXPECT_EQ(e.wrong, 0);
      samples += e.samples;
    }
    EXPECT_GE(contacts, 100);
    EXPECT_GT(samples, 1'000'000);
  }
}

// A crossing is a contact only if rounding explains the depth of one of its sides: r for each face, which is
// u for faces seen from above. A step of the grid is 0.04 r here.
TEST(Contact, IsNoDeeperThanRounding) {
  constexpr double kU = 1e-5;
  const Card floor{-1, 1, -1, 1, 0, 0};
  EXPECT_EQ(splitsOf({floor, {-0.8, 0.8, -0.5, 0.5, -8 * kU, 1.9 * kU}}, kU), 0);
  EXPECT_EQ(splitsOf({floor, {-0.8, 0.8, -0.5, 0.5, -8 * kU, 2.1 * kU}}, kU), 1);
  EXPECT_EQ(splitsOf({floor, {-0.8, 0.8, -0.5, 0.5, -1.9 * kU, 8 * kU}}, kU), 0);
  EXPECT_EQ(splitsOf({floor, {-0.8, 0.8, -0.5, 0.5, -2.1 * kU, 8 * kU}}, kU), 1);
}

// For a contact, the planes of the faces' own corners count, also where a face shares the plane of a class.
// Floor and mat are one class, with a plane half way between them. The card crosses only the mat. Where the
// records are nearer to each other than the planes of the corners, 1.5 times the rounding counts.
TEST(Contact, IsByThePlanesOfTheirOwnCorners) {
  constexpr double kU = 1e-5;
  for (const double side : {1.0, -1.0}) {  // the mat is above the floor, or below it
    const double height = side * 1.9 * kU;
    const Card floor{-1, 1, -1, 1, 0, 0}, mat{0.8, 3, -0.5, 0.5, height, height};
    // The card passes the mat at its left by 8 r one way, and at its right by this the other way.
    const auto splits = [&](double byR, double way) {
      const Card card{1.2, 2.8, -0.3, 0.3, height - 8 * way * kU, height + byR * way * kU};
      return splitsOf({floor, mat, card}, kU);
    };
    EXPECT_EQ(splits(1.9, side), 0);
    EXPECT_EQ(splits(2.1, side), 1);
    EXPECT_EQ(splits(2.9, -side), 0);
    EXPECT_EQ(splits(3.1, -side), 1);
  }
}

}  // namespace xnewell::THIS_FILE
