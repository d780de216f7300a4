#pragma once

#include <array>
#include <string_view>

#include "geometry/view/project.h"

namespace xnewell {

/// Scenes made to be hard to sort, and small enough to be checked sample by sample. They are given on the
/// grid: the doubt is 0, and each face is the model's face of its own number.
enum class SceneKind {
  BigTriangles,
  Lattice,
  Limits,
  Slivers,
  Sticks,
  Pinwheels,
  NearCoplanar,
  Coplanar,
  Duplicates,
  EqualZ,
  Fans,
  SharedRow,
  Tiny,
  Steep,
  Polygons,
  Classes,
};
struct SceneKindRow {
  SceneKind id;
  std::string_view name, what;
};
inline constexpr std::array<SceneKindRow, 16> kSceneKinds{{
    {SceneKind::BigTriangles, "big triangles", "anywhere in the picture and at any depth"},
    {SceneKind::Lattice, "lattice", "vertices on pixel centres and corners, few depths"},
    {SceneKind::Limits, "limits", "coordinates up to the limits of the grid, often at them"},
    {SceneKind::Slivers, "slivers", "triangles a fraction of a pixel wide, to both sides of one row"},
    {SceneKind::Sticks, "sticks", "across the picture in every direction, a step to a pixel wide"},
    {SceneKind::Pinwheels, "pinwheels", "rings in which each lies over the next"},
    {SceneKind::NearCoplanar, "near-coplanar", "vertices of one plane, off by a step"},
    {SceneKind::Coplanar, "coplanar", "exactly in one plane, each by its own record"},
    {SceneKind::Duplicates, "duplicates", "few triangles, each many times over"},
    {SceneKind::EqualZ, "equal z", "facing the eye at few depths"},
    {SceneKind::Fans, "fans", "triangles around common vertices"},
    {SceneKind::SharedRow, "shared row", "all planes meet in one row of pixel centres"},
    {SceneKind::Tiny, "tiny", "a few steps large, around few pixel centres"},
    {SceneKind::Steep, "steep", "of about a step's area: the steepest planes there are"},
    {SceneKind::Polygons, "polygons", "up to nine corners, which miss their plane by a step"},
    {SceneKind::Classes, "classes", "triangles and polygons of which several share a plane record"},
}};
/// The number of kinds before Polygons. They have triangles only, whose planes go through their vertices.
inline constexpr int kTriangleKinds = static_cast<int>(SceneKind::Polygons);

/// A scene of `count` faces (for rings and fans, about as many), for a picture of size by size pixels. The
/// same arguments give the same scene.
[[nodiscard]] SnappedScene randomScene(SceneKind kind, unsigned seed, int count, int size);

/// A scene of kind seed % #kinds.
[[nodiscard]] inline SnappedScene randomScene(unsigned seed, int count, int size) {
  return randomScene(kSceneKinds[seed % kSceneKinds.size()].id, seed, count, size);
}
/// A scene of kind seed % kTriangleKinds.
[[nodiscard]] inline SnappedScene randomTriangles(unsigned seed, int count, int size) {
  return randomScene(kSceneKinds[seed % kTriangleKinds].id, seed, count, size);
}

/// Appends a face. Its plane is a given record, or a new one through vertices that lie far apart. The outline
/// may run either way. If it has no area, the function adds nothing and returns false.
bool addFace(SnappedScene& scene, std::vector<glm::ivec3> outline, int plane = -1);

/// Adds a copy of a face, as a separate face with its own plane record.
void addCopy(SnappedScene& scene, int face);

}  // namespace xnewell
