#include "x11/server/colormap.h"

#include <X11/Xutil.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "x11/drawing/wording.h"
#include "x11/server/read_visuals.h"

namespace xnewell {

namespace {

constexpr int kCellCount = 256;
/// A picture with several hues is taken to have these six: red, yellow, green, cyan, blue, magenta.
constexpr int kPureHues = 6;

Visual* findVisual(Display* display, unsigned long id) {
  XVisualInfo wanted{};
  wanted.visualid = id;
  int count = 0;
  const std::unique_ptr<XVisualInfo, int (*)(void*)> found{
      XGetVisualInfo(display, VisualIDMask, &wanted, &count), XFree};
  if (count == 0) throw X11Error("the X server no longer has this visual");
  return found->visual;
}

std::vector<Rgb16> readColors(Display* display, Colormap map, const VisualInfo& visual,
                              const std::vector<unsigned long>& pixels) {
  std::vector<XColor> cells(pixels.size());
  for (std::size_t k = 0; k < cells.size(); ++k) cells[k].pixel = visual.withoutAlpha(pixels[k]);
  ErrorTrap trap{display};
  XQueryColors(display, map, cells.data(), static_cast<int>(cells.size()));
  trap.check();
  // Xlib does not report a BadAlloc here. But an answer sets the flags, so flags of 0 mean that none came.
  if (cells[0].flags == 0) throw X11Error("X_QueryColors: the X server did not return the colours");
  std::vector<Rgb16> colors(cells.size());
  std::ranges::transform(cells, colors.begin(), [](const XColor& c) {
    return Rgb16{c.red, c.green, c.blue};
  });
  return colors;
}

XColor cellHolding(unsigned long pixel, Rgb16 color, int channels = DoRed | DoGreen | DoBlue) {
  return {.pixel = pixel,
          .red = color.r,
          .green = color.g,
          .blue = color.b,
          .flags = static_cast<char>(channels),
          .pad = 0};
}

/// For each index: the interface colour that the plan puts there, if the palette really has that colour
/// there.
std::array<std::optional<Cell>, kCellCount> interfaceCells(const Palette& palette, const CellPlan& plan) {
  const Palette its = withInterface(palette, plan);
  std::array<std::optional<Cell>, kCellCount> cells;
  for (int role = 0; role < kCells; ++role)
    if (const int i = plan[static_cast<Cell>(role)]; palette[i] == its[i]) cells[i] = static_cast<Cell>(role);
  return cells;
}

}  // namespace

ServerColormap::ServerColormap(Display* display, const VisualChoice& choice, const Settings& settings)
    : display_{display},
      screen_{DefaultScreen(display)},
      visual_{choice.visual},
      xVisual_{findVisual(display, choice.visual.id)},
      settings_{settings} {
  const bool writable = visual_.writable(), sharing = writable && settings.owner == MapOwner::Shared;
  // Cells are taken one by one from a map that others share, and from a map too small to hold the whole
  // table.
  const bool byCell = sharing || (writable && !visual_.hasChannels() && !visual_.holdsTable());
  ErrorTrap trap{display};
  if (!sharing && (writable || xVisual_ != DefaultVisual(display, screen_))) {
    OwnedColormap made{display, XCreateColormap(display, RootWindow(display, screen_), xVisual_,
                                                writable && !byCell ? AllocAll : AllocNone)};
    try {
      trap.check();
    } catch (const X11Error& e) {
      throw NoColormapError{e.what()};
    }
    own_ = std::move(made);
  }
  if (sharing && visual_.hasChannels() && !visual_.holdsTable()) {
    shared_ = std::make_unique<SharedCells>(display, id(), visual_, 0, false);
    fixed_.emplace(shared_->levels(), visual_.alphaMask());
  } else if (byCell) {
    takeShades();
  } else if (visual_.holdsTable()) {
    has_ = Own::Everything;
    useEveryCell();
  } else if (!visual_.exact()) {
    offerFixedColors();
  }
  store(unneeded_);
  trap.check();
}

void ServerColormap::takeShades() {
  shared_.reset();  // frees what was taken before
  shared_ = std::make_unique<SharedCells>(display_, id(), visual_, settings_.shades, own_.get() != 0);
  found_ = static_cast<int>(shared_->ramp().size());
  misses_ = missesOfMap();
  if (misses_ && misses_->mixing < misses_->ramp) shared_->giveRampBack();
  has_ = shared_->ramp().empty() ? Own::Nothing : Own::Ramp;
}

void ServerColormap::reconsider(bool severalHues) {
  if (std::exchange(settings_.severalHues, severalHues) == severalHues || !shared_ || fixed_) return;
  takeShades();
  lookedUp_.reset();
  tool_.reset();
  stored_.fill({});
}

void ServerColormap::useEveryCell() {
  std::array<unsigned long, kCellCount> pixels;
  for (int i = 0; i < kCellCount; ++i) pixels[i] = pixelOfCell(visual_, i);
  table_ = PixelTable{pixels};
  if (!identity() || DefaultDepth(display_, screen_) != 8) return;
  std::ranges::copy(
      readColors(display_, DefaultColormap(display_, screen_), visual_, {pixels.begin(), pixels.end()}),
      unneeded_.begin());
}

std::optional<ServerColormap::Misses> ServerColormap::missesOfMap() const {
  const bool several = settings_.severalHues && !visual_.gray();
  const int shades = several ? found_ / kPureHues : found_;
  // A mixture of two colours has at most 65 levels, so it cannot beat a longer ramp. And asking for the
  // colours takes many round trips.
  if (found_ == 0 || found_ == settings_.shades || shades > 65) return std::nullopt;
  const std::vector<OfferedColor> held = shared_->held();
  if (held.empty()) return std::nullopt;
  const OfferedColors offered{held};
  Misses sum;
  int count = 0;
  for (int corner = visual_.gray() ? 7 : 1; corner <= 7; ++corner) {
    const glm::ivec3 hue{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
    for (int value = 0; value < 256; value += 3, ++count) {
      sum.mixing += offered.miss(hue * value, settings_.dither);
      const double step = 255.0 / std::max(shades - 1, 1);
      sum.ramp += glm::length(glm::dvec3{hue}) * std::abs(value - step * std::round(value / step));
    }
  }
  return Misses{sum.mixing / count, sum.ramp / count};
}

void ServerColormap::offerFixedColors() {
  if (visual_.writable()) fillEvenly();
  const PixelColors shown{display_, id(), visual_};
  if (visual_.hasChannels()) {
    fixed_.emplace(visual_.masks, visual_.alphaMask(), shown);
    return;
  }
  std::vector<OfferedColor> list;
  for (int k = 0; k < visual_.cells; ++k)
    list.push_back({static_cast<unsigned long>(k), eightBits(seen(shown(k)))});
  fixed_.emplace(std::move(list));
}

void ServerColormap::fillEvenly() {
  std::vector<XColor> cells;
  const ChannelMasks& masks = visual_.masks;
  for (int k = 0; k < visual_.cells; ++k) {
    const auto has = [&](unsigned long mask) { return k < static_cast<int>(levelsOf(mask)); };
    const auto level = [&](unsigned long mask) {
      return static_cast<std::uint16_t>(has(mask) ? k * 65535ul / (levelsOf(mask) - 1) : 0);
    };
    cells.push_back(cellHolding(
        pixelOfCell(visual_, k), {level(masks.red), level(masks.green), level(masks.blue)},
        (has(masks.red) ? DoRed : 0) | (has(masks.green) ? DoGreen : 0) | (has(masks.blue) ? DoBlue : 0)));
  }
  XStoreColors(display_, id(), cells.data(), static_cast<int>(cells.size()));
}

int ServerColormap::mostShades() const {
  return has_ == Own::Ramp ? static_cast<int>(shared_->ramp().size()) : kMaxShades;
}

std::string ServerColormap::account() const {
  const std::string map = visual_.name() + (own_.get() ? ", private map, " : ", shared map, ");
  if (has_ == Own::Everything) return map + "256 of 256 cells";
  if (has_ == Own::Ramp)
    return map + std::to_string(mostShades()) + " of " + std::to_string(settings_.shades) + " shades";
  const std::string emulated = visual_.holdsColors() ? ", table emulated"
                               : settings_.dither    ? ", colours mixed"
                                                     : ", nearest colours";
  if (!shared_) return visual_.name() + emulated;
  if (fixed_) return map + std::to_string(fixed_->size()) + " colours" + (settings_.dither ? ", mixed" : "");
  return map + (found_ > 0 ? "too few cells free" : "no cell free") + emulated;
}

std::string ServerColormap::shortfall() const {
  const std::string its = "the " + std::string{own_.get() ? "" : "default "} + "colormap";
  if (shared_ && found_ > 0 && found_ < settings_.shades) {
    const std::string has = its + " has free cells for " + std::to_string(found_) + " of " +
                            std::to_string(settings_.shades) + " shades" +
                            (own_.get() ? "" : ", and some for other programs");
    if (has_ == Own::Ramp) return has;
    return has + "; " + instead() + " instead, which miss a colour by " + fixed(misses_->mixing, 1) +
           " of 255 on average, and the shades by " + fixed(misses_->ramp, 1);
  }
  if (shared_ && fixed_)
    return its + " has levels for " + std::to_string(fixed_->size()) +
           " colours, but no cells for a ramp of shades: " + instead();
  if (shared_ && !live()) return its + " has no free cells for a ramp of shades: " + instead();
  if (!shared_ && settings_.owner == MapOwner::Shared)
    return "the default colormap (" + visual_.name() + ") is not writable, so the colour table is emulated";
  return "";
}

std::string ServerColormap::instead() const {
  return settings_.dither ? "its colours are mixed" : "its nearest colours are shown";
}

CellPlan ServerColormap::plan(TableKind table) const {
  if (!identity() || DefaultDepth(display_, screen_) != 8) return CellPlan{table};
  return CellPlan{table, static_cast<int>(BlackPixel(display_, screen_)),
                  static_cast<int>(WhitePixel(display_, screen_))};
}

ServerColormap::OwnCells ServerColormap::ownCells(const CellPlan& plan) const {
  OwnCells own;
  if (has_ == Own::Everything) std::ranges::copy(pixels(), own.begin());
  if (has_ != Own::Ramp) return own;
  std::array<bool, kCellCount> tools{};
  for (int role = 0; role < kCells; ++role) tools[plan[static_cast<Cell>(role)]] = true;
  auto next = shared_->ramp().begin();
  for (int i = 0; i < kCellCount && next != shared_->ramp().end(); ++i)
    if (!tools[i]) own[i] = *next++;
  return own;
}

OfferedColors ServerColormap::offered(const Palette& palette, const OwnCells& own) const {
  if (fixed_) return *fixed_;
  std::vector<OfferedColor> list = shared_->held();
  for (int i = 0; i < kCellCount; ++i)
    if (own[i]) list.push_back({*own[i], eightBits(seen(palette[i]))});
  if (list.empty()) list.push_back({BlackPixel(display_, screen_), glm::ivec3{0}});
  return OfferedColors{std::move(list)};
}

const ToolColors& ServerColormap::toolColors() {
  if (tool_) return *tool_;
  const CellPlan plan;
  const Palette colors = withInterface({}, plan);
  std::array<glm::ivec3, kCells> wanted;
  std::array<std::optional<OfferedColor>, kCells> has;
  for (int role = 0; role < kCells; ++role) {
    const Cell cell = static_cast<Cell>(role);
    wanted[role] = eightBits(seen(colors[plan[cell]]));
    if (!shared_) continue;
    if (const std::optional<unsigned long> pixel = shared_->interfaceCell(cell))
      has[role] = OfferedColor{*pixel, wanted[role]};
  }
  // Asking for the colours that others hold takes many round trips, so we do it only if we need them.
  const bool settled = std::ranges::all_of(has, [](const auto& cell) { return cell.has_value(); });
  return tool_.emplace(chooseToolColors(settled ? OfferedColors{{}} : offered({}, {}), wanted, has));
}

bool ServerColormap::lookUp(const Palette& palette, const CellPlan& plan) {
  const LookedUp now{palette, plan};
  if (has_ == Own::Everything || lookedUp_ == now) return false;
  const OwnCells own = ownCells(plan);
  const auto interface = interfaceCells(palette, plan);
  PixelTable next;
  std::optional<OfferedColors> all;
  for (int i = 0; i < kCellCount; ++i) {
    const Rgb16 color = seen(palette[i]);
    std::optional<unsigned long> pixel = own[i];
    if (!pixel && visual_.exact()) pixel = pixelOf(color, visual_.masks) | visual_.alphaMask();
    if (!pixel && shared_ && color == Rgb16{}) pixel = shared_->interfaceCell(Cell::Black);
    // The interface must not use one of our shades, because a shade changes with the hue.
    if (!pixel && interface[i]) pixel = toolColors()[static_cast<int>(*interface[i])].pixel;
    if (pixel) {
      next.set(i, *pixel);
      continue;
    }
    if (!all) all.emplace(offered(palette, own));
    const unsigned long nearest = all->nearest(eightBits(color)).pixel;
    if (settings_.dither)
      next.set(i, nearest, all->mixture(eightBits(color)));
    else
      next.set(i, nearest);
  }
  const bool again = next != table_;
  table_ = std::move(next);
  lookedUp_ = now;
  return again;
}

bool ServerColormap::store(const Palette& palette, const CellPlan& plan) {
  const bool again = lookUp(palette, plan);
  const OwnCells own = ownCells(plan);
  std::vector<XColor> changed;
  for (int i = 0; i < kCellCount; ++i) {
    const Stored now{own[i].value_or(0), seen(palette[i])};
    if (!own[i] || stored_[i] == now) continue;
    changed.push_back(cellHolding(now.pixel, now.color));
    stored_[i] = now;
  }
  if (!changed.empty()) XStoreColors(display_, id(), changed.data(), static_cast<int>(changed.size()));
  return again;
}

Palette ServerColormap::shown() const {
  const PixelColors colors{display_, id(), visual_};
  Palette palette;
  std::ranges::transform(pixels(), palette.begin(), colors);
  return palette;
}

bool ServerColormap::installed() const {
  int count = 0;
  const std::unique_ptr<Colormap[], int (*)(void*)> maps{
      XListInstalledColormaps(display_, RootWindow(display_, screen_), &count), XFree};
  return std::find(maps.get(), maps.get() + count, id()) != maps.get() + count;
}

void ServerColormap::installUnlessManaged() {
  if (own_.get() && !windowManagerRuns(display_)) XInstallColormap(display_, id());
}

PixelColors::PixelColors(Display* display, Colormap map, const VisualInfo& visual) : masks_{visual.masks} {
  const unsigned long all = (1ul << visual.depth) - 1;
  if (!visual.hasChannels()) masks_ = {all, all, all};
  std::vector<unsigned long> pixels(visual.cells);
  for (int k = 0; k < visual.cells; ++k) pixels[k] = pixelOfCell(visual, k);
  cells_ = readColors(display, map, visual, pixels);
}

bool windowManagerRuns(Display* display) {
  XWindowAttributes root{};
  XGetWindowAttributes(display, DefaultRootWindow(display), &root);
  return (root.all_event_masks & SubstructureRedirectMask) != 0;
}

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
