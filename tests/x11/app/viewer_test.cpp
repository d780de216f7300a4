#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/views/colors_page.h"

#include <X11/Xatom.h>
#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

namespace {

constexpr Rect kSeen{0, 0, 1024, 724};  ///< the window of 1024 x 768 but for its status line
const std::string kTeapot = "teapot --divisions 4";

XServer serverFor(int depth) { return XServer::xvfb(depth, 1280, 1024); }

/// The requests that matter to a frame, in order. `S` stands for StoreColors, `[` and `]` for GrabServer and
/// UngrabServer, `c` for CopyArea, and `d` for all other drawing.
std::string frames(RequestRecord& record) {
  std::string seen;
  for (const int opcode : record.opcodes()) {
    if (opcode == X_StoreColors) seen += 'S';
    if (opcode == X_GrabServer) seen += '[';
    if (opcode == X_UngrabServer) seen += ']';
    if (opcode == X_CopyArea)
      seen += 'c';
    else if (record.isDrawing(opcode))
      seen += 'd';
  }
  return seen;
}

constexpr double kTick = 40;  ///< milliseconds at least between two moves of the ramp
const std::string kCorrected = kTeapot + " --table corrected";

/// The yellow of a lit shade.
bool isLit(const std::uint8_t* rgb) { return rgb[0] == 0xFF && rgb[1] == 0xE0 && rgb[2] == 0; }

/// Pixels of `now` that differ from `before` and that `counts`.
template <typename Counts>
int changed(const RgbImage& now, const RgbImage& before, const Counts& counts) {
  int pixels = 0;
  for (std::size_t k = 0; k < now.rgb.size(); k += 3)
    pixels += !std::equal(&now.rgb[k], &now.rgb[k] + 3, &before.rgb[k]) && counts(&now.rgb[k]);
  return pixels;
}

/// Another program that pastes.
class Paster {
 public:
  explicit Paster(const XServer& server)
      : display_{openDisplay(server.name())},
        window_{display_.get(),
                XCreateSimpleWindow(display_.get(), DefaultRootWindow(display_.get()), 0, 0, 1, 1, 0, 0, 0)} {
  }

  [[nodiscard]] Atom atom(const char* name) const { return XInternAtom(display_.get(), name, 0); }
  [[nodiscard]] bool isOwned(Atom selection) const {
    return XGetSelectionOwner(display_.get(), selection) != 0;
  }
  /// What the owner of the selection answers, with its type; type 0 if it declines.
  struct Answer {
    Atom type = 0;
    std::string bytes;  ///< of format 32: one long each
  };
  [[nodiscard]] Answer paste(Atom selection, Atom target) const {
    Display* d = display_.get();
    const Atom into = atom("XNEWELL_TEST");
    XConvertSelection(d, selection, target, into, window_.get(), CurrentTime);
    XEvent event{};
    if (!comesTrue([&] { return XCheckTypedEvent(d, SelectionNotify, &event) != 0; })) return {};
    if (event.xselection.property == 0) return {};
    Answer answer;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* bytes = nullptr;
    XGetWindowProperty(d, window_.get(), into, 0, 100'000, 1, AnyPropertyType, &answer.type, &format, &count,
                       &left, &bytes);
    answer.bytes.assign(reinterpret_cast<char*>(bytes), count * (format == 32 ? sizeof(long) : 1));
    XFree(bytes);
    return answer;
  }

 private:
  OwnedDisplay display_;
  OwnedWindow window_;
};

}  // namespace

// What keys and mouse do to the picture in the window, on real servers.

class ViewerAt : public testing::TestWithParam<int> {
 protected:
  XServer server = serverFor(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Depths, ViewerAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// A new hue shows the window as a fresh start with that hue would. After five hues the first comes again. On
// a real colormap colours are stored and nothing is drawn. The counter of drawing does count: a key that
// changes the panel draws.
TEST_P(ViewerAt, NewHueStoresColorsAndDrawsNothingWhereCellsAreReal) {
  const RgbImage red = freshWindow(server, kTeapot), amber = freshWindow(server, kTeapot + " --hue 1,0.7,0");
  EXPECT_NE(red, amber);
  const WatchedViewer viewer{server, kTeapot};
  ASSERT_TRUE(viewer.window.comesToShow(red, kSeen));
  RequestRecord record{server, viewer.window.id()};

  viewer.window.type("H");
  EXPECT_TRUE(viewer.window.comesToShow(amber, kSeen));
  viewer.window.type("HHHH");
  EXPECT_TRUE(viewer.window.comesToShow(red, kSeen));
  // Key presses that arrive together may share one frame.
  const std::ptrdiff_t stores = record.count(X_StoreColors);
  if (GetParam() == 8) {
    EXPECT_GE(stores, 2);
    EXPECT_EQ(frames(record), std::string(stores, 'S'));
    record.forget();
    viewer.window.press(XK_Right);
    EXPECT_TRUE(comesTrue([&] { return record.count(X_UngrabServer) == 1; }));
    EXPECT_EQ(frames(record), "d[c]");
  } else {
    EXPECT_EQ(stores, 0);
    EXPECT_GE(record.drawing(), 4);
  }
}

// Under a layout of other letters, a key has the Latin letter of the layout's other group, with Shift and
// with Caps Lock.
TEST(Viewer, TakesTheLetterOfAnotherGroup) {
  const XServer server = serverFor(24);
  const RgbImage amber = freshWindow(server, kTeapot + " --hue 1,0.7,0"), red = freshWindow(server, kTeapot);
  const WatchedViewer viewer{server, kTeapot};
  ASSERT_TRUE(viewer.window.comesToShow(red, kSeen));
  std::array<KeySym, 4> er{XK_Cyrillic_er, XK_Cyrillic_ER, XK_h, XK_H};
  const KeyCode h = XKeysymToKeycode(viewer.window.display(), XK_h);
  XChangeKeyboardMapping(viewer.window.display(), h, 4, er.data(), 1);
  XSync(viewer.window.display(), False);
  XEvent changed{};  // so that this test finds the keys of the letters, too
  changed.xmapping.type = MappingNotify, changed.xmapping.display = viewer.window.display();
  changed.xmapping.request = MappingKeyboard, changed.xmapping.first_keycode = h, changed.xmapping.count = 1;
  XRefreshKeyboardMapping(&changed.xmapping);
  viewer.window.press(XK_Cyrillic_er, true);
  EXPECT_TRUE(viewer.window.comesToShow(amber, kSeen));
  viewer.window.press(XK_Caps_Lock);
  for (int k = 0; k < 4; ++k) viewer.window.press(XK_Cyrillic_er);
  EXPECT_TRUE(viewer.window.comesToShow(red, kSeen));
}

// A change of table, shades or I0 gives intensities other cells. Colours and indices arrive together, between
// GrabServer and UngrabServer. Then the window looks like a fresh start with these values.
TEST_P(ViewerAt, CellsAndIndicesChangeInOneFrame) {
  struct Change {
    std::string before, focus;
    KeySym key;  // or T
    std::string after;
  };
  std::vector<Change> changes{{"--shades 64", "c", XK_Left, "--shades 63"},
                              {"--table corrected --shades 64", "c", XK_Home, "--table corrected --shades 2"},
                              {"--table corrected", "o", XK_End, "--table corrected --i0 0.5"}};
  const auto table = [](std::size_t row) {
    return "--table " + std::string{kTables[row % kTables.size()].name};
  };
  for (std::size_t k = 0; k < kTables.size(); ++k) changes.push_back({table(k), "", 0, table(k + 1)});
  // The marks of the defaults on the sliders of the colour table differ from those of a fresh start.
  const Layout at = layoutOf(1024, 768);
  const Rect tracks{at.controls.x + 78, at.controls.y + at.controls.height - 160, 180, 160};
  const auto withoutTracks = [&](RgbImage image) {
    for (int y = tracks.y; y < tracks.y + tracks.height; ++y)
      std::fill_n(image.pixel(tracks.x, y), 3 * tracks.width, 0);
    return image;
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.before + " -> " + change.after);
    const RgbImage before = freshWindow(server, kTeapot + " " + change.before),
                   after = withoutTracks(freshWindow(server, kTeapot + " " + change.after));
    const WatchedViewer viewer{server, kTeapot + " " + change.before};
    ASSERT_TRUE(viewer.window.comesToShow(before, kSeen));
    viewer.window.type(change.focus);
    ASSERT_TRUE(viewer.window.settles());
    RequestRecord record{server, viewer.window.id()};
    change.key ? viewer.window.press(change.key) : viewer.window.type("T");
    EXPECT_TRUE(comesTrue([&] { return record.count(X_UngrabServer) == 1; }));
    EXPECT_EQ(frames(record), GetParam() == 8 ? "d[Sc]" : "d[c]");
    viewer.window.type("s");  // a fresh start has the keyboard there
    EXPECT_TRUE(comesTrue([&] { return withoutTracks(viewer.window.shown(kSeen)) == after; }));
  }
}

// The wheel zooms, and a drag over the picture turns the scene until the button is released. Undo takes each
// of these back.
TEST_P(ViewerAt, MouseTurnsAndZooms) {
  const RgbImage start = freshWindow(server, kTeapot);
  const WatchedViewer viewer{server, kTeapot};
  const WatchedWindow& window = viewer.window;
  ASSERT_TRUE(window.comesToShow(start, kSeen));
  window.moveTo(300, 300);
  for (const unsigned button : {4u, 5u, 1u}) {
    window.button(button, true);
    if (button == 1) window.moveTo(340, 310);
    window.button(button, false);
    ASSERT_TRUE(window.comesToDiffer(start, kSeen));
    if (button == 1) {
      ASSERT_TRUE(window.settles());
      const RgbImage turned = window.shown(kSeen);
      window.moveTo(100, 100);
      ASSERT_TRUE(window.settles());
      EXPECT_EQ(window.shown(kSeen), turned);
    }
    window.type("u");
    EXPECT_TRUE(window.comesToShow(start, kSeen));
  }
}

// The view of the colour table in the window, on real servers: what is stored, and what is drawn.

class ColorsWindowAt : public testing::TestWithParam<int> {
 protected:
  XServer server = serverFor(GetParam());
  const RgbImage picture = freshWindow(server, kCorrected),
                 colors = freshWindow(server, kCorrected + " --view colours");
  const WatchedViewer viewer{server, kCorrected};
  const WatchedWindow& window = viewer.window;
  bool real = GetParam() == 8;

  void enter() {
    ASSERT_TRUE(window.comesToShow(picture, kSeen));
    window.moveTo(500, 15);  // where no cell is inspected
    window.type("3");
    ASSERT_TRUE(window.comesToShow(colors, kSeen));
    ASSERT_TRUE(window.settles());
  }
};
INSTANTIATE_TEST_SUITE_P(Depths, ColorsWindowAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// While h is held the shade is lit, in the picture, the grid and the strip. When h is let go the window is as
// it was; after a tap, with the second tap. Keys that the keyboard repeats meanwhile change nothing. A real
// colormap takes one store for the light and one for its end, and nothing is drawn.
TEST_P(ColorsWindowAt, AHeldKeyLightsTheShade) {
  enter();
  Display* const d = window.display();
  XSelectInput(d, window.id(), KeyPressMask);
  const auto layout = layoutOf(1024, 768);
  const Rect small = layoutOfColors(layout.body).picture, strip = intersection(layout.strip, kSeen);
  RequestRecord record{server, window.id()};
  RgbImage lit;
  /// Holds h until it is repeated so often, and lets it go; without repeats, taps it twice. Returns the
  /// requests that draw.
  const auto hold = [&](int repeats) {
    record.forget();
    window.hold(XK_h, true);
    EXPECT_TRUE(comesTrue([&] {
      lit = window.shown(kSeen);
      return changed(lit, colors, isLit) > 500 && cropped(lit, small) != cropped(colors, small) &&
             cropped(lit, strip) != cropped(colors, strip);
    }));
    if (repeats == 0) window.hold(XK_h, false), window.hold(XK_h, true);
    for (int key = 0; key <= std::max(1, repeats); ++key) {  // the first is the key itself
      XEvent event;
      EXPECT_TRUE(comesTrue([&] { return XCheckMaskEvent(d, KeyPressMask, &event) != 0; })) << key;
    }
    window.hold(XK_h, false);
    EXPECT_TRUE(window.comesToShow(colors, kSeen));
    return record.drawing();
  };
  XAutoRepeatOff(d);
  const std::ptrdiff_t once = hold(0);
  const RgbImage litOnce = lit;
  EXPECT_EQ(changed(lit, colors, [](const std::uint8_t* rgb) { return !isLit(rgb); }), 0);
  XAutoRepeatOn(d);
  EXPECT_EQ(hold(3), once);
  EXPECT_EQ(lit, litOnce);
  EXPECT_EQ(record.count(X_StoreColors), real ? 2 : 0);
  EXPECT_EQ(once > 0, !real);
}

// The ramp moves by itself, no faster than its clock. On a real colormap it moves through stores alone. Esc
// brings the view back, and leaving brings the picture back.
TEST_P(ColorsWindowAt, TheRampMovesThroughStoresAlone) {
  constexpr int kMoves = 12;
  enter();
  for (const bool byEscape : {true, false}) {
    RequestRecord record{server, window.id()};
    const auto start = std::chrono::steady_clock::now();
    window.type("m");
    if (real) {
      EXPECT_TRUE(comesTrue([&] { return record.count(X_StoreColors) >= kMoves; }));
      const std::vector<int> all = record.opcodes();
      // Read after the requests: so many moves, of which the first needs no time, took no longer than this.
      const double ms =
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      // The key may store and draw by itself before the first move. Everything is drawn before the second.
      EXPECT_LE(static_cast<double>(std::ranges::count(all, X_StoreColors) - 2), ms / kTick);
      auto moved = all.begin();
      for (int store = 0; store < 2; ++store) moved = std::next(std::find(moved, all.end(), X_StoreColors));
      EXPECT_TRUE(std::none_of(moved, all.end(), [&](int opcode) { return record.isDrawing(opcode); }));
    } else {
      RgbImage last = colors;
      for (int move = 0; move < 3; ++move) {
        ASSERT_TRUE(window.comesToDiffer(last, kSeen)) << move;
        last = window.shown(kSeen);
      }
      EXPECT_EQ(record.count(X_StoreColors), 0);
    }
    if (byEscape)
      window.press(XK_Escape);
    else
      window.type("1");
    EXPECT_TRUE(window.comesToShow(byEscape ? colors : picture, kSeen));
  }
}

// After C, other programs can paste the command that the program has printed, from both selections, as UTF-8
// and as Latin-1. They can ask which forms there are; any other form is declined.
TEST(SelectionOfTheWindow, HasTheCommand) {
  const XServer server = serverFor(24);
  WatchedViewer viewer{server, kTeapot + " --ks 0.5"};
  const Paster paster{server};
  const Atom clipboard = paster.atom("CLIPBOARD"), utf8 = paster.atom("UTF8_STRING");
  EXPECT_FALSE(paster.isOwned(clipboard));
  viewer.window.type("SC");
  ASSERT_TRUE(comesTrue([&] { return paster.isOwned(clipboard) && paster.isOwned(XA_PRIMARY); }));
  const std::string command = paster.paste(clipboard, utf8).bytes;
  EXPECT_NE(command.find(" polygons, "), std::string::npos) << command;
  EXPECT_NE(command.find("\nxnewell draw teapot --size "), std::string::npos) << command;
  EXPECT_NE(command.find(" --divisions 4 --shade gouraud --ks 0.5 "), std::string::npos) << command;
  for (const Atom selection : {clipboard, Atom{XA_PRIMARY}}) {
    EXPECT_EQ(paster.paste(selection, utf8).type, utf8);
    EXPECT_EQ(paster.paste(selection, utf8).bytes, command);
    EXPECT_EQ(paster.paste(selection, XA_STRING).type, Atom{XA_STRING});
    EXPECT_EQ(paster.paste(selection, XA_STRING).bytes, command);
    const Paster::Answer targets = paster.paste(selection, paster.atom("TARGETS"));
    EXPECT_EQ(targets.type, Atom{XA_ATOM});
    for (const Atom each : {paster.atom("TARGETS"), utf8, Atom{XA_STRING}})
      EXPECT_NE(targets.bytes.find(std::string{reinterpret_cast<const char*>(&each), sizeof each}),
                std::string::npos);
    EXPECT_EQ(paster.paste(selection, XA_BITMAP).type, 0u);
  }
  viewer.window.type("q");
  const Finished end = viewer.program.wait();
  EXPECT_EQ(end.out, command + '\n');
  EXPECT_EQ(end.err, "");
  EXPECT_EQ(end.status, 0);
}

}  // namespace xnewell::THIS_FILE
