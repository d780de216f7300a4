#include "x11/server/shared_cells.h"
#include "x11/server/read_visuals.h"

#include <algorithm>
#include <span>

namespace xnewell {

namespace {

constexpr std::array kByNeed{Cell::Black, Cell::White, Cell::Faint,    Cell::Soft, Cell::Well, Cell::Alarm,
                             Cell::Focus, Cell::Panel, Cell::WellText, Cell::Rule, Cell::P,    Cell::Q,
                             Cell::Good,  Cell::Ink,   Cell::WellLine, Cell::Paper};
static_assert(kByNeed.size() == kCells);

void giveBack(Display* display, Colormap map, std::vector<unsigned long>& cells, std::size_t keep) {
  if (cells.size() <= keep) return;
  XFreeColors(display, map, &cells[keep], static_cast<int>(cells.size() - keep), 0);
  cells.resize(keep);
}

}  // namespace

SharedCells::SharedCells(Display* display, Colormap map, const VisualInfo& visual, int shades, bool ours)
    : display_{display}, map_{map}, visual_{visual} {
  const ServerGrab grab{display};
  if (shades > 0) ramp_ = takeCells(display, map_, visual.cells);
  const std::size_t free = ramp_.size(), left = ours ? 0 : std::min(free / 4, kLeft);
  const std::size_t forInterface = std::min<std::size_t>(free / 4, kCells);
  giveBack(display, map_, ramp_, ramp_.size() - forInterface);
  const CellPlan plan;
  const Palette colors = withInterface({}, plan);
  for (const Cell cell : std::span{kByNeed}.first(shades > 0 ? kCells : 2))
    interface_[static_cast<int>(cell)] = take(colors[plan[cell]]);
  const std::vector<unsigned long> rest = takeCells(display, map_, static_cast<int>(forInterface));
  ramp_.insert(ramp_.end(), rest.begin(), rest.end());
  giveBack(display, map_, ramp_, std::min<std::size_t>(shades, ramp_.size() - std::min(ramp_.size(), left)));
  if (ramp_.size() < 2) giveBack(display, map_, ramp_, 0);
}

SharedCells::~SharedCells() {
  giveBack(display_, map_, ramp_, 0);
  // A list may not name a cell more often than one request of ours is counted, so we free one cell at a time.
  for (unsigned long pixel : taken_) XFreeColors(display_, map_, &pixel, 1, 0);
}

void SharedCells::giveRampBack() { giveBack(display_, map_, ramp_, 0); }

std::optional<unsigned long> SharedCells::take(Rgb16 color) {
  XColor cell{.pixel = 0, .red = color.r, .green = color.g, .blue = color.b, .flags = 0, .pad = 0};
  if (!XAllocColor(display_, map_, &cell)) return std::nullopt;
  taken_.push_back(cell.pixel);
  return cell.pixel;
}

std::vector<OfferedColor> SharedCells::held() {
  if (!held_.empty()) return held_;
  // If a cell were free, asking for a colour that others may change would take that cell.
  const ServerGrab grab{display_};
  std::vector<unsigned long> free = takeCells(display_, map_, visual_.cells);
  std::vector<XColor> cells(visual_.cells);
  for (int k = 0; k < visual_.cells; ++k) cells[k].pixel = pixelOfCell(visual_, k);
  XQueryColors(display_, map_, cells.data(), visual_.cells);
  std::vector<Rgb16> colors;
  // Where each channel has its own cells, the cells of black and white also give all eight corners of the
  // cube.
  for (unsigned corner = 0; visual_.hasChannels() && corner < 8; ++corner) {
    const auto full = [&](unsigned bit) { return static_cast<std::uint16_t>(corner & bit ? 65535 : 0); };
    colors.push_back({full(1), full(2), full(4)});
  }
  for (const XColor& cell : cells)
    if (std::ranges::find(ramp_, cell.pixel) == ramp_.end() &&
        std::ranges::find(free, cell.pixel) == free.end())
      colors.push_back({cell.red, cell.green, cell.blue});
  for (const Rgb16 color : colors) {
    const glm::ivec3 shown = eightBits(color);
    if (std::ranges::find(held_, shown, &OfferedColor::color) != held_.end()) continue;
    if (const std::optional<unsigned long> pixel = take(color)) held_.push_back({*pixel, shown});
  }
  giveBack(display_, map_, free, 0);
  return held_;
}

std::array<std::vector<OfferedLevel>, 3> SharedCells::levels() {
  std::vector<XColor> cells(visual_.cells);
  for (int k = 0; k < visual_.cells; ++k) cells[k].pixel = pixelOfCell(visual_, k);
  const std::array masks{visual_.masks.red, visual_.masks.green, visual_.masks.blue};
  std::array<std::vector<OfferedLevel>, 3> levels;
  for (int c = 0; c < 3; ++c) {
    const unsigned long n = levelsOf(masks[c]);
    const auto ask = [&](std::uint16_t value) {  // the other two channels are black, which is already there
      if (std::ranges::find(levels[c], value >> 8, &OfferedLevel::value) != levels[c].end()) return;
      Rgb16 color;
      (c == 0 ? color.r : c == 1 ? color.g : color.b) = value;
      if (const std::optional<unsigned long> pixel = take(color))
        levels[c].push_back({*pixel & masks[c], value >> 8});
    };
    ask(0);
    ask(65535);
    // Ask for the other levels in an order that spreads any number of them evenly: n / 2, n / 4, 3 n / 4, ...
    for (unsigned long step = n / 2; step > 0; step /= 2)
      for (unsigned long l = step; l < n; l += 2 * step) ask(static_cast<std::uint16_t>(l * 65535 / (n - 1)));
    if (levels[c].size() < n) XQueryColors(display_, map_, cells.data(), visual_.cells);
    for (unsigned long l = 0; l < n && levels[c].size() < n; ++l)
      ask(c == 0 ? cells[l].red : c == 1 ? cells[l].green : cells[l].blue);
  }
  return levels;
}

}  // namespace xnewell
