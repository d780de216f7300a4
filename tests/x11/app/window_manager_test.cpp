#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <set>
#include <stdexcept>

#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_proxy.h"

#include <X11/Xproto.h>
#include <X11/Xutil.h>
#include <X11/extensions/XRes.h>

#include "x11/server/colormap.h"
#include "x11/server/read_visuals.h"

namespace xnewell::THIS_FILE {

// The window under a real window manager, next to a client that has its own colormap; and what the window
// leaves behind on the server.

namespace {

const std::string kTeapot = "teapot --divisions 4 --size 400x300";

/// twm, which places windows without asking.
class WindowManager {
 public:
  explicit WindowManager(const XServer& server) : twm_{"twm", {"-f", configured(folder_)}, server.name()} {
    const OwnedDisplay display = openDisplay(server.name());
    EXPECT_TRUE(comesTrue([&] { return windowManagerRuns(display.get()) || !twm_.running(); }));
    if (!twm_.running()) throw std::runtime_error{"twm has ended, which the tests need"};
  }

 private:
  static std::string configured(const TemporaryFolder& folder) {
    std::ofstream out{folder.file("twmrc")};
    out << "RandomPlacement\n";
    // Its default fonts come in a separate package, and without them twm ends.
    for (const char* font : {"TitleFont", "ResizeFont", "MenuFont", "IconFont", "IconManagerFont"})
      out << font << " \"fixed\"\n";
    out.close();
    return folder.file("twmrc");
  }
  TemporaryFolder folder_;
  RunningProgram twm_;
};

/// Another client's window with its own colormap, at the lower right of a screen of 1280 x 1024.
struct Stranger {
  explicit Stranger(const XServer& server)
      : display{openDisplay(server.name())},
        colormap{display.get(), XCreateColormap(display.get(), DefaultRootWindow(display.get()),
                                                DefaultVisual(display.get(), 0), AllocNone)} {
    Display* d = display.get();
    XSetWindowAttributes attributes{};
    attributes.colormap = colormap.get();
    window = {d, XCreateWindow(d, DefaultRootWindow(d), 800, 700, 200, 150, 0, CopyFromParent, InputOutput,
                               CopyFromParent, CWColormap, &attributes)};
    XSizeHints hints{};
    hints.flags = USPosition | USSize;
    hints.x = 800;
    hints.y = 700;
    hints.width = 200;
    hints.height = 150;
    XSetWMNormalHints(d, window.get(), &hints);
    XMapWindow(d, window.get());
    EXPECT_TRUE(comesTrue([&] {
      XWindowAttributes now{};
      return XGetWindowAttributes(d, window.get(), &now) != 0 && now.map_state == IsViewable;
    }));
  }

  OwnedDisplay display;
  OwnedColormap colormap;
  OwnedWindow window;
};

std::set<Colormap> installed(Display* d) {
  int count = 0;
  const std::unique_ptr<Colormap[], int (*)(void*)> maps{
      XListInstalledColormaps(d, DefaultRootWindow(d), &count), XFree};
  return {maps.get(), maps.get() + count};
}

/// Moves the pointer to the middle of a window.
void enter(const WatchedWindow& hand, Window window) {
  Display* d = hand.display();
  XWindowAttributes attributes{};
  XGetWindowAttributes(d, window, &attributes);
  int x = 0, y = 0;
  Window child = 0;
  XTranslateCoordinates(d, window, DefaultRootWindow(d), attributes.width / 2, attributes.height / 2, &x, &y,
                        &child);
  hand.moveTo(x, y);
}

std::vector<Window> colormapWindows(Display* d, Window window) {
  Window* windows = nullptr;
  int count = 0;
  if (XGetWMColormapWindows(d, window, &windows, &count) == 0) return {};
  const std::unique_ptr<Window[], int (*)(void*)> owned{windows, XFree};
  return {windows, windows + count};
}

/// What clients can leave behind on a server.
struct Traces {
  int clients = 0;
  std::set<std::string> rootProperties;
  int freeCells = 0;  ///< in the default colormap
  std::set<Colormap> installed;
  bool operator==(const Traces&) const = default;
};

Traces tracesOn(Display* d) {
  Traces traces;
  XResClient* clients = nullptr;
  EXPECT_NE(XResQueryClients(d, &traces.clients, &clients), 0);
  XFree(clients);
  int count = 0;
  const std::unique_ptr<Atom[], int (*)(void*)> properties{XListProperties(d, DefaultRootWindow(d), &count),
                                                           XFree};
  for (int i = 0; i < count; ++i) {
    const std::unique_ptr<char, int (*)(void*)> name{XGetAtomName(d, properties[i]), XFree};
    traces.rootProperties.insert(name.get());
  }
  traces.freeCells = readVisuals(d, true).freeCells.value_or(-1);
  traces.installed = installed(d);
  return traces;
}

/// The number of resources of the client that made `resource`; 0 if there is no such client.
int resourcesOf(Display* d, XID resource) {
  const ErrorTrap trap{d};
  int count = 0;
  XResType* types = nullptr;
  if (XResQueryClientResources(d, resource, &count, &types) == 0) return 0;
  const std::unique_ptr<XResType[], int (*)(void*)> owned{types, XFree};
  int total = 0;
  for (int i = 0; i < count; ++i) total += static_cast<int>(types[i].count);
  return total;
}

}  // namespace

// Under a window manager, the installed colormap is that of the window under the pointer: ours, the other
// client's, or the default map where there is no window. The manager installs it, told by the window; the
// program does not.
TEST(WindowManager, InstallsOurColormapWhereThePointerIs) {
  const XServer server = XServer::xvfb(8, 1280, 1024);
  const WindowManager manager{server};
  XProxy proxy{server};
  RunningProgram program{words("view " + kTeapot), proxy.name()};
  const WatchedWindow window{server};
  Display* d = window.display();
  const Stranger stranger{server};
  const Colormap ours = window.colormap(), theirs = stranger.colormap.get();
  const Colormap usual = DefaultColormap(d, 0);
  const auto comesToInstall = [&](Colormap map) {
    return comesTrue([&] { return installed(d) == std::set{map}; });
  };

  // ICCCM 4.1.8: the map is the window's attribute, and the window is in its own WM_COLORMAP_WINDOWS list.
  EXPECT_NE(ours, usual);
  EXPECT_EQ(colormapWindows(d, window.id()), std::vector{window.id()});

  for (int round = 0; round < 3; ++round) {
    SCOPED_TRACE(round);
    enter(window, window.id());
    EXPECT_TRUE(comesToInstall(ours));
    enter(window, stranger.window.get());
    EXPECT_TRUE(comesToInstall(theirs));
    window.moveTo(1270, 20);
    EXPECT_TRUE(comesToInstall(usual));
  }
  enter(window, window.id());
  ASSERT_TRUE(comesToInstall(ours));
  EXPECT_EQ(std::ranges::count(proxy.requests(), XRequest{X_InstallColormap}), 0);
  window.type("q");
  EXPECT_EQ(program.wait().status, 0);
  enter(window, stranger.window.get());
  EXPECT_TRUE(comesToInstall(theirs));
}

// Nothing of the window stays on the server, however it ends, with or without a window manager. Nothing of a
// snapshot stays either.
TEST(WindowManager, FindsNothingOfUsAfterwards) {
  const XServer server = XServer::xvfb(8, 1280, 1024);
  std::optional<WindowManager> manager;
  for (const bool managed : {false, true}) {
    SCOPED_TRACE(managed);
    if (managed) manager.emplace(server);
    const OwnedDisplay display = openDisplay(server.name());
    Display* d = display.get();
    XWarpPointer(d, Window{}, DefaultRootWindow(d), 0, 0, 0, 0, 1270, 20);
    XSync(d, 0);
    const Traces before = tracesOn(d);
    EXPECT_GT(before.freeCells, 0);
    for (const int signal : {0, SIGINT, SIGKILL}) {
      SCOPED_TRACE(signal);
      Window id = 0;
      {
        WatchedViewer viewer{server, kTeapot};
        id = viewer.window.id();
        enter(viewer.window, id);
        EXPECT_TRUE(comesTrue([&] { return viewer.window.colormapInstalled(); }));
        EXPECT_GT(resourcesOf(d, id), 3);  // window, picture, colormap, ...
        EXPECT_NE(tracesOn(d).installed, before.installed);
        viewer.window.moveTo(1270, 20);
        if (signal != 0)
          viewer.program.signal(signal);
        else
          viewer.window.askToClose();
        EXPECT_EQ(viewer.program.wait().status, signal == 0 ? 0 : 128 + signal);
      }
      EXPECT_TRUE(comesTrue([&] { return tracesOn(d) == before; }));
      EXPECT_EQ(resourcesOf(d, id), 0);
    }
    EXPECT_GT(pictureOf("snapshot " + kTeapot, server.name()).width, 0);
    EXPECT_TRUE(comesTrue([&] { return tracesOn(d) == before; }));
  }
}

}  // namespace xnewell::THIS_FILE
