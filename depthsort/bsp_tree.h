#pragma once

#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// A BSP tree (binary space partition). A node is a polygon, and its plane divides all others of its subtree
/// in two: those behind it and those in front. A polygon that crosses the plane is split. The tree is walked
/// from back to front: first what lies beyond a node's plane, then the node, then what lies on the eye's
/// side.
///
/// In the paper the tree is built once, in the world, and each view only walks it: an eye on the other side
/// of a node's plane exchanges the node's two subtrees. Here the tree is built on the screen grid, for one
/// view. After the perspective warp, all planes are those of the depth sort, exactly, and the eye is
/// infinitely far away in front of each of them. So every side and every cut is exact. A tree in the world
/// would need planes through points that are rounded, and splits by planes that are seen edge-on and have no
/// cut line on the screen. In each view it would cost a backToFront(), and a sign at each node.
///
/// The root of a subtree is one of at most 5 polygons, taken at equal distances from the list. The one that
/// crosses the fewest of at most 64 others, taken in the same way, is the root. Of equals it is the one with
/// the most equal sides, then the first.
///
/// A polygon is split only if both parts own a sample of the picture, or if polygons are painted in pixels,
/// are wide (isWide()). A part without a sample shows nowhere, so it stays with the other part. Hence, unlike
/// the depth sort, a tree needs no rule for contacts: each sample shows the face that the oracle sees there.
/// Polygons in the plane of a node belong to it. They are painted in order of the scene, so the later one
/// wins.
///
/// Work: each node asks all polygons of its list. Where planes divide the list evenly, that is n log n. A
/// convex solid has no such plane: all of it lies behind each of its polygons. Its tree is a list, and the
/// work grows as n^2. The number of pieces can grow as n^3.
/// @see Fuchs, Kedem and Naylor 1980; Foley & van Dam 2e §15.5.2
struct BspNode {
  int first = 0, count = 0;     ///< the fragments in its plane: a range of BspTree::sorted.fragments
  int behind = -1, front = -1;  ///< indices of the subtrees' roots, or -1
};
struct BspTree {
  std::vector<BspNode> nodes;  ///< the root first; empty if nothing shows
  SortedScene sorted;          ///< its fragments stand node by node
};

/// Builds the tree of a scene that has planes (scene_planes.h). Of the settings, it uses width, height,
/// inPixels and mostPieces. The same scene gives the same tree. @throws TooManyPieces
[[nodiscard]] BspTree bspTree(const SnappedScene& scene, const SortSettings& settings);

/// The fragments in painting order. Work: linear in the number of nodes and fragments.
[[nodiscard]] SortedScene backToFront(BspTree tree);

}  // namespace xnewell
