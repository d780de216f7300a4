#pragma once

#include <cstdint>
#include <vector>

#include "shading/color/color_plan.h"
#include "shading/color/color_table.h"
#include "shading/fill/ramp.h"
#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// Finds the simplest plan that can show the scene's colours: first one hue, then several hues, then chosen
/// colours. Several hues need gray lights, gray textures, and kLeastShades shades for each hue.
inline constexpr int kLeastShades = 24;
/// @throws ViewError if the user asks for several hues and the table has fewer than two shades for each
[[nodiscard]] ColorPlan planOf(const Scene& scene, const PictureSettings& settings);
[[nodiscard]] constexpr Channels channelsOf(ColorPlan plan) {
  return plan == ColorPlan::OneHue ? Channels::Luminance
         : plan == ColorPlan::Hues ? Channels::Brightness
                                   : Channels::Rgb;
}

/// The ramps of a picture: they map an intensity on a surface to a cell.
class SceneColors {
 public:
  /// Makes the tables. If a plan has several hues, each hue gets shades by its need. The need depends on the
  /// number of samples that a hue covers and on the intensities of its surfaces. These are the intensities at
  /// faces or at vertices. If they are found pixel by pixel, all pixels of all faces count, hidden or not, so
  /// the plan does not depend on the order of painting.
  void make(const Surfaces& surfaces, ColorPlan plan);

  [[nodiscard]] ColorPlan plan() const { return plan_; }
  [[nodiscard]] const std::vector<ColorTable>& tables() const { return tables_; }
  /// The table of the one hue, or the first of several tables.
  [[nodiscard]] const ColorTable& table() const { return tables_.front(); }
  /// The table of a material; -1 is for faces without a material.
  [[nodiscard]] const ColorTable& tableOf(int material) const { return tables_[tableOf_[material + 1]]; }
  /// The intensity that a cell of one of the ramps stands for.
  [[nodiscard]] double intensityOf(int cell) const;
  /// The ramp of each material; the first is for faces without a material. In a plan of colours, each is that
  /// of a channel (kChannelRamp).
  [[nodiscard]] std::vector<Ramp> ramps() const;

 private:
  ColorPlan plan_ = ColorPlan::OneHue;
  std::vector<ColorTable> tables_;
  std::vector<int> tableOf_;       ///< by material; the first is for faces without one
  std::vector<TableCells> cells_;  ///< Ramp::table for each of tables_; none if these are even
};

}  // namespace xnewell
