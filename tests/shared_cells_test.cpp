#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/watched_viewer.h"
#include "tests/x_session.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

#include "x11/canvas.h"
#include "x11/viewer.h"

using testing::HasSubstr;

// Cells of the default map beside other programs: few of them, none, and others who change what they please.

namespace {

/// While there is one, the server refuses new colormaps.
struct NoMoreColormaps {
  static inline int alive = 0;
  NoMoreColormaps() { ++alive; }
  ~NoMoreColormaps() { --alive; }
};

using Cells = std::vector<unsigned long>;

/// Another program with cells of its own in the default map, in colours of no use to anybody else.
class Stranger {
 public:
  /// Takes all free cells but `left`.
  Stranger(const XServer& server, std::size_t left) : display_{openDisplay(server.name())} {
    cells_ = freeCells();
    XFreeColors(get(), map(), cells_.data(), static_cast<int>(left), 0);
    cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(left));
    paint(1);
  }
  [[nodiscard]] ::Display* get() const { return display_.get(); }
  [[nodiscard]] ::Colormap map() const { return DefaultColormap(get(), 0); }

  /// How many cells are free now: by taking them one by one.
  [[nodiscard]] std::size_t countFree() const {
    Cells cells = freeCells();
    XFreeColors(get(), map(), cells.data(), static_cast<int>(cells.size()), 0);
    XSync(get(), 0);
    return cells.size();
  }
  /// Other colours in its cells.
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
  /// Gives its cells back, and somebody else takes and paints them.
  void leave() {
    XFreeColors(get(), map(), cells_.data(), static_cast<int>(cells_.size()), 0);
    cells_ = freeCells();
    paint(2);
  }
  [[nodiscard]] const Cells& cells() const { return cells_; }

 private:
  [[nodiscard]] Cells freeCells() const {
    Cells cells;
    for (unsigned long pixel = 0; XAllocColorCells(get(), map(), 0, nullptr, 0, &pixel, 1) != 0;)
      cells.push_back(pixel);
    return cells;
  }
  OwnedDisplay display_;
  Cells cells_;
};

ServerColormap sharedOn(::Display* display, int shades = kMaxShades) {
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

/// The mean difference of a channel between two pictures' blocks of 8 x 8 pixels, each block's mean for it.
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

/// Stands before Xlib's: BadAlloc comes from the server, for a pixmap that is too large.
extern "C" ::Colormap XCreateColormap(::Display* display, ::Window window, ::Visual* visual, int allocated) {
  if (NoMoreColormaps::alive > 0) return XCreatePixmap(display, window, 40'000, 1, 1);
  using Create = ::Colormap (*)(::Display*, ::Window, ::Visual*, int);
  static const auto xlibs = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "XCreateColormap"));
  return xlibs(display, window, visual, allocated);
}

// A program that shares gets all the cells that are left, and shows its shades exactly and live. With none,
// or with so few that the map's colours show more, it mixes those: of RENDER's there are many, without it
// only black and white, and no mixture has a hue. It tells what it does, and gives everything back.
TEST(SharedCells, TakesWhatIsFreeAndGivesItBack) {
  for (const bool render : {true, false})
    for (const std::size_t left : {0, 1, 2, 3, 7, 50, 183}) {
      SCOPED_TRACE(testing::Message() << left << (render ? "" : ", no RENDER"));
      Session s{XServer::xvfb(
          8, 640, 480,
          render ? std::vector<std::string>{} : std::vector<std::string>{"-extension", "RENDER"})};
      ::Display* d = s.display.get();
      const Stranger stranger{s.server, left};
      ASSERT_EQ(stranger.countFree(), left);
      {
        ServerColormap map = sharedOn(d);
        EXPECT_EQ(map.id(), DefaultColormap(d, 0));
        EXPECT_FALSE(map.identity());
        ASSERT_EQ(map.live(), left >= (render ? 50u : 2u));
        const int shades = map.mostShades();
        if (map.live()) {
          // All are taken: a quarter at most for the tool, which needs 14 besides black and white.
          EXPECT_EQ(stranger.countFree(), 0u);
          EXPECT_GE(shades, static_cast<int>(left - std::min<std::size_t>(left / 4, 14)));
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
        // Black and white are there always, and text stands out from the paper.
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

// Nobody needs more cells than it has shades: the others stay free.
TEST(SharedCells, TakesNoMoreThanItNeeds) {
  Session s{XServer::xvfb(8)};
  const Stranger stranger{s.server, 183};
  const ServerColormap map = sharedOn(s.display.get(), 64);
  EXPECT_EQ(map.mostShades(), 64);
  EXPECT_EQ(map.shortfall(), "");
  EXPECT_THAT(map.account(), HasSubstr("shared map, 64 of 64 shades"));
  EXPECT_GE(stranger.countFree(), 183u - 64 - 14);
}

// What others do to the map does not show: they change their cells, free them, and others take those.
TEST(SharedCells, OthersCannotChangeWhatWeShow) {
  for (const std::size_t left : {0, 20}) {
    SCOPED_TRACE(left);
    Session s{XServer::xvfb(8)};
    ::Display* d = s.display.get();
    Stranger stranger{s.server, left};
    ASSERT_GT(stranger.cells().size(), 100u);
    ServerColormap map = sharedOn(d);
    // All 240 shades, also those without a cell, in colours that would suit the stranger's.
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

// A map of our own that has too few cells for the table is used the same way: as if of depth 4, which no
// server at hand has.
TEST(SharedCells, SmallMapsOfOurOwn) {
  Session s{XServer::xvfb(8)};
  ::Display* d = s.display.get();
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

// A second program on the same server has what the first left, and all of it once that has gone.
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
  EXPECT_GE(sharedOn(s.display.get()).mostShades(), 169);
}

// Where the default map cannot be written there are no cells to share: its colours are used, and that is
// told.
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

// On a DirectColor screen cells are shared too: of each channel.
TEST(SharedCells, OnDirectColor) {
  Session s{XServer::xvfb(24, 640, 480, {"-cc", "5"})};
  ::Display* d = s.display.get();
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
    // The tool's colours have cells too: a pixel value there is no colour.
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

// Where a channel has few levels, all of them that can be had are shared: in a fresh map as many colours as a
// map of our own would have, and no flashing; beside a stranger fewer, of which black and white are two.
TEST(SharedCells, LevelsOfDirectColor) {
  std::size_t before = 257;
  for (const bool beside : {false, true}) {
    SCOPED_TRACE(beside);
    Session s{XServer::xvfb(8, 640, 480, {"-cc", "5"})};
    ::Display* d = s.display.get();
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
      // Nobody can change what they show.
      const std::vector<unsigned long> pixels{used.begin(), used.end()};
      const PixelColors shows{d, map.id(), map.visual()};
      if (stranger) stranger->paint(3);
      const PixelColors now{d, map.id(), map.visual()};
      for (const unsigned long pixel : pixels) EXPECT_EQ(shows(pixel), now(pixel));
      EXPECT_GE(pixels.size(), 4u);
    }
    XSync(d, 0);
    if (!beside) {
      EXPECT_EQ(Stranger(s.server, 0).cells().size(), 2u);  // all given back
    }
  }
}

// The program itself, beside a stranger who has taken nearly everything: always a picture, always told in one
// line, nothing of BadAlloc, and nothing left behind. Where it has cells the picture is the one of so many
// shades.
TEST(SharedCells, AlwaysAPictureAlwaysTold) {
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

// Seen from where 8 x 8 pixels are one spot, some free cells never show less of a picture than none do: where
// several hues would have too few shades each, or a channel has few levels, the map's colours are mixed as
// with none.
TEST(SharedCells, FewCellsShowNoLessThanNone) {
  struct Case {
    int defaultClass;
    std::string scene;
    std::vector<std::size_t> left;  ///< so many that only black and white serve, then more
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
      EXPECT_LE(missed, none) << left;
    }
    EXPECT_GT(none, 0.0);
  }
}

// A scene that is opened in the window is shown as a start with it would: few cells are a ramp for one hue,
// and for several the map's colours are mixed; and for one hue again a ramp.
TEST(SharedCells, AreDividedAnewForAnotherScene) {
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
  EXPECT_EQ(stranger.countFree(), 0u);
  const auto open = [&](const std::string& scene) {
    viewer.window.type("e");
    for (int k = 0; k < 20; ++k) viewer.window.press(XK_BackSpace);
    viewer.window.type(scene);
    viewer.window.press(XK_Return);
  };
  open("hues");
  EXPECT_TRUE(viewer.window.comesToShow(hues, seen));
  EXPECT_GT(stranger.countFree(), 30u);  // the ramp is given back
  open("teapot");
  EXPECT_TRUE(viewer.window.comesToShow(teapot, seen));
  EXPECT_EQ(stranger.countFree(), 0u);
}

// In the window the status line tells the shades, and a new hue is stored and nothing drawn.
TEST(SharedCells, StoringShowsInTheWindow) {
  struct Case {
    int depth;
    std::string line;
  };
  for (const Case& at : {Case{8, "--colormap shared"}, Case{24, "--visual DirectColor24"}}) {
    SCOPED_TRACE(at.line);
    const XServer server = XServer::xvfb(at.depth, 1280, 1024);
    const WatchedViewer viewer{server, "teapot --divisions 3 " + at.line};
    ASSERT_TRUE(viewer.window.settles());
    RequestRecord record{server, viewer.window.id()};
    viewer.window.type("H");
    EXPECT_TRUE(comesTrue([&] { return record.count(X_StoreColors) == 1; }));
    EXPECT_EQ(record.drawing(), 0);
    viewer.window.press(XK_Right);
    EXPECT_TRUE(comesTrue([&] { return record.drawing() > 0; }));
  }
}

// Where the server has no room for another colormap, the default one serves, and that is told; insisting on a
// visual that it is not for is refused.
TEST(SharedCells, ServeWhereNoMapCanBeMade) {
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  const XServer server = XServer::xvfb(8);
  ASSERT_EQ(setenv("DISPLAY", server.name().c_str(), 1), 0);
  const NoMoreColormaps from;
  const auto snapshot = [&](const std::string& more) {
    const std::vector<std::string> line = words("xnewell snapshot cycle --size 160x120 -o " + file + more);
    std::vector<const char*> arguments;
    for (const std::string& word : line) arguments.push_back(word.c_str());
    const Options options = parseOptions(static_cast<int>(line.size()), arguments.data()).value();
    testing::internal::CaptureStderr();
    try {
      takeSnapshot(options, readScene(options.scene, 3), 0.0);
    } catch (const X11Error& e) {
      return testing::internal::GetCapturedStderr() + "thrown: " + e.what();
    }
    return testing::internal::GetCapturedStderr();
  };
  const std::string told = snapshot("");
  EXPECT_EQ(lines(told), 1u) << told;
  EXPECT_THAT(told, HasSubstr("xnewell: no colormap of our own ("));
  EXPECT_THAT(told, HasSubstr("BadAlloc"));
  EXPECT_THAT(told, HasSubstr("169 of 240 shades"));
  const RgbImage picture = readPng(file);
  EXPECT_EQ(snapshot(" --colormap shared"),
            "xnewell: the default colormap has free cells for 169 of 240 shades\n");
  EXPECT_EQ(readPng(file), picture);
  EXPECT_THAT(snapshot(" --visual StaticColor8"), testing::StartsWith("thrown: X_CreatePixmap: BadAlloc"));
  unsetenv("DISPLAY");
}
