#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_proxy.h"
#include "tests/x11/support/x_session.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

#include "x11/server/canvas.h"
#include "x11/server/read_visuals.h"

namespace xnewell::THIS_FILE {

using testing::AllOf;
using testing::HasSubstr;

// Sharing the cells of the default map with other programs: with few free cells, with none, and with programs
// that change cells.

namespace {

/// Another program with its own cells in the default map, in colours that are of no use to others.
class Stranger {
 public:
  /// Takes all free cells but `left`.
  Stranger(const XServer& server, std::size_t left) : display_{openDisplay(server.name())} {
    cells_ = freeCells();
    XFreeColors(get(), map(), cells_.data(), static_cast<int>(left), 0);
    cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(left));
    paint(1);
  }
  [[nodiscard]] Display* get() const { return display_.get(); }
  [[nodiscard]] Colormap map() const { return DefaultColormap(get(), 0); }

  /// The number of free cells now, found by taking them one by one.
  [[nodiscard]] std::size_t countFree() const {
    std::vector<unsigned long> cells = freeCells();
    XFreeColors(get(), map(), cells.data(), static_cast<int>(cells.size()), 0);
    XSync(get(), 0);
    return cells.size();
  }
  /// Puts other colours into its cells.
  void paint(unsigned seed) {
    std::mt19937 rng{seed};
    const auto value = [&] { return static_cast<unsigned short>(rng()); };
    for (const unsigned long pixel : cells_) {
      XColor cell{.pixel = pixel,
                  .red = value(),
                  .green = value(),
                  .blue = value(),
                  .flags = DoRed | DoGreen | DoBlue,
                  .pad = 0};
      XStoreColor(get(), map(), &cell);
    }
    XSync(get(), 0);
  }
  /// Gives its cells back, and another program takes and colours them.
  void leave() {
    XFreeColors(get(), map(), cells_.data(), static_cast<int>(cells_.size()), 0);
    cells_ = freeCells();
    paint(2);
  }
  [[nodiscard]] const std::vector<unsigned long>& cells() const { return cells_; }

 private:
  [[nodiscard]] std::vector<unsigned long> freeCells() const {
    std::vector<unsigned long> cells;
    for (unsigned long pixel = 0; XAllocColorCells(get(), map(), 0, nullptr, 0, &pixel, 1) != 0;)
      cells.push_back(pixel);
    return cells;
  }
  OwnedDisplay display_;
  std::vector<unsigned long> cells_;
};

ServerColormap sharedOn(Display* display, int shades = kMaxShades) {
  const VisualChoice choice = chooseVisual(readVisuals(display), {}, MapOwner::Shared);
  return ServerColormap{display, choice, {.owner = MapOwner::Shared, .shades = shades}};
}

Palette rampOf(int shades, glm::dvec3 hue = {1, 0, 0}) {
  return makePalette(CellPlan{}, ColorTable{{.shades = shades, .hue = hue}});
}

IndexImage rampImage(int shades) {
  IndexImage image{shades, 8, 0};
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < shades; ++x) image.row(y)[x] = static_cast<std::uint8_t>(11 + x);
  return image;
}

/// The colours of a row of pixels.
std::vector<std::array<int, 3>> firstRow(const RgbImage& image) {
  std::vector<std::array<int, 3>> row;
  for (int x = 0; x < image.width; ++x)
    row.push_back({image.pixel(x, 0)[0], image.pixel(x, 0)[1], image.pixel(x, 0)[2]});
  return row;
}

/// The mean difference of a channel between two pictures, each taken as the means of its blocks of 8 x 8
/// pixels.
double missOfBlocks(const RgbImage& seen, const RgbImage& wanted) {
  double sum = 0;
  int blocks = 0;
  for (int top = 0; top < wanted.height; top += 8)
    for (int left = 0; left < wanted.width; left += 8)
      for (int c = 0; c < 3; ++c, ++blocks) {
        int owed = 0;
        for (int k = 0; k < 64; ++k)
          owed += seen.pixel(left + k % 8, top + k / 8)[c] - wanted.pixel(left + k % 8, top + k / 8)[c];
        sum += std::abs(owed) / 64.0;
      }
  return sum / blocks;
}

std::size_t lines(const std::string& text) { return std::ranges::count(text, '\n'); }

}  // namespace

// A program that shares gets all free cells, shows its shades exactly, and can change them live. With no free
// cells, or with so few that the map's colours show more, it mixes the map's colours. RENDER's map has many;
// without RENDER there are only black and white, and no mixture has a hue. The program tells what it does,
// and gives all cells back.
TEST(SharedCells, TakesWhatIsFreeAndGivesItBack) {
  for (const bool render : {true, false})
    for (const std::size_t left : {0, 1, 2, 3, 7, 50, 183}) {
      SCOPED_TRACE(testing::Message() << left << (render ? "" : ", no RENDER"));
      Session s{XServer::xvfb(
          8, 640, 480,
          render ? std::vector<std::string>{} : std::vector<std::string>{"-extension", "RENDER"})};
      Display* d = s.display.get();
      const Stranger stranger{s.server, left};
      ASSERT_EQ(stranger.countFree(), left);
      {
        ServerColormap map = sharedOn(d);
        EXPECT_EQ(map.id(), DefaultColormap(d, 0));
        EXPECT_FALSE(map.identity());
        ASSERT_EQ(map.live(), left >= (render ? 50u : 2u));
        const int shades = map.mostShades();
        if (map.live()) {
          // At most a quarter is for the tool, which needs 14 besides black and white. Another quarter, at
          // most 16, stays free for programs that start later.
          const std::size_t others = std::min<std::size_t>(left / 4, 16);
          EXPECT_EQ(stranger.countFree(), others);
          EXPECT_GE(shades, static_cast<int>(left - std::min<std::size_t>(left / 4, 14) - others));
          EXPECT_LE(shades, static_cast<int>(left));
          EXPECT_THAT(map.account(), HasSubstr("shared map, " + std::to_string(shades) + " of 240 shades"));
          EXPECT_THAT(map.shortfall(), HasSubstr(std::to_string(shades) + " of 240 shades"));
        } else {
          EXPECT_EQ(shades, kMaxShades);
          EXPECT_GE(stranger.countFree(), left - left / 4);
          EXPECT_THAT(map.account(), HasSubstr(left < 2 ? "no cell free, colours mixed"
                                                        : "too few cells free, colours mixed"));
          EXPECT_THAT(map.shortfall(), HasSubstr(left < 2 ? "no free cells" : "free cells for "));
          EXPECT_THAT(map.shortfall(), HasSubstr("its colours are mixed"));
        }
        Canvas canvas{d, map, {.width = shades, .height = 8}};
        const Rect all{0, 0, shades, 8};
        for (const glm::dvec3 hue : {glm::dvec3{1, 0, 0}, glm::dvec3{0.5, 1, 0.25}}) {
          const Palette palette = rampOf(shades, hue);
          const bool again = map.store(palette);
          if (hue.r == 1 || again) canvas.present(rampImage(shades), all);
          EXPECT_TRUE(hue.r == 1 || again != map.live());
          const std::vector<std::array<int, 3>> row = firstRow(canvas.readBack(all));
          for (int j = 0; map.live() && j < shades; ++j) {
            const Rgb16 c = palette[11 + j];
            ASSERT_EQ(row[j], (std::array<int, 3>{c.r >> 8, c.g >> 8, c.b >> 8})) << j;
          }
          EXPECT_GE(std::set(row.begin(), row.end()).size(), 2u);
        }
        // Black and white are always there, and text stands out from the paper.
        const Palette shown = map.shown();
        const CellPlan plan;
        EXPECT_EQ(shown[plan[Cell::Black]], (Rgb16{0, 0, 0}));
        EXPECT_EQ(shown[plan[Cell::White]], (Rgb16{0xFFFF, 0xFFFF, 0xFFFF}));
        for (const Cell text : {Cell::Faint, Cell::Soft, Cell::Ink, Cell::Good, Cell::Alarm, Cell::P})
          for (const Cell ground : {Cell::Paper, Cell::Panel, Cell::White})
            EXPECT_GT(grayOf(shown[plan[ground]]).r - grayOf(shown[plan[text]]).r, 0x2000)
                << static_cast<int>(text);
        EXPECT_GT(grayOf(shown[plan[Cell::WellText]]).r - grayOf(shown[plan[Cell::Well]]).r, 0x2000);
      }
      XSync(d, 0);
      EXPECT_EQ(stranger.countFree(), left);
    }
}

// A program takes no more cells than it has shades. The others stay free.
TEST(SharedCells, TakesNoMoreThanItNeeds) {
  Session s{XServer::xvfb(8)};
  const Stranger stranger{s.server, 183};
  const ServerColormap map = sharedOn(s.display.get(), 64);
  EXPECT_EQ(map.mostShades(), 64);
  EXPECT_EQ(map.shortfall(), "");
  EXPECT_THAT(map.account(), HasSubstr("shared map, 64 of 64 shades"));
  EXPECT_GE(stranger.countFree(), 183u - 64 - 14);
}

// The picture does not change when other programs change their cells, free them, and others take those.
TEST(SharedCells, OthersCannotChangeWhatWeShow) {
  for (const std::size_t left : {0, 20}) {
    SCOPED_TRACE(left);
    Session s{XServer::xvfb(8)};
    Display* d = s.display.get();
    Stranger stranger{s.server, left};
    ASSERT_GT(stranger.cells().size(), 100u);
    ServerColormap map = sharedOn(d);
    // All 240 shades, also those without a cell, in colours that would match the stranger's.
    Palette palette = distinctPalette();
    map.store(palette);
    Canvas canvas{d, map, {.width = 256, .height = 64}};
    const Rect all{0, 0, 256, 64};
    canvas.present(randomImage(256, 64, 1), all);
    const RgbImage before = canvas.readBack(all);
    stranger.paint(7);
    EXPECT_EQ(canvas.readBack(all), before);
    stranger.leave();
    EXPECT_EQ(canvas.readBack(all), before);
  }
}

// A map of our own with too few cells for the table is used in the same way. The test pretends a map of depth
// 4, which no server at hand has.
TEST(SharedCells, SmallMapsOfOurOwn) {
  Session s{XServer::xvfb(8)};
  Display* d = s.display.get();
  VisualInfo small = readVisuals(d).defaultVisual();
  small.cells = 16;
  ServerColormap map{d, {small, ""}};
  EXPECT_NE(map.id(), DefaultColormap(d, 0));
  EXPECT_TRUE(map.live());
  EXPECT_FALSE(map.identity());
  const int shades = map.mostShades();
  EXPECT_GE(shades, 12);  // a quarter is the tool's
  EXPECT_LE(shades, 16);
  EXPECT_THAT(map.account(), HasSubstr("private map, " + std::to_string(shades) + " of 240 shades"));
  EXPECT_EQ(map.shortfall(), "the colormap has free cells for " + std::to_string(shades) + " of 240 shades");
  const Palette palette = rampOf(shades);
  map.store(palette);
  const std::vector<XColor> cells = [&] {
    std::vector<XColor> asked;
    for (int j = 0; j < shades; ++j) {
      XColor cell{};
      cell.pixel = map.pixel(static_cast<std::uint8_t>(11 + j));
      asked.push_back(cell);
    }
    XQueryColors(d, map.id(), asked.data(), shades);
    return asked;
  }();
  for (int j = 0; j < shades; ++j) EXPECT_EQ(cells[j].red >> 8, palette[11 + j].r >> 8);
}

// A second program on the same server gets the cells that the first one left, and all cells once the first
// has ended.
TEST(SharedCells, TwoShare) {
  Session s{XServer::xvfb(8)};
  const OwnedDisplay other = openDisplay(s.server.name());
  auto first = std::make_unique<ServerColormap>(sharedOn(other.get(), 100));
  EXPECT_EQ(first->mostShades(), 100);
  {
    const ServerColormap second = sharedOn(s.display.get());
    EXPECT_TRUE(second.live());
    EXPECT_LT(second.mostShades(), 183 - 100 + 1);
    EXPECT_GT(second.mostShades(), 50);
  }
  first.reset();
  XSync(other.get(), 0);
  EXPECT_GE(sharedOn(s.display.get()).mostShades(), 153);
}

// If the default map cannot be written, there are no cells to share. Its colours are used, and the program
// says so.
TEST(SharedCells, FixedMapsAreEmulated) {
  for (const int defaultClass : {0, 2, 4}) {
    SCOPED_TRACE(defaultClass);
    Session s{XServer::xvfb(8, 640, 480, {"-cc", std::to_string(defaultClass)})};
    const ServerColormap map = sharedOn(s.display.get());
    EXPECT_FALSE(map.live());
    EXPECT_EQ(map.id(), DefaultColormap(s.display.get(), 0));
    EXPECT_THAT(map.shortfall(), HasSubstr("is not writable"));
  }
}

// On a DirectColor screen, the cells of each channel are shared too.
TEST(SharedCells, OnDirectColor) {
  Session s{XServer::xvfb(24, 640, 480, {"-cc", "5"})};
  Display* d = s.display.get();
  ASSERT_EQ(readVisuals(d).defaultVisual().name(), "DirectColor 24");
  {
    ServerColormap map = sharedOn(d);
    ASSERT_TRUE(map.live());
    const int shades = map.mostShades();
    EXPECT_GT(shades, 200);
    const Palette palette = rampOf(shades, {0.5, 1, 0.25});
    map.store(palette);
    Canvas canvas{d, map, {.width = shades, .height = 8}};
    canvas.present(rampImage(shades), {0, 0, shades, 8});
    const std::vector<std::array<int, 3>> row = firstRow(canvas.readBack({0, 0, shades, 8}));
    for (int j = 0; j < shades; ++j) {
      const Rgb16 c = palette[11 + j];
      ASSERT_EQ(row[j], (std::array<int, 3>{c.r >> 8, c.g >> 8, c.b >> 8})) << j;
    }
    // The tool's colours need cells too: a pixel value there is not a colour by itself.
    const Palette shown = map.shown();
    const CellPlan plan;
    for (int role = 0; role < kCells; ++role) {
      const int i = plan[static_cast<Cell>(role)];
      EXPECT_EQ(eightBits(shown[i]), eightBits(palette[i])) << role;
    }
  }
  XSync(d, 0);
  const std::size_t before = readVisuals(d, true).freeCells.value();
  EXPECT_GT(before, 240u);
}

// If a channel has few levels, all that are free are shared. A fresh map gives as many colours as our own map
// would, without flashing. Next to a stranger there are fewer, and two of them are black and white.
TEST(SharedCells, LevelsOfDirectColor) {
  std::size_t before = 257;
  for (const bool beside : {false, true}) {
    SCOPED_TRACE(beside);
    Session s{XServer::xvfb(8, 640, 480, {"-cc", "5"})};
    Display* d = s.display.get();
    std::optional<Stranger> stranger;
    if (beside) stranger.emplace(s.server, 0);
    std::set<unsigned long> used;
    {
      ServerColormap map = sharedOn(d);
      EXPECT_FALSE(map.live());
      EXPECT_EQ(map.id(), DefaultColormap(d, 0));
      map.store(rampOf(kMaxShades, {1, 1, 1}));
      for (int place = 0; place < 64; ++place)
        for (const unsigned long pixel : map.table().at(place)) used.insert(pixel);
      const std::string account = map.account();
      const std::size_t colors = std::stoul(account.substr(account.find("map, ") + 5));
      EXPECT_THAT(account, HasSubstr("colours, mixed"));
      EXPECT_THAT(map.shortfall(), HasSubstr("levels for " + std::to_string(colors) + " colours"));
      if (!beside) {
        EXPECT_EQ(colors, 256u);
      }
      EXPECT_LT(colors, before);
      EXPECT_GE(colors, 8u);
      before = colors;
      // Nobody can change what these cells show.
      const std::vector<unsigned long> pixels{used.begin(), used.end()};
      const PixelColors shows{d, map.id(), map.visual()};
      if (stranger) stranger->paint(3);
      const PixelColors now{d, map.id(), map.visual()};
      for (const unsigned long pixel : pixels) EXPECT_EQ(shows(pixel), now(pixel));
      EXPECT_GE(pixels.size(), 4u);
    }
    XSync(d, 0);
    if (!beside) {
      EXPECT_EQ(Stranger(s.server, 0).cells().size(), 2u);  // all cells are given back
    }
  }
}

// The program itself when it has few cells of the default map or none, or no map of its own.

// Next to a program that has taken nearly all cells, the program always gives a picture. It tells so in one
// line, does not mention BadAlloc, and leaves nothing behind. If it has cells, the picture is the one with
// that many shades.
TEST(SharedCellsProgram, AlwaysAPictureAlwaysTold) {
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  for (const std::size_t left : {0, 1, 50, 183})
    for (const std::string fill : {"scanline", "x11"}) {
      SCOPED_TRACE(testing::Message() << left << ' ' << fill);
      const XServer server = XServer::xvfb(8);
      const Stranger stranger{server, left};
      const std::string line = "teapot --divisions 3 --table corrected --size 160x120";
      const Finished done = runProgram(
          words("snapshot --colormap shared " + line + " --fill " + fill + " -o " + file), server.name());
      ASSERT_EQ(done.status, 0) << done.err;
      EXPECT_EQ(lines(done.err), 1u) << done.err;
      EXPECT_THAT(done.err, HasSubstr("xnewell: the default colormap has "));
      EXPECT_THAT(done.err, Not(HasSubstr("BadAlloc")));
      EXPECT_EQ(stranger.countFree(), left);
      const RgbImage picture = readPng(file);
      std::set<std::array<int, 3>> colors;
      for (std::size_t k = 0; k < picture.rgb.size(); k += 3)
        colors.insert({picture.rgb[k], picture.rgb[k + 1], picture.rgb[k + 2]});
      EXPECT_GT(colors.size(), 5u);
      if (left < 2 || fill == "x11") continue;
      const std::string told = done.err.substr(done.err.find(" for ") + 5);
      EXPECT_EQ(picture, pictureOf("draw " + line + " --shades " + told.substr(0, told.find(' '))));
    }
}

// Seen from so far that 8 x 8 pixels are one spot, a picture is never worse with some free cells than with
// none. If several hues would have too few shades each, or a channel has few levels, the map's colours are
// mixed as they are without free cells. That is decided by the colours that hues can have, not by the
// picture, so where both are about equally near the picture may be a tenth worse.
TEST(SharedCellsProgram, FewCellsShowNoLessThanNone) {
  struct Case {
    int defaultClass;
    std::string scene;
    std::vector<std::size_t> left;  ///< first so few that only black and white serve, then more
  };
  for (const Case& at :
       {Case{3, "hues", {0, 2, 20, 50, 100, 183}}, Case{5, "teapot --divisions 3", {0, 1, 2}}}) {
    SCOPED_TRACE(at.scene);
    const std::string line = at.scene + " --size 160x120";
    const RgbImage drawn = pictureOf("draw " + line);
    const TemporaryFolder folder;
    const std::string file = folder.file("picture.png");
    double none = 0;
    for (const std::size_t left : at.left) {
      const XServer server = XServer::xvfb(8, 640, 480, {"-cc", std::to_string(at.defaultClass)});
      const Stranger stranger{server, left};
      const Finished done =
          runProgram(words("snapshot --colormap shared " + line + " -o " + file), server.name());
      ASSERT_EQ(done.status, 0) << done.err;
      EXPECT_EQ(done.err.find("its colours are mixed") != std::string::npos, left < 183) << done.err;
      const double missed = missOfBlocks(readPng(file), drawn);
      if (left == 0) none = missed;
      EXPECT_LE(missed, left < 183 ? none : none * 1.1) << left;
    }
    EXPECT_GT(none, 0.0);
  }
}

// A scene that is opened in the window looks as if the program had started with it. Few cells make a ramp for
// one hue; for several hues the map's colours are mixed; and for one hue there is a ramp again.
TEST(SharedCellsProgram, AreDividedAnewForAnotherScene) {
  const XServer server = XServer::xvfb(8, 1280, 1024);
  const Stranger stranger{server, 50};
  const TemporaryFolder folder;
  const std::string shared = " --colormap shared", file = folder.file("window.png");
  const Rect seen = aboveStatus(1024, 768);
  const auto fresh = [&](const std::string& scene) {
    const Finished done =
        runProgram(words("snapshot --whole-window " + scene + shared + " -o " + file), server.name());
    EXPECT_EQ(done.err.find("its colours are mixed") != std::string::npos, scene == "hues") << done.err;
    return cropped(readPng(file), seen);
  };
  const RgbImage teapot = fresh("teapot"), hues = fresh("hues");
  const WatchedViewer viewer{server, "teapot" + shared};
  ASSERT_TRUE(viewer.window.comesToShow(teapot, seen));
  EXPECT_EQ(stranger.countFree(), 12u);  // left to others
  const auto open = [&](const std::string& scene) {
    viewer.window.type("e");
    for (int k = 0; k < 20; ++k) viewer.window.press(XK_BackSpace);
    viewer.window.type(scene);
    viewer.window.press(XK_Return);
  };
  open("hues");
  EXPECT_TRUE(viewer.window.comesToShow(hues, seen));
  EXPECT_GT(stranger.countFree(), 30u);  // the ramp is given back
  { const Stranger other{server, 0}; }   // it paints them and ends
  EXPECT_TRUE(comesTrue([&] { return stranger.countFree() > 30u; }));
  open("teapot");
  EXPECT_TRUE(viewer.window.comesToShow(teapot, seen));
  EXPECT_EQ(stranger.countFree(), 12u);  // left to others
}

// The window's status line tells the number of shades. A new hue is stored and nothing is drawn.
TEST(SharedCellsProgram, StoringShowsInTheWindow) {
  for (const auto& [depth, line] : {std::pair{8, "--colormap shared"}, {24, "--visual DirectColor24"}}) {
    SCOPED_TRACE(line);
    const XServer server = XServer::xvfb(depth, 1280, 1024);
    const WatchedViewer viewer{server, std::string{"teapot --divisions 3 "} + line};
    ASSERT_TRUE(viewer.window.settles());
    RequestRecord record{server, viewer.window.id()};
    viewer.window.type("H");
    EXPECT_TRUE(comesTrue([&] { return record.count(X_StoreColors) == 1; }));
    EXPECT_EQ(record.drawing(), 0);
    viewer.window.press(XK_Right);
    EXPECT_TRUE(comesTrue([&] { return record.drawing() > 0; }));
  }
}

// If the server has no room for another colormap, the default one is used, and the program says so. A visual
// that needs another map is refused.
TEST(SharedCellsProgram, ServeWhereNoMapCanBeMade) {
  const TemporaryFolder folder;
  const XServer server = XServer::xvfb(8);
  XProxy proxy{server};
  const auto snapshot = [&](const std::string& more) {
    proxy.begin(XFaultPlan{.request = {X_CreateColormap}});
    return runProgram(words("snapshot cycle --size 160x120 -o " + folder.file("picture.png") + more),
                      proxy.name());
  };
  const Finished refused = snapshot("");
  EXPECT_EQ(refused.status, 0);
  EXPECT_EQ(lines(refused.err), 1u) << refused.err;
  EXPECT_THAT(refused.err, testing::StartsWith("xnewell: the X server has no room for another colormap ("));
  EXPECT_THAT(refused.err, AllOf(HasSubstr("BadAlloc"), HasSubstr("153 of 240 shades")));
  const RgbImage picture = readPng(folder.file("picture.png"));
  EXPECT_EQ(
      snapshot(" --colormap shared").err,
      "xnewell: the default colormap has free cells for 153 of 240 shades, and some for other programs\n");
  EXPECT_EQ(readPng(folder.file("picture.png")), picture);
  const Finished needs = snapshot(" --visual StaticColor8");
  EXPECT_EQ(needs.status, 1);
  EXPECT_THAT(needs.err, testing::StartsWith("xnewell: X_CreateColormap: BadAlloc"));
}

}  // namespace xnewell::THIS_FILE
