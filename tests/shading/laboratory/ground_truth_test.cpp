#include "shading/laboratory/ground_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <tuple>

#include "depthsort/oracle.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/divide_anew.h"
#include "shading/scene/scene_file.h"
#include "tests/support/small_picture.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

using Long = double;
using Vec = glm::dvec3;

/// A place on a surface that a ray meets first, in file coordinates.
struct Met {
  Long t;
  Vec N;  ///< unit, outward
};
using Surface = std::function<std::optional<Met>(const Vec& from, const Vec& along)>;

/// The ellipsoid (p - centre) / axes on the unit sphere: the smaller root of a quadratic.
Surface ellipsoid(const Vec& centre, const Vec& axes) {
  return [=](const Vec& from, const Vec& along) -> std::optional<Met> {
    const Vec o = (from - centre) / axes, d = along / axes;
    const Long a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1, root = b * b - a * c;
    if (root < 0) return std::nullopt;
    const Long t = (-b - std::sqrt(root)) / a;
    return Met{t, normalize((o + t * d) / axes)};
  };
}

/// The torus about the z axis with radii 1 and 0.4. Steps along the ray are as long as the distance to it.
Surface torus(const Vec& centre) {
  return [=](const Vec& from, const Vec& along) -> std::optional<Met> {
    const auto ring = [&](const Vec& p) {
      const Long r = std::sqrt(p.x * p.x + p.y * p.y);
      return r > 0 ? p - Vec{p.x / r, p.y / r, 0} : p;
    };
    Long t = 0;
    for (int step = 0; step < 2'000 && t < 40; ++step) {
      const Vec away = ring(from + t * along - centre);
      const Long distance = length(away) - 0.4;
      if (distance < 1e-9) return Met{t, normalize(away)};
      t += distance;
    }
    return std::nullopt;
  };
}

/// The vault z = 0.9 (4 - x^2) / 4 over |x|, |y| <= 2 about `at`, which the patch of kVault is.
Surface vault(const Vec& at) {
  return [=](const Vec& from, const Vec& along) -> std::optional<Met> {
    const Vec o = from - at;
    const Long k = 0.225, a = k * along.x * along.x, b = 2 * k * o.x * along.x + along.z,
               c = o.z + k * o.x * o.x - 0.9, root = b * b - 4 * a * c;
    std::optional<Met> first;
    const auto take = [&](Long t) {
      const Vec p = o + t * along;
      if (t > 0 && std::abs(p.x) <= 2 && std::abs(p.y) <= 2 && (!first || t < first->t))
        first = Met{t, normalize(Vec{2 * k * p.x, 0, 1})};
    };
    if (a < 1e-12) {
      take(-c / b);
    } else if (root >= 0) {
      take((-b - std::sqrt(root)) / (2 * a));
      take((-b + std::sqrt(root)) / (2 * a));
    }
    return first;
  };
}

/// A view from `eye` to `at`, z up, lit from a direction. It computes what a pixel should show.
struct Judge {
  Vec eye, at, L;
  Long fov, Ia, Ip;
  std::vector<Surface> surfaces;

  /// The intensity at the centre of a pixel; nothing for background.
  [[nodiscard]] std::optional<Long> operator()(int i, int j, int width, int height) const {
    const Vec n = normalize(eye - at), u = normalize(cross(Vec{0, 0, 1}, n)), v = cross(n, u);
    const Long half = std::tan(fov / 360 * 3.14159265358979323846);
    const Long x = half * width / height * (2 * (i + 0.5) / width - 1),
               y = half * (1 - 2 * (j + 0.5) / height);
    const Vec along = normalize(x * u + y * v - n);
    std::optional<Met> first;
    for (const Surface& surface : surfaces)
      if (const std::optional<Met> met = surface(eye, along); met && (!first || met->t < first->t))
        first = met;
    if (!first) return std::nullopt;
    const Vec N = dot(first->N, along) > 0 ? -first->N : first->N;
    return Ia + Ip * std::max<Long>(0, dot(N, L));
  }
};

/// The patch of vault(): x = 4 u - 2, y = 4 v - 2.
std::string vaultPatch() {
  std::string text = "1\n3 3\n";
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      text += std::to_string(4 * i / 3.0 - 2) + ' ' + std::to_string(4 * j / 3.0 - 2) +
              (i == 1 || i == 2 ? " 1.2\n" : " 0\n");
  return text;
}

/// An ellipsoid, a torus and a vault of few polygons. The file sets the divisions of all.
const std::string kFew = R"({
  "up": "z", "camera": {"eye": [1, -9, 6], "look_at": [0, 0, 0.4], "fov": 36},
  "objects": [
    {"solid": "sphere", "around": 10, "down": 5, "scale": [1.2, 0.8, 1], "move": [-1.6, -0.6, 1.7]},
    {"file": "vault.bpt", "divisions": 2, "move": [-1, 1, -1]},
    {"solid": "torus", "around": 9, "across": 6, "move": [1.7, 0.2, 0.4]}]})";
Judge judgeOfFew() {
  return {{1, -9, 6},
          {0, 0, 0.4},
          normalize(Vec{-1, -2, 3}),
          36,
          0.2,
          0.7,
          {ellipsoid({-1.6, -0.6, 1.7}, {1.2, 0.8, 1}), vault({-1, 1, -1}), torus({1.7, 0.2, 0.4})}};
}

struct Few {
  Few() {
    folder.write("vault.bpt", vaultPatch());
    scene = parseSceneFile(kFew, "few", folder.path());
    settings.width = 160, settings.height = 120;
    settings.camera = completed({}, scene.camera);
    settings.light = {.Ia = 0.2, .Ip = 0.7, .ka = 1, .kd = 1, .ks = 0, .n = 5, .light = {-1, -2, 3}};
  }
  TemporaryFolder folder;
  Scene scene;
  PictureSettings settings;
};

double errorOf(const std::string& name, int divisions, ColorPlan colors, int width, int height) {
  const Scene scene = readScene(name, divisions);
  PictureSettings s = scene.settings;
  s.width = width, s.height = height;
  s.colors = colors;
  s.camera = completed({}, scene.camera);
  const Picture picture = makePicture(scene, s, CellPlan{s.table.kind}[Cell::Well]);
  return errorsOf(picture, picture.palette(CellPlan{s.table.kind})).afterTable.rootMeanSquare;
}

}  // namespace

// Rays meet the true ellipsoid, torus and vault, however few polygons the file asks for. The truth has the
// same intensity at every sample, but for a few at outlines: the fine polygons are up to 0.02 pixels inside
// of them.
TEST(GroundTruth, IsThatOfTheSurfaces) {
  const Few few;
  const Judge judge = judgeOfFew();
  const Picture picture = makePicture(few.scene, few.settings);
  const GroundTruth truth{picture};
  int shown = 0, off = 0, beyond = 0;
  for (int j = 0; j < few.settings.height; ++j)
    for (int i = 0; i < few.settings.width; ++i) {
      const std::size_t k = std::size_t(j) * few.settings.width + i;
      const std::optional<Long> I = judge(i, j, few.settings.width, few.settings.height);
      const bool shows = truth.reference().faces()[k] != kNothing;
      shown += I.has_value();
      beyond += I && truth.polygons().faces()[k] == kNothing;
      off += I.has_value() != shows ||
             (I && std::abs(static_cast<double>(*I) - truth.reference().I(k).r) > 0.002);
    }
  EXPECT_GT(shown, 3'500);
  EXPECT_GT(beyond, 100);  // the file's polygons miss that much of the surfaces
  EXPECT_LE(off, 8);
}

// So the errors of a picture are those of a comparison with the true surfaces.
TEST(GroundTruth, GivesTheErrorsOfThePolygons) {
  Few few;
  const Judge judge = judgeOfFew();
  for (const Shading shading : {Shading::Flat, Shading::Phong}) {
    few.settings.shading = shading;
    few.settings.table.hue = glm::dvec3{1};
    const Picture picture = makePicture(few.scene, few.settings, CellPlan{}[Cell::Well]);
    double squares = 0;
    int samples = 0;
    for (int j = 0; j < few.settings.height; ++j)
      for (int i = 0; i < few.settings.width; ++i) {
        const int cell = picture.image().row(j)[i];
        const bool shows = cell != picture.ground();
        const std::optional<Long> due = judge(i, j, few.settings.width, few.settings.height);
        if (!shows && !due) continue;
        const double error =
            (shows ? picture.colors().intensityOf(cell) : 0.0) - static_cast<double>(due.value_or(0));
        ++samples, squares += error * error;
      }
    const Errors errors = errorsOf(picture, picture.palette(CellPlan{}));
    const double expected = std::sqrt(squares / samples);
    EXPECT_GT(expected, 0.05);
    EXPECT_NEAR(errors.afterTable.rootMeanSquare, expected, 0.02 * expected);
    EXPECT_NEAR(static_cast<double>(errors.samples), samples, 8);
    EXPECT_EQ(errors.wrongFaces, 0);
    // At an outline, where the polygons show nothing, the face is the one that stands for the surface.
    ASSERT_FALSE(errors.worst.empty());
    for (const WorstPlace& place : errors.worst) {
      EXPECT_EQ(place.due.r > 0, place.face >= 0);
      EXPECT_LT(place.face, few.scene.mesh.faceCount());
    }
  }
}

// The figures of another program, which has true spheres, and patches of many polygons.
TEST(GroundTruth, IsThatOfBuiltInScenes) {
  EXPECT_NEAR(errorOf("colored-lights", 8, ColorPlan::OneHue, 320, 240), 0.0116, 0.0002);
  EXPECT_NEAR(errorOf("colored-lights", 2, ColorPlan::OneHue, 320, 240), 0.0487, 0.0005);
  EXPECT_NEAR(errorOf("hues", 8, ColorPlan::Needed, 640, 480), 0.0376, 0.002);
}

// A patch is as wrong if its file sets the divisions as if the user does.
TEST(GroundTruth, DoesNotAskWhoSetTheDivisions) {
  const Scene own = readScene("coarse-teapot"), open = readScene("teapot", 3);
  PictureSettings s = own.settings;
  s.width = 120, s.height = 90;
  const auto errors = [&](const Scene& scene) {
    const Picture picture = makePicture(scene, s, CellPlan{}[Cell::Well]);
    return errorsOf(picture, picture.palette(CellPlan{}));
  };
  const Errors a = errors(own), b = errors(open);
  EXPECT_NEAR(a.afterTable.rootMeanSquare, b.afterTable.rootMeanSquare, 1e-9);
  EXPECT_GT(a.afterTable.rootMeanSquare, 0.08);
}

// A scene whose surfaces are as fine as those of the reference is not divided again: nothing is held twice.
TEST(GroundTruth, NeedsNoSecondSceneIfTheFirstIsFine) {
  EXPECT_TRUE(fineSceneOf(readScene("teapot", 63)));
  EXPECT_FALSE(fineSceneOf(readScene("teapot", 64)));
  EXPECT_FALSE(fineSceneOf(readScene("cycle")));
  const Few few;
  EXPECT_TRUE(fineSceneOf(few.scene));
  EXPECT_FALSE(fineSceneOf(finelyDivided(few.scene)));
}

// A face of one division is a face of any other: at poles, edges, and beside other objects.
TEST(GroundTruth, FindsTheFaceOfOtherDivisions) {
  const Few few;
  const Scene fine = finelyDivided(few.scene);
  EXPECT_EQ(finestDivisions(few.scene), 64);
  EXPECT_EQ(fine.mesh.faceCount(), 256 * 128 + 64 * 64 + 256 * 256);
  for (int face = 0; face < few.scene.mesh.faceCount(); ++face) {
    ASSERT_EQ(sameFaceIn(few.scene, few.scene, face), face);
    ASSERT_EQ(sameFaceIn(few.scene, fine, sameFaceIn(fine, few.scene, face)), face);
  }
  // Its middle is within the size of a coarse face of that face's middle.
  const auto middle = [](const Scene& scene, int face) {
    glm::dvec3 sum{0};
    for (const int c : scene.mesh.face(face)) sum += scene.mesh.points[c];
    return std::ldexp(1.0, scene.exponent) * sum / static_cast<double>(scene.mesh.face(face).size());
  };
  for (int face = 0; face < fine.mesh.faceCount(); face += 37)
    ASSERT_LT(glm::length(middle(fine, face) - middle(few.scene, sameFaceIn(few.scene, fine, face))), 1.8)
        << face;
}

// The last truth stays as long as nothing that decides it changes. A short cut does not.
TEST(GroundTruth, IsKept) {
  Few few;
  PictureCache pictures{few.scene};
  CachedGroundTruth last;
  const GroundTruth* const first = &last.of(pictures.make(few.settings));
  const double before = first->reference().I(60 * 160 + 80).r;
  std::vector<int> faces = first->reference().faces();
  few.settings.shading = Shading::Phong, few.settings.order = Order::ZSort;
  EXPECT_EQ(last.of(pictures.make(few.settings)).reference().faces(), faces);
  few.settings.light.Ia = 0.1;
  EXPECT_NEAR(last.of(pictures.make(few.settings)).reference().I(60 * 160 + 80).r, before - 0.1, 1e-12);
  few.settings.camera.fov = 50;
  EXPECT_NE(last.of(pictures.make(few.settings)).reference().faces(), faces);
  const Picture other = makePicture(readScene("cycle"), few.settings);
  EXPECT_EQ(last.of(other).reference().picture().scene().name, "cycle");
}

// A reference that has forgotten the hidden faces has the same light and the same places.
TEST(GroundTruth, IsTheSameWithoutHiddenFaces) {
  for (const char* const name : {"teapot", "decals", "lamp"}) {
    SCOPED_TRACE(name);
    const Picture picture = makePicture(readScene(name, 8), small(), 8);
    const FineScene fine = fineSceneOf(picture.scene());
    const Reference all = referenceOf(picture, fine);
    Reference shown = referenceOf(picture, fine);
    shown.keepShownOnly();
    for (std::size_t k = 0; k < all.faces().size(); ++k) {
      ASSERT_EQ(all.I(k), shown.I(k));
      if (all.faces()[k] == kNothing) continue;
      ASSERT_EQ(all.place(k).at, shown.place(k).at);
      ASSERT_EQ(all.place(k).N, shown.place(k).N);
    }
    const Palette palette = picture.palette(CellPlan{});
    const auto worst = [&](const Reference& reference) {
      std::vector<std::tuple<int, int, int>> places;
      const Comparison comparison{picture, reference, palette};
      for (const WorstPlace& p : worstPlaces(comparison, comparison.intensityErrors(TableSide::After)))
        places.emplace_back(p.x, p.y, p.face);
      return places;
    };
    EXPECT_EQ(worst(all), worst(shown));
    EXPECT_LE(shown.picture().snapped().faces.size(), all.picture().snapped().faces.size());
  }
}

}  // namespace xnewell::THIS_FILE
