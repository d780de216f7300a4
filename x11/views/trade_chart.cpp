#include "x11/views/trade_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "shading/trade/trade.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kTradeChart = 1024, kTradeLeft = 64, kTradeWidth = 590, kTradeHeight = 460, kBelow = 56;
constexpr int kMark = 3;  // half the width of a mark

/// A number as short as it can be: 0.02, 0.5, 10.
std::string shortNumber(double v) {
  int decimals = 0;
  while (decimals < 6 && std::abs(std::stod(fixed(v, decimals)) - v) > 1e-3 * v) ++decimals;
  return fixed(v, decimals);
}

/// 1, 2, 5, 10, 20 ... within [low, high].
std::vector<double> ticksBetween(double low, double high) {
  std::vector<double> ticks;
  for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10)
    for (const double digit : {1.0, 2.0, 5.0})
      if (digit * power >= low * (1 - 1e-9) && digit * power <= high * (1 + 1e-9))
        ticks.push_back(digit * power);
  return ticks;
}

/// The mark of a method: flat a square, Gouraud a disc, Phong a triangle, the others a cross.
void drawMark(Painter& paint, int x, int y, Shading method, bool filled, std::uint8_t cell) {
  switch (method) {
    case Shading::Flat:
      if (filled)
        paint.fillRect({x - kMark, y - kMark, 2 * kMark + 1, 2 * kMark + 1}, cell);
      else
        paint.frame({x - kMark, y - kMark, 2 * kMark + 1, 2 * kMark + 1}, cell);
      return;
    case Shading::Gouraud:
      if (filled)
        paint.disc(x, y, kMark + 1, cell);
      else
        paint.ring(x, y, kMark + 1, cell);
      return;
    case Shading::Phong:
      for (int row = 0; row <= 2 * kMark; ++row) {
        const int half = row / 2 + 1;
        if (filled || row == 2 * kMark)
          paint.hline(x - half, y - kMark + row, 2 * half + 1, cell);
        else
          paint.point(x - half, y - kMark + row, cell), paint.point(x + half, y - kMark + row, cell);
      }
      return;
    default:
      paint.line(x - kMark, y - kMark, x + kMark, y + kMark, cell, {filled ? 2 : 1});
      paint.line(x - kMark, y + kMark, x + kMark, y - kMark, cell, {filled ? 2 : 1});
  }
}

}  // namespace

double TradeAxes::costOf(const Measured& one) const {
  return cost == TradeCost::Time ? one.cost.time.ms : static_cast<double>(one.cost.bytes) / 1e6;
}

double TradeAxes::errorOf(const Measured& one) const {
  const double value = error == TradeError::Rms       ? one.here.afterTable.rootMeanSquare
                       : error == TradeError::Largest ? one.here.afterTable.largest
                                                      : static_cast<double>(one.here.wrongFaces);
  return std::max(value, kTradeErrors[static_cast<std::size_t>(error)].least);
}

std::vector<int> frontBy(const TradeAxes& axes, const Trade& trade) {
  if (axes == TradeAxes{}) return trade.front;
  std::vector<int> order(trade.combinations.size()), front;
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) {
    return std::pair{axes.costOf(trade.combinations[k]), axes.errorOf(trade.combinations[k])};
  });
  for (const int k : order)
    if (front.empty() || axes.errorOf(trade.combinations[k]) < axes.errorOf(trade.combinations[front.back()]))
      front.push_back(k);
  return front;
}

TradeScale::TradeScale(const Rect& area, const Trade& trade, const TradeAxes& axes)
    : area_{area}, axes_{axes}, cost0_{1e300}, cost1_{0}, error0_{1e300}, error1_{0} {
  for (const Measured& one : trade.combinations) {
    const double cost = std::max(axes.costOf(one), 1e-6), error = axes.errorOf(one);
    cost0_ = std::min(cost0_, cost), cost1_ = std::max(cost1_, cost);
    error0_ = std::min(error0_, error), error1_ = std::max(error1_, error);
  }
  // Some space around the marks.
  cost0_ /= 1.25, cost1_ *= 1.25, error0_ /= 1.3, error1_ *= 1.3;
}

int TradeScale::x(double cost) const {
  const double share = std::log(std::clamp(cost, cost0_, cost1_) / cost0_) / std::log(cost1_ / cost0_);
  return area_.x + static_cast<int>(std::lround((area_.width - 1) * share));
}

int TradeScale::y(double error) const {
  const double share = std::log(std::clamp(error, error0_, error1_) / error0_) / std::log(error1_ / error0_);
  return area_.y + area_.height - 1 - static_cast<int>(std::lround((area_.height - 1) * share));
}

double TradeScale::errorAt(int y) const {
  const double share = static_cast<double>(area_.y + area_.height - 1 - y) / (area_.height - 1);
  return error0_ * std::pow(error1_ / error0_, std::clamp(share, 0.0, 1.0));
}

std::vector<double> TradeScale::ticksOfCost() const { return ticksBetween(cost0_, cost1_); }
std::vector<double> TradeScale::ticksOfError() const { return ticksBetween(error0_, error1_); }

std::string labelOf(const Configuration& configuration) {
  const PictureSettings& s = configuration.settings;
  std::string text{rowOf(s.shading).label};
  if (configuration.divisions > 0) {
    const std::string n = std::to_string(configuration.divisions);
    text += ' ' + n + 'x' + n;
  }
  text += ", " + std::string{std::ranges::find(kOrders, s.order, &OrderRow::id)->label};
  for (const Change& change : configuration.changes)
    if (change.setting && change.setting->key != "method" && change.setting->key != "order")
      text += ", " + phraseOf(*change.setting, s);
  return text;
}

Rect limitHandle(const TradeScale& scale, double limit) {
  return {scale.area().x + scale.area().width - 4, scale.y(limit) - 6, 8, 13};
}

void drawTradePlot(Painter paint, const CellPlan& plan, const TradeScale& scale, const Trade& trade,
                   int chosen, std::optional<double> limit) {
  const Rect& area = scale.area();
  const int base = area.y + area.height, right = area.x + area.width;
  for (const double ms : scale.ticksOfCost()) {
    paint.vline(scale.x(ms), area.y, area.height, plan[Cell::Rule]);
    const std::string name = shortNumber(ms);
    paint.text(scale.x(ms) - textWidth(name) / 2, base + 16, name, plan[Cell::Soft]);
  }
  for (const double error : scale.ticksOfError()) {
    paint.hline(area.x, scale.y(error), area.width, plan[Cell::Rule]);
    paint.textRight(area.x - 6, scale.y(error) + 4, shortNumber(error), plan[Cell::Soft]);
  }
  paint.vline(area.x, area.y, area.height, plan[Cell::Ink]);
  paint.hline(area.x, base, area.width, plan[Cell::Ink]);
  const TradeAxes& axes = scale.axes();
  const std::string_view errorSays = kTradeErrors[static_cast<std::size_t>(axes.error)].says;
  paint.text(area.x + 6, area.y - 6, errorSays, plan[Cell::Soft]);
  paint.textRight(right, base + 34, kTradeCosts[static_cast<std::size_t>(axes.cost)].says, plan[Cell::Soft]);
  const std::vector<int> front = frontBy(axes, trade);

  const auto isOnFront = [&](int k) { return std::ranges::find(front, k) != front.end(); };
  const auto xOf = [&](int k) { return scale.x(axes.costOf(trade.combinations[k])); };
  const auto yOf = [&](int k) { return scale.y(axes.errorOf(trade.combinations[k])); };
  Painter inside = paint.within({area.x, area.y, area.width + 4, area.height + 4});
  Labels labels{inside, plan, area};
  const auto count = static_cast<int>(trade.combinations.size());
  for (int k = 0; k < count; ++k) {
    labels.avoid({xOf(k) - kMark - 1, yOf(k) - kMark - 1, 2 * kMark + 3, 2 * kMark + 3});
    if (!isOnFront(k))
      drawMark(inside, xOf(k), yOf(k), trade.combinations[k].configuration.settings.shading, false,
               plan[Cell::Faint]);
  }
  for (std::size_t k = 0; k + 1 < front.size(); ++k) {
    const int from = front[k], to = front[k + 1];
    inside.line(xOf(from), yOf(from), xOf(to), yOf(from), plan[Cell::Ink]);
    inside.line(xOf(to), yOf(from), xOf(to), yOf(to), plan[Cell::Ink]);
    labels.avoid({xOf(from), yOf(from), xOf(to) - xOf(from), 1});
    labels.avoid({xOf(to), yOf(from), 1, yOf(to) - yOf(from)});
  }
  if (limit) {
    const int y = scale.y(*limit);
    inside.line(area.x, y, right - 1, y, plan[Cell::Good], {1, 4, 3});
    paint.fillRect(limitHandle(scale, *limit), plan[Cell::Good]);
    labels.avoid({area.x, y - 1, area.width, 3});
    // The choice knows more than the chart.
    for (const std::string& words :
         {"within the limit here; turned views and " + textOf(100 * kSpare) + " % spare count too",
          std::string{"within the limit here"}}) {
      const int width = textWidth(words) + 2;
      std::vector<Rect> places;
      for (int row = y + 3; row < base; row += 14)
        for (const int x : {area.x + 6, right - width - 10, area.x + (area.width - width) / 2})
          places.push_back({x, row, width, 14});
      const std::optional<Rect> at = labels.take(places);
      if (at) inside.text(at->x, at->y + 11, words, plan[Cell::Good]);
      if (at) break;
    }
  }
  for (const int k : front)
    drawMark(inside, xOf(k), yOf(k), trade.combinations[k].configuration.settings.shading, true,
             plan[Cell::Ink]);
  if (chosen >= 0) {
    for (const int radius : {8, 9}) inside.ring(xOf(chosen), yOf(chosen), radius, plan[Cell::Ink]);
    labels.place(xOf(chosen) + 6, yOf(chosen) - 4, labelOf(trade.combinations[chosen].configuration), true);
  }
  for (const int k : front)
    if (k != chosen) labels.place(xOf(k), yOf(k), labelOf(trade.combinations[k].configuration), false);
}

int drawTradeLegend(Painter paint, const CellPlan& plan, int x, int y) {
  for (const ShadingRow& method : kShadings) {
    if (method.id != Shading::Flat && method.id != Shading::Gouraud && method.id != Shading::Phong) continue;
    drawMark(paint, x + kMark, y, method.id, false, plan[Cell::Ink]);
    x = paint.text(x + 14, y + 4, method.label, plan[Cell::Soft]) + 12;
  }
  drawMark(paint, x + kMark, y, Shading::Full, false, plan[Cell::Ink]);
  x = paint.text(x + 14, y + 4, "others", plan[Cell::Soft]) + 12;
  return paint.text(x, y + 4, "filled: front", plan[Cell::Soft]);
}

ColoredImage drawTrade(const Trade& trade, const std::string& title) {
  const int column = kTradeLeft + kTradeWidth + 2 * Sheet::kGutter,
            words = kTradeChart - column - Sheet::kMargin;
  const int top = Sheet::kMargin + Sheet::kTitle + Sheet::kLine;
  int rows = 0;
  for (const int k : trade.front)
    rows += Sheet::kRow + Sheet::paragraphHeight(words, labelOf(trade.combinations[k].configuration)) + 4;
  const int height =
      std::max(top + kTradeHeight + kBelow, top + Sheet::kSection + Sheet::kRow + rows) + Sheet::kMargin;
  const CellPlan plan{TableKind::Linear};
  Sheet sheet{kTradeChart, height, plan};
  sheet.title(Sheet::kMargin, Sheet::kMargin, title);
  Painter paint = sheet.painter();
  paint.text(Sheet::kMargin, top - Sheet::kLine + Sheet::kAscent,
             counted(static_cast<std::int64_t>(trade.combinations.size()), "configuration") + ", " +
                 std::to_string(trade.front.size()) + " on the front",
             sheet.cell(Cell::Soft));
  if (!trade.combinations.empty())
    drawTradePlot(paint, plan, TradeScale{{kTradeLeft, top + 20, kTradeWidth, kTradeHeight - 20}, trade},
                  trade);
  drawTradeLegend(paint, plan, kTradeLeft, top + kTradeHeight + 48);
  int y = sheet.section(column, top, words, "the front");
  y = sheet.tableRow(column, y, "", {"ms", "error", "wrong faces"}, {70, 150, words}, Cell::Soft,
                     Voice::Plain);
  for (const int k : trade.front) {
    const Measured& one = trade.combinations[k];
    y = sheet.paragraph(column, y, words, labelOf(one.configuration), Cell::Ink);
    y = 4 + sheet.tableRow(
                column, y, "",
                {msText(one.cost.time.ms), fixed(TradeAxes{}.errorOf(one), 4), grouped(one.here.wrongFaces)},
                {70, 150, words}, Cell::Ink, Voice::Plain);
  }
  return {sheet.image(), makePalette(plan, ColorTable{{}})};
}

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
