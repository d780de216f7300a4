#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace xnewell {

/// The colours of a surface, RGB in [0, 1], and how it reflects. The user chooses what the file leaves out.
struct MeshMaterial {
  std::string name;
  glm::dvec3 diffuse{1.0};   ///< of the diffuse and the ambient term; Kd in an MTL file
  glm::dvec3 specular{1.0};  ///< of the highlight
  std::optional<double> ka = {}, kd = {}, ks = {};  ///< in [0, 1]
  std::optional<int> n = {};                        ///< 0..1,000,000
  /// Index into the scene's textures, -1 for none: what the diffuse term shows (TexelUse). Before the scene
  /// has read them, an index into Mesh::textureFiles.
  int texture = -1;
};

/// A picture that a material of a file names, and where it does.
struct TextureFile {
  std::string file, namedIn;
  int line = 0;
  bool operator==(const TextureFile&) const = default;
};

/// Polygons that share vertices, as the modeller made them.
/// Space:  world, right-handed, units of the file.
/// Holds:  every corner is an index into `points`; all coordinates are finite; a face has at least three
///         corners (they may coincide: a face without area is dropped, and counted, after projection).
/// A face's number is its index here, in the order of the file. Triangulation, clipping, culling and
/// splitting keep it.
struct Mesh {
  std::vector<glm::dvec3> points;      ///< #points by 3
  std::vector<int> corners;            ///< vertex indices of all faces, one face after the other
  std::vector<int> firstCorner = {0};  ///< #faces + 1; face f owns corners [firstCorner[f], firstCorner[f+1])
  std::vector<int> group;              ///< #faces, index into groupNames
  std::vector<std::string> groupNames;  ///< the file's names of its parts: "body", "spout", ...
  std::vector<int> material;            ///< #faces, index into materials, -1 for none
  std::vector<MeshMaterial> materials;
  std::vector<TextureFile> textureFiles;  ///< each file once; empty when the scene has read them
  /// Texture coordinates. (0, 0) and (1, 1) are opposite corners of the texture; u runs along its rows, v up
  /// its columns.
  std::vector<glm::dvec2> uv;
  std::vector<int> uvOfCorner;  ///< #corners, index into uv, -1 for none; empty if no corner has any
  /// The unit normals that the file gives the surface at the corners, #corners by 3; 0 where it gives none.
  /// Empty if no corner has any.
  std::vector<glm::dvec3> normals;
  /// The rounding of the input, by group: half a unit of the last decimal of the coordinates in the file, in
  /// world units. It is 0 where the coordinates are exact by definition (points of a Bezier patch). The
  /// vector is empty if all are exact.
  std::vector<double> rounding;
  /// What the reader of the file had to leave out: one sentence for each, with file and line.
  std::vector<std::string> notes;

  [[nodiscard]] int faceCount() const { return static_cast<int>(firstCorner.size()) - 1; }
  [[nodiscard]] std::span<const int> face(int f) const {
    return {corners.data() + firstCorner[f], corners.data() + firstCorner[f + 1]};
  }
  /// The part of `normals` for face f.
  [[nodiscard]] std::span<const glm::dvec3> normalsOf(int f) const {
    if (normals.empty()) return {};
    return {normals.data() + firstCorner[f], normals.data() + firstCorner[f + 1]};
  }
  /// The rounding of the coordinates of face f, in world units.
  [[nodiscard]] double roundingOf(int f) const { return rounding.empty() ? 0.0 : rounding[group[f]]; }
  /// Appends one face. `faceCorners` has at least three valid indices. `faceUv` (-1 for none) and
  /// `faceNormals` (0 for none) have as many, or they are empty.
  void addFace(std::span<const int> faceCorners, int groupIndex, int materialIndex = -1,
               std::span<const int> faceUv = {}, std::span<const glm::dvec3> faceNormals = {}) {
    if (!faceNormals.empty()) {
      normals.resize(corners.size(), glm::dvec3{0.0});
      normals.insert(normals.end(), faceNormals.begin(), faceNormals.end());
    }
    if (!faceUv.empty()) {
      uvOfCorner.resize(corners.size(), -1);  // the first face with any: those before it have none
      uvOfCorner.insert(uvOfCorner.end(), faceUv.begin(), faceUv.end());
    }
    corners.insert(corners.end(), faceCorners.begin(), faceCorners.end());
    if (!uvOfCorner.empty()) uvOfCorner.resize(corners.size(), -1);
    if (!normals.empty()) normals.resize(corners.size(), glm::dvec3{0.0});
    firstCorner.push_back(static_cast<int>(corners.size()));
    group.push_back(groupIndex);
    material.push_back(materialIndex);
  }
};

}  // namespace xnewell
