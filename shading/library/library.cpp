#include <algorithm>
#include <cmath>
#include <utility>

#include "depthsort/depth_sort.h"
#include "depthsort/region.h"
#include "geometry/files/obj.h"
#include "geometry/view/camera.h"
#include "shading/color/png.h"
#include "shading/library/xnewell.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"
#include "shading/scene/units.h"

namespace xnewell::library {

namespace {

constexpr double kPixel = 65536;  // steps of the screen's grid

glm::dvec3 vectorOf(const Point& p) { return {p[0], p[1], p[2]}; }

CameraSettings cameraOf(const View& view) {
  if (view.width < 1 || view.height < 1 || view.width > kMaxPicture || view.height > kMaxPicture)
    throw std::invalid_argument{"the picture's width and height must be from 1 to 8192"};
  if (view.fov && view.parallel) throw std::invalid_argument{"a parallel view has no field of view"};
  if (view.fov && !(*view.fov > 0 && *view.fov < 180))
    throw std::invalid_argument{"the field of view must be between 0 and 180 degrees"};
  if (view.parallel && !(*view.parallel > 0 && std::isfinite(*view.parallel)))
    throw std::invalid_argument{"the height of a parallel view must be above 0"};
  CameraSettings camera;
  for (const auto& [given, taken] :
       {std::pair{&view.eye, &camera.eye}, {&view.lookAt, &camera.lookAt}, {&view.up, &camera.up}}) {
    if (!*given) continue;
    *taken = vectorOf(**given);
    if (!std::isfinite((*taken)->x + (*taken)->y + (*taken)->z))
      throw std::invalid_argument{"the view must be finite"};
  }
  camera.fov = view.fov;
  camera.parallel = view.parallel.has_value();
  camera.height = view.parallel;
  return camera;
}

Mesh meshOf(const Polygons& polygons) {
  Mesh mesh;
  for (const Point& p : polygons.points) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw std::invalid_argument{"point " + std::to_string(mesh.points.size()) + " is not finite"};
    mesh.points.push_back(vectorOf(p));
  }
  mesh.groupNames = {"default"};
  if (!(polygons.rounding >= 0 && std::isfinite(polygons.rounding)))
    throw std::invalid_argument{"the rounding must be a finite number of at least 0"};
  mesh.rounding = {polygons.rounding};
  for (const std::vector<int>& face : polygons.faces) {
    const std::string name = "face " + std::to_string(mesh.faceCount());
    if (face.size() < 3) throw std::invalid_argument{name + " has fewer than three corners"};
    for (const int corner : face) {
      if (corner < 0 || corner >= std::ssize(mesh.points))
        throw std::invalid_argument{name + ": there is no point " + std::to_string(corner)};
      mesh.corners.push_back(corner);
    }
    mesh.firstCorner.push_back(static_cast<int>(mesh.corners.size()));
    mesh.group.push_back(0);
    mesh.material.push_back(-1);
  }
  return mesh;
}

}  // namespace

Polygons readObj(const std::string& file) {
  const Mesh mesh = xnewell::readObj(file);
  Polygons polygons;
  for (const glm::dvec3& p : mesh.points) polygons.points.push_back({p.x, p.y, p.z});
  for (const double rounding : mesh.rounding) polygons.rounding = std::max(polygons.rounding, rounding);
  for (int f = 0; f < mesh.faceCount(); ++f)
    polygons.faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  return polygons;
}

std::vector<Piece> paintingOrder(const Polygons& polygons, const View& view, int mostPieces) try {
  const CameraSettings camera = cameraOf(view);
  const Scene scene = makeScene("the polygons", meshOf(polygons), UpAxis::Y);
  const double aspect = static_cast<double>(view.width) / view.height;
  const Camera placed = placeCamera(scene, camera, aspect);
  const SnappedScene snapped =
      project(scene.mesh, scene.parts, placed.view, view.width, view.height, Cull::Keep);
  const SortedScene sorted = depthSort(snapped, {.width = view.width,
                                                 .height = view.height,
                                                 .samples = false,
                                                 .areas = false,
                                                 .mostPieces = mostPieces});
  const Regions regions{snapped};
  std::vector<Piece> pieces;
  pieces.reserve(sorted.fragments.size());
  Region region;
  for (const Fragment& fragment : sorted.fragments) {
    const SnappedFace& face = snapped.faces[fragment.face];
    regions.outline(face, region);
    if (fragment.piece >= 0) {
      const xnewell::Piece& piece = sorted.pieces[fragment.piece];
      for (int k = piece.firstCut; k < piece.firstCut + piece.cuts; ++k)
        regions.clip(region, regions.cut(sorted.cuts[k].over, sorted.cuts[k].under));
    }
    Piece& piece = pieces.emplace_back(Piece{face.number, {}});
    for (const Side& side : region) piece.outline.push_back({side.corner.x / kPixel, side.corner.y / kPixel});
  }
  return pieces;
} catch (const xnewell::TooManyPieces& e) {
  throw TooManyPieces{e.what()};
} catch (const ViewError& e) {
  throw std::invalid_argument{e.what()};
}

Picture draw(const std::string& sceneFile, const View& view) try {
  const CameraSettings camera = cameraOf(view);
  Scene scene = readScene(sceneFile);
  PictureSettings settings = scene.settings;
  settings.width = view.width, settings.height = view.height;
  settings.camera = completed(camera, scene.camera);
  const CellPlan plan{settings.table.kind};
  const xnewell::Picture made = makePicture(std::move(scene), settings, plan[Cell::Well]);
  const Palette palette = made.palette(plan);
  Picture picture{view.width, view.height, made.image().pixels, {}};
  for (int cell = 0; cell < 256; ++cell)
    picture.colors[cell] = {static_cast<std::uint8_t>(palette[cell].r >> 8),
                            static_cast<std::uint8_t>(palette[cell].g >> 8),
                            static_cast<std::uint8_t>(palette[cell].b >> 8)};
  return picture;
} catch (const ViewError& e) {
  throw std::invalid_argument{e.what()};
}

void writePng(const std::string& file, const Picture& picture) {
  IndexImage image{picture.width, picture.height, 0};
  if (picture.cells.size() != image.pixels.size())
    throw std::invalid_argument{"the picture has not as many cells as pixels"};
  image.pixels = picture.cells;
  Palette palette{};
  for (int cell = 0; cell < 256; ++cell) {
    const auto& color = picture.colors[cell];
    palette[cell] = {static_cast<std::uint16_t>(color[0] << 8), static_cast<std::uint16_t>(color[1] << 8),
                     static_cast<std::uint16_t>(color[2] << 8)};
  }
  xnewell::writePng(file, image, palette);
}

}  // namespace xnewell::library
