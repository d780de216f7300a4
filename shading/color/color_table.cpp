#include "shading/color/color_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "geometry/exact/scale.h"

namespace xnewell {

double ratioOfShades(double I0, int n) {
  double low = 1.0, high = 1.0 / I0;  // low^n <= 1/I0 < high^n, or n == 1
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return low;
    (power(middle, n) * I0 <= 1.0 ? low : high) = middle;
  }
}

ColorTable::ColorTable(const TableSettings& settings)
    : settings_{settings}, first_{settings.first.value_or(kTables[static_cast<int>(settings.kind)].first)} {
  const int N = settings.shades;
  assert(N >= 2 && N <= kMaxShades && settings.I0 > 0.0 && settings.I0 < 1.0);
  assert(0.0 <= settings.low && settings.low <= settings.high && settings.high <= 1.0);
  levels_.resize(N);
  thresholds_.resize(N - 1);
  if (settings.kind == TableKind::Corrected) {
    const double lowest = std::max(settings.I0, settings.low), highest = std::max(lowest, settings.high);
    const double r = ratioOfShades(lowest / highest, N - 1);
    for (int j = 0; j < N; ++j) levels_[j] = std::min(highest, lowest * power(r, j));
    levels_[N - 1] = highest;
    for (int j = 0; j + 1 < N; ++j) {
      const double below = levels_[j], above = levels_[j + 1];
      thresholds_[j] = settings.pick == Pick::Log ? std::sqrt(below) * std::sqrt(above) : (below + above) / 2;
    }
  } else {
    const double offset = settings.kind == TableKind::Linear ? 1.0 : 0.0;
    const double low = settings.low, width = settings.high - low;
    for (int j = 0; j < N; ++j) levels_[j] = (offset + 239.0 * low + 239.0 * width * j / (N - 1)) / 255.0;
    for (int j = 0; j + 1 < N; ++j) thresholds_[j] = low + width * (j + 0.5) / (N - 1);
  }
  // A bucket holds the number of thresholds below its lower end. A product with a power of two is exact.
  static_assert((kBuckets & (kBuckets - 1)) == 0);
  bucket_.assign(kBuckets + 1, 0);
  for (const double threshold : thresholds_)
    if (threshold < 1.0) ++bucket_[static_cast<int>(threshold * kBuckets) + 1];
  std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
}

double ColorTable::Picked::nearest(double I) const {
  return std::max(from, std::min(I, last ? to : std::nextafter(to, 0.0)));
}

int ColorTable::shade(double I) const {
  assert(!std::isnan(I));
  if (I >= 1.0) return shades() - 1;
  if (!(I >= 0.0)) return 0;
  const int b = static_cast<int>(I * kBuckets);
  const auto from = thresholds_.begin() + bucket_[b], to = thresholds_.begin() + bucket_[b + 1];
  return static_cast<int>(std::upper_bound(from, to, I) - thresholds_.begin());
}

Rgb16 ColorTable::color(int j) const {
  const auto stored = [&](double v) {
    return static_cast<std::uint16_t>(settings_.bits == 8 ? 257.0 * std::floor(255.0 * v + 0.5)
                                                          : std::floor(65535.0 * v + 0.5));
  };
  const glm::dvec3 color = levels_[j] * settings_.hue;
  return {stored(color.r), stored(color.g), stored(color.b)};
}

namespace {

struct CellRow {
  int preferred;
  Rgb16 color;
};
constexpr std::array<CellRow, kCells> kCellRows{{
    {0, {0x0000, 0x0000, 0x0000}},    // Black
    {1, {0xFFFF, 0xFFFF, 0xFFFF}},    // White
    {2, {0xF5F5, 0xF2F2, 0xEBEB}},    // Paper
    {3, {0xE8E8, 0xE3E3, 0xD9D9}},    // Panel
    {4, {0xCDCD, 0xC6C6, 0xB9B9}},    // Rule
    {5, {0x9C9C, 0x9595, 0x8A8A}},    // Faint
    {6, {0x6969, 0x6262, 0x5A5A}},    // Soft
    {7, {0x2323, 0x2020, 0x1C1C}},    // Ink
    {8, {0x2A2A, 0x2E2E, 0x3535}},    // Well
    {9, {0x4A4A, 0x5050, 0x5A5A}},    // WellLine
    {10, {0xC6C6, 0xCBCB, 0xD2D2}},   // WellText
    {251, {0x2A2A, 0x7F7F, 0xC9C9}},  // P
    {252, {0xF0F0, 0xA8A8, 0x1818}},  // Q
    {253, {0x1B1B, 0x8282, 0x5959}},  // Good
    {254, {0xB8B8, 0x4040, 0x0E0E}},  // Alarm
    {255, {0xFFFF, 0xF0F0, 0xB3B3}},  // Focus
}};

}  // namespace

CellPlan::CellPlan(TableKind table, int black, int white) {
  const int rampFirst = kTables[static_cast<int>(table)].first, rampEnd = rampFirst + kMaxShades;
  const auto inRamp = [&](int cell) { return cell >= rampFirst && cell < rampEnd; };
  std::array<bool, 256> taken{};
  for (int cell = rampFirst; cell < rampEnd; ++cell) taken[cell] = true;
  std::array<bool, kCells> placed{};
  const auto place = [&](int role, int cell) {
    at_[role] = static_cast<std::uint8_t>(cell);
    taken[cell] = placed[role] = true;
  };
  if (black >= 0 && black < 256 && !inRamp(black)) place(0, black);
  if (white >= 0 && white < 256 && white != black && !inRamp(white)) place(1, white);
  // A colour keeps its usual cell if that is free. The others take the cells that are left, in order.
  for (int role = 0; role < kCells; ++role)
    if (!placed[role] && !taken[kCellRows[role].preferred]) place(role, kCellRows[role].preferred);
  for (int role = 0; role < kCells; ++role)
    if (!placed[role])
      place(role, static_cast<int>(std::find(taken.begin(), taken.end(), false) - taken.begin()));
}

Palette withInterface(Palette palette, const CellPlan& plan) {
  for (int role = 0; role < kCells; ++role) palette[plan[static_cast<Cell>(role)]] = kCellRows[role].color;
  return palette;
}

Palette makePalette(const CellPlan& plan, const ColorTable& table, const Palette& unneeded) {
  Palette palette = unneeded;
  for (int j = 0; j < table.shades(); ++j) palette[table.first() + j] = table.color(j);
  return withInterface(palette, plan);
}

}  // namespace xnewell
