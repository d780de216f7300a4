#pragma once

#include <cstdint>
#include <vector>

#include "shading/color/color_plan.h"
#include "shading/color/color_table.h"
#include "shading/fill/ramp.h"
#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// Whether the scene's colours can be told apart by fewer than all: the first plan of one hue, several hues
/// and chosen colours that shows it. Hues serve as long as lights and textures are gray and each hue gets
/// kLeastShades.
inline constexpr int kLeastShades = 24;
/// @throws ViewError if several hues are asked for and there are more than the table has pairs of shades
[[nodiscard]] ColorPlan planOf(const Scene& scene, const PictureSettings& settings);
[[nodiscard]] constexpr Channels channelsOf(ColorPlan plan) {
  return plan == ColorPlan::OneHue ? Channels::Luminance
         : plan == ColorPlan::Hues ? Channels::Brightness
                                   : Channels::Rgb;
}

/// The ramps of a picture: which cells an intensity on a surface gets.
class SceneColors {
 public:
  /// Where a plan has several hues, their shades go where the need is: by the samples that a hue covers and
  /// the intensities that its surfaces have, at faces or vertices or, where they are found pixel by pixel, at
  /// all pixels of all faces, hidden or not: no order of painting changes the plan.
  void make(const Surfaces& surfaces, ColorPlan plan);

  [[nodiscard]] ColorPlan plan() const { return plan_; }
  [[nodiscard]] const std::vector<ColorTable>& tables() const { return tables_; }
  /// The one hue's, or the first.
  [[nodiscard]] const ColorTable& table() const { return tables_.front(); }
  /// Of a material, -1 for none.
  [[nodiscard]] const ColorTable& tableOf(int material) const { return tables_[tableOf_[material + 1]]; }
  /// What one of the ramps' cells stands for.
  [[nodiscard]] double intensityOf(int cell) const;
  /// By material, of none first. In a plan of colours those of a channel.
  [[nodiscard]] std::vector<Ramp> ramps() const;

 private:
  ColorPlan plan_ = ColorPlan::OneHue;
  std::vector<ColorTable> tables_;
  std::vector<int> tableOf_;                        ///< by material, of none first
  std::vector<std::vector<std::uint8_t>> lookUps_;  ///< Ramp::table of each of tables_ that is not linear
};

}  // namespace xnewell
