#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/model_view.h"
#include "tests/support/painted.h"
#include "tests/support/seeds.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Models

constexpr int kWidth = 96, kHeight = 72;

/// What one kind of view showed.
struct Tally {
  long certain = 0, doubtful = 0, culled = 0, clipped = 0, splits = 0, contacts = 0;
};

// The picture of every scene in data/ is the oracle's at every sample that is not doubtful. At doubtful
// samples the painted face may touch the one on top. This holds from any side and from within, in every
// projection, with and without back faces, for the program's sort and for the textbook's.
TEST(Model, PaintsWhatTheOracleSees) {
  const Seeds seeds{96};
  std::array<Tally, kSeen.size()> tallies;
  for (const BuiltInScene& scene : builtInScenes()) {
    SCOPED_TRACE(scene.name);
    PictureCache pictures{readScene(scene.name, 6)};
    for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
      SCOPED_TRACE(seed);
      Tally& tally = tallies[seed % kSeen.size()];
      pictures.make(randomView(pictures.scene(), seed, kWidth, kHeight));
      const Picture complete = pictures.last().withPlanes();
      const SnappedScene& snapped = complete.snapped();
      tally.culled += snapped.culled;
      tally.clipped += snapped.outside;
      const std::vector<int> seen = visibleFaces(snapped, kWidth, kHeight);
      const std::vector<char> doubt = doubtful(snapped, seen, kWidth, kHeight);
      for (const bool textbook : {false, true}) {
        SCOPED_TRACE(textbook ? "textbook" : "quick");
        const SortedScene sorted =
            textbook ? depthSort(snapped, {kWidth, kHeight, true}) : pictures.last().sorted();
        const std::vector<int> shown = painted(snapped, sorted, kWidth, kHeight);
        for (int k = 0; k < kWidth * kHeight; ++k) {
          if (shown[k] != seen[k]) {
            ASSERT_TRUE(doubt[k]) << "sample " << k % kWidth << ", " << k / kWidth;
            ASSERT_NE(shown[k], kNothing);
            ASSERT_TRUE(mayTouch(snapped, shown[k], seen[k], k, kWidth));
          }
          tally.certain += seen[k] != kNothing && !doubt[k];
          tally.doubtful += doubt[k];
        }
        tally.splits += sorted.statistics.splits;
        tally.contacts += sorted.statistics.contacts;
      }
    }
  }
  if (!seeds.all()) return;
  for (const SeenRow& row : kSeen) {
    SCOPED_TRACE(row.name);
    const Tally& tally = tallies[static_cast<int>(row.id)];
    EXPECT_GT(tally.certain, 500'000);
    EXPECT_GT(tally.doubtful, 100);
    EXPECT_GT(tally.culled, 1'000);
    EXPECT_GT(tally.splits, 5'000);
    EXPECT_GT(tally.contacts, 10);
  }
  EXPECT_GT(tallies[static_cast<int>(Seen::Inside)].clipped, 3'000);
}

// Rounding near the eye does not change what is seen far away. The plates pass through each other and the
// eye's surroundings, where rounding matters most: near the eye it moves a plate by whole pixels.
TEST(Model, WhatIsNearTheEyeLeavesNoDoubtAboutTheRest) {
  long samples = 0, near = 0, splits = 0;
  for (const char* name : {"penetrate", "crossing-sheets"}) {
    SCOPED_TRACE(name);
    PictureCache pictures{readScene(name)};
    for (unsigned seed = static_cast<unsigned>(Seen::Inside); seed < 400; seed += kSeen.size()) {
      SCOPED_TRACE(seed);
      PictureSettings s = randomView(pictures.scene(), seed, kWidth, kHeight);
      s.cull = Cull::Keep;
      pictures.make(s);
      const Picture complete = pictures.last().withPlanes();
      const SnappedScene& snapped = complete.snapped();
      const std::vector<int> seen = visibleFaces(snapped, kWidth, kHeight);
      EXPECT_EQ(painted(snapped, pictures.last().sorted(), kWidth, kHeight), seen);
      samples += std::ranges::count_if(seen, [](int face) { return face != kNothing; });
      splits += pictures.last().sorted().statistics.splits;
      near += std::ranges::count_if(snapped.faces, [&](const SnappedFace& face) {
        const auto first = snapped.vertices.begin() + face.first;
        return std::any_of(first, first + face.count, [&](const glm::ivec3& v) {
          return snapped.doubtOf(face).at(v.z) > kGrid >> snapped.zShift;
        });
      });
    }
  }
  EXPECT_GT(samples, 500'000);
  EXPECT_GT(near, 100);
  EXPECT_GT(splits, 400);
}

/// ---- Their scale

glm::dvec3 scaled(glm::dvec3 v, int k) {
  return {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
}

Mesh scaled(Mesh mesh, int k) {
  for (glm::dvec3& p : mesh.points) p = scaled(p, k);
  for (double& u : mesh.rounding) u = std::ldexp(u, k);
  return mesh;
}

/// In file units 2^k times as small.
CameraSettings scaled(CameraSettings c, int k) {
  for (std::optional<glm::dvec3>* p : {&c.eye, &c.lookAt, &c.vrp, &c.prp})
    if (*p) *p = scaled(**p, k);
  for (std::optional<double>* v : {&c.height, &c.front, &c.back})
    if (*v) *v = std::ldexp(**v, k);
  if (c.window)
    for (int i = 0; i < 4; ++i) (*c.window)[i] = std::ldexp((*c.window)[i], k);
  return c;
}

/// Of the scene, camera and light said in the file's units, which are 2^k times as small.
IndexImage imageOf(const Scene& scene, PictureSettings s, int k) {
  s.camera = scaled(s.camera, k);
  s.light.lightPosition = scaled(glm::dvec3{-3, 2, 5}, k);
  PictureCache pictures{scene};
  const IndexImage image = pictures.make(s, 0).image();
  return image;
}

bool isFinite(const glm::dvec3& p) { return std::isfinite(p.x + p.y + p.z); }

Mesh fileMesh(const Scene& scene) { return scaled(scene.mesh, scene.exponent); }

/// Face f of the result is face order[f].
Mesh permutedFaces(const Mesh& mesh, const std::vector<int>& order) {
  Mesh permuted = mesh;
  permuted.corners.clear();
  permuted.firstCorner = {0};
  permuted.group.clear();
  permuted.material.clear();
  for (const int f : order) permuted.addFace(mesh.face(f), mesh.group[f], mesh.material[f]);
  return permuted;
}

/// Triangles about the origin, most of which pass through others.
Mesh soup(std::mt19937& rng) { return triangleSoup(30, 1.0, rng()); }

/// Counts samples that show a face. The test fails if a face differs from the oracle's and may not touch it.
long agreeing(const Picture& picture) {
  const Picture complete = picture.withPlanes();
  const SnappedScene& snapped = complete.snapped();
  const std::vector<int> seen = visibleFaces(snapped, kWidth, kHeight);
  const std::vector<int> shown = painted(snapped, picture.sorted(), kWidth, kHeight);
  for (int k = 0; k < kWidth * kHeight; ++k)
    EXPECT_TRUE(shown[k] == seen[k] ||
                (shown[k] != kNothing && mayTouch(snapped, shown[k], seen[k], k, kWidth)))
        << "sample " << k;
  return kWidth * kHeight - std::ranges::count(seen, kNothing);
}

/// What a soup is made of.
struct Extreme {
  std::string_view name;
  void (*change)(Mesh&, std::mt19937&);
};
constexpr std::array kExtremes{
    Extreme{"1e-300",
            [](Mesh& mesh, std::mt19937&) {
              for (glm::dvec3& p : mesh.points) p *= 1e-300;
            }},
    Extreme{"1e300",
            [](Mesh& mesh, std::mt19937&) {
              for (glm::dvec3& p : mesh.points) p *= 1e300;
            }},
    Extreme{"the largest doubles",
            [](Mesh& mesh, std::mt19937&) {
              double largest = 0.0;
              for (const glm::dvec3& p : mesh.points)
                largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
              for (glm::dvec3& p : mesh.points) p = p / largest * std::numeric_limits<double>::max();
            }},
    Extreme{"subnormal: whole steps of the smallest double",
            [](Mesh& mesh, std::mt19937&) {
              for (glm::dvec3& p : mesh.points)
                for (int axis = 0; axis < 3; ++axis)
                  p[axis] = std::nearbyint(10.0 * p[axis]) * std::numeric_limits<double>::denorm_min();
            }},
    Extreme{"every triangle of its own magnitude",
            [](Mesh& mesh, std::mt19937& rng) {
              for (int f = 0; f < mesh.faceCount(); ++f) {
                const int exponent = f < 6 ? -f : -static_cast<int>(rng() % 1000);
                for (const int corner : mesh.face(f))
                  mesh.points[corner] = scaled(mesh.points[corner], exponent);
              }
            }},
    Extreme{"every corner of its own magnitude",
            [](Mesh& mesh, std::mt19937& rng) {
              for (glm::dvec3& p : mesh.points)
                p = scaled(p, -static_cast<int>(rng() % 8) * static_cast<int>(rng() % 100));
            }},
    Extreme{"1e15 away, where doubles are an eighth apart",
            [](Mesh& mesh, std::mt19937&) {
              for (glm::dvec3& p : mesh.points) p += glm::dvec3{1e15, -1e15, 1e15};
            }},
    Extreme{"duplicate faces, some turned over, and faces without area",
            [](Mesh& mesh, std::mt19937&) {
              for (int f = 0; f < 30; ++f) {
                const int a = mesh.face(f)[0], b = mesh.face(f)[1], c = mesh.face(f)[2];
                const std::array<std::vector<int>, 5> kinds{
                    {{a, b, c}, {c, b, a}, {a, a, b}, {a, b, a, b}, {a, a, a}}};
                mesh.addFace(kinds[f % 5], 0);
              }
            }},
};

// No pixel of the picture changes when the scene is scaled by a power of two together with its rounding,
// camera and light.
TEST(ModelScale, PowersOfTwoChangeNoPixel) {
  int pictures = 0;
  IndexImage last;
  for (const BuiltInScene& builtIn : builtInScenes()) {
    SCOPED_TRACE(builtIn.name);
    const Scene scene = readScene(builtIn.name, 3);
    const Mesh mesh = fileMesh(scene);
    for (unsigned seed = 0; seed < kSeen.size(); ++seed) {
      SCOPED_TRACE(seed);
      const PictureSettings s = randomView(scene, seed, kWidth, kHeight);
      const IndexImage image = imageOf(scene, s, 0);
      EXPECT_NE(image, last);
      last = image;
      for (int k = -900; k <= 900; k += 50)
        if ((k / 50 + 18) % 4 == static_cast<int>(seed)) {
          Scene other = makeScene("scaled", scaled(mesh, k), scene.up, scene.divisions);
          other.light = scene.light;  // in units of the scene, which scaling does not change
          other.textures = scene.textures;
          ASSERT_EQ(other.exponent, scene.exponent + k);
          ASSERT_EQ(imageOf(other, s, k), image) << "2^" << k;
          ++pictures;
        }
    }
  }
  EXPECT_GT(pictures, 500);
}

// The order of the faces, and so of the vertices, does not matter, except at doubtful samples and ties.
TEST(ModelScale, PermutedFacesShowTheSame) {
  long certain = 0, tied = 0, splits = 0;
  for (const BuiltInScene& builtIn : builtInScenes()) {
    SCOPED_TRACE(builtIn.name);
    const Scene scene = readScene(builtIn.name, 4);
    PictureCache pictures{scene};
    for (unsigned seed = 0; seed < 16; ++seed) {
      SCOPED_TRACE(seed);
      std::vector<int> order(scene.mesh.faceCount());
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), std::mt19937{seed});
      PictureCache permuted{makeScene("permuted", permutedFaces(fileMesh(scene), order), scene.up)};
      const PictureSettings s = randomView(scene, seed, kWidth, kHeight);
      pictures.make(s);
      permuted.make(s);
      const std::vector<std::uint32_t> shown = pictures.last().faceImage(),
                                       other = permuted.last().faceImage();
      const Picture complete = pictures.last().withPlanes();
      const SnappedScene& snapped = complete.snapped();
      const std::vector<int> seen = visibleFaces(snapped, kWidth, kHeight);
      std::vector<char> either = doubtful(snapped, seen, kWidth, kHeight);
      forEachSample(snapped, kWidth, kHeight, [&](int k, int f) {
        const SnappedFace &F = snapped.faces[f], &top = snapped.faces[seen[k]];
        const bool tie = F.number != top.number && nearer(snapped.planes[F.plane], snapped.planes[top.plane],
                                                          k % kWidth, k / kWidth) == 0;
        tied += tie;
        either[k] |= tie;
      });
      for (int k = 0; k < kWidth * kHeight; ++k)
        if (!either[k]) {
          ASSERT_EQ(shown[k], other[k] == 0 ? 0 : 1u + order[other[k] - 1]);
          certain += shown[k] != 0;
        }
      splits += permuted.last().sorted().statistics.splits;
    }
  }
  EXPECT_GT(certain, 300'000);
  EXPECT_GT(tied, 1'000);
  EXPECT_GT(splits, 2'000);
}

// Scenes at the ends of the range of doubles, and other extremes that a file may hold, can be drawn and agree
// with the oracle.
TEST(ModelScale, ExtremeCoordinatesAgreeWithTheOracle) {
  for (const Extreme& extreme : kExtremes) {
    SCOPED_TRACE(extreme.name);
    long samples = 0, splits = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
      SCOPED_TRACE(seed);
      std::mt19937 rng{seed};
      Mesh mesh = soup(rng);
      extreme.change(mesh, rng);
      PictureCache pictures{makeScene("extreme", std::move(mesh), UpAxis::Z)};
      PictureSettings s = randomView(pictures.scene(), seed, kWidth, kHeight);
      // No file can say a place beyond the largest double.
      if (seed % 5 == 4 || !isFinite(*s.camera.eye) || !isFinite(*s.camera.lookAt)) s.camera = {};
      pictures.make(s);
      samples += agreeing(pictures.last());
      splits += pictures.last().sorted().statistics.splits;
    }
    EXPECT_GT(samples, 3'000);
    EXPECT_GT(splits, 0);
  }
}

// Triangles a million pixels wide, through the plane of an eye that stands among small ones, agree with the
// oracle too.
TEST(ModelScale, FacesThroughTheEyesPlaneAgreeWithTheOracle) {
  long samples = 0, splits = 0, wide = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> component{-1.0, 1.0};
    Mesh mesh = soup(rng);
    for (int f = 0; f < mesh.faceCount(); f += 5)
      for (const int corner : mesh.face(f)) mesh.points[corner] *= glm::dvec3{1e5, 1e5, 1.0};
    PictureCache pictures{makeScene("wide", mesh, UpAxis::Z)};
    PictureSettings s;
    s.width = kWidth;
    s.height = kHeight;
    s.camera.eye = glm::dvec3{component(rng), component(rng), component(rng)};
    s.camera.lookAt = glm::dvec3{0.0};
    s.camera.up = glm::dvec3{0.3, 0.2, 0.9};
    s.camera.fov = 60;
    s.camera.front = 0.9 * glm::length(*s.camera.eye);
    pictures.make(s);
    samples += agreeing(pictures.last());
    splits += pictures.last().sorted().statistics.splits;
    for (const SnappedFace& face : pictures.last().snapped().faces) {
      int left = std::numeric_limits<int>::max(), right = -left;
      for (int v = face.first; v < face.first + face.count; ++v) {
        left = std::min(left, pictures.last().snapped().vertices[v].x);
        right = std::max(right, pictures.last().snapped().vertices[v].x);
      }
      wide += right - left >= kMaxPicture * kGrid;  // the guard band cuts off the rest
    }
  }
  EXPECT_GT(samples, 100'000);
  EXPECT_GT(splits, 100);
  EXPECT_GT(wide, 50);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
