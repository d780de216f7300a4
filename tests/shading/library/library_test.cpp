#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "shading/library/xnewell.h"

namespace xnewell::THIS_FILE {

namespace {

using library::Polygons;
using library::View;

/// Two squares through each other.
Polygons crossing() {
  return {.points = {{-1, -1, 0.5},
                     {1, -1, -0.5},
                     {1, 1, -0.5},
                     {-1, 1, 0.5},
                     {-1, -1, -0.5},
                     {1, -1, 0.5},
                     {1, 1, 0.5},
                     {-1, 1, -0.5}},
          .faces = {{0, 1, 2, 3}, {4, 5, 6, 7}}};
}

const View kFront{.width = 100, .height = 100, .eye = library::Point{0, 0, 5}, .parallel = 4.0};

double areaOf(const std::vector<std::array<double, 2>>& outline) {
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto &a = outline[k], &b = outline[(k + 1) % outline.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(twice) / 2;
}

std::string refusal(const std::function<void()>& what) {
  try {
    what();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace

// Two squares of 50 x 50 pixels that cross: one of them is cut into halves, one of which comes first and one
// last. The pieces have the squares' areas, and counter-clockwise outlines.
TEST(Library, CutsWhatCrosses) {
  const std::vector<library::Piece> pieces = library::paintingOrder(crossing(), kFront);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].face, pieces[2].face);
  EXPECT_EQ(pieces[0].face + pieces[1].face, 1);
  EXPECT_NEAR(areaOf(pieces[0].outline), 1250, 0.01);
  EXPECT_NEAR(areaOf(pieces[1].outline), 2500, 0.01);
  EXPECT_NEAR(areaOf(pieces[2].outline), 1250, 0.01);
}

// Of two faces in one plane, the later one is painted later.
TEST(Library, PaintsTheLaterOfEqualFacesLater) {
  Polygons twice = crossing();
  twice.faces[1] = twice.faces[0];
  const std::vector<library::Piece> pieces = library::paintingOrder(twice, kFront);
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.back().face, 1);
}

// What is not as the header says is refused in words, and nothing else happens.
TEST(Library, RefusesWhatIsWrong) {
  const auto order = [](const std::function<void(Polygons&, View&)>& change) {
    Polygons polygons = crossing();
    View view = kFront;
    change(polygons, view);
    return refusal([&] { (void)library::paintingOrder(polygons, view); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(order([](auto&, auto&) {}), "");
  EXPECT_EQ(order([](auto& p, auto&) { p.faces[1][2] = 8; }), "face 1: there is no point 8");
  EXPECT_EQ(order([](auto& p, auto&) { p.faces[1][2] = -1; }), "face 1: there is no point -1");
  EXPECT_EQ(order([](auto& p, auto&) { p.faces[0] = {0, 1}; }), "face 0 has fewer than three corners");
  EXPECT_EQ(order([&](auto& p, auto&) { p.points[3][1] = nan; }), "point 3 is not finite");
  EXPECT_EQ(order([&](auto& p, auto&) { p.rounding = nan; }),
            "the rounding must be a finite number of at least 0");
  EXPECT_NE(order([](auto& p, auto&) { p = {}; }), "");
  EXPECT_EQ(order([](auto&, auto& v) { v.width = 0; }),
            "the picture's width and height must be from 1 to 8192");
  EXPECT_EQ(order([](auto&, auto& v) { v.height = 8193; }),
            "the picture's width and height must be from 1 to 8192");
  EXPECT_EQ(order([](auto&, auto& v) { v.parallel = 0; }), "the height of a parallel view must be above 0");
  EXPECT_EQ(order([](auto&, auto& v) { v.fov = 30; }), "a parallel view has no field of view");
  EXPECT_EQ(order([](auto&, auto& v) { v.parallel.reset(), v.fov = 180; }),
            "the field of view must be between 0 and 180 degrees");
  EXPECT_EQ(order([&](auto&, auto& v) { v.up = library::Point{0, nan, 0}; }), "the view must be finite");
  EXPECT_NE(order([](auto&, auto& v) { v.eye = v.lookAt = library::Point{0, 0, 0}; }), "");
  EXPECT_THROW((void)library::paintingOrder(crossing(), kFront, 1), library::TooManyPieces);
  EXPECT_THROW((void)library::draw("/nowhere.obj"), std::runtime_error);
  EXPECT_THROW((void)library::readObj("/nowhere.obj"), std::runtime_error);
}

}  // namespace xnewell::THIS_FILE
