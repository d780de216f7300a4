#include <cstdlib>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"
#include "tests/fuzz/fuzz.h"

// Random polygons through snap, depth sort and painting. The first bytes choose the order and the view, then
// come points with coordinates in eighths, then faces. Without contacts and voids, an exact order shows at
// each sample the face that the oracle finds there.
namespace xnewell {

void fuzzPolygons(const std::uint8_t* bytes, std::size_t size) {
  constexpr int kPoints = 24, kMostFaces = 16;
  if (size < 3 + 3 * kPoints + 3) return;
  PictureSettings settings;
  settings.width = 40, settings.height = 30;
  settings.order = bytes[0] % 2 == 0 ? Order::Newell : Order::Bsp;
  settings.shading = kShadings[bytes[1] % kShadings.size()].id;
  if (bytes[2] % 2 == 0) settings.camera.parallel = true;
  settings.cull = bytes[2] % 4 > 1 ? Cull::Back : Cull::Keep;
  bytes += 3, size -= 3;

  Mesh mesh;
  for (int i = 0; i < kPoints; ++i, bytes += 3, size -= 3)
    mesh.points.emplace_back(static_cast<std::int8_t>(bytes[0]) / 8.0,
                             static_cast<std::int8_t>(bytes[1]) / 8.0,
                             static_cast<std::int8_t>(bytes[2]) / 8.0);
  std::vector<int> face;
  while (size > 0 && mesh.faceCount() < kMostFaces) {
    const std::size_t corners = std::min<std::size_t>(3 + *bytes % 4, size - 1);
    face.clear();
    for (std::size_t k = 1; k <= corners; ++k) face.push_back(bytes[k] % kPoints);
    bytes += corners + 1, size -= corners + 1;
    if (corners >= 3) mesh.addFace(face, 0);
  }
  if (mesh.faceCount() == 0) return;
  mesh.groupNames = {"all"}, mesh.rounding = {0.0};
  PictureCache pictures{makeScene("fuzzed", std::move(mesh), UpAxis::Y)};
  const Picture picture = pictures.make(settings, std::uint8_t{8});
  const SortStatistics& sort = picture.sorted().statistics;
  if (sort.contacts > 0 || sort.voids > 0) return;
  const std::vector<std::uint32_t> shown = picture.faceImage();
  settings.order = Order::Oracle;
  if (pictures.make(settings, std::uint8_t{8}).faceImage() != shown) std::abort();
}

}  // namespace xnewell
