#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "depthsort/depth_sort.h"
#include "geometry/view/project.h"
#include "shading/color/color_table.h"
#include "shading/color/images.h"
#include "shading/picture/scene_colors.h"
#include "shading/picture/scene_shading.h"
#include "shading/picture/shared.h"
#include "shading/picture/surface_evaluator.h"
#include "shading/picture/surface_painter.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The milliseconds that each stage of a picture took; 0 for a stage whose result came from an earlier
/// picture. A picture does not read its scene or present itself: the caller adds those two times.
struct StageTimes {
  double read = 0, shade = 0, transform = 0, sort = 0, fill = 0, present = 0;
  [[nodiscard]] double total() const { return read + shade + transform + sort + fill + present; }
};

/// The result of the last stage: the image, and what is known only after painting.
struct Painted {
  IndexImage image;
  std::uint8_t ground = 0;          ///< the cell of the background
  std::vector<Rgb16> chosen;        ///< the chosen colours, if the plan is one of colours
  std::vector<std::uint8_t> cells;  ///< Picture::cells(), if the plan is one of colours
  /// evaluations at pixels that exceeded 1; a pixel counts each time it is painted
  std::int64_t clamped = 0;
};

/// One picture of a scene, from polygons to colour indices. It needs no X server. It is immutable and holds
/// the results of all stages. Copies share the results, so a copy is cheap. PictureCache::make() makes
/// pictures.
class Picture {
 public:
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const PictureSettings& settings() const { return settings_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const SceneShading& shading() const { return shading_; }
  [[nodiscard]] const SnappedScene& snapped() const { return *snapped_; }
  /// What to paint, back to front: whole faces, or pieces of the faces that were split. There are none for
  /// the oracle and a z-buffer (OrderRow::bySample), which find the visible face at each sample instead.
  [[nodiscard]] const SortedScene& sorted() const { return *sorted_; }
  [[nodiscard]] const SceneColors& colors() const { return *colors_; }
  /// The ramp of the one hue, or the first of several ramps.
  [[nodiscard]] const ColorTable& table() const { return colors_->table(); }
  /// The cell of each of snapped().faces, if the method gives each face a single cell; otherwise empty. For a
  /// plan of colours, the cells are known only if the picture is painted.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const;
  [[nodiscard]] const StageTimes& times() const { return times_; }

  /// True if make() painted the image.
  [[nodiscard]] bool isPainted() const { return painted_ != nullptr; }
  /// Precondition: isPainted().
  [[nodiscard]] const IndexImage& image() const { return painted_->image; }
  /// The cell of the background. Precondition: isPainted().
  [[nodiscard]] std::uint8_t ground() const { return painted_->ground; }
  /// The number of colours that a plan of colours has chosen; 0 if the picture is not painted.
  [[nodiscard]] int chosenColors() const { return painted_ ? static_cast<int>(painted_->chosen.size()) : 0; }
  /// The colours of the cells. For a plan of colours, they are known only if the picture is painted.
  /// `unneeded` gives the colours of the cells that the picture does not use.
  [[nodiscard]] Palette palette(const CellPlan& plan, const Palette& unneeded = {}) const;
  /// The number of evaluations of the illumination that exceeded 1 and were clamped, over all channels. Flat
  /// shading evaluates at faces and Gouraud shading at vertices, for both sides. If the picture is painted,
  /// evaluations at pixels count too.
  [[nodiscard]] std::int64_t saturated() const;

  /// Does the last stage, for a picture that was made without its image, or for another background cell.
  [[nodiscard]] Painted paint(std::uint8_t ground) const;
  /// Paints single fragments of snapped(), also those of other sorts. The picture must outlive the painter.
  /// Precondition: the plan is not one of colours.
  [[nodiscard]] SurfacePainter painter() const;
  /// What painters and explanations read of the picture; it must outlive them.
  [[nodiscard]] Surfaces surfaces() const;
  /// The same picture with the planes that a sort of snapped() needs. If the order is exact, they are
  /// already there, and the result is a plain copy.
  [[nodiscard]] Picture withPlanes() const;
  /// The same picture with only those of snapped().faces that a sample shows, in the same order. It tells
  /// what is seen, in little memory. What was only needed to make it is forgotten: it cannot be sorted, lit
  /// or painted anew.
  [[nodiscard]] Picture onlyShown() const;
  /// The same picture with only those of snapped().faces whose box meets the samples [low, high), in the same
  /// order. Sorted anew, it shows the same there. It is not painted or sorted.
  [[nodiscard]] Picture onlyWithin(glm::ivec2 low, glm::ivec2 high) const;
  /// How many faces these are.
  [[nodiscard]] std::int64_t facesWithin(glm::ivec2 low, glm::ivec2 high) const;

  /// The face number + 1 at every sample, 0 where nothing shows; row by row from the top.
  [[nodiscard]] std::vector<std::uint32_t> faceImage() const;
  /// The face that each sample of rows [firstRow, endRow) shows.
  [[nodiscard]] SeenRows seen(int firstRow, int endRow) const;
  /// How many times each sample was painted, row by row: once for each fragment that covers it. Where an
  /// order decides by sample, it is once where a face shows.
  [[nodiscard]] std::vector<int> timesPainted() const;
  /// The intensities of one channel before the colour table rounds them; see intensitiesAt().
  [[nodiscard]] std::vector<double> intensities(const SeenRows& rows, int channel = 0) const;
  /// The normals at the samples; see normalsAt().
  [[nodiscard]] std::vector<glm::dvec3> normals(const SeenRows& rows) const;

 private:
  friend class PictureCache;
  explicit Picture(const Shared<Scene>& scene) : scene_{scene}, unlit_{scene} {}

  /// Calls span(row, from, to, face) for runs of samples in rows [firstRow, endRow) that show one of
  /// snapped().faces. Later calls paint over earlier ones.
  template <class Span>
  void paintFaces(int firstRow, int endRow, Span&& span) const;
  /// The intensity of each of snapped().faces in one channel, before the table. Use it only if the method
  /// gives each face one intensity.
  [[nodiscard]] std::vector<double> faceIntensities(int channel) const;
  /// The cell, or the value of the channel, of each of snapped().faces. Use it only if the method gives each
  /// face one cell.
  [[nodiscard]] std::vector<std::uint8_t> cellsOf(int channel) const;
  /// Paints one channel on `image`. Returns how many evaluations at pixels exceeded 1.
  std::int64_t paintChannel(IndexImage& image, int channel, const std::vector<std::uint8_t>& cells) const;
  void paintColors(Painted& painted) const;
  /// The cell of each of snapped().faces in a plan of colours: the nearest chosen colour.
  [[nodiscard]] std::vector<std::uint8_t> nearestCells(const std::vector<Rgb16>& chosen) const;

  // The results, in the order of the stages.
  Shared<Scene> scene_;
  Shared<Scene> unlit_;  ///< the same with its own lights
  PictureSettings settings_;
  Camera camera_;
  SceneShading shading_;
  Shared<SnappedScene> snapped_;
  Shared<SortedScene> sorted_;
  /// For an order that decides by sample, the index of the visible face at each sample; otherwise empty.
  Shared<std::vector<int>> visible_;
  Shared<SceneColors> colors_;
  Shared<std::vector<std::uint8_t>> cells_;  ///< empty for a plan of colours, or if the method interpolates
  std::shared_ptr<const Painted> painted_;   ///< null if the picture is not painted
  StageTimes times_;
};

}  // namespace xnewell
