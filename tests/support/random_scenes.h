#pragma once

#include <array>
#include <string_view>

#include "geometry/view/project.h"

namespace xnewell {

/// Scenes made to be hard to sort, small enough to be checked sample by sample. All are given on the grid:
/// doubt is 0 and each face is the model's face of its own number.
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
/// The kinds before Polygons: triangles, whose planes go through their vertices.
inline constexpr int kTriangleKinds = static_cast<int>(SceneKind::Polygons);

/// `count` faces or, of rings and fans, about as many; a picture of size by size pixels sees them.
/// The same for the same arguments.
[[nodiscard]] SnappedScene randomScene(SceneKind kind, unsigned seed, int count, int size);

/// Of the kind seed % #kinds.
[[nodiscard]] inline SnappedScene randomScene(unsigned seed, int count, int size) {
  return randomScene(kSceneKinds[seed % kSceneKinds.size()].id, seed, count, size);
}
/// Of the kind seed % kTriangleKinds.
[[nodiscard]] inline SnappedScene randomTriangles(unsigned seed, int count, int size) {
  return randomScene(kSceneKinds[seed % kTriangleKinds].id, seed, count, size);
}

/// Appends a face with a plane record of its own, through vertices that lie far apart, or with a given
/// record. The outline may run either way; without an area it is left out and false returned.
bool addFace(SnappedScene& scene, std::vector<glm::ivec3> outline, int plane = -1);

/// The same face again, as one of its own with its own record.
void addCopy(SnappedScene& scene, int face);

}  // namespace xnewell
