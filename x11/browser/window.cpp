#include <emscripten.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exact/give_up.h"
#include "shading/color/png.h"
#include "shading/picture/stopwatch.h"
#include "x11/app/snapshot.h"
#include "x11/app/viewer.h"
#include "x11/app/work.h"
#include "x11/app/workbench.h"
#include "x11/browser/address.h"
#include "x11/visual/x11_error.h"

/// What the page does for the window (page.html).
EM_JS(int, hasPage, (), { return Module.page ? 1 : 0; });
EM_JS(void, copyText, (const char* text, const char* address),
      { Module.page.copy(UTF8ToString(text), UTF8ToString(address)); });
EM_JS(int, shouldGoOn, (int seconds), { return Module.page.goOn(seconds) ? 1 : 0; });
EM_JS(void, fillPage, (int full), { Module.page.fill(full > 0); });

namespace xnewell {

int program(int argc, char** argv);  // of the commands

namespace {

struct PageSize {
  int width = 1024, height = 768, unit = 1;
} page;

/// The names that browsers give to keys.
struct KeyName {
  std::string_view name;
  NamedKey key;
};
constexpr std::array kKeyNames{
    KeyName{"ArrowLeft", NamedKey::Left},   KeyName{"ArrowRight", NamedKey::Right},
    KeyName{"ArrowUp", NamedKey::Up},       KeyName{"ArrowDown", NamedKey::Down},
    KeyName{"Home", NamedKey::Home},        KeyName{"End", NamedKey::End},
    KeyName{"PageUp", NamedKey::PageUp},    KeyName{"PageDown", NamedKey::PageDown},
    KeyName{"Tab", NamedKey::Tab},          KeyName{" ", NamedKey::Space},
    KeyName{"Enter", NamedKey::Return},     KeyName{"Backspace", NamedKey::Backspace},
    KeyName{"Delete", NamedKey::Backspace}, KeyName{"Escape", NamedKey::Escape},
    KeyName{"F11", NamedKey::F11},
};

/// The window in a page: keys and the pointer in, an image of indices and a table of 256 colours out.
class Window {
 public:
  Window(const Options& options, Scene scene)
      : size_{options.size},
        scale_{options.gave("--scale") ? options.scale : 0},
        bench_{std::move(scene), setupOf(options), forBench()} {
    resize();
    bench_.lessons().keepAnswers(options.answers.empty() ? "answers.json" : options.answers);
  }

  [[nodiscard]] Workbench& bench() { return bench_; }

  void resize() {
    const glm::ivec2 size = size_.value_or(glm::ivec2{page.width, page.height});
    if (!bench_.scaleIsChosen())
      bench_.scale(std::min(scale_ > 0 ? scale_ : page.unit, largestScale(size.x, size.y)));
    bench_.resize(size.x, size.y);
  }

  /// Brings image and colours up to date, and says what was out of date.
  Workbench::Stale update() {
    constexpr double kTick = 40, kPatience = 10'000;  // ms
    if (bench_.moving() && sinceTick_.ms() > kTick) {
      sinceTick_ = {};
      bench_.tick();
    }
    if (bench_.serverFills()) {
      bench_.change('F', [](Setup& s) { s.fill = Fill::Scanline; });
      bench_.notify("A page has no X server, and so no XFillPolygon.");
    }
    const Workbench::Stale stale = bench_.stale();
    if (stale == Workbench::Stale::Nothing) return stale;
    const Stopwatch watch;
    double patience = kPatience;
    const MayGiveUp asked{[&] {
      if (!bench_.hasShown() || watch.ms() < patience) return false;
      const bool goOn = shouldGoOn(static_cast<int>(watch.ms() / 1000)) != 0;
      patience = 2 * watch.ms();
      return !goOn;
    }};
    bench_.update(dragging_);
    for (std::size_t k = 0; k < bench_.palette().size(); ++k) {
      const Rgb16 c = bench_.palette()[k];
      std::ranges::copy(std::array{c.r >> 8, c.g >> 8, c.b >> 8, 255}, &colors_[4 * k]);
    }
    return stale;
  }

  [[nodiscard]] const std::uint8_t* colors() const { return colors_.data(); }

  void point(bool press, int x, int y) {
    if (press)
      dragging_ = bench_.grab(x, y);
    else if (dragging_)
      bench_.dragTo(x, y);
    else
      bench_.hover(x, y);
  }
  void letGo() {
    if (std::exchange(dragging_, false)) bench_.settle();
  }

  /// What the window says, a line each, for a screen reader.
  const std::string& words() {
    const PanelState& panel = bench_.panel();
    words_ = panel.notice.empty() ? panel.told : panel.notice;
    if (panel.typed) words_ = panel.typed->asks + ": " + panel.typed->text + ". " + panel.typed->complaint;
    for (const std::string& line : bench_.bench().inWords()) words_ += '\n' + line;
    return words_;
  }

 private:
  [[nodiscard]] Workbench::Server forBench() {
    Workbench::Server server;
    server.visual = [] { return std::string{"a page, 256 of 256 cells"}; };
    server.shownBits = 8;
    server.copy = [this](const std::string& text) {
      copyText(text.c_str(), addressOf(bench_.pictureNote()).c_str());
    };
    server.picture = [this] {
      for (int k = 0; k < 3 && bench_.stale() != Workbench::Stale::Nothing; ++k) update();
      return encodePng(bench_.image(), bench_.palette(), bench_.pictureNote());
    };
    server.say = [](const std::string& text) { std::cout << text << std::flush; };
    server.fillScreen = [this](std::optional<bool> wish) {
      full_ = wish.value_or(!full_);
      fillPage(full_ ? 1 : 0);
      return std::optional{full_};
    };
    return server;
  }

  std::optional<glm::ivec2> size_;  ///< that an option says: then the page shows it larger or smaller
  int scale_;                       ///< that an option says; 0 for none
  Workbench bench_;
  std::array<std::uint8_t, 1024> colors_{};
  std::string words_;
  bool dragging_ = false, full_ = false;
  Stopwatch sinceTick_;
};

std::unique_ptr<Window> window;

int show(const Options& options, Scene scene, const std::function<void(Workbench&)>& begin,
         const std::function<void()>& shown) {
  if (hasPage() == 0) throw X11Error{"there is no page to show the window in"};
  auto next = std::make_unique<Window>(options, std::move(scene));
  begin(next->bench());
  next->update();
  shown();
  window = std::move(next);
  return 0;
}

}  // namespace

int runViewer(const Options& options, Scene scene, std::optional<Lesson> lesson,
              const std::function<void()>& shown) {
  return show(
      options, std::move(scene), [&](Workbench& bench) { bench.begin(options, std::move(lesson)); }, shown);
}

int runLecture(const Options& options, std::vector<Page> pages, const std::function<void()>& shown) {
  Scene scene = pages.front().scene;
  return show(
      options, std::move(scene),
      [&](Workbench& bench) {
        bench.lecture({std::move(pages), options.play});
      },
      shown);
}

}  // namespace xnewell

// What the page calls. All but xn_open() and xn_resize() need a window.
using xnewell::window;

extern "C" {

/// Does what an address says. Returns the exit status of the command, or 1 if there is no window.
EMSCRIPTEN_KEEPALIVE int xn_open(const char* address) {
  std::vector<std::string> words = xnewell::argumentsOf(address);
  words.insert(words.begin(), "xnewell");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int status = xnewell::program(static_cast<int>(words.size()), arguments.data());
  return status == 0 && !window ? 1 : status;
}
EMSCRIPTEN_KEEPALIVE void xn_resize(int width, int height, int unit) {
  xnewell::page = {std::clamp(width, 1, xnewell::kMaxPicture), std::clamp(height, 1, xnewell::kMaxPicture),
                   std::clamp(unit, 1, xnewell::kMostScale)};
  if (window) window->resize();
}
/// Returns 1 if the window knows such a key.
EMSCRIPTEN_KEEPALIVE int xn_key(const char* text, int shift, int down) {
  const std::string_view name{text};
  const auto* const row = std::ranges::find(xnewell::kKeyNames, name, &xnewell::KeyName::name);
  const bool letter = name.size() == 1 && name[0] > ' ' && name[0] <= '~';
  if (row == xnewell::kKeyNames.end() && !letter) return 0;
  const xnewell::Key key = letter ? xnewell::Key{xnewell::NamedKey::Letter, name[0], shift != 0}
                                  : xnewell::Key{row->key, 0, shift != 0};
  if (down == 0)
    window->bench().release(key.letter);
  else
    window->bench().press(key);
  if (window->bench().quitAsked()) window->bench().notify("Close the page to quit.");
  return 1;
}
EMSCRIPTEN_KEEPALIVE void xn_point(int press, int x, int y) { window->point(press != 0, x, y); }
EMSCRIPTEN_KEEPALIVE void xn_let_go() { window->letGo(); }
EMSCRIPTEN_KEEPALIVE void xn_wheel(int x, int y, double factor) { window->bench().wheel(x, y, factor); }
EMSCRIPTEN_KEEPALIVE int xn_saved() { return window->bench().isSaved() ? 1 : 0; }

/// 0: nothing has changed; 1: only the colours; 2: the indices, too.
EMSCRIPTEN_KEEPALIVE int xn_update() { return static_cast<int>(window->update()); }
EMSCRIPTEN_KEEPALIVE int xn_width() { return window->bench().image().width; }
EMSCRIPTEN_KEEPALIVE int xn_height() { return window->bench().image().height; }
EMSCRIPTEN_KEEPALIVE const std::uint8_t* xn_cells() { return window->bench().image().pixels.data(); }
EMSCRIPTEN_KEEPALIVE const std::uint8_t* xn_colors() { return window->colors(); }
EMSCRIPTEN_KEEPALIVE const char* xn_words() { return window->words().c_str(); }
}
