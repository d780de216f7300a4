#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Collects what PLY and OFF files have alike: points, and faces that name them by indices from 0.
/// A face may have a colour. It becomes the diffuse colour of a material, because the illumination equation
/// has such a colour for each surface. It has none for each vertex.
class IndexedFaces {
 public:
  /// The coordinates and, where a file has them, one texture coordinate for each point (all or none).
  Mesh mesh;
  /// One for each point, of any length, or none. Those without a direction count as none.
  std::vector<glm::dvec3> normals;

  /// Adds a face, or only counts it if it has fewer than three corners: some writers store edges and points
  /// as such faces. The corners are valid indices. Channels of the colour beyond [0, 1] are clamped.
  void add(std::span<const int> corners, const std::optional<glm::dvec3>& color);
  /// The mesh, with notes on what was left out. `rounding` is Mesh::rounding. Messages call the file `name`.
  /// Throws ParseError if there is no face.
  [[nodiscard]] Mesh take(const std::string& name, double rounding);

  /// A file with more colours than this is shown without them: so many are no longer parts of a model but
  /// samples of a picture on it.
  static constexpr std::size_t kMostColors = 256;

 private:
  std::vector<glm::dvec3> ofCorners_;  ///< of the current face; a member to reuse its memory
  std::map<std::array<double, 3>, int> materials_;
  int small_ = 0;  ///< faces with fewer than three corners
};

}  // namespace xnewell
