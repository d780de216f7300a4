#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/doubt.h"
#include "tests/support/model_view.h"
#include "tests/support/painted.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kWidth = 96, kHeight = 72;

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

/// 17 digits distinguish every double from all others.
void writeObj(const std::string& file, const Mesh& mesh) {
  std::ofstream out{file};
  out.precision(17);
  for (const glm::dvec3& p : mesh.points) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (int f = 0; f < mesh.faceCount(); ++f) {
    out << 'f';
    for (const int corner : mesh.face(f)) out << ' ' << corner + 1;
    out << '\n';
  }
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
  for (int k = 0; k < kWidth * kHeight; ++k) {
    if (shown[k] == seen[k]) continue;
    EXPECT_NE(shown[k], kNothing);
    EXPECT_TRUE(shown[k] == kNothing || mayTouch(snapped, shown[k], seen[k], k, kWidth)) << "sample " << k;
  }
  return kWidth * kHeight - std::ranges::count(seen, kNothing);
}

struct Extreme {
  std::string_view name;
  Mesh (*make)(std::mt19937&);
};
constexpr std::array kExtremes{
    Extreme{"1e-300",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (glm::dvec3& p : mesh.points) p *= 1e-300;
              return mesh;
            }},
    Extreme{"1e300",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (glm::dvec3& p : mesh.points) p *= 1e300;
              return mesh;
            }},
    Extreme{"the largest doubles",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              double largest = 0.0;
              for (const glm::dvec3& p : mesh.points)
                largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
              for (glm::dvec3& p : mesh.points) p = p / largest * std::numeric_limits<double>::max();
              return mesh;
            }},
    Extreme{"subnormal: whole steps of the smallest double",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (glm::dvec3& p : mesh.points)
                for (int axis = 0; axis < 3; ++axis)
                  p[axis] = std::nearbyint(10.0 * p[axis]) * std::numeric_limits<double>::denorm_min();
              return mesh;
            }},
    Extreme{"every triangle of its own magnitude",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (int f = 0; f < mesh.faceCount(); ++f) {
                const int exponent = f < 6 ? -f : -static_cast<int>(rng() % 1000);
                for (const int corner : mesh.face(f))
                  mesh.points[corner] = scaled(mesh.points[corner], exponent);
              }
              return mesh;
            }},
    Extreme{"every corner of its own magnitude",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (glm::dvec3& p : mesh.points)
                p = scaled(p, -static_cast<int>(rng() % 8) * static_cast<int>(rng() % 100));
              return mesh;
            }},
    Extreme{"1e15 away, where doubles are an eighth apart",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (glm::dvec3& p : mesh.points) p += glm::dvec3{1e15, -1e15, 1e15};
              return mesh;
            }},
    Extreme{"duplicate faces, some turned over, and faces without area",
            [](std::mt19937& rng) {
              Mesh mesh = soup(rng);
              for (int f = 0; f < 30; ++f) {
                const int a = mesh.face(f)[0], b = mesh.face(f)[1], c = mesh.face(f)[2];
                switch (f % 5) {
                  case 0:
                    mesh.addFace(std::array{a, b, c}, 0);
                    break;
                  case 1:
                    mesh.addFace(std::array{c, b, a}, 0);
                    break;
                  case 2:
                    mesh.addFace(std::array{a, a, b}, 0);
                    break;
                  case 3:
                    mesh.addFace(std::array{a, b, a, b}, 0);
                    break;
                  default:
                    mesh.addFace(std::array{a, a, a}, 0);
                }
              }
              return mesh;
            }},
};

}  // namespace

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

// No pixel changes either when files hold the scaled coordinates.
TEST(ModelScale, FilesOfAnyMagnitudeShowTheSame) {
  const TemporaryFolder folder;
  const std::string file = folder.file("scaled.obj");
  std::ptrdiff_t shown = 0;
  for (const char* name : {"teapot", "room", "tori", "pinwheels"}) {
    SCOPED_TRACE(name);
    const Scene scene = readScene(name, 3);
    const auto read = [&](int k) {
      writeObj(file, scaled(fileMesh(scene), k));
      return readScene(file);
    };
    const Scene unscaled = read(0);
    ASSERT_EQ(unscaled.mesh.faceCount(), scene.mesh.faceCount());
    for (const int k : {-900, -800, -701, -600, -500, -397, -300, -200, -100, -53, -7,
                        1,    10,   100,  200,  300,  411,  500,  600,  703,  800, 900}) {
      const unsigned seed = static_cast<unsigned>(k + 1000);
      const PictureSettings s = randomView(scene, seed, kWidth, kHeight);
      const IndexImage image = imageOf(unscaled, s, 0);
      ASSERT_EQ(imageOf(read(k), s, k), image) << "2^" << k;
      shown += std::ranges::count_if(image.pixels, [](std::uint8_t cell) { return cell != 0; });
    }
  }
  EXPECT_GT(shown, 100'000);
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
      PictureCache pictures{makeScene("extreme", extreme.make(rng), UpAxis::Z)};
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

}  // namespace xnewell::THIS_FILE
