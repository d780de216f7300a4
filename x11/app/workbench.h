#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "x11/lessons/lesson_bench.h"
#include "x11/window/bench.h"
#include "x11/window/control_keys.h"
#include "x11/window/panel.h"

namespace xnewell {

class SortBench;

/// The window without a server: what keys and the mouse do to the setup, and the index image and palette that
/// show it. The event loop (viewer.h) and the pictures of the whole window use the same one. Each view is a
/// Bench; what they share is here: the scene's picture, the setup with its undo, and the bands.
class Workbench : public Host {
 public:
  /// Cell plan of a table on the server at hand, and the colours of cells that nobody needs.
  struct Server {
    std::function<CellPlan(TableKind)> plan = [](TableKind t) { return CellPlan{t}; };
    Palette unneeded{};
    std::function<std::string()> visual = [] { return std::string{}; };  ///< for the status line
    bool gray = false;                                                   ///< shows grays only
    /// For how many shades it has cells, of one hue or divided among several: asked for each scene anew.
    std::function<int(bool severalHues)> mostShades = [](bool) { return kMaxShades; };
  };
  Workbench(Scene scene, const Setup& setup, Server server);
  Workbench(Workbench&&) = delete;  // the benches know it
  ~Workbench() override = default;

  void resize(int width, int height);
  void press(const Key& key);
  /// A letter let go, where that means something.
  void release(char letter) { bench().release(letter); }
  /// Shows a lesson from its first step.
  void teach(Lesson lesson);
  /// For those who draw step by step.
  [[nodiscard]] LessonBench& lessons() { return *lessons_; }
  [[nodiscard]] SortBench& stepper() { return *stepper_; }
  /// The button pressed: whether what follows until it is let go, and settle(), is a drag.
  [[nodiscard]] bool grab(int x, int y);
  void dragTo(int x, int y) { bench().dragTo(x, y); }
  /// After dragging: what was left out meanwhile is asked for.
  void settle();
  /// The mouse moved with no button pressed.
  void hover(int x, int y);
  /// > 1 comes nearer; the wheel does so over the picture.
  void zoom(double factor);
  void wheel(int x, int y, double factor);

  /// As `q`, whatever is being typed.
  void askToQuit() {
    question_.reset();
    press({NamedKey::Letter, 'q'});
  }
  /// Whether nothing is lost by leaving.
  [[nodiscard]] bool isSaved() const { return work_.file.empty() || work_.setup == work_.saved; }
  /// Whether letters are typed into a line.
  [[nodiscard]] bool isAsking() const { return question_.has_value(); }
  [[nodiscard]] bool quitAsked() const { return quit_; }

  /// Whether something moves by itself: then tick() is to be called every so often.
  [[nodiscard]] bool moving() const { return bench().moving(); }
  void tick() { bench().tick(); }

  /// What the last changes ask for, least first: nothing; other colours in the same cells; new indices. In
  /// the view of the colours words about them are indices, and follow the colours in a second update().
  enum class Stale { Nothing, Colors, Everything };
  [[nodiscard]] Stale stale() const;
  /// Brings image and palette up to date. A setup that cannot be drawn is undone and told. While something
  /// is dragged what takes long is left out, and a picture that takes long is made more coarsely.
  void update(bool dragging = false);

  [[nodiscard]] const IndexImage& image() const { return image_; }
  [[nodiscard]] const Palette& palette() const { return palette_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const Scene& scene() const { return work_.pictures.scene(); }
  /// The one that update() made last.
  [[nodiscard]] const Picture& picture() const { return work_.pictures.last(); }
  [[nodiscard]] WindowView view() const { return layout_.roomy ? view_ : WindowView::Picture; }
  /// Whether an X server is to fill the polygons at layout().picture.
  [[nodiscard]] bool serverFills() const {
    return work_.setup.fill == Fill::XFillPolygon && view() == WindowView::Picture &&
           work_.setup.show == Show::Shaded;
  }
  /// Parts of image() that lie over the picture.
  [[nodiscard]] std::vector<Rect> overPicture() const { return drawnOverPicture(layout_, panel_); }
  /// Where the tool's colours are in palette(): by the table that picks the indices.
  [[nodiscard]] CellPlan plan() const { return server_.plan(painted().picture.table.kind); }
  /// The picture's ground in image().
  [[nodiscard]] std::uint8_t ground() const { return plan()[Cell::Well]; }

  // Of Host.
  [[nodiscard]] const Setup& setup() const override { return work_.setup; }
  [[nodiscard]] const Setup& defaults() const override { return work_.defaults; }
  void open(Scene scene, const Setup& setup) override;
  void close() override;
  void switchTo(WindowView view) override;
  void ask(Question question) override;
  void notify(std::string notice) override;
  void tell(std::string news) override;
  void change(char control, const std::function<void(Setup&)>& edit) override;
  void pressLetter(char letter) override;

 private:
  static constexpr std::size_t kMostUndone = 1000;  // steps, of less than a kilobyte
  /// A scene and all that was done to it.
  struct Work {
    Work(Scene scene, const Setup& setup);
    PictureCache pictures;
    glm::dvec3 centre;  ///< of the scene
    Setup setup, defaults;
    std::string file;  ///< a scene file that this is saved in, or was read from; "" for none
    Setup saved;       ///< there
    int divisions;     ///< that it was read with
    std::vector<Setup> undo, redo;
    char lastChanged = 0;  ///< control of the newest undo step: a run of its changes is one step
  };
  /// Everything here that decides which cells the window shows. A bench knows more of its own: Bench::late().
  struct Indices {
    WindowView view;
    int width, height;
    Setup painted;  ///< without the colours of the cells
    std::string notice, told;
    std::array<std::string, 3> typing;  ///< what is asked, typed, and complained of
    bool help;
    bool leftOut;  ///< something takes too long while it is dragged
    bool operator==(const Indices&) const = default;
  };
  /// What decides which colours the cells have.
  struct Colors {
    Setup setup;
    PaletteEffects effects;
    bool operator==(const Colors&) const = default;
  };
  /// What was shown last.
  struct Shown {
    Indices indices;
    Colors colors;
    std::optional<Picture> image;  ///< the picture, if the view wanted its image
  };

  [[nodiscard]] Work workOn(Scene scene, Setup setup);
  /// Asks for cells for a scene's hues.
  void fit(const Scene& scene, const Setup& setup);
  void begin(Work work);
  void answer(const Key& key);
  void askToSave();
  void askToOpen();
  void divide();
  void drawFrame(bool dragging);
  /// Stores the colours of the picture as it was made.
  void makePalette(const PaletteEffects& effects);
  [[nodiscard]] Palette plainPalette() const;
  /// What is to be shown now.
  [[nodiscard]] Indices indices() const;
  [[nodiscard]] Colors colors() const { return {work_.setup, bench().stored(work_.setup)}; }
  [[nodiscard]] Bench& bench() const { return *benches_[static_cast<std::size_t>(view())]; }
  /// The setup by which indices are picked.
  [[nodiscard]] Setup painted() const { return bench().painted(work_.setup); }
  /// That picture at the size the view has for it, which is nothing to undo.
  [[nodiscard]] PictureSettings sized() const;
  [[nodiscard]] ControlKeys::Subject subject() const;
  /// Whether the view was drawn as large as it is: before that it has no places for the pointer.
  [[nodiscard]] bool isDrawn() const {
    return shown_ && shown_->indices.view == view() && shown_->indices.width == layout_.width &&
           shown_->indices.height == layout_.height;
  }
  /// Whether another view shows the scene of the lesson's step.
  [[nodiscard]] bool visitsFromLesson() const { return before_ && view() != WindowView::Lesson; }
  [[nodiscard]] std::vector<Legend> legend() const;
  [[nodiscard]] std::vector<HelpLine> helpLines() const;

  Work work_;
  std::unique_ptr<Work> before_;  ///< open()
  Server server_;
  int mostShades_ = kMaxShades;
  ControlKeys keys_;
  std::array<std::unique_ptr<Bench>, kEveryWindowView> benches_;
  LessonBench* lessons_;  ///< one of them
  SortBench* stepper_;    ///< another
  WindowView view_ = WindowView::Picture;
  Layout layout_;
  PanelState panel_;
  std::string notice_, told_;  ///< sentences for the status line until the next key: a warning, plain news
  std::optional<Question> question_;
  std::string complaint_;  ///< of what was typed
  bool help_ = false, quit_ = false;
  bool warned_ = false;    ///< that changes are not saved
  bool dragging_ = false;  ///< the window was drawn during a drag that is not settled
  bool slow_ = false;      ///< the drag is too slow with the whole picture
  std::optional<Shown> shown_;
  IndexImage image_;
  Palette palette_{};
};

}  // namespace xnewell
