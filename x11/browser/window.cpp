#include <emscripten.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/png.h"
#include "x11/app/snapshot.h"
#include "x11/app/surface.h"
#include "x11/app/viewer.h"
#include "x11/app/work.h"
#include "x11/options/shell_words.h"
#include "x11/visual/x11_error.h"

/// What the page does for the window (page.html).
EM_JS(int, hasPage, (), { return Module.page ? 1 : 0; });
EM_JS(void, copyText, (const char* text, const char* address),
      { Module.page.copy(UTF8ToString(text), UTF8ToString(address)); });
EM_JS(void, fillPage, (int full), { Module.page.fill(full > 0); });

namespace xnewell {

int program(int argc, char** argv);  // of the commands

namespace {

struct PageSize {
  int width = 1024, height = 768, unit = 1;
} page;

/// What the page shows, and what it must know beside. `stale` is as Workbench::Stale.
struct Frame {
  int stale, width, height;
  const std::uint8_t *cells, *colors;
  int saved, dragging;
};

/// The window in a page: keys and the pointer in, an image of indices and a table of 256 colours out.
class Window {
 public:
  Window(const Options& options, Scene scene)
      : size_{options.size},
        surface_{options,
                 std::move(scene),
                 setupOf(options),
                 forBench(),
                 [this] { (void)update(); },
                 [this] { return encodePng(bench().image(), bench().palette(), bench().pictureNote()); }} {
    resize();
    if (options.answers.empty()) bench().lessons().keepAnswers("answers.json");
  }

  [[nodiscard]] Surface& surface() { return surface_; }
  [[nodiscard]] Workbench& bench() { return surface_.bench(); }

  void resize() {
    const glm::ivec2 size = size_.value_or(glm::ivec2{page.width, page.height});
    surface_.scale(page.unit, size.x, size.y);
    bench().resize(size.x, size.y);
  }

  /// Brings image and colours up to date, and says what was out of date.
  Frame update() {
    (void)surface_.tick();
    if (bench().serverFills()) {
      bench().change('F', [](Setup& s) { s.fill = Fill::Scanline; });
      bench().notify("A page has no X server, and so no XFillPolygon.");
    }
    const Workbench::Stale stale = bench().stale();
    bench().update(surface_.dragging());
    for (std::size_t k = 0; k < bench().palette().size(); ++k) {
      const Rgb16 c = bench().palette()[k];
      std::ranges::copy(std::array{c.r >> 8, c.g >> 8, c.b >> 8, 255}, &colors_[4 * k]);
    }
    const IndexImage& image = bench().image();
    return {static_cast<int>(stale), image.width,       image.height,       image.pixels.data(),
            colors_.data(),          bench().isSaved(), surface_.dragging()};
  }

  /// What the window says, a line each, for a screen reader.
  [[nodiscard]] std::string words() {
    const PanelState& panel = bench().panel();
    std::string words = panel.notice.empty() ? panel.told : panel.notice;
    if (panel.typed) words = panel.typed->asks + ": " + panel.typed->text + ". " + panel.typed->complaint;
    for (const std::string& line : bench().bench().report()) words += '\n' + line;
    return words;
  }

  [[nodiscard]] std::string address() { return addressOf(bench().pictureNote()); }
  /// For the page, until the next call.
  [[nodiscard]] const char* kept(std::string text) { return (kept_ = std::move(text)).c_str(); }

 private:
  [[nodiscard]] Workbench::Server forBench() {
    Workbench::Server server;
    server.visual = [] { return std::string{"a page, 256 of 256 cells"}; };
    server.shownBits = 8;
    server.copy = [this](const std::string& text) { copyText(text.c_str(), address().c_str()); };
    server.fillScreen = [this](std::optional<bool> wish) {
      full_ = wish.value_or(!full_);
      fillPage(full_ ? 1 : 0);
      return std::optional{full_};
    };
    return server;
  }

  std::optional<glm::ivec2> size_;  ///< that an option says: then the page shows it larger or smaller
  Surface surface_;
  std::array<std::uint8_t, 1024> colors_{};
  bool full_ = false;
  std::string kept_;
};

std::unique_ptr<Window> window;

}  // namespace

int showWindow(const Options& options, Scene scene, const std::function<void(Workbench&)>& begin,
               const std::function<void()>& shown) {
  if (hasPage() == 0) throw X11Error{"there is no page to show the window in"};
  auto next = std::make_unique<Window>(options, std::move(scene));
  begin(next->bench());
  (void)next->update();
  shown();
  window = std::move(next);
  return 0;
}

// What only an X server can do.
void takeSnapshot(const Options&, Scene, const Taken&) {
  throw X11Error{"there is no X server here; `draw` makes the same picture"};
}
std::string visualsTable(const Options&) { throw X11Error{"there is no X server here"}; }

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
/// The page names keys by their places in NamedKey.
static_assert(static_cast<int>(xnewell::NamedKey::F11) == 14);
EMSCRIPTEN_KEEPALIVE void xn_key(int name, int letter, int shift, int down) {
  const xnewell::Key key{static_cast<xnewell::NamedKey>(name), static_cast<char>(letter), shift != 0};
  if (down == 0)
    window->bench().release(key.letter);
  else
    window->bench().press(key);
  if (window->bench().quitAsked()) window->bench().notify("Close the page to quit.");
}
EMSCRIPTEN_KEEPALIVE void xn_point(int press, int x, int y) {
  if (press != 0)
    window->surface().press(x, y);
  else
    window->surface().move(x, y);
}
EMSCRIPTEN_KEEPALIVE void xn_let_go() { window->surface().letGo(); }
EMSCRIPTEN_KEEPALIVE void xn_wheel(int x, int y, double factor) { window->bench().wheel(x, y, factor); }

EMSCRIPTEN_KEEPALIVE const xnewell::Frame* xn_update() {
  static xnewell::Frame frame;
  frame = window->update();
  return &frame;
}
EMSCRIPTEN_KEEPALIVE const char* xn_words() { return window->kept(window->words()); }
/// What a link to this moment says.
EMSCRIPTEN_KEEPALIVE const char* xn_address() { return window->kept(window->address()); }
}
