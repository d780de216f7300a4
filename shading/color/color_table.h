#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace xnewell {

/// Maps an intensity in [0, 1] to a cell of the colour table, and tells what the cell holds.
/// A *shade* j is a number 0..N-1 along the ramp; a *cell* is its place in the colormap.
/// @see Foley & van Dam 2e §13.1

enum class TableKind { Brief, Linear, Corrected };
struct TableRow {
  TableKind id;
  std::string_view name;
  int first;  ///< cell of shade 0; 240 shades fill first..first+239
};
inline constexpr std::array kTables{
    TableRow{TableKind::Brief, "brief", 10},
    TableRow{TableKind::Linear, "linear", 11},
    TableRow{TableKind::Corrected, "corrected", 11},
};

/// True if the intensities that the shades stand for are evenly spaced. Then a shade is found by a product
/// and a sum, else by a search.
[[nodiscard]] constexpr bool isEven(TableKind kind) { return kind != TableKind::Corrected; }

/// How `corrected` picks the shade for an intensity. The two rules disagree on about 0.2 % of the
/// intensities, if these are spread evenly over [0, 1].
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
  double I0 = 0.02;         ///< lowest intensity of `corrected`, above 0 and below 1
  Pick pick = Pick::Log;
  glm::dvec3 hue{1, 0, 0};                  ///< each in [0, 1]; the largest is 1
  int bits = 16;                            ///< 16 stores round(65535 v), 8 stores 257 round(255 v)
  std::optional<int> first = std::nullopt;  ///< cell of shade 0; without a value, the table's usual first
                                            ///< cell
  double low = 0, high = 1;                 ///< the range of intensities that the shades cover, within [0, 1]
  bool operator==(const TableSettings&) const = default;
};

/// A colour as XStoreColors takes it. A server shows the upper 8 bits of each value, which is value >> 8.
struct Rgb16 {
  std::uint16_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb16&) const = default;
};

/// The gray that a gray visual shows for a colour; red, green and blue all get this value:
/// (30 R + 59 G + 11 B) / 100, truncated to a whole number as in the servers' own formula.
[[nodiscard]] constexpr Rgb16 grayOf(Rgb16 c) {
  const auto gray = static_cast<std::uint16_t>((30u * c.r + 59u * c.g + 11u * c.b) / 100u);
  return {gray, gray, gray};
}

/// The ramp of one hue. It is computed with + - * / and square root, whose
/// rounding IEEE 754 fixes, so it is the same on every machine.
///
/// A level of `corrected` is off by at most (5 j + 2) 2^-53 of itself: 4 j for r^j, whose r is off by 2^-51,
/// and j for the power. Its threshold between j and j + 1 is off by at most (5 j + 8) 2^-53 of itself. In the
/// other tables a level is within 2^-50 and a threshold within 2^-51. An intensity that near to a threshold
/// may pick either shade. A colour is off by at most 2^-26 of its last step beyond the half that it is
/// rounded by.
class ColorTable {
 public:
  explicit ColorTable(const TableSettings& settings);

  /// The shade nearest to intensity I; half way between two shades, the brighter. An intensity below the
  /// table's lowest or above its highest gives the shade at that end. Precondition: I is not NaN.
  [[nodiscard]] int shade(double I) const;
  [[nodiscard]] int cell(double I) const { return first_ + shade(I); }

  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int shades() const { return static_cast<int>(levels_.size()); }
  /// The value that shade j holds before it is multiplied by the hue, in [0, 1]. In `linear` this is not the
  /// intensity that picks the shade: full intensity shows 240/255 there (the brief's choice). `corrected`
  /// holds nothing below I0.
  [[nodiscard]] double level(int j) const { return levels_[j]; }
  /// The intensity that shade j stands for: the middle, by the table's own measure, of the intensities that
  /// pick it. For the first and the last shade it is the end of the range.
  [[nodiscard]] double intensity(int j) const {
    return isEven(settings_.kind) ? low() + (high() - low()) * j / (shades() - 1) : levels_[j];
  }
  [[nodiscard]] Rgb16 color(int j) const;
  /// The intensities that pick shade j: from <= I < to. The first shade also gets every intensity below
  /// `from`, the last also every one above `to`.
  struct Picked {
    double from, to;
    bool last = false;  ///< whether `to` picks it, too
    [[nodiscard]] bool has(double I) const { return from <= I && (I < to || (last && I == to)); }
    /// The nearest of them to I.
    [[nodiscard]] double nearest(double I) const;
  };
  [[nodiscard]] Picked picked(int j) const {
    const bool last = j + 1 == shades();
    return {j == 0 ? 0.0 : thresholds_[j - 1], last ? 1.0 : thresholds_[j], last};
  }
  /// The range of intensities that the shades cover.
  [[nodiscard]] double low() const { return settings_.low; }
  [[nodiscard]] double high() const { return settings_.high; }
  [[nodiscard]] const TableSettings& settings() const { return settings_; }

 private:
  static constexpr int kBuckets = 1024;  ///< dividing [0, 1] into buckets narrows the search to a few
                                         ///< thresholds
  TableSettings settings_;
  int first_;
  std::vector<double> levels_;      ///< #shades
  std::vector<double> thresholds_;  ///< #shades - 1, ascending; shade j + 1 begins at thresholds_[j]
  std::vector<int> bucket_;         ///< kBuckets + 1; the number of thresholds below the lower end of each
                                    ///< bucket
};

/// The ratio r with r^n = 1/I0, found by bisection. With n = N-1, r^(N-1) I0 = 1 gives the brightest of N
/// shades full intensity. The relative error is below 2^-51. n >= 1, 0 < I0 <= 1.
[[nodiscard]] double ratioOfShades(double I0, int n);

/// The 256 colours of an index image: sixteen cells for the interface, the rest for the scene.

enum class Cell {
  Black,
  White,
  Paper,
  Panel,
  Rule,
  Faint,
  Soft,
  Ink,
  Well,
  WellLine,
  WellText,
  P,
  Q,
  Good,
  Alarm,
  Focus
};
inline constexpr int kCells = 16;
/// A short name of each cell's use.
inline constexpr std::array<std::string_view, kCells> kCellNames{"black",
                                                                 "white",
                                                                 "paper",
                                                                 "panel",
                                                                 "rule",
                                                                 "faint",
                                                                 "soft",
                                                                 "ink",
                                                                 "well",
                                                                 "lines on the well",
                                                                 "words on the well",
                                                                 "polygon P",
                                                                 "polygon Q",
                                                                 "holds",
                                                                 "fails",
                                                                 "focus"};

/// The cell of each interface colour. The usual cells are those of the window's design. Black and white keep
/// the pixel values that the server gives them; a colour whose usual cell is thereby taken moves to another.
class CellPlan {
 public:
  /// `black` and `white` are the server's pixel values. If one of them lies inside the ramp, it cannot be
  /// kept: the interface then has a black or white of its own.
  explicit CellPlan(TableKind table = TableKind::Linear, int black = 0, int white = 1);
  [[nodiscard]] std::uint8_t operator[](Cell cell) const { return at_[static_cast<int>(cell)]; }
  /// True if this cell, 0..255, is one of the interface's sixteen.
  [[nodiscard]] bool has(int cell) const { return std::ranges::find(at_, cell) != at_.end(); }
  bool operator==(const CellPlan&) const = default;

 private:
  std::array<std::uint8_t, kCells> at_{};
};

using Palette = std::array<Rgb16, 256>;

/// The scene's colours, with the interface's sixteen colours put into the cells of the plan.
[[nodiscard]] Palette withInterface(Palette scene, const CellPlan& plan);

/// The colour of every cell: the plan's sixteen, the ramp, and `unneeded` in the cells that a ramp of fewer
/// than 240 shades leaves free (the server's default colours, or black).
[[nodiscard]] Palette makePalette(const CellPlan& plan, const ColorTable& table,
                                  const Palette& unneeded = {});

}  // namespace xnewell
