#include "x11/views/trade_table.h"

#include <algorithm>
#include <numeric>

#include "x11/drawing/wording.h"

namespace xnewell {

ServerCost serverCostOf(const Measured& one) {
  constexpr std::int64_t kStoreColors = 8, kColor = 12, kPutImage = 24, kCopyArea = 28;
  constexpr std::int64_t kLongest =
      4 * 65'535;  // of a request without BIG-REQUESTS, which Xlib does not use here
  const PictureSettings& s = one.configuration.settings;
  const std::int64_t row = (std::int64_t{s.width} + 3) / 4 * 4, rows = (kLongest - kPutImage) / row,
                     puts = (s.height + rows - 1) / rows;
  return {.requests = puts + 2,
          .bytes = kStoreColors + kColor * one.cost.cells + kPutImage * puts + row * s.height + kCopyArea};
}

std::string percentOf(double ratio) { return fixed(100 * ratio, 0) + " %"; }

page::Table tradeTable(std::string what) {
  page::Table table;
  table.columns.push_back({.head = std::move(what)});
  for (const char* head :
       {"ms", "time", " ", "RMS", "99 %", "largest", "faces", "dE", "dE max", "MB", "X bytes"})
    table.columns.push_back({.head = head, .right = true});
  return table;
}

void addNumbers(page::Table& table, std::string name, const Measured& one,
                const std::vector<std::string>& below) {
  const Errors& e = one.here;
  const Timing& time = one.cost.time;
  const bool timed = time.ms > 0, colored = e.color.count > 0;
  std::vector<page::Entry>& row = table.rows.emplace_back();
  for (std::string words :
       {std::move(name), timed ? msText(time.ms) : "-", timed ? percentOf(time.ratio) : "-",
        std::string{timed && time.tie ? "=" : " "}, fixed(e.afterTable.rootMeanSquare, 4),
        fixed(e.afterTable.p99, 4), fixed(e.afterTable.largest, 4), grouped(e.wrongFaces),
        colored ? fixed(e.color.mean, 2) : "-", colored ? fixed(e.color.largest, 1) : "-",
        fixed(static_cast<double>(one.cost.bytes) / 1e6, 1), grouped(serverCostOf(one).bytes)})
    row.push_back({.words = std::move(words)});
  for (const std::string& line : below)
    table.rows.push_back({{.words = "    " + line, .span = static_cast<int>(table.columns.size())}});
}

std::string tableOfCombinations(const Trade& trade) {
  std::vector<int> order(trade.combinations.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return trade.combinations[k].cost.time.ratio; });
  page::Table table = tradeTable("combination (* on the front)");
  for (const int k : order) {
    const Configuration& one = trade.combinations[k].configuration;
    const bool front = std::ranges::find(trade.front, k) != trade.front.end();
    std::vector<std::string> below;
    if (const std::string options = one.options(); front && !options.empty()) below = {options};
    addNumbers(table, (front ? "* " : "  ") + one.name(), trade.combinations[k], below);
  }
  return asText(page::Page{.sections = {{.parts = {std::move(table)}}}});
}

}  // namespace xnewell
