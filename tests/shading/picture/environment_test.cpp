#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "shading/fill/environment.h"
#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Environment maps

/// One light of the given direction as the eye sees it, on a plain white surface.
struct Lit {
  Lighting lighting;
  explicit Lit(glm::dvec3 L, double kd = 1, double ks = 0, int n = 1)
      : lighting{resolve(cube(), {}, {.Ia = 0, .Ip = 1, .ka = 1, .kd = kd, .ks = ks, .n = n, .light = L},
                         Channels::Luminance, {0, 0, 5}, {0, 0, 0})} {}
  [[nodiscard]] Environment map(EnvironmentForm form) const {
    return makeEnvironment(form, lighting, lighting.materials[0], 0, glm::dmat3{1.0}, {0, 0, 0});
  }
};

/// The normal that a place of a map stands for, on the near or the far side. There is none if x and y lie
/// outside the circle.
std::optional<glm::dvec3> normalAt(int column, int row, double side) {
  const double x = (column + 0.5 - kMapCentre) / kMapScale, y = (row + 0.5 - kMapCentre) / kMapScale;
  const double square = 1 - x * x - y * y;
  if (square < 0) return std::nullopt;
  return glm::dvec3{x, y, side * std::sqrt(square)};
}

double tutorialPhong(const glm::dvec3& N, const glm::dvec3& L, double kd, double ks, int n) {
  const double cosine = std::max(0.0, glm::dot(N, L));
  return std::min(1.0, cosine > 0 ? kd * cosine + ks * power(cosine, n) : 0.0);
}

/// Root mean square error of the published look-up over all normals that face the eye, with the places of the
/// map taken as evenly spread, for a light that many degrees off the view axis.
double publishedError(double degrees) {
  const SinCos angle = sinCosDegrees(degrees);
  const glm::dvec3 L{angle.sin, 0, angle.cos};
  const Environment map = Lit{L}.map(EnvironmentForm::Published);
  double squares = 0;
  int count = 0;
  for (int row = 0; row < 256; ++row)
    for (int column = 0; column < 256; ++column)
      if (const auto N = normalAt(column, row, 1)) {
        const double error = map.front[256 * row + column] - tutorialPhong(*N, L, 1, 0, 1);
        squares += error * error;
        ++count;
      }
  return std::sqrt(squares / count);
}

// At every place of the map the value is that of the equation, for every direction of the light and any
// sharpness of the highlight. In a frame where L is (0, 0, 1), the normal's x, y and side are enough.
TEST(Environment, RotatedIsExactAtEveryPlace) {
  for (const glm::dvec3 along : {glm::dvec3{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-0.4, 0.7, 0.2}, {1, 1, -1}})
    for (const int n : {0, 1, 20, 100'000}) {
      const glm::dvec3 L = glm::normalize(along);
      const Environment map = Lit{L, 0.5, 0.4, n}.map(EnvironmentForm::Rotated);
      ASSERT_TRUE(map.twoMaps);
      int places = 0;
      for (int k = 0; k < 65'536; ++k)
        for (const double side : {1.0, -1.0}) {
          const auto turned = normalAt(k % 256, k / 256, side);
          if (!turned) continue;
          const glm::dvec3 N = glm::transpose(map.frame) * *turned;  // back to the world
          ASSERT_NEAR((side > 0 ? map.front : map.away)[k], tutorialPhong(N, L, 0.5, 0.4, n),
                      1e-6 + n * 1e-14);
          ++places;
        }
      EXPECT_GT(places, 100'000);
    }
}

// The published look-up is exact for a light on the view axis. The farther off the axis the light is, the
// larger the error. The test has a white surface, diffuse light alone and all normals that face the eye.
TEST(Environment, PublishedIsExactOnTheViewAxisAlone) {
  EXPECT_LT(publishedError(0), 1e-7);
  for (const double degrees : {15.0, 30.0, 45.0, 60.0}) {
    SCOPED_TRACE(degrees);
    EXPECT_GT(publishedError(degrees), 0.13);
    EXPECT_LT(publishedError(degrees), 0.18);
  }
}

/// ---- Pictures by environment mapping, against the equation

/// An icosahedron whose faces are halved along every edge `times` times: 20, 80, 320, ... faces of a sphere.
Mesh icosphere(int times) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  std::vector<glm::dvec3> points;
  std::vector<std::array<int, 3>> faces;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g})
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 p{0};
        p[axis] = a, p[(axis + 1) % 3] = b;
        points.push_back(glm::normalize(p));
      }
  const double edge = 2.0 / std::sqrt(1.0 + g * g);
  const auto near = [&](int a, int b) { return std::abs(glm::length(points[a] - points[b]) - edge) < 1e-9; };
  for (int a = 0; a < 12; ++a)
    for (int b = a + 1; b < 12; ++b)
      for (int c = b + 1; c < 12; ++c)
        if (near(a, b) && near(b, c) && near(a, c)) {
          const bool out = glm::dot(glm::cross(points[b] - points[a], points[c] - points[a]), points[a]) > 0;
          faces.push_back(out ? std::array{a, b, c} : std::array{a, c, b});
        }
  for (; times > 0; --times) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [known, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (isNew) points.push_back(glm::normalize(points[a] + points[b]));
      return known->second;
    };
    std::vector<std::array<int, 3>> quarters;
    for (const auto& [a, b, c] : faces) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::array<int, 3>& q : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        quarters.push_back(q);
    }
    faces = std::move(quarters);
  }
  Mesh mesh;
  mesh.groupNames = {""};
  mesh.points = std::move(points);
  for (const auto& face : faces) mesh.addFace(face, 0);
  return mesh;
}

PictureSettings mapped(int size) {
  PictureSettings s;
  s.width = s.height = size;
  s.shading = Shading::Environment;
  return s;
}

/// How far the looked-up intensities are from the equation of the interpolated normal, made a unit vector.
struct Error {
  double rms = 0, largest = 0;
};
Error errorOf(const Picture& picture, const glm::dvec3& towardsLight) {
  const int rows = picture.settings().height;
  const SeenRows seen = picture.seen(0, rows);
  const std::vector<double> I = picture.intensities(seen, 0);
  const std::vector<glm::dvec3> N = picture.normals(seen);
  const Illumination& user = picture.settings().light;
  const glm::dvec3 L = glm::normalize(towardsLight);
  Error error;
  int count = 0;
  for (std::size_t k = 0; k < I.size(); ++k) {
    if (std::isnan(I[k])) continue;
    const double c = std::max(0.0, glm::dot(N[k], L));
    const double lit = user.Ip * (user.kd * c + (c > 0 ? user.ks * std::pow(c, user.n) : 0.0));
    const double off = I[k] - std::min(1.0, user.ka * user.Ia + lit);
    error.rms += off * off, ++count;
    error.largest = std::max(error.largest, std::abs(off));
  }
  error.rms = std::sqrt(error.rms / count);
  return error;
}

// Each channel is looked up in the axes in which its own map was made: red light from the left and green
// light from the right fall on the left and on the right of a white ball. All other normals agree with the
// equation, too, to what the steps of the map leave: at its rim 1.5 / 127 in x is 0.15 in z.
TEST(EnvironmentPicture, EachChannelHasItsOwnLight) {
  Scene scene = makeScene("ball", sphere(96, 48), UpAxis::Y);
  const std::array<glm::dvec3, 2> towards{{{-1, 0, 1}, {1, 0, 1}}};
  scene.light.lights = {{.Ip = {0.7, 0, 0}, .direction = towards[0]},
                        {.Ip = {0, 0.7, 0}, .direction = towards[1]}};
  PictureCache pictures{std::move(scene)};
  PictureSettings s = mapped(240);
  s.colors = ColorPlan::Chosen;
  s.camera.eye = glm::dvec3{0, 0, 6}, s.camera.lookAt = glm::dvec3{0};
  const Picture picture = pictures.make(s, 8);
  const SeenRows seen = picture.seen(0, s.height);
  const std::vector<glm::dvec3> N = picture.normals(seen);
  int compared = 0;
  for (int channel = 0; channel < 2; ++channel) {
    const std::vector<double> I = picture.intensities(seen, channel);
    const glm::dvec3 L = glm::normalize(towards[channel]);
    for (std::size_t k = 0; k < I.size(); ++k) {
      if (std::isnan(I[k])) continue;
      const double c = std::max(0.0, glm::dot(N[k], L));
      const double lit = 0.7 * (s.light.kd * c + s.light.ks * std::pow(c, s.light.n));
      ASSERT_NEAR(I[k], std::min(1.0, s.light.ka * s.light.Ia + lit), 0.1) << channel << " at " << k;
      ++compared;
    }
  }
  EXPECT_GT(compared, 20'000);
  // And so are the cells: the stored colours, red beside the left border and green beside the right one.
  const Palette palette = picture.palette(CellPlan{s.table.kind});
  const auto colorAt = [&](int i) { return palette[picture.image().row(120)[i]]; };
  EXPECT_GT(colorAt(70).r, 2 * colorAt(70).g);
  EXPECT_GT(colorAt(170).g, 2 * colorAt(170).r);
}

// The interpolated normal is shorter than 1 inside a face, and the look-up does not make it longer. So coarse
// spheres err most beside the terminator, where N.L is 0. The figures of shading/README.md, which this
// prints.
TEST(EnvironmentPicture, ErrsOnCoarseMeshesAsTheReadmeSays) {
  for (const auto& [times, rms, largest] :
       {std::tuple{0, 0.210, 0.60}, {1, 0.099, 0.35}, {2, 0.039, 0.20}, {3, 0.016, 0.13}, {4, 0.012, 0.10}}) {
    PictureCache pictures{makeScene("ball", icosphere(times), UpAxis::Y)};
    PictureSettings s = mapped(480);
    s.light = {.Ia = 0, .Ip = 1, .kd = 1, .ks = 0, .light = {-1, 0.5, 0.25}};
    const Picture picture = pictures.make(s);
    const Error error = errorOf(picture, s.light.light);
    std::printf("%5d faces: rms %.4f, largest %.3f\n", picture.scene().mesh.faceCount(), error.rms,
                error.largest);
    EXPECT_NEAR(error.rms, rms, 0.05 * rms);
    EXPECT_NEAR(error.largest, largest, 0.05 * largest);
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
