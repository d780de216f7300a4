#include "geometry/model/bezier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/files/bpt.h"

namespace xnewell::THIS_FILE {

namespace {

using Triple = std::tuple<double, double, double>;
Triple triple(const glm::dvec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

class Teapot : public testing::Test {
 protected:
  std::vector<BezierPatch> patches = readBpt(XNEWELL_DATA_DIR "/teapot.bpt");
  void SetUp() override { ASSERT_EQ(patches.size(), 32u); }

  /// Calls check(patch, u, v) at a grid of places of one part, poles included.
  template <typename Check>
  void overPart(int part, Check check) {
    for (int k = 4 * part; k < 4 * part + 4; ++k)
      for (int i = 0; i <= 16; ++i)
        for (int j = 0; j <= 16; ++j) {
          SCOPED_TRACE(testing::Message() << "patch " << k << " at " << i << "/16, " << j << "/16");
          check(patches[k], i / 16.0, j / 16.0);
        }
  }
};

enum Part { kRim, kUpperBody, kLowerBody, kHandle, kSpout, kKnob, kLid, kBottom };

/// The area of a tessellation, with every quad cut along its first diagonal.
double area(const Mesh& mesh) {
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const glm::dvec3& a = mesh.points[face[0]];
    for (std::size_t i = 2; i < face.size(); ++i)
      sum += glm::length(glm::cross(mesh.points[face[i - 1]] - a, mesh.points[face[i]] - a)) / 2.0;
  }
  return sum;
}

/// The radial direction at P; 0 on the axis.
glm::dvec3 radial(const glm::dvec3& P) { return {P.x, P.y, 0.0}; }

}  // namespace

// The 290 distinct control points are Newell's, by the checksum of their sorted list.
TEST_F(Teapot, ControlPointsHaveTheKnownChecksum) {
  std::set<std::string> lines;
  for (const BezierPatch& patch : patches)
    for (const glm::dvec3& p : patch.p) {
      char line[64];
      std::snprintf(line, sizeof line, "%.6f,%.6f,%.6f", p.x + 0.0, p.y + 0.0, p.z + 0.0);
      lines.insert(line);
    }
  EXPECT_EQ(lines.size(), 290u);
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  EXPECT_EQ(text.find("-0.000000"), std::string::npos);

  const std::filesystem::path list = testing::TempDir() + "xnewell_teapot_points.txt";
  std::ofstream{list, std::ios::binary} << text;
  FILE* sum = popen(("sha256sum < " + list.string()).c_str(), "r");
  char digest[65] = "";
  ASSERT_EQ(std::fread(digest, 1, 64, sum), 64u);
  pclose(sum);
  std::filesystem::remove(list);
  EXPECT_STREQ(digest, "89429611b6eeaf2988c815dea4494a30f9ed46a4dca77e618f5b857344add026");
}

// The file is checked against a second source. Each part's patches have the points that its rings (radius,
// height) or sections (x, z at y = 0, -w, -w, 0) demand.
TEST_F(Teapot, ControlPointsFollowTheRingsAndSections) {
  struct Ring {
    double r, z;
  };
  const auto ringPart = [](const std::array<Ring, 4>& rings) {
    std::multiset<Triple> points;
    for (const auto [r, z] : rings) {
      const double k = r == 0.8 ? 0.5625 : 0.56;
      for (const double x : {-r, r})
        for (const double y : {-r, r}) {  // a quadrant: two ends and two points between
          const double a = std::copysign(k * r, x), b = std::copysign(k * r, y);
          for (const glm::dvec3& p : {glm::dvec3{x, 0, z}, {x, b, z}, {a, y, z}, {0, y, z}})
            points.insert(triple(p));
        }
    }
    return points;
  };
  struct Section {
    double w, x0, z0, x1, z1;
  };
  const auto tubePart = [](const std::array<Section, 7>& sections) {
    std::multiset<Triple> points;
    for (std::size_t i = 0; i < 7; ++i)
      for (int times = 0; times < (i == 3 ? 2 : 1); ++times)  // two patches share the middle section
        for (const double side : {-1.0, 1.0}) {
          const auto [w, x0, z0, x1, z1] = sections[i];
          for (const double y : {0.0, side * w}) {
            points.insert({x0, y, z0});
            points.insert({x1, y, z1});
          }
        }
    return points;
  };
  const double h = 0.3;
  const std::array expected{
      ringPart({{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}}),
      ringPart({{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}}),
      ringPart({{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}}),
      tubePart({{{h, -1.6, 2.025, -1.5, 2.25},
                 {h, -2.3, 2.025, -2.5, 2.25},
                 {h, -2.7, 2.025, -3, 2.25},
                 {h, -2.7, 1.8, -3, 1.8},
                 {h, -2.7, 1.575, -3, 1.35},
                 {h, -2.5, 1.125, -2.65, 0.9375},
                 {h, -2, 0.9, -1.9, 0.6}}}),
      tubePart({{{0.66, 1.7, 1.425, 1.7, 0.6},
                 {0.66, 2.6, 1.425, 3.1, 0.825},
                 {0.25, 2.3, 2.1, 2.4, 2.025},
                 {0.25, 2.7, 2.4, 3.3, 2.4},
                 {0.25, 2.8, 2.475, 3.525, 2.49375},
                 {0.15, 2.9, 2.475, 3.45, 2.5125},
                 {0.15, 2.8, 2.4, 3.2, 2.4}}}),
      ringPart({{{0, 3.15}, {0.8, 3.15}, {0, 2.85}, {0.2, 2.7}}}),
      ringPart({{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}}),
      ringPart({{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}}),
  };
  for (int part = 0; part < 8; ++part) {
    std::vector<Triple> points;
    for (int k = 4 * part; k < 4 * part + 4; ++k)
      for (const glm::dvec3& p : patches[k].p) points.push_back(triple(p));
    std::sort(points.begin(), points.end());
    ASSERT_EQ(points.size(), expected[part].size());
    // k * r as a double may differ from the file's decimal by a rounding
    auto other = expected[part].begin();
    for (const auto& [x, y, z] : points) {
      const auto& [ex, ey, ez] = *other++;
      EXPECT_LT(glm::length(glm::dvec3{x - ex, y - ey, z - ez}), 1e-15) << kTeapotParts[part].name;
    }
  }
}

// The control points fill the box (-3, -2, 0)..(3.525, 2, 3.15). The surface stops short of it at the spout's
// lip, in the plane y = 0.
TEST_F(Teapot, BoxOfControlPointsAndReachOfTheSpout) {
  glm::dvec3 lowest{1e9}, highest{-1e9};
  for (const BezierPatch& patch : patches)
    for (const glm::dvec3& p : patch.p) {
      lowest = glm::min(lowest, p);
      highest = glm::max(highest, p);
    }
  EXPECT_EQ(lowest, glm::dvec3(-3, -2, 0));
  EXPECT_EQ(highest, glm::dvec3(3.525, 2, 3.15));
  const auto reach = [&](int divisions) {
    double x = 0.0;
    for (const glm::dvec3& p : tessellate(patches, divisions).points) x = std::max(x, p.x);
    return x;
  };
  EXPECT_NEAR(reach(32), 3.43406, 5e-6);
  // The lip's edge has x = 3.3, 3.525, 3.45, 3.2, so dx/dt / 3 = 0.225 - 0.6 t + 0.125 t^2. Half a step of
  // 1/128 beside its zero, the edge is lower by less than 0.6 * 3 / 2 / 256^2.
  const double t = (0.6 - std::sqrt(0.6 * 0.6 - 4 * 0.225 * 0.125)) / (2 * 0.125);
  const double tip = point(patches[18], t, 0.0).x;
  EXPECT_LE(reach(128), tip);
  EXPECT_GE(reach(128), tip - 0.6 * 3 / 2 / (256 * 256));
}

// Every tessellation is its own mirror image in y, to the bit.
TEST_F(Teapot, TessellationIsMirrorSymmetric) {
  for (const int n : {1, 3, 8, 11}) {
    std::set<Triple> points, mirrored;
    for (const glm::dvec3& p : tessellate(patches, n).points) {
      points.insert(triple(p));
      mirrored.insert(triple(p * glm::dvec3{1, -1, 1}));
    }
    EXPECT_EQ(points, mirrored) << n;
  }
}

// The areas are known from independent work. The choice of diagonal changes the coarsest by up to 0.0003, and
// a quarter of that with each doubling. The fourth decimal is rounded.
TEST_F(Teapot, AreasOfTessellations) {
  EXPECT_NEAR(area(tessellate(patches, 8, kTeapotParts)), 52.5370, 0.0003 + 0.00005);
  EXPECT_NEAR(area(tessellate(patches, 16)), 52.7959, 0.0003 / 4 + 0.00005);
  EXPECT_NEAR(area(tessellate(patches, 32)), 52.8614, 0.0003 / 16 + 0.00005);
  EXPECT_NEAR(area(tessellate(patches, 64)), 52.8778, 0.0003 / 64 + 0.00005);
}

// Neighbours share vertices. A ring of four patches has 4 n of them around, a tube of two halves has 2 n. The
// knob and the bottom start in a pole. Rim, upper body, lower body and bottom each share a circle with the
// next one, and the knob shares one with the lid. The handle's lower end touches the body in one point, (-2,
// 0, 0.9).
TEST_F(Teapot, NeighbouringPatchesAreWelded) {
  const int n = 6;
  const int openRings = 4 * (4 * n * (n + 1));  // rim, upper and lower body, lid
  const int closedRings = 2 * (4 * n * n + 1);  // knob, bottom
  const int tubes = 2 * (2 * n * (2 * n + 1));  // handle, spout
  const int shared = 4 * (4 * n) + 1;
  EXPECT_EQ(tessellate(patches, n).points.size(),
            static_cast<std::size_t>(openRings + closedRings + tubes - shared));
}

// The front of every patch is the outside: away from the axis on body, knob and lid; away from the middle of
// its own cross-section on rim, handle and spout; downwards at the bottom. The spout's last quarter turns
// over its lip: there the outside is above, then towards the middle.
TEST_F(Teapot, EveryPatchFacesOutward) {
  for (const int part : {kUpperBody, kLowerBody})
    overPart(part, [](const BezierPatch& patch, double u, double v) {
      EXPECT_GT(glm::dot(normal(patch, u, v), radial(point(patch, u, v))), 0.5);
    });
  overPart(kKnob, [](const BezierPatch& patch, double u, double v) {
    const glm::dvec3 P = point(patch, u, v), N = normal(patch, u, v);
    EXPECT_GT(u == 0.0 ? N.z : glm::dot(N, radial(P)), 0.0);
  });
  overPart(kLid, [](const BezierPatch& patch, double u, double v) {
    const glm::dvec3 P = point(patch, u, v), N = normal(patch, u, v);
    EXPECT_GT(glm::dot(N, P - glm::dvec3{0, 0, 2.0}), 0.0);
  });
  overPart(kBottom, [](const BezierPatch& patch, double u, double v) {
    const glm::dvec3 P = point(patch, u, v), N = normal(patch, u, v);
    EXPECT_GT(glm::dot(N, P - glm::dvec3{0, 0, 1.0}), 0.0);
  });
  overPart(kRim, [](const BezierPatch& patch, double u, double v) {
    const glm::dvec3 P = point(patch, u, v), N = normal(patch, u, v);
    const glm::dvec3 middle = radial(P) * (1.45 / glm::length(radial(P))) + glm::dvec3{0, 0, 2.4};
    EXPECT_GT(glm::dot(N, P - middle), 0.0);
  });
  for (const int part : {kHandle, kSpout})
    overPart(part, [&](const BezierPatch& patch, double u, double v) {
      const glm::dvec3 P = point(patch, u, v), N = normal(patch, u, v);
      const glm::dvec3 middle = (point(patch, u, 0.0) + point(patch, u, 1.0)) / 2.0;
      const double away = glm::dot(N, P - middle);
      const bool lip = &patch == &patches[18] || &patch == &patches[19];
      if (!lip || u < 0.4)
        EXPECT_GT(away, 0.0);
      else if (u < 0.7)
        EXPECT_GT(N.z, 0.0);
      else
        EXPECT_LT(away, 0.0);
    });
}

// At the poles of knob and bottom a whole row of control points is one point, and du x dv is 0. The normal
// there is the axis. It agrees with the normal a step of 2^-30 away.
TEST_F(Teapot, PolesHaveLimitNormals) {
  for (const auto& [part, up] : {std::pair{kKnob, 1.0}, std::pair{kBottom, -1.0}})
    for (int k = 4 * part; k < 4 * part + 4; ++k) {
      const auto& p = patches[k].p;
      EXPECT_TRUE(std::equal(p.begin(), p.begin() + 3, p.begin() + 1)) << "row 0 is a point";
      EXPECT_EQ(std::equal(p.begin() + 8, p.begin() + 11, p.begin() + 9), part == kKnob) << "row 2";
      for (int j = 0; j <= 8; ++j) {
        const glm::dvec3 N = normal(patches[k], 0.0, j / 8.0);
        EXPECT_LT(glm::length(N - glm::dvec3{0, 0, up}), 0x1p-50);
        EXPECT_LT(glm::length(N - normal(patches[k], 0x1p-30, j / 8.0)), 0x1p-26);
      }
    }
}

// The teapot has a normal everywhere.
TEST_F(Teapot, HasNormalsEverywhere) {
  for (int part = 0; part < 8; ++part)
    overPart(part, [](const BezierPatch& patch, double u, double v) {
      EXPECT_NEAR(glm::length(normal(patch, u, v)), 1.0, 0x1p-50);
    });
}

}  // namespace xnewell::THIS_FILE
