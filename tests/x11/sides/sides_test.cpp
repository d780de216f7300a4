#include "x11/sides/sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "x11/sides/sides_page.h"

namespace xnewell::THIS_FILE {

namespace {

/// A picture, painted.
struct Made {
  Picture picture;
  Palette palette;
  Made(const Scene& scene, const PictureSettings& settings)
      : picture{makePicture(scene, settings, CellPlan{}[Cell::Well])},
        palette{picture.palette(CellPlan{settings.table.kind})} {}
  [[nodiscard]] ColoredPicture painted() const { return {picture, palette}; }
  [[nodiscard]] Difference errors() const {
    return comparedWithReference(picture, GroundTruth{picture}).difference;
  }
};

PictureSettings viewOf(const Scene& scene, Shading shading = Shading::Flat, Order order = Order::Newell) {
  PictureSettings s;
  s.width = 220, s.height = 150;
  s.shading = shading;
  s.order = order;
  s.camera = completed({}, scene.camera);
  return s;
}

Rgb16 onScreen(Rgb16 c) {
  return {static_cast<std::uint16_t>(c.r >> 8), static_cast<std::uint16_t>(c.g >> 8),
          static_cast<std::uint16_t>(c.b >> 8)};
}

}  // namespace

// Two pictures made alike differ nowhere, whatever their cells hold and whatever is measured.
TEST(Sides, AlikeDifferNowhere) {
  for (const auto& [name, plan] : someOf({std::pair{"hues", ColorPlan::Needed},
                                          {"teapot", ColorPlan::Needed},
                                          {"tori", ColorPlan::Chosen},
                                          {"spotlight", ColorPlan::Needed}},
                                         1)) {
    SCOPED_TRACE(name);
    const Scene scene = readScene(name, 3);
    PictureSettings s = viewOf(scene, Shading::Gouraud, Order::ZSort);
    s.colors = plan;
    Made A{scene, s}, B{scene, s};
    const Difference ofA = A.errors(), ofB = B.errors();
    for (const UnlikeRow& row : kUnlikes) {
      if (row.id == Unlike::Intensity && !hasIntensities(A.picture, B.picture)) continue;
      const Difference u = unlikeness(row.id, A.painted(), B.painted());
      EXPECT_GT(u.errors.count, 2000);
      EXPECT_EQ(u.above, 0);
      EXPECT_EQ(u.errors.largest, 0.0);
      EXPECT_TRUE(placesOf(u, 30, 40).empty());
      EXPECT_EQ(findingOf(A.picture, B.picture, ofA, ofB, u, {}).bold, "A and B have the same settings.");
    }
    EXPECT_TRUE(differencesOf(s, s).empty());
    EXPECT_FALSE(onePalette(A.painted(), B.painted(), CellPlan{}, A.palette).shared);
  }
}

// A sample has another face if another face of the model shows there. Samples that differ from the oracle's
// picture are counted as wrong, except where faces lie too close to tell.
TEST(Sides, CountsOtherFaces) {
  const Scene scene = readScene("penetrate");
  Made A{scene, viewOf(scene, Shading::Flat, Order::ZSort)},
      B{scene, viewOf(scene, Shading::Flat, Order::Oracle)};
  const std::vector<std::uint32_t> a = A.picture.faceImage(), b = B.picture.faceImage();
  std::int64_t others = 0, samples = 0;
  for (std::size_t k = 0; k < a.size(); ++k) others += a[k] != b[k], samples += a[k] != 0 || b[k] != 0;
  const Difference u = unlikeness(Unlike::Face, A.painted(), B.painted());
  EXPECT_EQ(u.above, others);
  EXPECT_EQ(u.errors.count, samples);
  EXPECT_GT(u.above, 500);
  EXPECT_LE(A.errors().wrongFaces, others);
  EXPECT_GT(A.errors().wrongFaces, others * 99 / 100);
  EXPECT_EQ(B.errors().wrongFaces, 0);
  // At a sample that differs in no face, the wrong piece of the right face may show.
  for (const int divisions : {2, 3, 5, 8}) {
    const Scene pot = readScene("teapot", divisions);
    Made z{pot, viewOf(pot, Shading::Flat, Order::ZSort)},
        oracle{pot, viewOf(pot, Shading::Flat, Order::Oracle)};
    EXPECT_LE(z.errors().wrongFaces, unlikeness(Unlike::Face, z.painted(), oracle.painted()).above);
  }
  Made C{scene, viewOf(scene)};
  EXPECT_EQ(unlikeness(Unlike::Face, B.painted(), C.painted()).above, 0);
}

// Differences of intensity are those of the surfaces to within one shade, and the numbers are computed from
// them.
TEST(Sides, IntensitiesAreThoseOfTheSurfaces) {
  const Scene scene = readScene("teapot", 3);
  Made A{scene, viewOf(scene, Shading::Flat)}, B{scene, viewOf(scene, Shading::Gouraud)};
  const Difference u = unlikeness(Unlike::Intensity, A.painted(), B.painted());
  const std::vector<double> a = A.picture.intensities(A.picture.seen(0, 150)),
                            b = B.picture.intensities(B.picture.seen(0, 150));
  double largest = 0;
  std::int64_t samples = 0, differ = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(std::isnan(a[k]), std::isnan(u.at[k]));
    if (std::isnan(a[k])) continue;
    ASSERT_NEAR(u.at[k], std::abs(a[k] - b[k]), 1.02 / 239);
    ++samples, differ += u.at[k] > 1.0 / 240;
    largest = std::max(largest, double{u.at[k]});
  }
  EXPECT_EQ(u.errors.count, samples);
  EXPECT_EQ(u.above, differ);
  EXPECT_GT(differ, samples / 2);
  EXPECT_DOUBLE_EQ(u.errors.largest, largest);
}

// The first place has more differing samples than any other frame of its size. Each of the others has no more
// of the rest than the one before. If only a few samples differ, each lies in some place.
TEST(Sides, PlacesAreTheDensest) {
  Difference u{ErrorMap{.width = 100, .at = std::vector<float>(100 * 60, 0.0f)}};
  const auto spot = [&](int x, int y, int width, int height) {
    for (int j = y; j < y + height; ++j)
      for (int i = x; i < x + width; ++i) u.at[100 * j + i] = 1, ++u.above;
  };
  spot(10, 10, 6, 5), spot(70, 40, 4, 4), spot(95, 2, 2, 3);
  std::vector<DifferingPlace> places = placesOf(u, 12, 15);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].samples, 30);
  EXPECT_EQ(places[1].samples, 16);
  EXPECT_EQ(places[2].samples, 6);
  EXPECT_EQ(places[0].frame, (Rect{7, 5, 12, 15}));   // the spot is in its middle
  EXPECT_EQ(places[2].frame, (Rect{88, 0, 12, 15}));  // the frame stays inside the picture
  for (int k = 0; k < 12; ++k) spot(8 * k, 55, 2, 2);
  places = placesOf(u, 4, 4);
  EXPECT_EQ(places.size(), std::size_t{kMostPlaces});
  EXPECT_TRUE(std::ranges::is_sorted(places, std::greater{}, &DifferingPlace::samples));
  EXPECT_FALSE(placesOf(u, 500, 500).empty());
}

// If two tables hold different colours, both pictures are shown in one palette. If there are at most 240
// colours, every sample has exactly the colour that its own table stores, as 8 bits show it.
TEST(Sides, OnePaletteShowsBoth) {
  const Scene scene = readScene("teapot", 3);
  PictureSettings a = viewOf(scene), b = a;
  b.table.kind = TableKind::Corrected;
  for (const TableKind kind : {TableKind::Linear, TableKind::Brief}) {
    a.table.kind = kind;
    Made A{scene, a}, B{scene, b};
    const CellPlan plan{kind};
    const OnePalette one = onePalette(A.painted(), B.painted(), plan, A.picture.palette(plan));
    EXPECT_TRUE(one.shared);
    EXPECT_TRUE(one.exact);
    EXPECT_EQ(withInterface(one.palette, plan), one.palette);
    int samples = 0, others = 0;
    for (const auto& [made, image] : {std::pair{&A, &one.A}, {&B, &one.B}}) {
      const SeenRows seen = made->picture.seen(0, 150);
      for (std::size_t k = 0; k < image->pixels.size(); ++k) {
        if (seen.faces[k] == kNothing) {
          ASSERT_EQ(image->pixels[k], plan[Cell::Well]);
          continue;
        }
        ++samples;
        ASSERT_EQ(onScreen(one.palette[image->pixels[k]]),
                  onScreen(made->palette[made->picture.image().pixels[k]]));
        others += onScreen(A.palette[A.picture.image().pixels[k]]) !=
                  onScreen(B.palette[B.picture.image().pixels[k]]);
      }
    }
    EXPECT_GT(samples, 10'000);
    EXPECT_GT(others, samples / 2);
  }
  // With more colours the samples have the nearest ones, and the result says so.
  const Scene hues = readScene("hues");
  Made A{hues, viewOf(hues, Shading::Flat)}, B{hues, viewOf(hues, Shading::Phong)};
  const OnePalette one = onePalette(A.painted(), B.painted(), CellPlan{}, A.palette);
  EXPECT_TRUE(one.shared);
  EXPECT_EQ(one.colors, 240);
  EXPECT_FALSE(one.exact);
}

// Only phrases that differ are marked, and they come first. A next to B and B next to A differ in the same
// settings.
TEST(Sides, PhrasesTellWhatDiffers) {
  const Scene scene = readScene("teapot", 3);
  PictureSettings a = viewOf(scene), b = a;
  const auto differing = [](const std::vector<Phrase>& phrases) {
    EXPECT_TRUE(std::ranges::is_partitioned(phrases, &Phrase::differs));
    std::string all;
    for (const Phrase& p : phrases) all += p.differs ? p.text + ';' : "";
    return all;
  };
  EXPECT_EQ(differing(phrasesOf(a, b)), "");
  EXPECT_EQ(phrasesOf(a, b).size(), 3u);
  EXPECT_EQ(sidesStatus(a, b), "same scene, same view, same light   nothing differs");
  b.order = Order::ZSort;
  EXPECT_EQ(differing(phrasesOf(a, b)), "Newell;");
  EXPECT_EQ(differing(phrasesOf(b, a)), "z-sort by farthest z;");
  EXPECT_EQ(sidesStatus(a, b), "same scene, same view, same light   only the order differs");
  b.light.ks = 0.125, b.light.Ia = 0.3;
  EXPECT_EQ(differing(phrasesOf(b, a)), "z-sort by farthest z;Ia 0.3;ks 0.125;");
  EXPECT_EQ(sidesStatus(a, b), "same scene, same view   the order, light and surface differ");
  b = a;
  b.table.shades = 20;
  EXPECT_EQ(sidesStatus(a, b), "same scene, same view, same light   only the shades differ");
  // Size and camera are the same in this view, so there are no words for them.
  b = a;
  b.width = 99, b.camera.fov = 20;
  EXPECT_TRUE(differencesOf(a, b).empty());
}

// The finding agrees with the numbers: which picture is wrong and by how much, or which is nearer to the
// truth method.
TEST(Sides, FindingsAreOfTheNumbers) {
  const Scene scene = readScene("teapot", 4);
  const auto found = [&](const PictureSettings& a, const PictureSettings& b) {
    Made A{scene, a}, B{scene, b};
    const Difference u = unlikeness(Unlike::Face, A.painted(), B.painted());
    const std::vector<DifferingPlace> places = placesOf(u, 30, 40);
    return findingOf(A.picture, B.picture, A.errors(), B.errors(), u,
                     places.empty() ? std::nullopt : std::optional{places[0]});
  };
  PictureSettings a = viewOf(scene, Shading::Flat, Order::ZSort), b = viewOf(scene);
  Made A{scene, a};
  const std::int64_t wrong = A.errors().wrongFaces;
  EXPECT_GT(wrong, 30);
  const Finding orders = found(a, b);
  EXPECT_TRUE(orders.bold.starts_with("A is wrong at " + std::to_string(wrong) + " samples, "))
      << orders.bold;
  EXPECT_TRUE(orders.bold.ends_with(" of them where spout and upper body meet.")) << orders.bold;
  EXPECT_TRUE(found(b, a).bold.starts_with("B is wrong at "));
  EXPECT_NE(orders.why.find("; B cuts "), std::string::npos);
  a = b;
  a.shading = Shading::Gouraud;
  const Finding shadings = found(a, b);
  EXPECT_EQ(shadings.bold, "A is closer to the truth overall.");
  EXPECT_NE(shadings.why.find("Both show the same face at every sample."), std::string::npos);
  a = b;
  a.dither = true;
  EXPECT_EQ(found(a, b).bold, "A and B show the same picture.");
  a.camera.eye = glm::dvec3{500, 0, 0}, a.camera.lookAt = glm::dvec3{900, 0, 0};
  b.camera = a.camera;
  EXPECT_EQ(found(a, b).bold, "Nothing shows.");
}

// The page's parts lie inside the body and do not overlap. The three pictures have one scale.
TEST(SidesLayout, HasRoomForAll) {
  for (const Rect body : {Rect{16, 43, 768, 449},
                          {16, 48, 992, 612},
                          {16, 48, 1568, 1044},
                          {16, 43, 2968, 549},
                          {16, 43, 768, 1500}}) {
    SCOPED_TRACE(testing::Message() << body.width << " x " << body.height);
    const SidesLayout at = layoutOfSides(body);
    const std::array parts{at.captionA, at.captionB, at.A, at.B, at.difference, at.numbers};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(intersection(parts[k], body), parts[k]) << k;
      EXPECT_FALSE(parts[k].empty()) << k;
      for (std::size_t l = 0; l < k; ++l) EXPECT_TRUE(intersection(parts[k], parts[l]).empty()) << k << l;
    }
    EXPECT_EQ(at.A.width, at.B.width);
    EXPECT_EQ(at.A.height, at.B.height);
    EXPECT_EQ(at.difference.width, at.A.width);
    EXPECT_GE(at.A.height, 160);
    EXPECT_LE(at.difference.height, at.A.height);
    EXPECT_GE(at.difference.height, 160);
    EXPECT_LT(at.frameHeight, at.A.height);
  }
}

}  // namespace xnewell::THIS_FILE
