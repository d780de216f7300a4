#include "geometry/view/scene_planes.h"

#include <gtest/gtest.h>

namespace xnewell::THIS_FILE {

namespace {

/// Two faces whose planes are level. Their records lie `lead` steps apart, and the planes of their own
/// corners `own` steps. Each is in doubt by half of 1000 steps.
bool touchIf(int lead, double own) {
  SnappedScene scene;
  for (const int k : {0, 1}) {
    scene.planes.add({.D = 5'000 + k * lead});
    scene.planes.setAhead(k, {.c = k * (own - lead)}, 2);
    scene.planes.setDoubt(k, {.atBack = 500}, 2);
    scene.faces.push_back({.part = k, .plane = k});
  }
  return mayTouch(scene, scene.faces[1], scene.faces[0], 0, 0);
}

}  // namespace

// Two faces may touch if the rounding of both explains that one's own plane is before the other's. Up to 1.5
// times that counts too, if it explains that the records are.
TEST(Touch, OneAndAHalfTimesWhatRoundingExplains) {
  EXPECT_TRUE(touchIf(0, 0));
  EXPECT_TRUE(touchIf(999, 999));
  EXPECT_TRUE(touchIf(999, 1'001));
  EXPECT_TRUE(touchIf(999, 1'499));
  EXPECT_FALSE(touchIf(999, 1'501));
  EXPECT_TRUE(touchIf(1'001, 999));
  EXPECT_FALSE(touchIf(1'001, 1'001));
  EXPECT_TRUE(touchIf(5'000, 999));
}

// Where all planes are those of the faces' own corners, only their distance counts.
TEST(Touch, WithoutRecordsOfSeveralFaces) {
  SnappedScene scene;
  scene.planes.add({.D = 0}), scene.planes.add({.D = 1'000});
  scene.faces = {{.plane = 0}, {.plane = 1}};
  scene.planes.setDoubt(0, {.atBack = 500}, 2), scene.planes.setDoubt(1, {.atBack = 499.5}, 2);
  EXPECT_FALSE(mayTouch(scene, scene.faces[1], scene.faces[0], 0, 0));
  scene.planes.setDoubt(1, {.atBack = 500.5}, 2);
  EXPECT_TRUE(mayTouch(scene, scene.faces[1], scene.faces[0], 0, 0));
}

}  // namespace xnewell::THIS_FILE
