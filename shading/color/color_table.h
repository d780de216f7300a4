#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace xnewell {

/// From an intensity in [0, 1] to a cell of the colour table, and what the cell holds.
/// A *shade* j counts 0..N-1 along the ramp; a *cell* is its place in the colormap.
/// @see Foley & van Dam 2e §13.1

enum class TableKind { Brief, Linear, Corrected };
struct TableRow {
  TableKind id;
  std::string_view name;
  int first;  ///< cell of shade 0; 240 shades fill first..first+239
  std::string_view holds;
};
inline constexpr std::array kTables{
    TableRow{TableKind::Brief, "brief", 10, "cell i holds (i - 10)/255 of the hue"},
    TableRow{TableKind::Linear, "linear", 11, "cell i holds (i - 10)/255 of the hue"},
    TableRow{TableKind::Corrected, "corrected", 11, "cell 11 + j holds I0 r^j of the hue"},
};

/// How `corrected` picks the shade for an intensity. They disagree on about 0.2 % of uniformly spread I.
enum class Pick { Log, Search };
struct PickRow {
  Pick id;
  std::string_view name, rule;
};
inline constexpr std::array kPicks{
    PickRow{Pick::Log, "log", "nearest in ratio: round(log_r(I / I0))"},
    PickRow{Pick::Search, "search", "nearest in difference among the stored I_j"},
};

inline constexpr int kMaxShades = 240;

struct TableSettings {
  TableKind kind = TableKind::Linear;
  int shades = kMaxShades;  ///< N, 2..240
  double I0 = 0.02;         ///< lowest intensity of `corrected`, 1e-6..0.5
  Pick pick = Pick::Log;
  glm::dvec3 hue{1, 0, 0};                  ///< each in [0, 1], the largest 1
  int bits = 16;                            ///< 16 stores round(65535 v), 8 stores 257 round(255 v)
  std::optional<int> first = std::nullopt;  ///< cell of shade 0, if not the table's own
  double low = 0, high = 1;                 ///< the intensities that the shades spread over, in [0, 1]
  bool operator==(const TableSettings&) const = default;
};

/// What XStoreColors takes. The 8-bit value that a server shows is each of them >> 8.
struct Rgb16 {
  std::uint16_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb16&) const = default;
};

/// The gray that a colour shows as on gray visuals, where red, green and blue get this value:
/// (30 R + 59 G + 11 B) / 100, cut off to a whole number as the servers' own formula is.
[[nodiscard]] constexpr Rgb16 grayOf(Rgb16 c) {
  const auto gray = static_cast<std::uint16_t>((30u * c.r + 59u * c.g + 11u * c.b) / 100u);
  return {gray, gray, gray};
}

/// The ramp of one hue. Computed with + - * / alone, so the same on every machine.
class ColorTable {
 public:
  explicit ColorTable(const TableSettings& settings);

  /// Shade for intensity I: the nearest, half way between two the brighter. I below the table's lowest
  /// intensity or above its highest clamps to the end. Precondition: I is not NaN.
  [[nodiscard]] int shade(double I) const;
  [[nodiscard]] int cell(double I) const { return first_ + shade(I); }

  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int shades() const { return static_cast<int>(levels_.size()); }
  /// What shade j holds before the hue, in [0, 1]. For `linear` that is not the intensity that
  /// picks it: full intensity shows 240/255 there (the brief's choice). `corrected` holds nothing below I0.
  [[nodiscard]] double level(int j) const { return levels_[j]; }
  /// What shade j stands for: the middle of the intensities that pick it, by the table's own measure; at the
  /// ends, the end.
  [[nodiscard]] double intensity(int j) const {
    return settings_.kind == TableKind::Corrected ? levels_[j]
                                                  : low() + (high() - low()) * j / (shades() - 1);
  }
  [[nodiscard]] Rgb16 color(int j) const;
  /// The intensities that pick shade j: `from` and above, below `to`. The first takes whatever lies below it
  /// too, the last whatever lies above.
  struct Picked {
    double from, to;
  };
  [[nodiscard]] Picked picked(int j) const {
    return {j == 0 ? 0.0 : thresholds_[j - 1], j + 1 == shades() ? 1.0 : thresholds_[j]};
  }
  /// The intensities that the shades spread over.
  [[nodiscard]] double low() const { return settings_.low; }
  [[nodiscard]] double high() const { return settings_.high; }
  [[nodiscard]] const TableSettings& settings() const { return settings_; }

 private:
  static constexpr int kBuckets = 1024;  ///< I * kBuckets narrows the search to a few thresholds
  TableSettings settings_;
  int first_;
  std::vector<double> levels_;      ///< #shades
  std::vector<double> thresholds_;  ///< #shades - 1, ascending; shade j + 1 begins at thresholds_[j]
  std::vector<int> bucket_;         ///< kBuckets + 1; thresholds below each bucket's lower end
};

/// The r with r^n = 1/I0, by bisection: r^(N-1) I0 = 1 makes the brightest shade full intensity.
/// Error below 2^-51 relative; n >= 1, 0 < I0 <= 1.
[[nodiscard]] double ratioOfShades(double I0, int n);

}  // namespace xnewell
