#include "x11/app/viewer.h"

#include <X11/XKBlib.h>
#include <X11/Xutil.h>
#include <X11/cursorfont.h>
#include <X11/keysym.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <utility>

#include "shading/picture/shared.h"
#include "x11/app/long_work.h"
#include "x11/app/server.h"
#include "x11/app/snapshot.h"
#include "x11/app/surface.h"
#include "x11/server/canvas.h"
#include "x11/server/colormap.h"
#include "x11/server/display.h"
#include "x11/server/read_cells.h"
#include "x11/server/screen.h"
#include "x11/server/selection.h"

namespace xnewell {

namespace {

struct KeysymRow {
  KeySym symbol, onKeypad;
  NamedKey name;
};
constexpr std::array kNamedKeys{
    KeysymRow{XK_Left, XK_KP_Left, NamedKey::Left},
    KeysymRow{XK_Right, XK_KP_Right, NamedKey::Right},
    KeysymRow{XK_Up, XK_KP_Up, NamedKey::Up},
    KeysymRow{XK_Down, XK_KP_Down, NamedKey::Down},
    KeysymRow{XK_Home, XK_KP_Home, NamedKey::Home},
    KeysymRow{XK_End, XK_KP_End, NamedKey::End},
    KeysymRow{XK_Prior, XK_KP_Prior, NamedKey::PageUp},
    KeysymRow{XK_Next, XK_KP_Next, NamedKey::PageDown},
    KeysymRow{XK_Tab, XK_ISO_Left_Tab, NamedKey::Tab},
    KeysymRow{XK_space, XK_KP_Space, NamedKey::Space},
    KeysymRow{XK_Return, XK_KP_Enter, NamedKey::Return},
    KeysymRow{XK_BackSpace, XK_Delete, NamedKey::Backspace},
    KeysymRow{XK_Escape, XK_Escape, NamedKey::Escape},
    KeysymRow{XK_F11, XK_F11, NamedKey::F11},
};

/// The letter of ASCII that a key has in another group of the keyboard's layout; 0 if it has none. So the
/// keys of the program work while Russian or Greek is written.
char letterOfOtherGroup(const XKeyEvent& event) {
  for (int group = 0; group < XkbNumKbdGroups; ++group) {
    const KeySym symbol = XkbKeycodeToKeysym(event.display, static_cast<KeyCode>(event.keycode), group,
                                             (event.state & ShiftMask) != 0);
    if (group == static_cast<int>(XkbGroupForCoreState(event.state)) || symbol <= ' ' || symbol > '~')
      continue;
    KeySym lower = symbol, upper = symbol;
    if ((event.state & LockMask) != 0) XConvertCase(symbol, &lower, &upper);
    return static_cast<char>(symbol == lower ? upper : lower);
  }
  return 0;
}

/// Translates a key event: keysyms to named keys, letters of ASCII to themselves.
std::optional<Key> keyOf(XKeyEvent& event) {
  char letter = 0;
  KeySym symbol = NoSymbol;
  const int count = XLookupString(&event, &letter, 1, &symbol, nullptr);
  const bool shift = (event.state & ShiftMask) != 0;
  const auto* const row = std::ranges::find_if(
      kNamedKeys, [&](const KeysymRow& r) { return r.symbol == symbol || r.onKeypad == symbol; });
  if (row != kNamedKeys.end()) return Key{row->name, 0, shift || symbol == XK_ISO_Left_Tab};
  if (count == 0 && (event.state & ControlMask) == 0) letter = letterOfOtherGroup(event);
  if (letter > ' ') return Key{NamedKey::Letter, letter, shift};
  return std::nullopt;
}

template <Key kWanted>
Bool isKey(Display*, XEvent* event, XPointer) {
  const std::optional<Key> key = event->type == KeyPress ? keyOf(event->xkey) : std::nullopt;
  return key && key->isSameKeyAs(kWanted);
}

/// Ends the program: there is no window left to draw into.
[[noreturn]] void endWithoutWindow() {
  std::cerr << "xnewell: the window was destroyed by another program" << std::endl;
  _exit(1);
}

class Viewer {
 public:
  Viewer(const Options& options, Scene scene)
      : server_{options, scene},
        given_{options.size},
        size_{firstSize(options)},
        canvas_{server_.display.get(),
                server_.colormap,
                {.title = titleOf(scene), .width = size_.x, .height = size_.y}},
        selection_{server_.display.get(), canvas_.window()},
        fullScreen_{server_.display.get(), canvas_.window()},
        surface_{options,
                 std::move(scene),
                 server_.setupOf(options),
                 forBench(),
                 [this] { refresh(); },
                 [this] { return pngOf(canvas_, server_.colormap, bench_.image(), bench_.pictureNote()); }},
        title_{titleOf(bench_.scene())},
        plan_{bench_.plan()} {
    surface_.scale(usualScale(), size_.x, size_.y);
    bench_.resize(size_.x, size_.y);
    selectResources(display());
    XkbSetDetectableAutoRepeat(display(), 1, nullptr);  // a held key sends only one release event
  }

  [[nodiscard]] Workbench& bench() { return bench_; }

  int run(const std::function<void()>& shown) {
    {
      ErrorTrap trap{display()};  // if the window cannot be shown, the user cannot close it either
      refresh();                  // draws the first picture before the window appears, unless that takes long
      map();
      trap.check();
    }
    shown();
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
    XSync(display(), 0);  // the server may still refuse the last frame
    if (strayErrors() == 0) return 0;
    throw X11Error{"the X server refused requests (" + std::to_string(strayErrors()) +
                   " in all): what was shown may be wrong"};
  }

 private:
  [[nodiscard]] Display* display() const { return server_.display.get(); }

  [[nodiscard]] Workbench::Server forBench() {
    Workbench::Server server = server_.forBench();
    server.copy = [this](const std::string& text) {
      std::cout << text << std::endl;
      selection_.offer(text, pressedAt_);
    };
    server.fillScreen = [this](std::optional<bool> wish) { return std::optional{fullScreen_.fill(wish)}; };
    return server;
  }

  /// The scale that suits the screen, or the window if its size is given and needs a larger one.
  [[nodiscard]] int usualScale() const {
    const int ofScreen = scaleFor(readResources(display()), screenSize(display()), kMostScale);
    return std::max(ofScreen, given_ ? std::min(given_->x / 960, given_->y / 540) : 1);
  }
  /// Without --size: the usual size at the scale, as far as the screen has room.
  [[nodiscard]] glm::ivec2 firstSize(const Options& options) const {
    if (options.size) return *options.size;
    const glm::ivec2 wanted = options.gave("--scale") ? windowSize(options) : kWindowSize * usualScale();
    return glm::min(wanted, screenSize(display()));
  }

  static std::string titleOf(const Scene& scene) { return "xnewell: " + scene.name; }

  /// True if the work may take long. This is so for the first picture, for another scene or view, for a
  /// change in how much must be sorted, and for everything once something took long in this window. All other
  /// work is done on this thread: a new thread starts with a cold cache, which costs milliseconds.
  [[nodiscard]] bool mayTakeLong() const {
    const Setup& now = bench_.setup();
    return !mapped_ || tookLong_ || titleOf(bench_.scene()) != title_ || bench_.view() != view_ ||
           now.picture.order != order_ || now.divisions != divisions_;
  }

  /// Brings the window up to date.
  void refresh() {
    bringUpToDate(server_, canvas_, bench_, [this] {
      const Stopwatch watch;
      if (bench_.stale() != Workbench::Stale::Everything || !mayTakeLong()) {
        bench_.update(surface_.dragging());
        tookLong_ = tookLong_ || watch.ms() > kLong;
        return;
      }
      const bool mayEnd = bench_.isSaved() && !bench_.isAsking();
      BusyNote note{.mayEnd = mayEnd, .mayGiveUp = bench_.hasShown()};
      doPatiently([this] { bench_.update(surface_.dragging()); },
                  [&](int seconds) { return sayBusy(seconds, note); });
      tookLong_ = tookLong_ || watch.ms() > kLong;
    });
    plan_ = bench_.plan();
    view_ = bench_.view();
    order_ = bench_.setup().picture.order;
    divisions_ = bench_.setup().divisions;
    if (busyFor_ >= 0) XUndefineCursor(display(), canvas_.window());
    busyFor_ = -1;
    entitle(titleOf(bench_.scene()));
  }

  void entitle(const std::string& title) {
    if (title != std::exchange(title_, title)) canvas_.entitle(title);
  }

  /// Draws a box over what is shown, or over an empty window, while the bench works and must not be touched.
  /// Most events wait. Three kinds do not: those that uncover parts of the window, those that close it if
  /// nothing would be lost, and Esc. Returns true if the work should be given up.
  bool sayBusy(int seconds, BusyNote& note) {
    const std::scoped_lock alone{server_.turn};
    XEvent event;
    while (XCheckTypedEvent(display(), Expose, &event)) handle(event);
    if (XCheckTypedEvent(display(), DestroyNotify, &event)) endWithoutWindow();
    if (note.mayEnd && XCheckTypedEvent(display(), ClientMessage, &event) && canvas_.isCloseRequest(event))
      _exit(0);
    if (note.mayEnd && XCheckIfEvent(display(), &event, isKey<Key{'q'}>, nullptr)) _exit(0);
    const bool giveUp =
        note.mayGiveUp && XCheckIfEvent(display(), &event, isKey<Key{NamedKey::Escape}>, nullptr);
    if (giveUp) {  // the work is told before the window says so
      note.mayGiveUp = false, note.givesUp = true;
      return true;
    }
    if (seconds == busyFor_ && !note.givesUp) return false;
    IndexImage box{canvas_.width(), canvas_.height(), plan_[Cell::Paper]};
    drawBusyBox(box, bench_.layout().unit, plan_, seconds, note);
    if (busyFor_ < 0) {
      entitle("(drawing) " + title_);
      if (watch_ == 0) watch_ = XCreateFontCursor(display(), XC_watch);
      XDefineCursor(display(), canvas_.window(), watch_);
    }
    if (!mapped_) {  // no picture was stored yet, so only the interface's colours are needed
      const Palette tool = withInterface(server_.colormap.unneeded(), plan_);
      (void)server_.colormap.lookUp(tool, plan_);
      server_.colormap.store(tool, plan_);
      canvas_.upload(box, {0, 0, box.width, box.height});
    }
    canvas_.present(box, busyBox(box.width, box.height, bench_.layout().unit));
    map();
    XFlush(display());
    busyFor_ = seconds;
    return false;
  }

  void map() {
    if (!std::exchange(mapped_, true)) canvas_.map();
  }

  [[nodiscard]] bool errorsToTell() const { return strayErrors() > 0 && !toldOfErrors_; }

  /// The longest time to wait for events, in milliseconds; -1 if nothing but an event can happen.
  [[nodiscard]] int longestWait() {
    if (XPending(display()) > 0 || errorsToTell() || bench_.stale() != Workbench::Stale::Nothing) return 0;
    return surface_.tick();
  }

  /// Calls the handler of the event's type.
  void handle(XEvent& event) {
    using Handler = void (Viewer::*)(XEvent&);
    static const auto handlers = [] {
      std::array<Handler, LASTEvent> of{};
      of[Expose] = &Viewer::exposed;
      of[ConfigureNotify] = &Viewer::configured;
      of[DestroyNotify] = &Viewer::destroyed;
      of[MapNotify] = of[FocusIn] = &Viewer::cameToFront;
      of[FocusOut] = &Viewer::lostFocus;
      of[EnterNotify] = of[LeaveNotify] = &Viewer::crossed;
      of[ColormapNotify] = &Viewer::colormapChanged;
      of[KeyPress] = of[KeyRelease] = &Viewer::key;
      of[ButtonPress] = &Viewer::pressed;
      of[ButtonRelease] = &Viewer::released;
      of[MotionNotify] = &Viewer::moved;
      of[ClientMessage] = &Viewer::message;
      of[MappingNotify] = &Viewer::keyboardChanged;
      of[SelectionRequest] = &Viewer::asked;
      of[PropertyNotify] = &Viewer::propertyChanged;
      return of;
    }();
    if (event.type < 0 || event.type >= LASTEvent) return;  // of an extension
    if (const Handler handler = handlers[event.type]) (this->*handler)(event);
  }

  void exposed(XEvent& event) {
    const XExposeEvent& e = event.xexpose;
    canvas_.expose({e.x, e.y, e.width, e.height});
  }
  void configured(XEvent& event) { resized(event.xconfigure.width, event.xconfigure.height); }
  void destroyed(XEvent&) { endWithoutWindow(); }
  void cameToFront(XEvent&) { server_.colormap.installUnlessManaged(); }
  /// A key released in another window sends us no event.
  void lostFocus(XEvent&) { bench_.release('h'); }
  void crossed(XEvent& event) {
    pointerInside_ = event.type == EnterNotify;
    if (pointerInside_) server_.colormap.installUnlessManaged();
  }
  /// If another program installs its map while the pointer is in our window, we take the screen back. If the
  /// pointer is elsewhere, the map of that window should be installed; two programs that both insisted would
  /// never stop.
  void colormapChanged(XEvent& event) {
    if (event.xcolormap.state == ColormapUninstalled && pointerInside_)
      server_.colormap.installUnlessManaged();
  }
  /// The user has set another resolution of the screen.
  void propertyChanged(XEvent& event) {
    if (isResourceChange(event)) surface_.scale(usualScale(), canvas_.width(), canvas_.height());
  }
  void asked(XEvent& event) { selection_.answer(event.xselectionrequest); }
  void key(XEvent& event) {
    pressedAt_ = event.xkey.time;
    const std::optional<Key> key = keyOf(event.xkey);
    if (!key) return;
    if (event.type == KeyPress && bench_.waits(*key)) refresh();  // press() would, but not patiently
    if (event.type == KeyPress)
      bench_.press(*key);
    else
      bench_.release(key->letter);
  }
  void released(XEvent& event) {
    if (event.xbutton.button == Button1) surface_.letGo();
  }
  void message(XEvent& event) {
    if (canvas_.isCloseRequest(event)) bench_.askToQuit();
  }
  void keyboardChanged(XEvent& event) { XRefreshKeyboardMapping(&event.xmapping); }

  void resized(int width, int height) {
    const int w = std::clamp(width, 1, kMaxPicture), h = std::clamp(height, 1, kMaxPicture);
    try {
      canvas_.resize(w, h);
      bench_.resize(w, h);
    } catch (const X11Error& e) {
      bench_.notify(e.what());
    }
  }

  void pressed(XEvent& event) {
    constexpr double kWheelStep = 1.1;
    const XButtonEvent& e = event.xbutton;
    if (e.button == Button4) bench_.wheel(e.x, e.y, kWheelStep);
    if (e.button == Button5) bench_.wheel(e.x, e.y, 1.0 / kWheelStep);
    if (e.button == Button1) surface_.press(e.x, e.y);
  }
  void moved(XEvent& event) { surface_.move(event.xmotion.x, event.xmotion.y); }

  Server server_;
  std::optional<glm::ivec2> given_;  ///< the window's size, by an option
  glm::ivec2 size_;
  Canvas canvas_;
  Selection selection_;
  FullScreen fullScreen_;
  Time pressedAt_ = 0;  ///< of the last key event
  Surface surface_;
  Workbench& bench_ = surface_.bench();
  static constexpr double kLong = 100;  ///< ms; a longer update counts as long

  std::string title_;
  bool tookLong_ = false;      ///< true once any update took longer than kLong
  View view_ = View::Picture;  ///< this and the next two describe the frame shown
  Order order_ = {};
  int divisions_ = 0;
  CellPlan plan_;     ///< of the frame shown
  int busyFor_ = -1;  ///< the seconds that the busy box shows; -1 if there is no box
  Cursor watch_ = 0;  ///< a resource of the server, freed when the connection ends
  bool mapped_ = false;
  bool pointerInside_ = false;
  bool toldOfErrors_ = false;  ///< the user is told only once, because the notice is one more frame, which
                               ///< the server may refuse too
};

}  // namespace

int showWindow(const Options& options, Scene scene, const std::function<void(Workbench&)>& begin,
               const std::function<void()>& shown) {
  Viewer viewer{options, std::move(scene)};
  if (options.answers.empty()) viewer.bench().lessons().keepAnswersAsUsual();
  begin(viewer.bench());
  return viewer.run(shown);
}

}  // namespace xnewell
