#include "shading/color/color_table.h"
#include "shading/fill/ramp.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

/// A table and its exact levels and thresholds. In an input: kind, pick, N, I0, low, high.
constexpr std::size_t kTableNumbers = 6;
struct ExactTable {
  TableSettings settings;
  Big low, high, lowest, highest;

  explicit ExactTable(const Numbers& in) {
    settings.kind = kTables[static_cast<std::size_t>(in[0])].id;
    settings.pick = kPicks[static_cast<std::size_t>(in[1])].id;
    settings.shades = static_cast<int>(in[2]);
    settings.I0 = in[3], settings.low = in[4], settings.high = in[5];
    low = big(in[4]), high = big(in[5]);
    lowest = big(std::max(in[3], in[4]));
    highest = largerOf(lowest, high);
  }
  [[nodiscard]] bool corrected() const { return settings.kind == TableKind::Corrected; }
  [[nodiscard]] Big share(const Big& j) const { return j / (settings.shades - 1); }
  [[nodiscard]] Big level(int j) const {
    if (corrected()) return lowest * pow(Big{highest / lowest}, share(j));
    const Big held = 239 * (low + (high - low) * share(j));
    return (settings.kind == TableKind::Linear ? held + 1 : held) / 255;
  }
  /// Where shade j + 1 begins.
  [[nodiscard]] Big threshold(int j) const {
    const Big middle = Big{j} + Big{0.5};
    if (!corrected()) return low + (high - low) * share(middle);
    if (settings.pick == Pick::Search) return (level(j) + level(j + 1)) / 2;
    return lowest * pow(Big{highest / lowest}, share(middle));
  }
  /// How far I lies outside the intensities that pick the shade, as a share of the bound. Inside, a little
  /// the more the nearer an end is, to lead the search there.
  [[nodiscard]] double missed(const Big& I, int shade) const {
    double worst = 0;
    const auto look = [&](int j, int side) {
      const Big at = threshold(j);
      const double beyond =
          toDouble(side * (I - at) / (corrected() ? Big{(5 * j + 8) * kU * at} : Big{4 * kU}));
      worst = std::max(worst, beyond > 0 ? beyond : 0.01 / (1 - beyond));
    };
    if (shade > 0) look(shade - 1, -1);
    if (shade + 1 < settings.shades) look(shade, 1);
    return worst;
  }
};

std::vector<Coordinate> tableInput() {
  return {integers(0, 2),         integers(0, 1), integers(2, kMaxShades),
          doubles(1e-300, 0.999), doubles(0, 1),  doubles(0, 1)};
}

/// The ends of the range in order, and at least 2^-20 apart: nearer to each other, the thresholds are too
/// near for the intensities to tell.
Numbers orderedTable(Numbers in) {
  if (in[4] > in[5]) std::swap(in[4], in[5]);
  if (in[5] - in[4] < 0x1p-20) return {};
  return in;
}

Numbers randomTable(Random& random) {
  const bool whole = random.oneIn(2);
  return {static_cast<double>(random.below(3)),
          static_cast<double>(random.below(2)),
          static_cast<double>(random.integer(2, kMaxShades)),
          random.oneIn(2) ? 0.02 : random.power(-996, -0.0015),
          whole ? 0.0 : random.uniform(0, 0.5),
          whole ? 1.0 : random.uniform(0.5, 1)};
}

/// An intensity next to a threshold, in doubles.
double nearThreshold(const Numbers& table, Random& random) {
  const double N = table[2], j = static_cast<double>(random.integer(0, static_cast<int>(N) - 2));
  const double low = table[0] == 2 ? std::max(table[3], table[4]) : table[4], high = std::max(low, table[5]);
  const double s = (j + 0.5) / (N - 1), r = table[0] == 2 ? std::pow(high / low, 1 / (N - 1)) : 1;
  const double at = table[0] != 2   ? low + (high - low) * s
                    : table[1] == 0 ? low * std::pow(high / low, s)
                                    : low * (std::pow(r, j) + std::pow(r, j + 1)) / 2;
  return at * (1 + random.sign() * random.power(-53, -40));
}

Kernel ratioKernel() {
  return {.name = "ratio of shades",
          .claim = "2^-51 of it",
          .header = "shading/color/color_table.h",
          .input = {doubles(1e-300, 1), integers(1, kMaxShades - 1)},
          .run = [](const Numbers& in) { return Numbers{ratioOfShades(in[0], static_cast<int>(in[1]))}; },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                const Big exact = pow(Big{1 / big(in[0])}, Big{1 / Big{in[1]}});
                return shareOf(out[0], exact, 0x1p-51 * exact);
              }};
}

Kernel levelKernel() {
  Kernel kernel{.name = "colour table: level of a shade",
                .claim = "(5 j + 2) 2^-53 of it; linear: 2^-50",
                .header = "shading/color/color_table.h",
                .input = tableInput(),
                .prepare = [](const Numbers& in) { return in[6] < in[2] ? orderedTable(in) : Numbers{}; },
                .run =
                    [](const Numbers& in) {
                      const int j = static_cast<int>(in[6]);
                      const ColorTable table{ExactTable{in}.settings};
                      return Numbers{table.level(j)};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      const int j = static_cast<int>(in[6]);
                      const ExactTable table{in};
                      const Big exact = table.level(j);
                      return shareOf(out[0], exact,
                                     table.corrected() ? (5 * j + 2) * kU * exact : Big{8 * kU});
                    },
                .hard = {[](Random& random) {
                  Numbers in = randomTable(random);
                  in.push_back(static_cast<double>(random.integer(0, static_cast<int>(in[2]) - 1)));
                  return in;
                }},
                .effort = 0.5};
  kernel.input.push_back(integers(0, kMaxShades - 1));
  return kernel;
}

Kernel shadeKernel() {
  Kernel kernel{.name = "colour table: shade of an intensity",
                .claim = "threshold j: (5 j + 8) 2^-53 of it; linear: 2^-51",
                .header = "shading/color/color_table.h",
                .input = tableInput(),
                .prepare = orderedTable,
                .run =
                    [](const Numbers& in) {
                      const ColorTable table{ExactTable{in}.settings};
                      return Numbers{static_cast<double>(table.shade(in[6]))};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      if (in[6] >= 1) return out[0] == in[2] - 1 ? 0.0 : kWrong;
                      return ExactTable{in}.missed(big(in[6]), static_cast<int>(out[0]));
                    },
                .hard = {[](Random& random) {
                  Numbers in = randomTable(random);
                  in.push_back(nearThreshold(in, random));
                  return in;
                }},
                .effort = 0.5};
  kernel.input.push_back(doubles(0, 1));
  return kernel;
}

/// The intensity is a float, or a value on kTableRamp in steps.
Kernel tableCellsKernel() {
  Kernel kernel{.name = "colour table: cell of a float or of steps",
                .claim = "as the shade of a double",
                .header = "shading/fill/ramp.h",
                .input = tableInput(),
                .prepare =
                    [](Numbers in) {
                      in[0] = static_cast<double>(TableKind::Corrected);
                      in[6] =
                          in[7] == 0 ? static_cast<float>(in[6]) : std::floor((0.5 + 255 * in[6]) * 0x1p24);
                      return orderedTable(in);
                    },
                .run =
                    [](const Numbers& in) {
                      const ColorTable table{ExactTable{in}.settings};
                      const TableCells cells{table};
                      const auto I = static_cast<float>(in[6]);
                      const int cell = in[7] == 0 ? cells.cells(Lanes<float, 4>{I, I, I, I})[0]
                                                  : cells.bySteps()(static_cast<std::uint32_t>(in[6]));
                      return Numbers{static_cast<double>(cell - table.first())};
                    },
                .judge =
                    [](const Numbers& in, const Numbers& out) {
                      const Big I = in[7] == 0 ? big(in[6]) : (big(in[6]) / 0x1p24 - Big{0.5}) / 255;
                      if (I >= 1) return out[0] == in[2] - 1 ? 0.0 : kWrong;
                      return ExactTable{in}.missed(I, static_cast<int>(out[0]));
                    },
                .hard = {[](Random& random) {
                  Numbers in = randomTable(random);
                  in[0] = static_cast<double>(TableKind::Corrected);
                  in.push_back(nearThreshold(in, random));
                  in.push_back(static_cast<double>(random.below(2)));
                  return in;
                }},
                .effort = 0.2};
  kernel.input.push_back(doubles(0, 1));
  kernel.input.push_back(integers(0, 1));
  return kernel;
}

Kernel storedKernel() {
  Kernel kernel{
      .name = "colour that a shade stores",
      .claim = "2^-26 beyond half of its last step",
      .header = "shading/color/color_table.h",
      .input = tableInput(),
      .prepare = [](const Numbers& in) { return in[6] < in[2] ? orderedTable(in) : Numbers{}; },
      .run =
          [](const Numbers& in) {
            TableSettings settings = ExactTable{in}.settings;
            settings.hue = {1, in[7], 0};
            settings.bits = static_cast<int>(in[8]) == 0 ? 8 : 16;
            return Numbers{static_cast<double>(ColorTable{settings}.color(static_cast<int>(in[6])).g)};
          },
      .judge =
          [](const Numbers& in, const Numbers& out) {
            const bool bytes = in[8] == 0;
            const Big exact =
                ExactTable{in}.level(static_cast<int>(in[6])) * big(in[7]) * (bytes ? 255 : 65535);
            const Big error = abs(big(bytes ? out[0] / 257 : out[0]) - exact);
            // What is beyond the half step; below it, little, to lead the search to the ties.
            return std::max(0.01 * toDouble(error), toDouble((error - 0.5) / 0x1p-26));
          },
      .hard = {[](Random& random) {
        Numbers in = randomTable(random);
        in.push_back(static_cast<double>(random.integer(0, static_cast<int>(in[2]) - 1)));
        in.push_back(random.oneIn(2) ? 1 : random.uniform(0, 1));
        in.push_back(static_cast<double>(random.below(2)));
        return in;
      }},
      .effort = 0.5};
  kernel.input.push_back(integers(0, kMaxShades - 1));
  kernel.input.push_back(doubles(0, 1));
  kernel.input.push_back(integers(0, 1));
  return kernel;
}

Kernel singleRampKernel() {
  return {.name = "value on a ramp, single precision",
          .claim = "2^-15",
          .header = "shading/fill/ramp.h",
          .input = {doubles(0, 1), integers(2, kMaxShades)},
          .run =
              [](const Numbers& in) {
                const Ramp ramp{.first = 256 - static_cast<int>(in[1]), .shades = static_cast<int>(in[1])};
                return Numbers{ValueOnRamp<float>{ramp}(static_cast<float>(in[0]))};
              },
          .judge =
              [](const Numbers& in, const Numbers& out) {
                return shareOf(out[0], 256 - in[1] + 0.5 + (in[1] - 1) * big(in[0]), 0x1p-15);
              }};
}

}  // namespace

void addColorKernels(std::vector<Kernel>& kernels) {
  kernels.push_back(ratioKernel());
  kernels.push_back(levelKernel());
  kernels.push_back(shadeKernel());
  kernels.push_back(tableCellsKernel());
  kernels.push_back(storedKernel());
  kernels.push_back(singleRampKernel());
}

}  // namespace xnewell
