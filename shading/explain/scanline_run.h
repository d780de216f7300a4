#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "shading/course/course.h"
#include "shading/explain/explain.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// How one polygon of a picture becomes pixels: row by row, between its active edges, by additions. Beside
/// each sample's value by steps stands the direct one, evaluated at the sample by the course's definitions in
/// double precision. The difference is the drift.

/// What is filled at once: a triangle of the polygon, or all of it where it has one value or where values go
/// along the rows (Polygons::Rows).
struct ScanPart {
  std::vector<int> vertex;          ///< indices into SnappedScene::vertices
  std::vector<glm::ivec3> outline;  ///< those vertices
  std::vector<ScanEdge> edges;
  std::vector<ScanSpan> spans;  ///< of the rows that own samples in the picture, cut off at its borders
};

struct ScanSample {
  int part = 0, span = 0, column = 0;  ///< indices into parts() and into that part's spans
  /// The values that pick the cells, as Ramp::value has them.
  double stepped = 0, direct = 0;
  std::uint8_t steppedCell = 0, directCell = 0;
};

/// A number that is linear over a part on the screen.
struct ScanQuantity {
  std::string_view name;
  std::vector<double> atVertex;  ///< of the part, in the order of its outline
};

/// The kinds of step that there are to go to.
enum class ScanMark { Pixel, Row, Edge, Shade, Differs };
struct ScanMarkRow {
  ScanMark id;
  std::string_view name, several;
};
inline constexpr std::array kScanMarks{
    ScanMarkRow{ScanMark::Pixel, "pixel", "pixels"}, ScanMarkRow{ScanMark::Row, "row", "rows"},
    ScanMarkRow{ScanMark::Edge, "edge", "edges"},           ///< an edge is taken up
    ScanMarkRow{ScanMark::Shade, "shade", "shades"},        ///< the cell is not that of the pixel before
    ScanMarkRow{ScanMark::Differs, "differs", "differs"}};  ///< by steps another cell than direct

/// Step k of the run has filled the samples 0 to k - 1; step 0 has filled none.
class ScanlineRun {
 public:
  static constexpr int kMostSamples = 20'000;

  /// `face` is an index into snapped().faces. The picture has one hue and must outlive the run. `bits` are
  /// after the binary point of stepped values; with 24 they are the picture's own. Fewer count only where
  /// choosesBits().
  ScanlineRun(const Picture& picture, int face, int bits = 24);

  [[nodiscard]] const Picture& picture() const { return picture_; }
  [[nodiscard]] int face() const { return face_; }
  [[nodiscard]] int bits() const { return bits_; }
  /// True if the polygon has more samples than a run may have. Then there are no samples.
  [[nodiscard]] bool tooLarge() const { return tooLarge_; }
  [[nodiscard]] const std::vector<ScanPart>& parts() const { return parts_; }
  [[nodiscard]] const std::vector<ScanSample>& samples() const { return samples_; }
  [[nodiscard]] int steps() const { return static_cast<int>(samples_.size()); }
  [[nodiscard]] const ScanSpan& spanOf(const ScanSample& sample) const {
    return parts_[static_cast<std::size_t>(sample.part)].spans[static_cast<std::size_t>(sample.span)];
  }
  /// The steps of a kind, in ascending order.
  [[nodiscard]] const std::vector<int>& marks(ScanMark kind) const {
    return marks_[static_cast<std::size_t>(kind)];
  }

  /// True for Gouraud shading without textures: its values are stepped in the picture, too.
  [[nodiscard]] bool stepsValues() const { return kind_ == Kind::Values || kind_ == Kind::Rows; }
  /// True for Gouraud and Phong shading without textures.
  [[nodiscard]] bool choosesBits() const { return stepsValues() || kind_ == Kind::Normals; }
  /// The plane of a part, where values are stepped over triangles.
  [[nodiscard]] const SteppedPlane& plane(int part) const { return planes_[static_cast<std::size_t>(part)]; }
  /// What is interpolated: I and the value that picks the cell; the normal over w; the texture coordinates
  /// over w, and 1/w; the column and row of an environment's map. Nothing where the polygon has one value.
  [[nodiscard]] const std::vector<ScanQuantity>& quantities(int part) const {
    return quantities_[static_cast<std::size_t>(part)];
  }
  /// A quantity where an edge of the part crosses the samples of a row: linear along the edge.
  [[nodiscard]] double onEdge(int part, int edge, int row, const ScanQuantity& quantity) const;

  /// A quantity at a sample, directly.
  [[nodiscard]] double at(const ScanSample& sample, const ScanQuantity& quantity) const;
  /// What a fan of triangles has at a sample, where the values go along the rows: the value and the cell.
  struct ByTriangles {
    double value = 0;
    std::uint8_t cell = 0;
  };
  [[nodiscard]] ByTriangles byTriangles(const ScanSample& sample) const;
  /// True if the values go along the rows of a polygon with more than three corners.
  [[nodiscard]] bool goesAlongRows() const { return kind_ == Kind::Rows; }
  [[nodiscard]] bool isConstant() const { return kind_ == Kind::Constant; }
  [[nodiscard]] bool hasNormals() const { return kind_ == Kind::Normals; }
  /// The chain of explanations that ends in the sample's cell.
  [[nodiscard]] Explanation explained(const ScanSample& sample) const;

  /// The largest drift, in units of the value, and how many samples have another cell by steps.
  [[nodiscard]] double mostDrift() const { return mostDrift_; }
  [[nodiscard]] int differing() const { return static_cast<int>(marks(ScanMark::Differs).size()); }
  /// The texture coordinates at a sample of a textured polygon: affine over the screen, and in perspective.
  struct TexturePlaces {
    glm::dvec2 affine{0}, perspective{0};
  };
  [[nodiscard]] TexturePlaces texturePlaces(const ScanSample& sample) const;
  [[nodiscard]] bool isTextured() const { return textured_; }
  /// From I to the value that picks the cell.
  [[nodiscard]] const Ramp& ramp() const { return ramp_; }

 private:
  enum class Kind { Constant, Values, Rows, Normals, Sampled };
  void addParts();
  void addQuantities(PixelExplainer& explain, int part);
  void addSamples(PixelExplainer& explain);
  /// The values and cells of a sample, by the kind of the polygon.
  [[nodiscard]] ScanSample stepped(int part, int i, int j) const;
  [[nodiscard]] ScanSample byRows(int part, int i, int j) const;
  [[nodiscard]] ScanSample sampled(const Explanation& e) const;
  /// The intensity of a normal that fewer bits have stepped.
  [[nodiscard]] double ofSteppedNormal(int part, const Explanation& e);
  [[nodiscard]] std::uint8_t cellOf(double value) const;
  void mark();

  const Picture& picture_;
  Surfaces s_;
  int face_, bits_;
  Kind kind_ = Kind::Sampled;
  Ramp ramp_;
  EquationOf equations_;
  bool tooLarge_ = false, textured_ = false;
  std::vector<ScanPart> parts_;
  std::vector<std::vector<ScanQuantity>> quantities_;
  std::vector<SteppedPlane> planes_;                  ///< Kind::Values
  std::vector<std::array<SteppedPlane, 3>> normals_;  ///< Kind::Normals
  std::vector<ScanSample> samples_;
  std::array<std::vector<int>, kScanMarks.size()> marks_;
  double mostDrift_ = 0;
};

}  // namespace xnewell
