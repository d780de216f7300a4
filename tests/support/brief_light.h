#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/view/camera.h"
#include "shading/scene/scene.h"
#include "tests/support/extended.h"

namespace xnewell {

/// What a sample should show, computed a second time: with 64 bits, from the definitions, and with nothing
/// of the program but the scene, the camera and the settings. It has its own rays, polygons, normals, lights,
/// equation and textures.
using Long = Extended;
using LongVec = glm::vec<3, Long>;

class BriefLight {
 public:
  BriefLight(const Scene& scene, const Camera& camera, const Illumination& user, int width, int height);

  /// The part that the ray through pixel coordinates (x, y) meets first, and how far it is from the next one,
  /// as a share of the window's height. Part -1 if it meets none.
  struct Seen {
    int part = -1;
    Long gap = 1;
  };
  [[nodiscard]] Seen seen(Long x, Long y) const;

  /// The intensity of a part at the centre of a pixel, RGB, clamped to [0, 1].
  struct Lit {
    LongVec I{0};
    bool sure = true;  ///< false next to the border of a texel, and where the normal is a limit
  };
  [[nodiscard]] Lit light(int part, int i, int j) const;

 private:
  /// A ray in the world, relative to the view reference point.
  struct Ray {
    LongVec from{0}, along{0};
  };
  [[nodiscard]] Ray ray(Long x, Long y) const;
  [[nodiscard]] LongVec corner(int meshCorner) const;
  struct Place {
    LongVec at{0};  ///< relative to the view reference point
    int corner[3];
    Long share[3];
  };
  [[nodiscard]] Place place(int part, const Ray& ray) const;
  /// Unit, on the side from which the face runs counter-clockwise.
  [[nodiscard]] LongVec normal(const Place& place, int face, bool& sure) const;
  [[nodiscard]] LongVec newell(int face) const;
  [[nodiscard]] LongVec texel(const Place& place, int face, bool& sure) const;

  const Scene& scene_;
  const Camera& camera_;
  Illumination user_;
  int width_, height_;
  LongVec u_, v_, n_;
  struct Part {
    std::vector<LongVec> corners;
    LongVec N;
  };
  std::vector<Part> parts_;
};

}  // namespace xnewell
