#pragma once

#include <map>
#include <string>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/extents.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The fragments of a recorded run by their ids: name, outline and extents, exactly as the sort had them.
/// They are computed on demand. The scene, the mesh and the run must outlive this object.
class Fragments {
 public:
  Fragments(const Mesh& mesh, const SnappedScene& scene, const SortedScene& sorted);

  [[nodiscard]] const SnappedFace& face(int id) const { return scene_->faces[faceIndex(id)]; }
  [[nodiscard]] int faceIndex(int id) const { return isPiece(id) ? sorted_->pieces[id - faces_].face : id; }
  [[nodiscard]] bool isPiece(int id) const { return id >= faces_; }
  [[nodiscard]] int parent(int piece) const { return sorted_->pieces[piece - faces_].parent; }
  /// The id of the k-th split's piece behind the plane. The piece in front has the next id.
  [[nodiscard]] int pieceOf(int k) const { return faces_ + 2 * k; }

  /// The region of a fragment. Work: one clip for each split that led to it.
  [[nodiscard]] Region region(int id) const;
  [[nodiscard]] Extents extents(int id) const;

  /// The name of a fragment. For a face it is the group's name if no other face has that group and it is not
  /// that of a role, P or Q, otherwise `face 12`. The second convex part of a divided face is `face 12.2`.
  /// The pieces of a face are `face 12a` behind the plane that split it and `face 12b` in front; their pieces
  /// add letters: `face 12ba`. After a name that ends in a letter a point comes first: `bar.a`.
  [[nodiscard]] std::string name(int id) const;
  /// True if the fragment is named by its group.
  [[nodiscard]] bool hasName(int id) const;
  /// number() is the face's number with its path: `12`, `12.2`, `12ba`. part() is what the fragment is a part
  /// of: its own name if it has one, otherwise its group's name, shortened, or "".
  [[nodiscard]] std::string number(int id) const;
  [[nodiscard]] std::string part(int id) const;

 private:
  /// The part of a divided face, then the letters of the splits: `.2ba`.
  [[nodiscard]] std::string path(int id) const;
  [[nodiscard]] const std::string& group(int id) const;

  const Mesh* mesh_;
  const SnappedScene* scene_;
  const SortedScene* sorted_;
  int faces_;
  Regions regions_;
  std::vector<int> splitter_;              ///< for each split: the plane that split
  std::map<std::string, int> facesNamed_;  ///< for each group name in the mesh: the number of faces
};

}  // namespace xnewell
