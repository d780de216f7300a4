#include "shading/fill/ramp.h"

#include <cmath>

namespace xnewell {

namespace {

/// The least float that is not below I.
float floatFrom(double I) {
  const auto near = static_cast<float>(I);
  return near < I ? std::nextafter(near, 2.0F) : near;
}

}  // namespace

TableCells::TableCells(const ColorTable& table)
    : table_{table},
      bySteps_{table.first(), stepsOf(table)},
      below_{std::nextafter(floatFrom(table.picked(0).to), 0.0F)},
      shift_{std::countl_zero(bitsOf(1.0F) - bitsOf(below_))},
      byBits_{table.first(), keysOf(table)} {}

std::vector<std::uint32_t> TableCells::stepsOf(const ColorTable& table) {
  const auto intensity = [](std::uint32_t steps) { return kTableRamp.intensity(steps * 0x1p-24); };
  std::vector<std::uint32_t> begins;
  for (int j = 0; j + 1 < table.shades(); ++j) {
    const double begin = table.picked(j).to;
    auto steps = static_cast<std::uint32_t>(kTableRamp.value(begin) * 0x1p24);
    while (intensity(steps) >= begin) --steps;
    while (intensity(steps) < begin) ++steps;
    begins.push_back(steps);
  }
  return begins;
}

std::vector<std::uint32_t> TableCells::keysOf(const ColorTable& table) const {
  std::vector<std::uint32_t> begins;
  for (int j = 0; j + 1 < table.shades(); ++j)
    begins.push_back((bitsOf(floatFrom(table.picked(j).to)) - bitsOf(below_)) << shift_);
  return begins;
}

}  // namespace xnewell
