#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/order.h"
#include "geometry/camera.h"
#include "geometry/project.h"
#include "shading/color_table.h"
#include "shading/illumination.h"
#include "shading/index_image.h"
#include "shading/palette.h"
#include "shading/scene.h"

/// One picture: from a scene to colour indices, without any server.

enum class Shading { Full, Flat };
struct ShadingRow {
  Shading id;
  std::string_view name, label, evaluates;
};
inline constexpr std::array kShadings{
    ShadingRow{Shading::Full, "none", "none", "nothing: every face at full intensity"},
    ShadingRow{Shading::Flat, "flat", "flat", "the illumination once a face, at its centroid"},
};

struct PictureSettings {
  int width = 800, height = 600;  ///< pixels, 1..kMaxPicture
  CameraSettings camera;          ///< in the scene's units
  Illumination light;
  Shading shading = Shading::Flat;
  Order order = Order::Newell;
  Cull cull = Cull::Keep;
  bool inPixels = false;  ///< an X server will fill the polygons (SortSettings::inPixels)
  TableSettings table;
  bool operator==(const PictureSettings&) const = default;
};

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

  /// The walk's last step: `image` becomes the picture, each face in its cell on `ground`.
  void paint(IndexImage& image, std::uint8_t ground);
  /// Face number + 1 at every sample, 0 where nothing is; row by row from the top.
  [[nodiscard]] std::vector<std::uint32_t> faceImage() const;

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const PictureSettings& settings() const { return made_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const std::vector<FaceShade>& faces() const { return faces_; }
  [[nodiscard]] const SnappedScene& snapped() const { return snapped_; }
  /// What to paint, back to front: whole faces, and pieces where the depth sort split them. Empty for
  /// Order::Oracle, which paints no faces.
  [[nodiscard]] const SortedScene& sorted() const { return sorted_; }
  [[nodiscard]] const ColorTable& table() const { return *table_; }
  /// The cell of each of snapped().faces.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return cells_; }
  /// Samples that show a face, and those of them where the painter's order shows another face than the
  /// visibility oracle does. Where the two lie so close that rounding alone may part them
  /// (SnappedFace::doubt) they may be coplanar in the model, and neither is called wrong. Asks the oracle: as
  /// slow as a picture of that order.
  struct Exactness {
    int samples = 0, wrong = 0;
  };
  [[nodiscard]] Exactness exactness() const;
  /// Evaluations of the illumination that exceeded 1 and were clamped.
  [[nodiscard]] int saturated() const;
  [[nodiscard]] const StageTimes& times() const { return times_; }

 private:
  /// Calls span(row, from, to, face) for runs of samples that show one of snapped().faces, later calls over
  /// earlier ones.
  template <class Span>
  void paintFaces(Span&& span) const;
  /// The same into cells, back to front, as fast as it goes.
  void fillFaces(IndexImage& image) const;

  Scene scene_;
  PictureSettings made_;  ///< what the results below were made with
  bool any_ = false;      ///< whether there are results
  Camera camera_;
  std::vector<FaceShade> faces_;
  SnappedScene snapped_;
  SortedScene sorted_;
  std::vector<int> visible_;  ///< of Order::Oracle: the face at each sample
  std::optional<ColorTable> table_;
  std::vector<std::uint8_t> cells_;
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
