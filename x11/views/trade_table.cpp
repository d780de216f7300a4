#include "x11/views/trade_table.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kName = 34;

}  // namespace

ServerCost serverCostOf(int width, int height, int cells) {
  constexpr std::int64_t kStoreColors = 8, kColor = 12, kPutImage = 24, kCopyArea = 28;
  // A longer request has its length in a word more (BIG-REQUESTS).
  constexpr std::int64_t kLongest = 4 * 65'535, kLengthWord = 4;
  const std::int64_t row = (std::int64_t{width} + 3) / 4 * 4, put = kPutImage + row * height;
  return {.requests = 3,
          .bytes = kStoreColors + kColor * cells + put + (put > kLongest ? kLengthWord : 0) + kCopyArea};
}

std::string percentOf(double ratio) { return fixed(100 * ratio, 0) + " %"; }

void printTradeHead(std::ostream& out, const std::string& what) {
  out << std::left << std::setw(kName) << what << std::right << std::setw(9) << "ms" << std::setw(8) << "time"
      << "  " << std::setw(9) << "RMS" << std::setw(9) << "99 %" << std::setw(9) << "largest" << std::setw(9)
      << "faces" << std::setw(8) << "dE" << std::setw(8) << "dE max" << std::setw(8) << "MB" << std::setw(11)
      << "X bytes" << '\n';
}

void printTradeNumbers(std::ostream& out, const std::string& name, const Measured& one) {
  const Errors& e = one.here;
  const Timing& time = one.cost.time;
  const bool timed = time.ms > 0, coloured = e.color.count > 0;
  out << std::left << std::setw(kName) << name << std::right << std::setw(9)
      << (timed ? msText(time.ms) : "-") << std::setw(8) << (timed ? percentOf(time.ratio) : "-")
      << (timed && time.tie ? " =" : "  ") << std::setw(9) << fixed(e.afterTable.rootMeanSquare, 4)
      << std::setw(9) << fixed(e.afterTable.p99, 4) << std::setw(9) << fixed(e.afterTable.largest, 4)
      << std::setw(9) << grouped(e.wrongFaces) << std::setw(8) << (coloured ? fixed(e.color.mean, 2) : "-")
      << std::setw(8) << (coloured ? fixed(e.color.largest, 1) : "-") << std::setw(8)
      << fixed(static_cast<double>(one.cost.bytes) / 1e6, 1) << std::setw(11)
      << grouped(
             serverCostOf(one.configuration.settings.width, one.configuration.settings.height, one.cost.cells)
                 .bytes)
      << '\n';
}

std::string tableOfCombinations(const Trade& trade) {
  std::vector<int> order(trade.combinations.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return trade.combinations[k].cost.time.ratio; });
  std::ostringstream out;
  printTradeHead(out, "combination (* on the front)");
  for (const int k : order) {
    const Configuration& one = trade.combinations[k].configuration;
    const bool front = std::ranges::find(trade.front, k) != trade.front.end();
    printTradeNumbers(out, (front ? "* " : "  ") + one.name(), trade.combinations[k]);
    if (const std::string options = one.options(); front && !options.empty())
      out << "    " << options << '\n';
  }
  return out.str();
}

}  // namespace xnewell
