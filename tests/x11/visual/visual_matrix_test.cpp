#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_server.h"

#include <X11/Xutil.h>

#include "x11/server/canvas.h"
#include "x11/server/fill_polygons.h"
#include "x11/server/read_visuals.h"

namespace xnewell::THIS_FILE {

// Servers x visuals x tables x fills: what a picture looks like on each, compared with what the server's own
// answers say it should look like. And pictures of the program on gray visuals and those of few colours.

namespace {

constexpr Rect kPicture{0, 0, 160, 120};
constexpr Rect kInside{21, 9, 160, 120};  ///< where the server fills it, away from a tile's corner
constexpr Rect kChart{0, 0, 128, 128};    ///< an 8 x 8 block of each index

struct ServerRow {
  std::string_view name, command;
  std::string_view only = "";  ///< the class of visual to try; "" for all
  bool required = true;        ///< otherwise it may refuse to start: not every build knows the depth
};

const std::array kServers{
    ServerRow{"Xvfb8StaticGray", "Xvfb -screen 0 320x240x8 -cc 0", "StaticGray"},
    ServerRow{"Xvfb8GrayScale", "Xvfb -screen 0 320x240x8 -cc 1", "GrayScale"},
    ServerRow{"Xvfb8StaticColor", "Xvfb -screen 0 320x240x8 -cc 2", "StaticColor"},
    ServerRow{"Xvfb8PseudoColor", "Xvfb -screen 0 320x240x8 -cc 3"},
    ServerRow{"Xvfb8TrueColor", "Xvfb -screen 0 320x240x8 -cc 4", "TrueColor"},
    ServerRow{"Xvfb8DirectColor", "Xvfb -screen 0 320x240x8 -cc 5", "DirectColor"},
    ServerRow{"Xvfb15", "Xvfb -screen 0 320x240x15", "", false},
    ServerRow{"Xvfb16", "Xvfb -screen 0 320x240x16"},
    ServerRow{"Xvfb24", "Xvfb -screen 0 320x240x24"},
    ServerRow{"Xvfb24DirectColor", "Xvfb -screen 0 320x240x24 -cc 5", "DirectColor"},
    ServerRow{"Xvfb30", "Xvfb -screen 0 320x240x30", "", false},
    ServerRow{"Xephyr8", "Xephyr -screen 320x240x8"},  // inside another server
    ServerRow{"Xvnc565", "Xvnc -geometry 320x240 -SecurityTypes None -rfbport -1 -pixelformat rgb565"},
    ServerRow{"XvncBgr565", "Xvnc -geometry 320x240 -SecurityTypes None -rfbport -1 -pixelformat bgr565"},
    ServerRow{"XvncBgr888", "Xvnc -geometry 320x240 -SecurityTypes None -rfbport -1 -pixelformat bgr888"},
};

using Color = std::array<int, 3>;  ///< 8-bit values

Color shownOf(const XColor& c) { return {c.red >> 8, c.green >> 8, c.blue >> 8}; }
Color shownOf(const Rgb16& c) { return {c.r >> 8, c.g >> 8, c.b >> 8}; }

/// What pixel values of a visual show through a map, as the server says. See VisualInfo::withoutAlpha.
std::map<unsigned long, Color> asked(Display* d, Colormap map, const VisualInfo& v,
                                     const std::set<unsigned long>& pixels) {
  std::vector<XColor> cells;
  for (const unsigned long pixel : pixels)
    cells.push_back({.pixel = v.withoutAlpha(pixel), .red = 0, .green = 0, .blue = 0, .flags = 0, .pad = 0});
  XQueryColors(d, map, cells.data(), static_cast<int>(cells.size()));
  std::map<unsigned long, Color> colors;
  auto cell = cells.begin();
  for (const unsigned long pixel : pixels) colors[pixel] = shownOf(*cell++);
  return colors;
}

/// A part of a canvas's picture as pixel values.
std::vector<unsigned long> pixelsOf(const Canvas& canvas, const Rect& part) {
  const OwnedImage got = canvas.pixels(part);
  std::vector<unsigned long> pixels;
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) pixels.push_back(XGetPixel(got.get(), x, y));
  return pixels;
}

IndexImage chart() {
  IndexImage image{kChart.width, kChart.height, 0};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) image.row(y)[x] = static_cast<std::uint8_t>(y / 8 * 16 + x / 8);
  return image;
}

/// The pixel values of each index at each place of its tile.
std::array<Tile, 256> tilesOf(const std::vector<unsigned long>& chart) {
  std::array<Tile, 256> tiles;
  for (int y = 0; y < kChart.height; ++y)
    for (int x = 0; x < kChart.width; ++x)
      tiles[y / 8 * 16 + x / 8][y % 8 * 8 + x % 8] = chart[y * kChart.width + x];
  return tiles;
}

/// The levels that a visual can show in each channel if channels are independent, or else its colours.
struct Offered {
  std::array<std::vector<int>, 3> levels;  ///< ascending
  std::vector<Color> colors;               ///< where there are no channels
};
Offered offeredBy(Display* d, Colormap map, const VisualInfo& v) {
  Offered offered;
  std::set<unsigned long> pixels;
  if (!v.hasChannels()) {
    for (unsigned long p = 0; p < 256; ++p) pixels.insert(p);
    for (const auto& [pixel, color] : asked(d, map, v, pixels)) offered.colors.push_back(color);
    return offered;
  }
  const std::array masks{v.masks.red, v.masks.green, v.masks.blue};
  for (int c = 0; c < 3; ++c) {
    const unsigned long unit = masks[c] & -masks[c];
    pixels.clear();
    for (unsigned long p = 0; p <= masks[c]; p += unit) pixels.insert(p);
    for (const auto& [pixel, color] : asked(d, map, v, pixels)) offered.levels[c].push_back(color[c]);
    std::ranges::sort(offered.levels[c]);
  }
  return offered;
}

int distance(const Color& p, const Color& q) {
  int sum = 0;
  for (int c = 0; c < 3; ++c) sum += (p[c] - q[c]) * (p[c] - q[c]);
  return sum;
}

/// The least distance from anything on offer.
int leastDistance(const Offered& offered, const Color& wanted) {
  int least = 1 << 30;
  for (const Color& c : offered.colors) least = std::min(least, distance(c, wanted));
  if (!offered.colors.empty()) return least;
  least = 0;
  for (int c = 0; c < 3; ++c) {
    int nearest = 1000;
    for (const int level : offered.levels[c]) nearest = std::min(nearest, std::abs(level - wanted[c]));
    least += nearest * nearest;
  }
  return least;
}

/// The widest step between neighbouring levels of a channel.
int widestStep(const Offered& offered, int channel) {
  std::set<int> levels(offered.levels[channel].begin(), offered.levels[channel].end());
  for (const Color& c : offered.colors) levels.insert(c[channel]);
  int step = 0;
  for (auto next = std::next(levels.begin()); next != levels.end(); ++next)
    step = std::max(step, *next - *std::prev(next));
  return step;
}

/// One visual of each kind that a server has, the default one first.
std::vector<VisualInfo> kindsOf(const ServerVisuals& server, std::string_view only) {
  std::vector<VisualInfo> kinds{server.defaultVisual()};
  for (const VisualInfo& v : server.visuals)
    if (std::ranges::none_of(kinds, [&](const VisualInfo& k) {
          return k.kind == v.kind && k.depth == v.depth && k.masks == v.masks && k.bitsPerRgb == v.bitsPerRgb;
        }))
      kinds.push_back(v);
  std::erase_if(kinds, [&](const VisualInfo& v) { return !v.name().starts_with(only); });
  return kinds;
}

/// One picture and its colours, with the indices that each fill gives it.
struct KnownPicture {
  TableKind table;
  Picture picture;
  Palette palette;
  IndexImage scanline, filled;
};

/// What XFillPolygon fills, as indices. The visual's pixel values are the indices.
IndexImage filledBy(Display* d, const Picture& picture, const Palette& palette) {
  ServerColormap colormap{d, chooseVisual(readVisuals(d), parseVisualWish("PseudoColor8"))};
  colormap.store(palette);
  Canvas canvas{d, colormap, {.width = kPicture.width, .height = kPicture.height}};
  fillPolygons(d, canvas, picture, kPicture, CellPlan{}[Cell::Well]);
  IndexImage image{kPicture.width, kPicture.height, 0};
  std::ranges::transform(pixelsOf(canvas, kPicture), image.pixels.begin(),
                         [](unsigned long p) { return static_cast<std::uint8_t>(p); });
  return image;
}

/// Three tables and hues of a teapot whose polygons penetrate each other.
const std::vector<KnownPicture>& references() {
  static std::vector<KnownPicture> made;
  if (!made.empty()) return made;
  const XServer server = XServer::xvfb(8, 320, 240);
  const OwnedDisplay display = openDisplay(server.name());
  for (const TableRow& row : kTables) {
    PictureSettings settings;
    settings.width = kPicture.width;
    settings.height = kPicture.height;
    settings.inPixels = true;
    settings.table.kind = row.id;
    settings.table.hue = row.id == TableKind::Brief    ? glm::dvec3{1, 0, 0}
                         : row.id == TableKind::Linear ? glm::dvec3{0.4, 1, 0.7}
                                                       : glm::dvec3{1, 1, 1};
    const Picture picture = makePicture(readScene("teapot", 3), settings, CellPlan{row.id}[Cell::Well]);
    KnownPicture reference{row.id, picture, picture.palette(CellPlan{row.id}), picture.image(), {}};
    reference.filled = filledBy(display.get(), picture, reference.palette);
    made.push_back(std::move(reference));
  }
  return made;
}

std::ostream& operator<<(std::ostream& out, const ServerRow& row) { return out << row.name; }

}  // namespace

class VisualMatrix : public testing::TestWithParam<ServerRow> {
 protected:
  TemporaryFolder folder;
  std::optional<XServer> host, server;
  OwnedDisplay display;

  void SetUp() override {
    const ServerRow& row = GetParam();
    std::vector<std::string> arguments = words(std::string{row.command});
    const std::string program = arguments[0];
    arguments.erase(arguments.begin());
    if (program == "Xephyr") host.emplace(XServer::xvfb(24, 640, 480));
    if (program == "Xvnc")  // from 1.15 on, TigerVNC needs a socket if it has no port
      arguments.insert(arguments.end(), {"-rfbunixpath", folder.file("vnc")});
    try {
      server.emplace(program, arguments, host ? host->name() : "");
    } catch (const std::runtime_error& e) {
      if (row.required) throw;
      GTEST_SKIP() << e.what();
    }
    display = openDisplay(server->name());
  }

  /// Checks that the tiles show what they should on a visual of this kind.
  void expectTiles(const std::array<Tile, 256>& tiles, const KnownPicture& reference,
                   const ServerColormap& colormap, bool dither) {
    const VisualInfo& v = colormap.visual();
    std::set<unsigned long> pixels;
    for (const Tile& tile : tiles) pixels.insert(tile.begin(), tile.end());
    const std::map<unsigned long, Color> shows = asked(display.get(), colormap.id(), v, pixels);
    const Offered offered = offeredBy(display.get(), colormap.id(), v);
    for (int c = 0; c < 3 && v.hasChannels() && v.depth < 24;
         ++c)  // levels are evenly spaced, as far as 6 bits of a stored colour allow
      EXPECT_LE(widestStep(offered, c), 255 / (std::ssize(offered.levels[c]) - 1) + 5);
    const CellPlan plan{reference.table};
    std::set<int> tool;
    for (int role = 0; role < kCells; ++role) tool.insert(plan[static_cast<Cell>(role)]);
    const bool exact = v.kind == VisualClass::PseudoColorClass || v.depth >= 24;
    int mixed = 0;
    for (int i = 0; i < 256; ++i) {
      SCOPED_TRACE(i);
      Color wanted = shownOf(reference.palette[i]);
      if (v.gray()) {
        const Rgb16 c = reference.palette[i];
        wanted.fill(static_cast<int>((30L * c.r + 59L * c.g + 11L * c.b) / 100 >> 8));
      }
      const std::set<unsigned long> used(tiles[i].begin(), tiles[i].end());
      mixed += used.size() > 1;
      if (exact || v.gray()) {  // there are 256 grays, which is all
        ASSERT_EQ(used.size(), 1u);
        ASSERT_EQ(shows.at(*used.begin()), wanted);
      } else if (tool.contains(i)) {  // emulation_test.cpp checks which colour
        ASSERT_EQ(used.size(), 1u);
      } else if (!dither) {
        ASSERT_EQ(used.size(), 1u);
        ASSERT_EQ(distance(shows.at(*used.begin()), wanted), leastDistance(offered, wanted));
      } else {
        for (int c = 0; c < 3; ++c) {
          int sum = 0;
          for (const unsigned long pixel : tiles[i]) sum += shows.at(pixel)[c];
          ASSERT_LE(2 * std::abs(sum - 64 * wanted[c]), widestStep(offered, c));
        }
      }
    }
    EXPECT_EQ(mixed > 100, !exact && !v.gray() && dither);
  }
};
INSTANTIATE_TEST_SUITE_P(Servers, VisualMatrix, testing::ValuesIn(kServers),
                         [](const auto& made) { return std::string{made.param.name}; });

// Each index is shown as its visual's class allows, on every visual of every server and with every table. On
// PseudoColor, and where channels have 8 bits, it has exactly its colour. On gray visuals it has its gray.
// Elsewhere it has the nearest colour or, dithered, colours whose mean is right within 1/128 of the widest
// step. A picture consists of these tiles, pixel for pixel, whether we fill the polygons or the server does.
TEST_P(VisualMatrix, ShowsEveryIndexAsItsClassAllows) {
  Display* d = display.get();
  const ServerVisuals visuals = readVisuals(d);
  const int strays = strayErrors();
  std::string covered;
  for (const VisualInfo& v : kindsOf(visuals, GetParam().only))
    for (const bool dither : {true, false}) {
      SCOPED_TRACE(testing::Message() << v.name() << (dither ? ", dithered" : ", nearest"));
      if (dither) covered += (covered.empty() ? "" : ", ") + v.name();
      ServerColormap colormap{d, {v, ""}, {.dither = dither}};
      Canvas canvas{d, colormap, {.width = 190, .height = 140}};
      bool mixed = false;
      for (const KnownPicture& reference : references()) {
        SCOPED_TRACE(kTables[static_cast<int>(reference.table)].name);
        colormap.store(reference.palette, CellPlan{reference.table});
        mixed |= colormap.table().dithers();
        canvas.upload(chart(), kChart);
        const std::array<Tile, 256> tiles = tilesOf(pixelsOf(canvas, kChart));
        expectTiles(tiles, reference, colormap, dither);
        if (HasFatalFailure()) return;

        const auto shows = [&](const IndexImage& image, const Rect& area) {
          const std::vector<unsigned long> pixels = pixelsOf(canvas, area);
          for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
              if (pixels[y * image.width + x] !=
                  tiles[image.row(y)[x]][(area.y + y) % 8 * 8 + (area.x + x) % 8])
                return false;
          return true;
        };
        canvas.upload(reference.scanline, kPicture);
        EXPECT_TRUE(shows(reference.scanline, kPicture));
        canvas.upload(reference.scanline,
                      {13, 7, 50, 40});  // tiles keep their places when only a part is uploaded
        EXPECT_TRUE(shows(reference.scanline, kPicture));
        const RgbImage read = canvas.readBack(kPicture);
        const std::vector<unsigned long> pixels = pixelsOf(canvas, kPicture);
        const std::map<unsigned long, Color> colors =
            asked(d, colormap.id(), v, {pixels.begin(), pixels.end()});
        for (std::size_t k = 0; k < pixels.size(); ++k)
          for (int c = 0; c < 3; ++c) ASSERT_EQ(read.rgb[3 * k + c], colors.at(pixels[k])[c]);
        fillPolygons(d, canvas, reference.picture, kInside, CellPlan{reference.table}[Cell::Well]);
        EXPECT_TRUE(shows(reference.filled, kInside));
        EXPECT_FALSE(shows(reference.scanline, kInside));
      }
      EXPECT_EQ(colormap.account().find("mixed") != std::string::npos, mixed) << colormap.account();
    }
  XSync(d, 0);
  EXPECT_EQ(strayErrors(), strays);
  ASSERT_FALSE(covered.empty());
  std::cout << "covered: " << GetParam().name << " (" << covered << ")\n";
}

// On every visual class the window follows its keys. It shows what a fresh start with the new hue shows, and
// then what a fresh start with the server filling shows.
TEST(FewColors, TheWindowFollows) {
  for (int defaultClass = 0; defaultClass < 6; ++defaultClass) {
    const XServer server = XServer::xvfb(8, 1280, 1024, {"-cc", std::to_string(defaultClass)});
    const std::string visual{kVisualClasses[defaultClass].name};
    SCOPED_TRACE(visual);
    const std::string line = "teapot --divisions 3 --visual " + visual;
    const WatchedViewer viewer{server, line};
    const Rect seen = aboveStatus(1024, 768);
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line), seen));
    viewer.window.type("H");
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line + " --hue 1,0.7,0"), seen));
    viewer.window.type("uF");
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line + " --fill x11"), seen));
    viewer.window.type("H");  // what the server fills follows, too
    EXPECT_TRUE(viewer.window.comesToShow(freshWindow(server, line + " --hue 1,0.7,0 --fill x11"), seen));
  }
}

}  // namespace xnewell::THIS_FILE
