#include "x11/viewer.h"

#include <X11/XKBlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <utility>

#include "shading/few_colors.h"
#include "shading/png.h"
#include "x11/canvas.h"
#include "x11/colormap.h"
#include "x11/display.h"
#include "x11/fill_polygons.h"
#include "x11/read_cells.h"
#include "x11/report.h"
#include "x11/visual.h"
#include "x11/workbench.h"

namespace {

std::optional<VisualWish> wishOf(const Options& options) {
  if (options.visual.empty()) return std::nullopt;
  return parseVisualWish(options.visual);
}

/// The colormap that the options ask for, or, where the server has no room for another one, cells of the
/// default one. What the user gets less than asked for is told on standard error.
ServerColormap openColormap(::Display* display, const Options& options) {
  const ServerVisuals server = readVisuals(display);
  const std::optional<VisualWish> wish = wishOf(options);
  const VisualChoice choice = chooseVisual(server, wish, options.colormap);
  ServerColormap::Settings settings{
      .owner = options.colormap, .dither = !options.nearest, .shades = options.picture.table.shades};
  const auto tell = [](const std::string& what) {
    if (!what.empty()) std::cerr << "xnewell: " << what << '\n';
  };
  try {
    ServerColormap colormap{display, choice, settings};
    tell(colormap.shortfall());
    return colormap;
  } catch (const NoColormapError& e) {
    const VisualInfo& standard = server.defaultVisual();
    if (options.colormap == MapOwner::Shared || (wish && choice.visual.name() != standard.name())) throw;
    settings.owner = MapOwner::Shared;
    ServerColormap colormap{display, chooseVisual(server, {}, MapOwner::Shared), settings};
    tell("no colormap of our own (" + std::string{e.what()} + "), but " + colormap.account());
    return colormap;
  }
}

/// A connection with its visual and colormap chosen: what every window needs.
struct Server {
  explicit Server(const Options& options)
      : display{openDisplay()}, colormap{openColormap(display.get(), options)} {}

  [[nodiscard]] Workbench::Server forBench() const {
    return {[this](TableKind table) { return colormap.plan(table); }, colormap.unneeded(), colormap.account(),
            gray()};
  }
  /// With a ramp of as many shades as there are cells for.
  [[nodiscard]] PictureSettings fitted(PictureSettings settings) const {
    settings.table.shades = std::min(settings.table.shades, colormap.mostShades());
    return settings;
  }
  [[nodiscard]] Setup setupOf(const Options& options) const {
    return {fitted(options.picture), options.fill};
  }

  [[nodiscard]] bool gray() const { return colormap.visual().gray(); }
  /// What to store for a picture's colours.
  [[nodiscard]] Palette colorsOf(const Picture& picture, const Palette& palette) const {
    return gray() ? forGrayScreen(palette, picture) : palette;
  }

  OwnedDisplay display;
  ServerColormap colormap;
};

/// A signal ends the window at once, also where Xlib waits for a server that has hung: what we have on the
/// server, a grab too, goes with the connection.
void endWithSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, [](int) { _exit(130); });
}

/// Keysyms to keys, Latin-1 letters by themselves.
std::optional<Key> keyOf(XKeyEvent& event) {
  char letter = 0;
  KeySym symbol = NoSymbol;
  const int count = XLookupString(&event, &letter, 1, &symbol, nullptr);
  const bool shift = (event.state & ShiftMask) != 0;
  switch (symbol) {
    case XK_Left:
    case XK_KP_Left:
      return Key{NamedKey::Left, 0, shift};
    case XK_Right:
    case XK_KP_Right:
      return Key{NamedKey::Right, 0, shift};
    case XK_Up:
    case XK_KP_Up:
      return Key{NamedKey::Up, 0, shift};
    case XK_Down:
    case XK_KP_Down:
      return Key{NamedKey::Down, 0, shift};
    case XK_Home:
    case XK_KP_Home:
      return Key{NamedKey::Home, 0, shift};
    case XK_End:
    case XK_KP_End:
      return Key{NamedKey::End, 0, shift};
    case XK_Tab:
      return Key{NamedKey::Tab, 0, shift};
    case XK_ISO_Left_Tab:
      return Key{NamedKey::Tab, 0, true};
    case XK_Escape:
      return Key{NamedKey::Escape, 0, shift};
    default:
      break;
  }
  if (count == 1 && letter > ' ') return Key{NamedKey::Letter, letter, shift};
  return std::nullopt;
}

class Viewer {
 public:
  Viewer(const Options& options, Scene scene)
      : server_{options},
        size_{options.size.value_or(kWindowSize)},
        canvas_{server_.display.get(),
                server_.colormap,
                {.title = "xnewell: " + scene.name, .width = size_.x, .height = size_.y}},
        bench_{std::move(scene), server_.setupOf(options), server_.forBench()} {
    bench_.resize(size_.x, size_.y);
    XkbSetDetectableAutoRepeat(display(), 1, nullptr);  // a key held is released once
  }

  int run() {
    endWithSignals();
    {
      ErrorTrap trap{display()};  // a window that cannot be seen could not be closed either
      refresh();                  // the first picture is there before the window is
      canvas_.map();
      trap.check();
    }
    while (true) {
      while (XPending(display()) > 0) {
        XEvent event;
        XNextEvent(display(), &event);
        handle(event);
      }
      if (errorsToTell()) {
        toldOfErrors_ = true;
        bench_.notify("the X server refused a request: what is shown may be wrong");
      }
      refresh();
      if (bench_.quitAsked()) break;
      pollfd connection{ConnectionNumber(display()), POLLIN, 0};
      poll(&connection, 1, longestWait());
    }
    XSync(display(), 0);  // the last frame may still be refused
    if (strayErrors() == 0) return 0;
    throw X11Error{"the X server refused requests (" + std::to_string(strayErrors()) +
                   " in all): what was shown may be wrong"};
  }

 private:
  [[nodiscard]] ::Display* display() const { return server_.display.get(); }

  [[nodiscard]] bool errorsToTell() const { return strayErrors() > 0 && !toldOfErrors_; }

  /// In milliseconds; -1 where nothing happens but events. Colours that move do so every 40 ms at most.
  [[nodiscard]] int longestWait() {
    constexpr double kTick = 40;
    if (XPending(display()) > 0 || errorsToTell() || bench_.stale() != Workbench::Stale::Nothing) return 0;
    if (!bench_.moving()) return -1;
    const double rest = kTick - sinceTick_.ms();
    if (rest > 0) return 1 + static_cast<int>(rest);
    sinceTick_ = {};
    bench_.tick();
    return 0;
  }

  void handle(XEvent& event) {
    switch (event.type) {
      case Expose: {
        const XExposeEvent& e = event.xexpose;
        canvas_.expose({e.x, e.y, e.width, e.height});
        break;
      }
      case ConfigureNotify:
        resized(event.xconfigure.width, event.xconfigure.height);
        break;
      case MapNotify:
      case FocusIn:
        server_.colormap.installUnlessManaged();
        break;
      case EnterNotify:
        pointerInside_ = true;
        server_.colormap.installUnlessManaged();
        break;
      case LeaveNotify:
        pointerInside_ = false;
        break;
      case ColormapNotify:
        // Stolen while the user is here: take it back. Elsewhere it is due to whoever has the pointer, and
        // two programs that both insisted would never stop.
        if (event.xcolormap.state == ColormapUninstalled && pointerInside_)
          server_.colormap.installUnlessManaged();
        break;
      case KeyPress:
        if (const std::optional<Key> key = keyOf(event.xkey)) bench_.press(*key);
        break;
      case KeyRelease:
        if (const std::optional<Key> key = keyOf(event.xkey)) bench_.release(key->letter);
        break;
      case FocusOut:  // a key let go elsewhere is not told
        bench_.release('h');
        break;
      case ButtonPress:
        pressed(event.xbutton);
        break;
      case ButtonRelease:
        if (event.xbutton.button == Button1 && std::exchange(dragging_, false)) bench_.settle();
        break;
      case MotionNotify:
        moved(event.xmotion);
        break;
      case ClientMessage:
        if (canvas_.isCloseRequest(event)) bench_.press({NamedKey::Letter, 'q'});
        break;
      case MappingNotify:
        XRefreshKeyboardMapping(&event.xmapping);
        break;
      default:
        break;
    }
  }

  void resized(int width, int height) {
    const int w = std::clamp(width, 1, kMaxPicture), h = std::clamp(height, 1, kMaxPicture);
    try {
      canvas_.resize(w, h);
      bench_.resize(w, h);
    } catch (const X11Error& e) {
      bench_.notify(e.what());
    }
  }

  void pressed(const XButtonEvent& e) {
    constexpr double kWheelStep = 1.1;
    if (e.button == Button4) bench_.zoom(kWheelStep);
    if (e.button == Button5) bench_.zoom(1.0 / kWheelStep);
    if (e.button == Button1 && bench_.grab(e.x, e.y)) {
      dragging_ = true;
      dragX_ = e.x;
      dragY_ = e.y;
    }
  }

  void moved(const XMotionEvent& e) {
    if (!dragging_) return bench_.hover(e.x, e.y);
    bench_.drag(e.x - dragX_, e.y - dragY_);
    dragX_ = e.x;
    dragY_ = e.y;
  }

  /// Colours alone are stored and nothing is drawn. New indices go into the picture behind the window
  /// first; then cells and indices change together, and no other client sees one without the other.
  void refresh() {
    const Workbench::Stale stale = bench_.stale();
    if (stale == Workbench::Stale::Nothing) return;
    bench_.update(dragging_);
    const CellPlan plan = bench_.plan();
    const Palette palette = server_.colorsOf(bench_.picture(), bench_.palette());
    const bool otherPixels = server_.colormap.lookUp(palette, plan);
    if (stale == Workbench::Stale::Colors && !otherPixels) {
      server_.colormap.store(palette, plan);
      XFlush(display());
      return;
    }
    const Rect all{0, 0, canvas_.width(), canvas_.height()};
    canvas_.upload(bench_.image(), all);
    if (bench_.serverFills()) {
      fillPolygons(display(), canvas_, bench_.picture(), bench_.layout().picture, bench_.ground());
      for (const Rect& part : bench_.overPicture()) canvas_.upload(bench_.image(), part);
    }
    const ServerGrab grab{display()};
    server_.colormap.store(palette, plan);
    canvas_.expose(all);
  }

  Server server_;
  glm::ivec2 size_;
  Canvas canvas_;
  Workbench bench_;
  bool dragging_ = false, pointerInside_ = false;
  bool toldOfErrors_ = false;  ///< once: to tell is a frame more, which may be refused too
  Stopwatch sinceTick_;
  int dragX_ = 0, dragY_ = 0;
};

/// What a snapshot shows: the picture alone, or the whole window.
struct Shot {
  const Picture& picture;
  const IndexImage& image;
  const Palette& palette;
  CellPlan plan;             ///< of the image
  Rect area;                 ///< of the picture in the image
  std::vector<Rect> over{};  ///< parts of the image that lie over the picture
};

void present(Server& server, Canvas& canvas, const Shot& shot, Fill fill) {
  server.colormap.store(server.colorsOf(shot.picture, shot.palette), shot.plan);
  const Rect all{0, 0, shot.image.width, shot.image.height};
  canvas.upload(shot.image, all);
  if (fill == Fill::XFillPolygon) {
    fillPolygons(server.display.get(), canvas, shot.picture, shot.area, shot.plan[Cell::Well]);
    for (const Rect& part : shot.over) canvas.upload(shot.image, part);
  }
  canvas.expose(all);
}

}  // namespace

int runViewer(const Options& options, Scene scene) {
  Viewer viewer{options, std::move(scene)};
  return viewer.run();
}

void takeSnapshot(const Options& options, Scene scene, double msRead) {
  Server server{options};
  const glm::ivec2 size = options.size.value_or(options.wholeWindow ? kWindowSize : kPictureSize);
  Canvas canvas{server.display.get(), server.colormap, {.width = size.x, .height = size.y}};
  ErrorTrap trap{server.display.get()};
  canvas.map();

  const auto shoot = [&](const Shot& shot) {
    StageTimes times = shot.picture.times();
    times.read = msRead;
    const Stopwatch watch;
    present(server, canvas, shot, options.fill);
    trap.check();
    times.present = watch.ms();
    if (strayErrors() > 0) throw X11Error{"the X server refused requests: no picture"};
    std::optional<ColoredImage> cells = readCells(server.display.get(), canvas, server.colormap, shot.image);
    const RgbImage seen = cells ? RgbImage{} : canvas.readBack({0, 0, size.x, size.y});
    if (!cells) cells = inFewColors(seen);
    writePictures(options, shot.picture, cells ? encodePng(cells->image, cells->palette) : encodePng(seen));
    report(options, shot.picture, times);
  };
  if (options.wholeWindow) {
    Workbench bench{std::move(scene), server.setupOf(options), server.forBench()};
    bench.resize(size.x, size.y);
    if (options.view == View::Colors) bench.press({NamedKey::Letter, '3'});
    bench.update();
    shoot({bench.picture(), bench.image(), bench.palette(), bench.plan(), bench.layout().picture,
           bench.overPicture()});
    return;
  }
  Picture picture{std::move(scene)};
  PictureSettings settings = server.fitted(options.picture);
  settings.width = size.x;
  settings.height = size.y;
  settings.inPixels = options.fill == Fill::XFillPolygon;
  const CellPlan plan = server.colormap.plan(settings.table.kind);
  if (options.view != View::Picture) {
    const ColoredImage view = drawView(picture, {.view = options.view,
                                                 .scanline = options.scanline,
                                                 .cell = options.cell,
                                                 .effects = options.effects,
                                                 .picture = settings,
                                                 .cells = plan,
                                                 .unneeded = server.colormap.unneeded(),
                                                 .gray = server.gray()});
    return shoot({picture, view.image, view.palette, plan, {0, 0, size.x, size.y}});
  }
  picture.make(settings);
  IndexImage image;
  picture.paint(image, plan[Cell::Well]);
  const Palette palette =
      withEffects(picture.palette(plan, server.colormap.unneeded()), picture, plan, options.effects);
  shoot({picture, image, palette, plan, {0, 0, size.x, size.y}});
}

std::string visualsTable(const Options& options) {
  const OwnedDisplay display = openDisplay();
  const std::string table =
      describeVisuals(readVisuals(display.get(), /*countsCells=*/true), wishOf(options), options.colormap);
  XSync(display.get(), 0);
  if (strayErrors() > 0) throw X11Error{"the X server refused requests: no table"};
  return table;
}
