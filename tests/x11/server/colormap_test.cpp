#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/x11/support/x_server.h"

#include "x11/server/colormap.h"
#include "x11/server/display.h"
#include "x11/server/read_visuals.h"

namespace xnewell::THIS_FILE {

using testing::AllOf;
using testing::HasSubstr;

// What the program has on a server: its colormap, and its connection with errors and resources.

namespace {

VisualChoice choiceOn(Display* display) { return chooseVisual(readVisuals(display)); }

/// The formulas again, in long double and with the C library: what shade j of N holds before the hue is
/// applied.
long double levelByFormula(TableKind kind, int j, int N, long double I0) {
  switch (kind) {
    case TableKind::Brief:
      return 239.0L * j / (N - 1) / 255;
    case TableKind::Linear:
      return (1 + 239.0L * j / (N - 1)) / 255;
    case TableKind::Corrected:
      return I0 * powl(1 / I0, static_cast<long double>(j) / (N - 1));
  }
  return -1;
}

/// The 8-bit value of v as stored with `bits`; nothing if rounding error could decide it.
std::optional<int> shownByFormula(long double v, int bits) {
  const long double scaled = (bits == 8 ? 255 : 65535) * v, low = floorl(scaled);
  if (fabsl(scaled - low - 0.5L) < 1e-9L) return std::nullopt;
  const int rounded = static_cast<int>(scaled - low < 0.5L ? low : low + 1);
  return (bits == 8 ? 257 * rounded : rounded) >> 8;
}

std::vector<XColor> cellsOf(Display* display, Colormap map) {
  std::vector<XColor> cells(256);
  for (unsigned i = 0; i < 256; ++i) cells[i].pixel = i;
  XQueryColors(display, map, cells.data(), 256);
  return cells;
}

bool sameColor(const XColor& a, const XColor& b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

/// The text of the X11Error that `f` throws; empty if it does not.
template <typename F>
std::string thrownBy(F f) {
  try {
    f();
  } catch (const X11Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

// The cells of the server's colormap hold what the tables define, for all tables, hues, numbers of shades,
// lowest intensities and both widths. The tool's cells and the unneeded ones hold what the palette says.
TEST(ServerColormap, HoldsTheTablesOfTheBook) {
  const XServer x = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(x.name());
  ServerColormap map{display.get(), choiceOn(display.get())};
  ASSERT_TRUE(map.live() && map.identity());
  int compared = 0, exempt = 0;
  for (const TableRow& row : kTables)
    for (const int shades : {2, 64, 240})
      for (const double I0 : {0.02, 0.0001, 0.25})
        for (const glm::dvec3 hue : {glm::dvec3{1, 0, 0}, glm::dvec3{0.2, 1, 0.6}, glm::dvec3{1, 1, 1}})
          for (const int bits : {8, 16}) {
            const ColorTable table{
                {.kind = row.id, .shades = shades, .I0 = I0, .pick = Pick::Log, .hue = hue, .bits = bits}};
            const Palette palette = makePalette(map.plan(row.id), table, map.unneeded());
            map.store(palette);
            const std::vector<XColor> cells = cellsOf(display.get(), map.id());
            for (int i = 0; i < 256; ++i) {
              ASSERT_EQ(cells[i].red >> 8, palette[i].r >> 8) << i;
              ASSERT_EQ(cells[i].green >> 8, palette[i].g >> 8) << i;
              ASSERT_EQ(cells[i].blue >> 8, palette[i].b >> 8) << i;
            }
            for (int j = 0; j < shades; ++j) {
              const XColor& cell = cells[row.first + j];
              const long double level = levelByFormula(row.id, j, shades, I0);
              const std::array<int, 3> shown{cell.red >> 8, cell.green >> 8, cell.blue >> 8};
              for (int channel = 0; channel < 3; ++channel) {
                const std::optional<int> expected = shownByFormula(level * hue[channel], bits);
                ++(expected ? compared : exempt);
                ASSERT_EQ(shown[channel], expected.value_or(shown[channel]))
                    << row.name << ' ' << shades << ' ' << j;
              }
            }
          }
  EXPECT_GT(compared, 40'000);
  EXPECT_EQ(exempt, 0);  // the settings above have no tie
}

// Black and white, and the cells that the ramp and the tool leave free, look as in the default map. This
// holds also after other shades have used them.
TEST(ServerColormap, UnneededCellsKeepTheDefaultColours) {
  const XServer x = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(x.name());
  Display* d = display.get();
  const std::vector<XColor> before = cellsOf(d, DefaultColormap(d, 0));
  ServerColormap map{d, choiceOn(d)};
  EXPECT_NE(map.id(), DefaultColormap(d, 0));
  for (unsigned i = 0; i < 256; ++i) EXPECT_TRUE(sameColor(cellsOf(d, map.id())[i], before[i])) << i;
  const CellPlan plan = map.plan(TableKind::Corrected);
  for (const int shades : {240, 64}) {
    map.store(
        makePalette(plan, ColorTable{{.kind = TableKind::Corrected, .shades = shades}}, map.unneeded()));
    const std::vector<XColor> now = cellsOf(d, map.id());
    EXPECT_TRUE(sameColor(now[BlackPixel(d, 0)], before[BlackPixel(d, 0)]));
    EXPECT_TRUE(sameColor(now[WhitePixel(d, 0)], before[WhitePixel(d, 0)]));
    for (int i = 11 + shades; i < 251; ++i) EXPECT_TRUE(sameColor(now[i], before[i])) << i;
  }
  for (unsigned i = 0; i < 256; ++i)
    EXPECT_TRUE(sameColor(cellsOf(d, DefaultColormap(d, 0))[i], before[i])) << i;
}

// A change of colours is one request. No change is no request.
TEST(ServerColormap, StoresOnceAndOnlyWhatChanged) {
  const XServer x = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(x.name());
  Display* d = display.get();
  ServerColormap map{d, choiceOn(d)};
  const CellPlan plan = map.plan(TableKind::Linear);
  const auto sent = [&](const Palette& palette) {
    const unsigned long before = NextRequest(d);
    EXPECT_FALSE(map.store(palette));  // a real map never needs a new picture
    return NextRequest(d) - before;
  };
  const Palette red = makePalette(plan, ColorTable{{}});
  Palette green = makePalette(plan, ColorTable{{.hue = {0, 1, 0}}});
  EXPECT_EQ(sent(red), 1u);
  EXPECT_EQ(sent(red), 0u);
  // Another program changes the map, which shows which cells a store touches.
  XColor mark{.pixel = 40,
              .red = 0x1111,
              .green = 0x2222,
              .blue = 0x3333,
              .flags = DoRed | DoGreen | DoBlue,
              .pad = 0};
  XStoreColor(d, map.id(), &mark);
  green[40] = red[40];
  EXPECT_EQ(sent(green), 1u);
  const Palette shown = map.shown();
  for (int i = 0; i < 256; ++i) EXPECT_EQ(shown[i].g >> 8, i == 40 ? 0x22 : green[i].g >> 8) << i;
}

// A default colormap without a free cell does no harm: our map is private.
TEST(ServerColormap, NeedsNoFreeCell) {
  const XServer x = XServer::xvfb(8);
  const OwnedDisplay greedy = openDisplay(x.name()), display = openDisplay(x.name());
  std::vector<unsigned long> cells(256);
  for (int i = 0; i < 256; ++i)
    if (!XAllocColorCells(greedy.get(), DefaultColormap(greedy.get(), 0), 0, nullptr, 0, &cells[i], 1)) break;
  XSync(greedy.get(), 0);
  const ServerVisuals server = readVisuals(display.get(), true);
  ASSERT_EQ(server.freeCells, 0);
  ServerColormap map{display.get(), chooseVisual(server)};
  const Palette palette = makePalette(map.plan(TableKind::Linear), ColorTable{{.hue = {1, 1, 1}}});
  map.store(palette);
  for (int i = 0; i < 256; ++i) EXPECT_EQ(map.shown()[i].b >> 8, palette[i].b >> 8);
}

// If the default visual is another class of depth 8, its colours are still copied cell by cell. If it is
// deeper, its pixels mean nothing in our map, and the plan is the usual one.
TEST(ServerColormap, PlansForTheDefaultVisual) {
  for (int defaultClass = 0; defaultClass < 6; ++defaultClass) {
    SCOPED_TRACE(defaultClass);
    const XServer x = XServer::xvfb(8, 640, 480, {"-cc", std::to_string(defaultClass)});
    const OwnedDisplay display = openDisplay(x.name());
    Display* d = display.get();
    ServerColormap map{d, choiceOn(d)};
    ASSERT_TRUE(map.live() && map.identity());
    const std::vector<XColor> copied = cellsOf(d, map.id());
    for (const unsigned long pixel : {BlackPixel(d, 0), WhitePixel(d, 0)}) {
      XColor wanted{};
      wanted.pixel = pixel;
      XQueryColor(d, DefaultColormap(d, 0), &wanted);
      EXPECT_TRUE(sameColor(copied[pixel], wanted)) << pixel;
    }
  }
  const XServer x = XServer::xvfb(24);
  const OwnedDisplay display = openDisplay(x.name());
  const ServerColormap map{display.get(), choiceOn(display.get())};
  EXPECT_EQ(map.plan(TableKind::Brief), CellPlan{TableKind::Brief});
}

// In an emulated map, index i has the pixel whose channels are the palette's high bits. A change needs a new
// picture, no change needs none, and neither makes a request. Alpha, where there is any, is opaque.
TEST(ServerColormap, EmulatesTheTable) {
  const XServer x = XServer::xvfb(24);
  const OwnedDisplay display = openDisplay(x.name());
  Display* d = display.get();
  const ServerVisuals server = readVisuals(d);
  for (const char* wish : {"TrueColor24", "TrueColor32"}) {
    SCOPED_TRACE(wish);
    ServerColormap map{d, chooseVisual(server, parseVisualWish(wish))};
    EXPECT_FALSE(map.live());
    EXPECT_EQ(map.id() == DefaultColormap(d, 0), std::string{wish} == "TrueColor24");
    const Palette palette = makePalette(map.plan(TableKind::Linear), ColorTable{{.hue = {0.5, 0.25, 1}}});
    const unsigned long before = NextRequest(d);
    EXPECT_TRUE(map.store(palette));
    EXPECT_FALSE(map.store(palette));
    EXPECT_EQ(NextRequest(d), before);
    const Palette shown = map.shown();
    const unsigned long alpha = map.visual().depth == 32 ? 0xFF000000ul : 0;
    for (int i = 0; i < 256; ++i) {
      const Rgb16 c = palette[i];
      EXPECT_EQ(map.pixel(static_cast<std::uint8_t>(i)),
                alpha | (static_cast<unsigned long>(c.r >> 8) << 16 | (c.g >> 8) << 8 | c.b >> 8));
      EXPECT_EQ(shown[i].r >> 8, c.r >> 8);
    }
  }
}

// The program installs the map itself if no window manager runs, and leaves that to the manager if one does.
TEST(ServerColormap, InstallsOnlyWhereNobodyElseDoes) {
  const XServer x = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(x.name()), manager = openDisplay(x.name());
  ServerColormap map{display.get(), choiceOn(display.get())};
  XSelectInput(manager.get(), DefaultRootWindow(manager.get()), SubstructureRedirectMask);
  XSync(manager.get(), 0);
  EXPECT_TRUE(windowManagerRuns(display.get()));
  map.installUnlessManaged();
  EXPECT_FALSE(map.installed());
  XSelectInput(manager.get(), DefaultRootWindow(manager.get()), 0);
  XSync(manager.get(), 0);
  EXPECT_FALSE(windowManagerRuns(display.get()));
  map.installUnlessManaged();
  EXPECT_TRUE(map.installed());
}

// A test program that dies without running destructors takes its server with it.
TEST(XServerFixture, DiesWithACrashingTest) {
  std::array<int, 2> channel{};
  ASSERT_EQ(pipe(channel.data()), 0);
  const pid_t crashing = fork();
  if (crashing == 0) {
    const XServer server = XServer::xvfb(8);
    const pid_t pid = server.pid();
    if (write(channel[1], &pid, sizeof pid) != sizeof pid) _exit(2);
    kill(getpid(), SIGKILL);
  }
  pid_t server = 0;
  ASSERT_EQ(read(channel[0], &server, sizeof server), static_cast<ssize_t>(sizeof server));
  close(channel[0]);
  close(channel[1]);
  waitpid(crashing, nullptr, 0);
  const auto gone = [&] {  // nobody may be there to reap it: a zombie is gone too
    std::ifstream stat{"/proc/" + std::to_string(server) + "/stat"};
    std::string number, program, state;
    return !(stat >> number >> program >> state) || state == "Z";
  };
  for (int tries = 0; tries < 1000 && !gone(); ++tries) usleep(10'000);
  EXPECT_TRUE(gone());
}

// check() throws the first error under a trap with the name of the request that caused it. The error is not
// counted as a stray one, and a trap set later does not get errors of earlier requests.
TEST(ErrorTrap, NamesTheRequest) {
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  Display* d = display.get();
  const Window root = DefaultRootWindow(d);
  const int before = strayErrors();
  EXPECT_THAT(thrownBy([&] {
                ErrorTrap trap{d};
                const OwnedPixmap wide{d, XCreatePixmap(d, root, 40000, 1, 8)};  // no pixmap above 32767
                trap.check();
              }),
              AllOf(HasSubstr("X_CreatePixmap"), HasSubstr("BadAlloc")));
  {
    ErrorTrap trap{d};
    const OwnedPixmap shallow{d, XCreatePixmap(d, root, 4, 4, 1)};
    const OwnedGC gc{d, XCreateGC(d, root, 0, nullptr)};
    EXPECT_EQ(thrownBy([&] { trap.check(); }), "");
    XFillRectangle(d, shallow.get(), gc.get(), 0, 0, 4, 4);  // a GC of depth 8 on a pixmap of depth 1
    XMapWindow(d, 0);                                        // a second error, not the first
    ErrorTrap inner{d};
    EXPECT_EQ(thrownBy([&] { inner.check(); }), "");
    EXPECT_THAT(thrownBy([&] { trap.check(); }),
                AllOf(HasSubstr("X_PolyFillRectangle"), HasSubstr("BadMatch")));
    EXPECT_EQ(thrownBy([&] { trap.check(); }), "");
  }
  {
    ErrorTrap dropped{d};
    XMapWindow(d, 0);
  }
  EXPECT_EQ(strayErrors(), before);
}

// A resource has one owner. Moving leaves nothing behind, and each id is freed exactly once.
TEST(XResource, IsFreedOnce) {
  static_assert(!std::is_copy_constructible_v<OwnedPixmap> && std::is_nothrow_move_assignable_v<OwnedPixmap>);
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  Display* d = display.get();
  const auto alive = [&](Pixmap pixmap) {
    ErrorTrap trap{d};
    Window root = 0;
    int x = 0, y = 0;
    unsigned w = 0, h = 0, border = 0, depth = 0;
    return XGetGeometry(d, pixmap, &root, &x, &y, &w, &h, &border, &depth) != 0;
  };
  ErrorTrap trap{d};
  Pixmap first = 0, second = 0;
  {
    OwnedPixmap a{d, XCreatePixmap(d, DefaultRootWindow(d), 4, 4, 8)};
    OwnedPixmap b{d, XCreatePixmap(d, DefaultRootWindow(d), 4, 4, 8)};
    first = a.get();
    second = b.get();
    a = std::move(b);
    OwnedPixmap c{std::move(a)};
    EXPECT_EQ(c.get(), second);
    EXPECT_EQ(a.get(), 0u);
    EXPECT_TRUE(alive(second));
  }
  EXPECT_FALSE(alive(first));
  EXPECT_FALSE(alive(second));
  EXPECT_NO_THROW(trap.check());  // a second free would be BadPixmap
}

// An error outside every trap is told and counted, and the program goes on. Of many only the first are told:
// a window may get one in every frame.
TEST(ErrorTrap, StrayErrorsAreToldAndCounted) {
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  const int before = strayErrors();
  ASSERT_LT(before, kToldErrors);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 100; ++i) XMapWindow(display.get(), 0);
  XSync(display.get(), 0);
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_THAT(told, HasSubstr("xnewell: X_MapWindow: BadWindow"));
  EXPECT_EQ(std::ranges::count(told, '\n'), kToldErrors - before);
  EXPECT_EQ(strayErrors(), before + 100);
}

}  // namespace xnewell::THIS_FILE
