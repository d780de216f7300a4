#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/course/course.h"
#include "shading/diagnose/other_model.h"

namespace xnewell {

/// What a program that works in some way shows at a sample, in doubles, by the definitions of the equation
/// and of the course. It shares no code with the loops that paint.

/// The terms at one place; `rest` is the ambient and the specular term.
struct LitPlace {
  std::array<double, 3> rest{}, diffuse{};
  bool isLit = false;                                       ///< by a light
  double NdotL = std::numeric_limits<double>::quiet_NaN();  ///< of the first light
  double RdotV = std::numeric_limits<double>::quiet_NaN();
};

struct ShownHere {
  int cell = -1;                  ///< -1 where the cells hold several hues
  std::array<double, 3> value{};  ///< what is stored, 0 to 255; only the first with one hue
  double step = 1;                ///< how far two neighbouring cells are apart there, at least 1
  double I = 0;                   ///< the intensity, or the luminance, before it is clamped
  double NdotL = std::numeric_limits<double>::quiet_NaN();
  double RdotV = std::numeric_limits<double>::quiet_NaN();
};

class OtherProgram {
 public:
  OtherProgram(OtherModel& model, const Approach& way);

  [[nodiscard]] const Approach& way() const { return way_; }
  /// False for a face that clipping has cut: its values between the corners are not known here.
  [[nodiscard]] bool canShow(int face) const;
  /// At the sample of pixel (i, j), which one of the snapped faces owns.
  [[nodiscard]] ShownHere at(int face, int i, int j);
  /// The colour of the texel under the sample; -1 for none.
  [[nodiscard]] int texelAt(int face, int i, int j);
  /// The cell of I = 1.
  [[nodiscard]] int brightest() const { return table_.first() + table_.shades() - 1; }
  /// What a cell holds.
  [[nodiscard]] double stored(int cell) const;
  /// What a program shows that stores no table.
  [[nodiscard]] double withoutTable(double I) const;

 private:
  /// A sample in one of the triangles of its face.
  struct InTriangle {
    std::array<int, 3> corner{};  ///< indices into Mesh::corners
    Weights onScreen{}, inWorld{};
  };
  [[nodiscard]] bool isWhole(const SnappedFace& face) const;
  [[nodiscard]] std::vector<int> fanOf(const SnappedFace& face) const;
  [[nodiscard]] InTriangle triangle(const SnappedFace& face, int i, int j) const;
  [[nodiscard]] LitPlace lit(const glm::dvec3& P, const glm::dvec3& N, int material) const;
  void addLight(LitPlace& sum, const Light& light, const glm::dvec3& P, const glm::dvec3& N,
                const glm::dvec3& V, const std::array<Reflection, 3>& surface) const;
  [[nodiscard]] double fade(Light light, double d) const;
  [[nodiscard]] const LitPlace& ofFace(int face, bool back);
  [[nodiscard]] LitPlace ofTriangle(const SnappedFace& face, const InTriangle& in) const;
  [[nodiscard]] const LitPlace& atCorner(int face, int corner, bool back);
  [[nodiscard]] LitPlace meanOfFaces(int point);
  [[nodiscard]] double side(bool back) const {
    return back && !way_.oneSided && !way_.equation.turnsByV ? -1.0 : 1.0;
  }
  [[nodiscard]] LitPlace gouraud(const SnappedFace& face, const InTriangle& in, bool clamps);
  [[nodiscard]] LitPlace alongRow(const SnappedFace& face, int i, int j, bool clamps);
  [[nodiscard]] LitPlace phong(const SnappedFace& face, const InTriangle& in);
  /// Of a face of the mesh; null for none.
  [[nodiscard]] const Texture* textureOf(int face) const;
  /// The texel of a sample, an index into a channel.
  [[nodiscard]] std::size_t texel(const Texture& texture, const InTriangle& in) const;
  [[nodiscard]] double intensity(const LitPlace& place, const std::array<double, 3>& texel) const;
  static void onRamp(ShownHere& shown, const std::array<double, 3>& I, const ColorTable& table);
  [[nodiscard]] int cellOf(double I) const;
  [[nodiscard]] double realCell(double I) const;
  [[nodiscard]] double levelOf(int j) const;

  OtherModel& model_;
  Approach way_;  ///< with the settings
  const OtherModel::Places& places_;
  ColorTable table_;
  std::array<Reflection, 3> none_{};
  std::unordered_map<std::size_t, LitPlace> faces_, corners_;  ///< by 2 k, and 2 k + 1 for the back
};

}  // namespace xnewell
