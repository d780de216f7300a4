#pragma once

#include <map>
#include <string>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/extents.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The fragments of a recorded run by their ids: name, outline and extents, exactly as the sort had
/// them, made when asked for. The scene, the mesh and the run outlive it.
class Fragments {
 public:
  Fragments(const Mesh& mesh, const SnappedScene& scene, const SortedScene& sorted);

  [[nodiscard]] const SnappedFace& face(int id) const { return scene_->faces[faceIndex(id)]; }
  [[nodiscard]] int faceIndex(int id) const { return isPiece(id) ? sorted_->pieces[id - faces_].face : id; }
  [[nodiscard]] bool isPiece(int id) const { return id >= faces_; }
  [[nodiscard]] int parent(int piece) const { return sorted_->pieces[piece - faces_].parent; }
  /// Id of the k-th split's piece behind the plane; that in front of it is the next.
  [[nodiscard]] int pieceOf(int k) const { return faces_ + 2 * k; }

  /// Work: a clip for each split that led to it.
  [[nodiscard]] Region region(int id) const;
  [[nodiscard]] Extents extents(int id) const;

  /// A face's group name, if no other face has it, else `face 12`; `face 12.2` is the second convex part
  /// of a face that was divided. Its pieces: `face 12a` behind the plane that split it, `face 12b` in front;
  /// pieces of these go on so: `face 12ba`. After a letter a point comes first: `bar.a`.
  [[nodiscard]] std::string name(int id) const;
  /// Whether it is named by its group.
  [[nodiscard]] bool hasName(int id) const;
  /// By the face's number alone: `12`, `12.2`, `12ba`; and what that is of: its own name or, of bounded
  /// length, that of its group, or "".
  [[nodiscard]] std::string number(int id) const;
  [[nodiscard]] std::string part(int id) const;

 private:
  /// What divided the face, then what split it: `.2ba`.
  [[nodiscard]] std::string path(int id) const;
  [[nodiscard]] const std::string& group(int id) const;

  const Mesh* mesh_;
  const SnappedScene* scene_;
  const SortedScene* sorted_;
  int faces_;
  Regions regions_;
  std::vector<std::uint8_t> facesOfPlane_;
  std::vector<int> splitter_;              ///< of each split, the plane
  std::map<std::string, int> facesNamed_;  ///< of each group's name in the mesh
};

}  // namespace xnewell
