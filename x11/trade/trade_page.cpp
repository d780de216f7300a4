#include "x11/trade/trade_page.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/pen.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/window/layout.h"

namespace xnewell {

namespace {

constexpr int kRow = 22, kLine = 17;
/// Draws a page.
class TradeDrawing {
 public:
  TradeDrawing(Painter paint, const TradeLayout& at, const TradePage& page, const CellPlan& plan)
      : pen_{paint, plan}, at_{at}, page_{page} {}

  void drawChart() {
    const int x = at_.chart.x - 48, y = at_.chart.y - 36;
    pen_.paint.text(x, y + 8, "Cost against error", pen_(Cell::Ink), Voice::Title);
    pen_.softRight(at_.chart.x + at_.chart.width, y + 8, heading());
    if (!hasTimes()) {
      drawWaiting();
      return;
    }
    drawTradePlot(pen_.paint, pen_.plan, TradeScale{at_.chart, page_.trade, page_.axes}, page_.trade,
                  page_.chosen,
                  page_.axes.error == TradeError::Rms ? std::optional{page_.limit} : std::nullopt);
  }

  void drawColumn() {
    const int x = at_.column.x, width = at_.column.width;
    int y = at_.column.y + 11;
    pen_.caps(x, y, "chosen");
    pen_.softRight(x + width, y,
                   page_.chosen < 0 ? ""
                   : page_.chosen == page_.within.combination
                       ? (page_.within.accurate ? "cheapest within the limit" : "the most accurate")
                   : isOnFront() ? "on the front"
                                 : "not on the front");
    pen_.paint.fillRect(at_.well, pen_(Cell::Well));
    if (page_.picture) pen_.paint.place(*page_.picture, at_.picture.x, at_.picture.y);
    drawPlaces();
    y = at_.well.y + at_.well.height + 20;
    if (page_.chosen >= 0) y = drawNumbers(x, y, width);
    drawControls();
    if (page_.chosen >= 0) drawWhy(x, y, width);
  }

 private:
  [[nodiscard]] bool hasTimes() const {
    return std::ranges::any_of(page_.trade.combinations,
                               [](const Measured& m) { return m.cost.time.ms > 0; });
  }

  [[nodiscard]] bool isOnFront() const {
    const std::vector<int> front = frontBy(page_.axes, page_.trade);
    return std::ranges::find(front, page_.chosen) != front.end();
  }

  [[nodiscard]] std::string heading() const {
    return page_.stale
               ? (at_.compact ? "out of date: press m" : "measured for an earlier set-up: m measures again")
               : counted(static_cast<std::int64_t>(page_.trade.combinations.size()), "configuration") +
                     (at_.compact    ? ""
                      : page_.single ? ", one change each"
                                     : ", this scene, this view");
  }

  void drawWaiting() {
    const int x = at_.chart.x, y = at_.chart.y + at_.chart.height / 2;
    pen_.bold(x, y, page_.failure.empty() ? "Measuring" : "This set-up cannot be measured.");
    for (int line = 0; const std::string& words :
                       broken(page_.failure.empty() ? page_.doing : page_.failure, at_.chart.width / 6))
      pen_.soft(x, y + kLine * ++line, words);
  }

  void drawPlaces() {
    Painter inside = pen_.paint.within(at_.well);
    for (std::size_t k = page_.places.size(); k-- > 0;) {
      const Rect& frame = page_.places[k];
      const bool told = static_cast<int>(k) == page_.place;
      inside.frame({frame.x - 1, frame.y - 1, frame.width + 2, frame.height + 2}, pen_(Cell::Well));
      inside.frame(frame, pen_(told ? Cell::White : Cell::WellText));
      if (told)
        inside.frame({frame.x + 1, frame.y + 1, frame.width - 2, frame.height - 2}, pen_(Cell::White));
    }
  }

  int drawNumbers(int x, int y, int width) {
    const Measured& one = page_.trade.combinations[page_.chosen];
    const std::vector<std::string> name = broken(labelOf(one.configuration), width / 6);
    for (const std::string& line : name) pen_.bold(x, y, line), y += kLine;
    const auto row = [&](std::string_view label, const std::string& value, const std::string& soft) {
      pen_.soft(x, y, label);
      pen_.boldRight(x + 190, y, value);
      pen_.soft(x + 200, y, soft);
      y += kLine;
    };
    row("error", fixed(errorOnAllViews(one), 4), "limit " + textOfLimit(page_.limit));
    row("time", msText(one.cost.time.ms) + " ms", fixed(one.cost.time.ratio, 2) + " x the set-up");
    if (!at_.compact) {
      row("memory", fixed(static_cast<double>(one.cost.bytes) / 1e6, 1) + " MB", "");
      const PictureSettings& measured = one.configuration.settings;
      row("wrong, of " + sizeText(measured.width, measured.height), grouped(one.here.wrongFaces),
          "of " + grouped(one.here.samples));
    }
    if (page_.place < static_cast<int>(one.here.worst.size())) {
      const WorstPlace& place = one.here.worst[page_.place];
      row("place " + std::to_string(page_.place + 1) + " of " + std::to_string(one.here.worst.size()) +
              ", off by",
          fixed(place.error, 3), place.shownFace != place.face ? "a wrong face" : "");
    }
    return y;
  }

  void drawWhy(int x, int y, int width) {
    if (page_.chosen != page_.within.combination) return;
    pen_.rule(x, y - 8, width);
    y += 10;
    pen_.caps(x, y, "why this one");
    y += kLine + 2;
    // The rows above say what the first two sentences say.
    const std::vector<std::string>& why = page_.within.why;
    const int room = (at_.controls.y - 26 - y) / (kLine - 1) + 1;
    for (const std::string& line : wholeSentences(
             {why.begin() + std::min<std::ptrdiff_t>(2, std::ssize(why)), why.end()}, width / 6, room))
      pen_.ink(x, y, line), y += kLine - 1;
  }

  void drawControls() {
    const int x = at_.controls.x, width = at_.controls.width;
    pen_.rule(x, at_.controls.y - 22, width);
    pen_.caps(x, at_.controls.y - 6, "limit and axes");
    drawTradeLegend(pen_.paint, pen_.plan, x, at_.controls.y + at_.controls.height + 12);
  }

  Pen pen_;
  const TradeLayout& at_;
  const TradePage& page_;
};

}  // namespace

TradeLayout layoutOfTrade(const Rect& body, const Rect& measured) {
  TradeLayout at;
  at.compact = body.height < kCompactBelow;
  at.column = {body.x + body.width - kControls, body.y, kControls, body.height};
  const int wide = at.column.x - kMargin - body.x;
  at.chart = {body.x + 56, body.y + 44, wide - 64, body.height - 44 - 44};
  at.well = {at.column.x, body.y + 18, kControls, at.compact ? 120 : 196};
  const double scale =
      std::min(double(at.well.width) / measured.width, double(at.well.height) / measured.height);
  const int w = std::max(1, static_cast<int>(scale * measured.width)),
            h = std::max(1, static_cast<int>(scale * measured.height));
  at.picture = {at.well.x + (at.well.width - w) / 2, at.well.y + (at.well.height - h) / 2, w, h};
  const int controls = body.y + body.height - 3 * kRow - 26;
  at.controls = {at.column.x, controls, kControls, 3 * kRow};
  return at;
}

std::string textOfLimit(double limit) {
  return limit < kLimits.low ? textOf(limit) : fixed(limit, limit < 0.01 ? 4 : 3);
}

std::vector<std::string> wholeSentences(const std::vector<std::string>& sentences, int most, int room) {
  std::vector<std::string> all;
  for (const std::string& sentence : sentences) {
    const std::vector<std::string> lines = broken(sentence, most);
    if (std::ssize(all) + std::ssize(lines) <= room) all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

std::vector<Rect> framesOfWorst(const TradeLayout& at, const Rect& measured, const Measured& one) {
  constexpr int kFrame = 9;
  std::vector<Rect> frames;
  for (const WorstPlace& place : one.here.worst)
    frames.push_back({at.picture.x + place.x * at.picture.width / measured.width - kFrame / 2,
                      at.picture.y + place.y * at.picture.height / measured.height - kFrame / 2, kFrame,
                      kFrame});
  return frames;
}

void drawTradePage(Painter paint, const TradeLayout& at, const TradePage& page, const CellPlan& plan) {
  TradeDrawing drawing{paint, at, page, plan};
  drawing.drawChart();
  drawing.drawColumn();
}

}  // namespace xnewell
