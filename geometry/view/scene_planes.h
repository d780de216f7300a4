#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/view/plane_record.h"
#include "geometry/view/project.h"

namespace xnewell {

/// What only an order that compares planes needs: parts of one plane (ConvexParts::plane) get one plane
/// record. So they are exactly coplanar, and at a common sample the later one is seen. The record is that of
/// the plane of the model (plane_record.h). Only a triangle that was not clipped and is alone in its plane
/// has the plane of its snapped vertices: it meets its neighbours exactly in their common vertices, so they
/// have fewer contacts. Faces of ConvexParts that uniteCoplanar() has not seen have their Newell planes.
///
/// Most faces are never compared. So a record, and the doubts of the faces in its plane, are made when they
/// are first asked for. It does not matter in which order that is.
class ScenePlanes {
 public:
  /// `scene` is the result of snap() with the same arguments. All of them must outlive this.
  ScenePlanes(SnappedScene& scene, const Mesh& mesh, const ConvexParts& parts, const ViewSpec& view,
              int width, int height);

  /// Makes the record of a face of the scene, unless it is there.
  void make(const SnappedFace& face) {
    if (!scene_.planes.has(face.plane)) makeRecord(static_cast<int>(&face - scene_.faces.data()));
  }
  void makeAll();

 private:
  void makeRecord(int f);
  /// A place in the picture, in the middle of the face or near it.
  [[nodiscard]] glm::ivec2 placeInPicture(const SnappedFace& face) const;

  SnappedScene& scene_;
  const Mesh& mesh_;
  const ConvexParts& parts_;
  glm::ivec2 size_;
  DepthDoubt doubt_;
  PlaneRecords records_;
  std::vector<std::pair<int, int>> shared_;  ///< plane and face, in order, where a plane has several faces
};

/// True if two faces of different planes may touch at (x, y), |x|, |y| <= 2^30 grid steps, where the records
/// put `front` before `behind`: the plane of front's own corners is not nearer than that of behind's by more
/// than the sum of their doubts. The plane of a polygon with more than three corners misses them; that of a
/// parallelogram may be 1.5 r off the true one. So it may also be nearer by 1.5 times the sum, if the records
/// are within the sum. The doubles decide right unless the two sides are within 2^-49 of the sum of the
/// depths, leads and doubts.
[[nodiscard]] bool mayTouch(const SnappedScene& scene, const SnappedFace& front, const SnappedFace& behind,
                            std::int64_t x, std::int64_t y);

}  // namespace xnewell
