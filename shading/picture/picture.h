#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "depthsort/depth_sort.h"
#include "geometry/view/project.h"
#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "shading/picture/scene_colors.h"
#include "shading/picture/scene_shading.h"
#include "shading/picture/shared.h"
#include "shading/picture/surface_painter.h"
#include "shading/picture/surface_values.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Milliseconds that each stage of a picture took; 0 for a stage whose result an earlier picture lent. A
/// picture does not read or present itself: the caller adds those times.
struct StageTimes {
  double read = 0, shade = 0, transform = 0, sort = 0, fill = 0, present = 0;
  [[nodiscard]] double total() const { return read + shade + transform + sort + fill + present; }
};

/// What the last stage makes: the image, and what is known only after painting.
struct Painted {
  IndexImage image;
  std::uint8_t ground = 0;          ///< the cell where nothing shows
  std::vector<Rgb16> chosen;        ///< the colours, of a plan of colours
  std::vector<std::uint8_t> cells;  ///< Picture::cells(), of a plan of colours
  std::int64_t clamped = 0;         ///< evaluations at pixels that exceeded 1, as often as painted
};

/// One picture of a scene, from polygons to colour indices, without any server: an immutable result with the
/// results of all stages. Copies share them, so a copy is cheap. PictureCache::make() makes it.
class Picture {
 public:
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const PictureSettings& settings() const { return settings_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const SceneShading& shading() const { return shading_; }
  [[nodiscard]] const SnappedScene& snapped() const { return *snapped_; }
  /// What to paint, back to front: whole faces, and pieces where the depth sort split them. Empty for
  /// Order::Oracle, which paints no faces.
  [[nodiscard]] const SortedScene& sorted() const { return *sorted_; }
  [[nodiscard]] const SceneColors& colors() const { return *colors_; }
  /// The ramp of the one hue, or of the first.
  [[nodiscard]] const ColorTable& table() const { return colors_->table(); }
  /// Where the method gives each of snapped().faces one cell, that cell; else empty. A plan of colours has
  /// them only if the picture is painted.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const;
  [[nodiscard]] const StageTimes& times() const { return times_; }

  /// Whether make() was asked for the image.
  [[nodiscard]] bool isPainted() const { return painted_ != nullptr; }
  /// Precondition: isPainted().
  [[nodiscard]] const IndexImage& image() const { return painted_->image; }
  /// The cell where nothing shows. Precondition: isPainted().
  [[nodiscard]] std::uint8_t ground() const { return painted_->ground; }
  /// How many colours a plan of colours has chosen; 0 if the picture is not painted.
  [[nodiscard]] int chosenColors() const { return painted_ ? static_cast<int>(painted_->chosen.size()) : 0; }
  /// The colours of the cells. A plan of colours has them only if the picture is painted.
  [[nodiscard]] Palette palette(const CellPlan& plan, const Palette& unneeded = {}) const;
  /// Evaluations of the illumination that exceeded 1 and were clamped, in each channel: at faces for flat
  /// shading and at vertices for Gouraud's, on either side; and, if the picture is painted, at pixels.
  [[nodiscard]] std::int64_t saturated() const;

  /// The walk's last step, for a picture that was made without its image, or for another ground.
  [[nodiscard]] Painted paint(std::uint8_t ground) const;
  /// Paints fragments of runs over snapped(), one by one. The picture outlives it. Not for a plan of colours.
  [[nodiscard]] SurfacePainter painter() const;
  /// The same picture with the planes that a sort of snapped() needs. Orders that compare planes have them
  /// already, and then it is a plain copy.
  [[nodiscard]] Picture withPlanes() const;

  /// Face number + 1 at every sample, 0 where nothing is; row by row from the top.
  [[nodiscard]] std::vector<std::uint32_t> faceImage() const;
  /// What each sample of rows [firstRow, endRow) shows.
  [[nodiscard]] SeenRows seen(int firstRow, int endRow) const;
  /// How often each sample was painted, row by row: as often as fragments cover it, or once where the face
  /// is decided at each sample.
  [[nodiscard]] std::vector<int> timesPainted() const;
  /// The intensities of one channel, before the colour table; as intensitiesAt().
  [[nodiscard]] std::vector<double> intensities(const SeenRows& rows, int channel = 0) const;
  /// As normalsAt().
  [[nodiscard]] std::vector<glm::dvec3> normals(const SeenRows& rows) const;

 private:
  friend class PictureCache;
  explicit Picture(Shared<Scene> scene) : scene_{std::move(scene)} {}

  /// Calls span(row, from, to, face) for runs of samples of rows [firstRow, endRow) that show one of
  /// snapped().faces, later calls over earlier ones.
  template <class Span>
  void paintFaces(int firstRow, int endRow, Span&& span) const;
  /// The intensity of each of snapped().faces in one channel, before the table, where each has one.
  [[nodiscard]] std::vector<double> faceIntensities(int channel) const;
  /// The cell, or the channel's value, of each of snapped().faces, where each has one.
  [[nodiscard]] std::vector<std::uint8_t> cellsOf(int channel) const;
  [[nodiscard]] Surfaces surfaces() const;
  /// Paints one channel on `image`. Returns how many evaluations at pixels were above 1.
  std::int64_t paintChannel(IndexImage& image, int channel, const std::vector<std::uint8_t>& cells) const;
  void paintColors(Painted& painted) const;
  /// The cell of each of snapped().faces in a plan of colours: the nearest of those chosen.
  [[nodiscard]] std::vector<std::uint8_t> nearestCells(const std::vector<Rgb16>& chosen) const;

  // The results, in the order of the walk.
  Shared<Scene> scene_;
  PictureSettings settings_;
  Camera camera_;
  SceneShading shading_;
  Shared<SnappedScene> snapped_;
  Shared<SortedScene> sorted_;
  Shared<std::vector<int>> visible_;  ///< of Order::Oracle: the face at each sample
  Shared<SceneColors> colors_;
  Shared<std::vector<std::uint8_t>> cells_;  ///< but for a plan of colours
  std::shared_ptr<const Painted> painted_;   ///< null if the image was not asked for
  StageTimes times_;
};

}  // namespace xnewell
