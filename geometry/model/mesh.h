#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace xnewell {

/// The colours of a surface, RGB in [0, 1], and how it reflects; what is not said is the user's to choose.
struct MeshMaterial {
  std::string name;
  glm::dvec3 diffuse{1.0};                          ///< ambient too, as an MTL file's Kd
  glm::dvec3 specular{1.0};                         ///< of the highlight
  std::optional<double> ka = {}, kd = {}, ks = {};  ///< in [0, 1]
  std::optional<int> n = {};                        ///< 0..1,000,000
  int texture = -1;  ///< index into the scene's textures: the diffuse colour is the texel
};

/// Polygons that share vertices, as a modeller made them.
/// Space:  world, right-handed, units of the file.
/// Holds:  every corner is an index into `points`; all coordinates are finite; a face has at least three
///         corners (they may coincide: a face without area is dropped, and counted, after projection).
/// A face's number is its index here: the order of the file. Triangulation, clipping, culling and
/// splitting keep it.
struct Mesh {
  std::vector<glm::dvec3> points;      ///< #points by 3
  std::vector<int> corners;            ///< vertex indices of all faces, one face after the other
  std::vector<int> firstCorner = {0};  ///< #faces + 1; face f owns corners [firstCorner[f], firstCorner[f+1])
  std::vector<int> group;              ///< #faces, index into groupNames
  std::vector<std::string> groupNames;  ///< "body", "spout", ... as the file names its parts
  std::vector<int> material;            ///< #faces, index into materials, -1 for none
  std::vector<MeshMaterial> materials;
  /// Texture coordinates: (0, 0) and (1, 1) are two corners of the texture, u along its rows, v up its
  /// columns.
  std::vector<glm::dvec2> uv;
  std::vector<int> uvOfCorner;  ///< #corners, index into uv, -1 for none; empty where no corner has any
  /// The rounding of the input, by group: half a unit of the last decimal that the coordinates of its file
  /// carry, in world units. 0 where they are exact by definition (points of a Bezier patch); empty where all
  /// are.
  std::vector<double> rounding;
  /// What the reader of the file did without: a sentence each, with file and line.
  std::vector<std::string> notes;

  [[nodiscard]] int faceCount() const { return static_cast<int>(firstCorner.size()) - 1; }
  [[nodiscard]] std::span<const int> face(int f) const {
    return {corners.data() + firstCorner[f], corners.data() + firstCorner[f + 1]};
  }
  /// The rounding of the coordinates of face f's corners.
  [[nodiscard]] double roundingOf(int f) const { return rounding.empty() ? 0.0 : rounding[group[f]]; }
  /// Appends one face; `corners` has at least three valid indices, `faceUv` as many (-1 for none) or none.
  void addFace(std::span<const int> faceCorners, int groupIndex, int materialIndex = -1,
               std::span<const int> faceUv = {}) {
    if (!faceUv.empty()) {
      uvOfCorner.resize(corners.size(), -1);  // those of the faces before it, if this is the first with any
      uvOfCorner.insert(uvOfCorner.end(), faceUv.begin(), faceUv.end());
    }
    corners.insert(corners.end(), faceCorners.begin(), faceCorners.end());
    if (!uvOfCorner.empty()) uvOfCorner.resize(corners.size(), -1);
    firstCorner.push_back(static_cast<int>(corners.size()));
    group.push_back(groupIndex);
    material.push_back(materialIndex);
  }
};

}  // namespace xnewell
