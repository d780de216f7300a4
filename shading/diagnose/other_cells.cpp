#include <algorithm>
#include <cmath>

#include "shading/diagnose/other_program.h"

namespace xnewell {

/// From an intensity to a cell and to what is stored there, right or with a mistake.

namespace {

double nearestWhole(double v) { return std::floor(v + 0.5); }

}  // namespace

/// The cell before it is rounded, counted from the first; for tables that pick by nearest ratio or by an even
/// step.
double OtherProgram::realCell(double I) const {
  const TableSettings& s = table_.settings();
  const int last = table_.shades() - 1;
  const double lnR = std::log(1.0 / s.I0) / last;
  CellWay way = way_.cell;
  const bool even = isEven(s.kind);
  switch (way) {
    case CellWay::By240:
      return (last + 1) * I;
    case CellWay::By255:
      return 255.0 * I;
    case CellWay::Even:
      return last * I;
    case CellWay::Ratios:
      return I > 0.0 ? std::max(0.0, std::log(I / s.I0) / lnR) : 0.0;
    case CellWay::Ratio240:
      return I > 0.0 ? std::max(0.0, std::log(I / s.I0) / lnR * (last + 1) / last) : 0.0;
    case CellWay::Ratio64:
      return I > 0.0 ? std::max(0.0, std::log(I / s.I0) / lnR * 63 / last) : 0.0;
    case CellWay::NaturalLog:
      return I > 0.0 ? std::max(0.0, std::log(I / s.I0)) : 0.0;
    case CellWay::NoI0:
      return 0.0;
    case CellWay::NoI0Wraps:
      return I > 0.0 ? std::log(I) / lnR : 0.0;
    default:
      break;
  }
  if (even) return last * I;
  if (I <= s.I0) return 0.0;
  const double real = std::log(I / s.I0) / lnR;
  if (s.pick == Pick::Log) return real;
  const double below = std::floor(real);  // nearest in difference
  const double low = s.I0 * std::exp(lnR * below), high = s.I0 * std::exp(lnR * (below + 1));
  return I - low < high - I ? below : below + 1;
}

int OtherProgram::cellOf(double I) const {
  const double in = way_.cellWraps ? std::max(0.0, I) : std::clamp(I, 0.0, 1.0);
  const double real = realCell(in);
  double cell = table_.first() + (way_.cell == CellWay::Truncated ? std::floor(real) : nearestWhole(real));
  if (way_.cell == CellWay::OneLess) cell -= 1;
  if (way_.cell == CellWay::FromZero) cell -= table_.first();
  if (way_.cellWraps || way_.cell == CellWay::NoI0Wraps)
    return static_cast<int>(static_cast<long long>(std::clamp(cell, -1e9, 1e9)) & 255);
  return static_cast<int>(std::clamp(cell, 0.0, 255.0));
}

/// What shade j holds before it is rounded, 0 to 1.
double OtherProgram::levelOf(int j) const {
  const TableSettings& s = table_.settings();
  const double perStep = way_.store == StoreWay::Ratio240 ? table_.shades() : 63.0;
  if (way_.store == StoreWay::Ratio240 || way_.store == StoreWay::Ratio64)
    return std::min(1.0, s.I0 * std::pow(1.0 / s.I0, j / perStep));
  if (0 <= j && j < table_.shades()) return table_.level(j);
  if (isEven(s.kind) && table_.shades() == kMaxShades)
    return std::clamp((table_.first() + j - 10) / 255.0, 0.0, 1.0);
  return j < 0 ? 0.0 : 1.0;
}

double OtherProgram::withoutTable(double I) const {
  const double in = std::clamp(I, 0.0, 1.0);
  const double value = way_.store == StoreWay::By256     ? std::min(255.0, 256.0 * in)
                       : way_.store == StoreWay::ByGamma ? 255.0 * std::pow(in, 1.0 / 2.2)
                                                         : 255.0 * in;
  return way_.cell == CellWay::Truncated ? std::floor(value) : nearestWhole(value);
}

double OtherProgram::stored(int cell) const {
  int j = cell - table_.first();
  const auto shown = [](double level) { return std::floor(std::floor(65535.0 * level + 0.5) / 256.0); };
  switch (way_.store) {
    case StoreWay::Minus11:
      return std::clamp(cell - 11.0, 0.0, 255.0);
    case StoreWay::EightIn16:
      return 0.0;
    case StoreWay::Rounded8:
      return nearestWhole(255.0 * levelOf(j));
    case StoreWay::Gamma:
      return shown(std::pow(levelOf(j), 1.0 / 2.2));
    case StoreWay::Backwards:
      j = table_.shades() - 1 - j;
      break;
    default:
      break;
  }
  return table_.settings().bits == 8 ? nearestWhole(255.0 * levelOf(j)) : shown(levelOf(j));
}

}  // namespace xnewell
