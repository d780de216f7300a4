#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "depthsort/oracle.h"
#include "shading/color/color_table.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// How wrong is a picture, by which measure, and where? The ground truth tells what is right, unless a
/// Comparison is given another reference.

/// The mean, the root mean square, the 99th percentile and the largest of some errors. All are 0 if there are
/// none. The percentile is one of the errors: the least one that 99 % of them do not exceed.
struct Spread {
  double mean = 0, rootMeanSquare = 0, p99 = 0, largest = 0;
  std::int64_t count = 0;
};
/// Errors that are NaN do not count.
[[nodiscard]] Spread spreadOf(std::span<const float> errors);

/// Errors, or differences of any two pictures, at the samples, row by row, and what they come to. NaN where
/// there is nothing to compare.
struct ErrorMap {
  int width = 0;
  double unit = 0;  ///< an error should stay below this
  std::vector<float> at = {};
  Spread errors = {};
  std::int64_t above = 0;     ///< samples with an error above the unit
  std::size_t largestAt = 0;  ///< index of the first sample with the largest error
};
[[nodiscard]] ErrorMap errorMap(std::vector<float> at, int width, double unit);

/// The intensities of a picture, before the table rounds them to a shade, or after.
enum class TableSide { Before, After };

/// A picture, painted, beside its reference. Errors of intensities and colours are by sample, row by
/// row, and NaN where neither shows a face. Where only one shows a face, the other has intensity 0, and the
/// colour of the background.
class Comparison {
 public:
  /// `picture` is painted. `palette` has its colours and that of its background. `ofItsPolygons` is the true
  /// view of the picture's own polygons. It tells which face should show, and `reference` tells the light.
  /// All outlive this.
  Comparison(const Picture& picture, const Reference& reference, const Palette& palette,
             const PolygonGroundTruth& ofItsPolygons);
  Comparison(const Picture& picture, const Reference& reference, const Palette& palette)
      : Comparison{picture, reference, palette, reference} {}
  Comparison(const Picture& picture, const GroundTruth& truth, const Palette& palette)
      : Comparison{picture, truth.reference(), palette, truth.polygons()} {}

  /// The error of the intensity.
  /// - A picture of one hue has one intensity. It is compared with the luminance of the reference. After the
  ///   table, a cell counts as the middle of the intensities that it stands for.
  /// - In several hues, each channel is compared: the intensity times the hue. The largest of the three
  ///   errors counts.
  /// - In a plan of colours each channel is compared, too. After the table, the intensity is the stored
  ///   colour.
  [[nodiscard]] std::vector<float> intensityErrors(TableSide side) const;
  /// CIEDE2000 between the colour that a sample shows and that of the reference. The reference has the colour
  /// of its three channels, or if it is gray, its intensity times the one hue. A hue belongs to the model.
  [[nodiscard]] std::vector<float> colorErrors() const;
  /// 1 where shownFace() is not dueFace(), otherwise 0. There is one exception, as in
  /// exactness.h: two faces in different planes may be so near that rounding alone tells them apart.
  [[nodiscard]] std::vector<std::uint8_t> wrongFaces() const;
  /// How many these are.
  [[nodiscard]] std::int64_t wrongFaceCount() const;
  /// The errors of the means of blocks of 8 x 8 pixels, each of which shows a face, in the picture and in the
  /// reference; after the table, and the largest of the channels. One number for each block.
  [[nodiscard]] std::vector<float> blockErrors() const;

  /// What a sample shows, and what it should show: one number for a picture of one hue (all three are the
  /// same), otherwise RGB.
  [[nodiscard]] glm::dvec3 shown(std::size_t sample) const;
  [[nodiscard]] glm::dvec3 due(std::size_t sample) const;
  /// The colour that the reference has at a sample, as it would be stored.
  [[nodiscard]] Rgb16 dueColor(std::size_t sample) const;
  /// The numbers of the faces at a sample; kNothing where no face shows. dueFace() is the one of the
  /// picture's polygons that should show. trueFace() is the one that stands for the part of the surface that
  /// should show: at the outline of a curved surface, its polygons may be elsewhere.
  [[nodiscard]] int shownFace(std::size_t sample) const;
  [[nodiscard]] int dueFace(std::size_t sample) const;
  [[nodiscard]] int trueFace(std::size_t sample) const;

  [[nodiscard]] const Picture& picture() const { return picture_; }
  [[nodiscard]] std::size_t samples() const { return faces_.faces.size(); }
  /// True if the picture or the reference shows a face.
  [[nodiscard]] bool shows(std::size_t sample) const {
    return faces_.faces[sample] != kNothing || reference_.faces()[sample] != kNothing;
  }

 private:
  [[nodiscard]] bool mayTouch(std::size_t sample) const;

  const Picture& picture_;
  const Reference& reference_;
  const PolygonGroundTruth& polygons_;
  const Palette& palette_;
  SeenRows faces_;
  std::array<glm::dvec3, 256> ofCell_;  ///< the intensities that a cell stands for
};

/// One of the samples with the largest errors.
struct WorstPlace {
  int x = 0, y = 0;               ///< pixel
  int face = -1, shownFace = -1;  ///< Comparison::trueFace() and shownFace()
  glm::dvec3 due{0}, shown{0};    ///< Comparison::due() and shown()
  double error = 0;
};
inline constexpr int kMostWorstPlaces = 10;
/// Pixels in x or in y between two of the worst places.
inline constexpr int kBetweenWorstPlaces = 8;
/// The samples with the largest errors, the largest first; of equal ones the first. Each is at least
/// kBetweenWorstPlaces away from those before. Errors of 0 are left out.
[[nodiscard]] std::vector<std::size_t> worstSamples(std::span<const float> errors, int width);
/// The same samples of a comparison, and what they show. `errors` are by sample.
[[nodiscard]] std::vector<WorstPlace> worstPlaces(const Comparison& comparison,
                                                  std::span<const float> errors);

/// The distance of the polygons from the Bezier patches that they approximate, over the samples of a true
/// view that show one.
struct PatchDistance {
  std::int64_t samples = 0;
  double mean = 0, largest = 0;  ///< in units of the scene's file
  double meanPixels = 0,
         largestPixels = 0;  ///< in pixels, as long as it would look at right angles to the line of sight
};

/// Nothing if no sample shows a patch.
[[nodiscard]] std::optional<PatchDistance> distanceFromPatches(const PolygonGroundTruth& view);

struct Errors {
  std::int64_t samples = 0;  ///< samples at which the picture or the reference shows a face
  std::int64_t wrongFaces = 0;
  Spread beforeTable, afterTable;        ///< of the intensity
  Spread color;                          ///< CIEDE2000
  std::optional<PatchDistance> patches;  ///< if a sample shows a face of a patch
  std::optional<Spread> blocks;          ///< of a dithered picture
  std::vector<WorstPlace> worst;         ///< by the intensity after the table; at most kMostWorstPlaces
};

/// All errors but the distance from patches, which depends on the polygons alone. Pictures that differ only
/// in short cuts can share a reference.
[[nodiscard]] Errors errorsOf(const Comparison& comparison);
/// All errors of a picture.
[[nodiscard]] Errors errorsOf(const Picture& picture, const Palette& palette);

/// Checks whether a picture shows the right faces. The visibility oracle is the judge. The check takes as
/// long as a picture with Order::Oracle.

/// The verdict on one sample. It is Wrong if the picture shows another face than the oracle sees, and the
/// oracle's is nearer; Earlier, which is wrong too, if both lie in one plane, where the later face should
/// win. There is one exception: rounding alone may separate two faces in different planes (mayTouch() in
/// scene_planes.h). They may touch in the model, so neither counts as wrong: the sample is Doubtful.
enum class SampleCheck : std::uint8_t { Nothing, Right, Doubtful, Wrong, Earlier };
[[nodiscard]] constexpr bool isWrong(SampleCheck verdict) {
  return verdict == SampleCheck::Wrong || verdict == SampleCheck::Earlier;
}
/// The verdict on the sample of pixel (i, j) that shows the face `painted` where the oracle sees `visible`;
/// both are indices into the faces of a scene with planes, `visible` is not kNothing.
[[nodiscard]] SampleCheck checkOf(const SnappedScene& scene, int painted, int visible, int i, int j);
/// The verdict on each sample, row by row.
[[nodiscard]] std::vector<SampleCheck> checkedSamples(const Picture& picture);

/// `samples` counts the samples that show a face, `wrong` those that show a wrong face, and `earlier` those
/// of the wrong ones whose face lies in the plane of the right one. `doubtful` counts those that show a
/// farther face which rounding alone may part from the nearest.
struct Exactness {
  int samples = 0, wrong = 0, earlier = 0, doubtful = 0;
};
[[nodiscard]] Exactness exactnessOf(std::span<const SampleCheck> verdicts);
[[nodiscard]] Exactness exactnessOf(const Picture& picture);

}  // namespace xnewell
