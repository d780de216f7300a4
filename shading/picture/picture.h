#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "depthsort/depth_sort.h"
#include "geometry/view/project.h"
#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "shading/picture/scene_colors.h"
#include "shading/picture/scene_shading.h"
#include "shading/picture/surface_painter.h"
#include "shading/picture/surface_values.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// One picture: from a scene to colour indices, without any server.

/// Milliseconds of each stage in the last run; 0 for a stage that was not needed again. Reading and
/// presenting are not the picture's own: whoever does them adds them.
struct StageTimes {
  double read = 0, shade = 0, transform = 0, sort = 0, fill = 0, present = 0;
  [[nodiscard]] double total() const { return read + shade + transform + sort + fill + present; }
};

/// The pipeline with its results kept: each stage runs again only when something it depends on changed,
/// so a new colour table paints again from the stored intensities and sorts nothing.
class Picture {
 public:
  explicit Picture(Scene scene) : scene_{std::move(scene)} {}

  /// The walk. @throws ViewError
  void make(const PictureSettings& settings);

  /// The walk's last step: `image` becomes the picture on `ground`.
  void paint(IndexImage& image, std::uint8_t ground);
  /// The colours that go with it. Of a plan that chooses them from the picture, after paint().
  [[nodiscard]] Palette palette(const CellPlan& plan, const Palette& unneeded = {}) const;
  /// Paints one fragment after the other of a run over snapped(). The picture outlives it. Not for a plan of
  /// colours.
  [[nodiscard]] SurfacePainter painter() const;
  /// For who sorts snapped() himself: its planes are made only for the orders that ask for them.
  void addPlanes();
  /// Face number + 1 at every sample, 0 where nothing is; row by row from the top.
  [[nodiscard]] std::vector<std::uint32_t> faceImage() const;

  /// What each sample of rows [firstRow, endRow) of the picture shows.
  [[nodiscard]] SeenRows seen(int firstRow, int endRow) const;
  /// How often each sample was painted, row by row: as often as fragments cover it, or once where the face
  /// is decided at each sample.
  [[nodiscard]] std::vector<int> timesPainted() const;
  /// Of one channel, before the colour table; as intensitiesAt().
  [[nodiscard]] std::vector<double> intensities(const SeenRows& rows, int channel = 0) const;
  /// As normalsAt().
  [[nodiscard]] std::vector<glm::dvec3> normals(const SeenRows& rows) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const PictureSettings& settings() const { return made_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const SceneShading& shading() const { return shading_; }
  [[nodiscard]] const SnappedScene& snapped() const { return snapped_; }
  /// What to paint, back to front: whole faces, and pieces where the depth sort split them. Empty for
  /// Order::Oracle, which paints no faces.
  [[nodiscard]] const SortedScene& sorted() const { return sorted_; }
  /// The ramp of the one hue, or of the first.
  [[nodiscard]] const ColorTable& table() const { return colors_.table(); }
  [[nodiscard]] const SceneColors& colors() const { return colors_; }
  /// How many colours a plan of colours has, after paint().
  [[nodiscard]] int chosenColors() const { return static_cast<int>(chosen_.size()); }
  /// The cell of each of snapped().faces; empty where a face has not one cell.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return cells_; }
  /// Samples that show a face, and those of them where the painter's order shows another face than the
  /// visibility oracle does. Where the two lie so close that rounding alone may part them
  /// (SnappedFace::doubt) they may be coplanar in the model, and neither is called wrong. Asks the oracle: as
  /// slow as a picture of that order.
  struct Exactness {
    int samples = 0, wrong = 0;
  };
  [[nodiscard]] Exactness exactness();
  /// The same of each sample, row by row.
  enum class SampleCheck : std::uint8_t { Nothing, Right, Wrong };
  [[nodiscard]] std::vector<SampleCheck> checkedSamples();
  /// Evaluations of the illumination that exceeded 1 and were clamped, in each channel: of flat shading at
  /// faces and of Gouraud's at vertices, on either side; at pixels where each is evaluated or looked up, by
  /// the last paint(), as often as they were painted.
  [[nodiscard]] std::int64_t saturated() const;
  [[nodiscard]] const StageTimes& times() const { return times_; }

 private:
  /// Calls span(row, from, to, face) for runs of samples of rows [firstRow, endRow) that show one of
  /// snapped().faces, later calls over earlier ones.
  template <class Span>
  void paintFaces(int firstRow, int endRow, Span&& span) const;
  /// Of snapped().faces in one channel, before the table, where each has one.
  [[nodiscard]] std::vector<double> faceIntensities(const PictureSettings& settings, int channel) const;
  /// Of snapped().faces in one channel, where each has one.
  [[nodiscard]] std::vector<std::uint8_t> cellsOf(const PictureSettings& settings, int channel) const;
  [[nodiscard]] Surfaces surfaces(const PictureSettings& settings) const;
  void paintChannel(IndexImage& image, int channel, const std::vector<std::uint8_t>& cells);
  void paintColors(IndexImage& image);
  /// Of snapped().faces in a plan of colours: the nearest of those chosen.
  [[nodiscard]] std::vector<std::uint8_t> nearestCells() const;

  Scene scene_;
  PictureSettings made_;  ///< what the results below were made with
  bool any_ = false;      ///< whether there are results
  Camera camera_;
  SceneShading shading_;
  SnappedScene snapped_;
  SortedScene sorted_;
  std::vector<int> visible_;  ///< of Order::Oracle: the face at each sample
  SceneColors colors_;
  std::vector<Rgb16> chosen_;  ///< of a plan of colours, by the last paint()
  std::vector<std::uint8_t> cells_;
  std::int64_t clampedPixels_ = 0;
  StageTimes times_;
};

/// Milliseconds since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace xnewell
