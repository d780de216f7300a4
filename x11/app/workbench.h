#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "x11/app/lecture.h"
#include "x11/app/work.h"
#include "x11/kit/typed_line.h"
#include "x11/lessons/lesson_view.h"
#include "x11/window/panel.h"
#include "x11/window/window_view.h"

namespace xnewell {

class ColorsView;
class MachBandsView;
class PictureView;
class PixelView;
class ScanlineView;
class SideBySideView;
class SortView;
class ViewingView;

/// The window without a server: what keys and the mouse do to the setup, and the index image and palette that
/// show it. The event loop (viewer.h) and snapshots of the whole window use this class. Each view is a
/// WindowView. The workbench holds what they share: the scene's picture, the setup with its undo, and the
/// bands.
class Workbench : public Host {
 public:
  /// What the workbench needs from the server, such as the cell plan for a table and the colours of cells
  /// that nobody needs.
  struct Server {
    std::function<CellPlan(TableKind)> plan = [](TableKind t) { return CellPlan{t}; };
    Palette unneeded{};
    std::function<std::string()> visual = [] { return std::string{}; };  ///< words for the status line
    bool gray = false;  ///< true if the screen shows only grays
    int shownBits = 0;  ///< as VisualInfo::shownBits(); 0 without a server
    /// The most shades that the server has cells for, of one hue or divided among several. Each new scene
    /// asks again.
    std::function<int(bool severalHues)> mostShades = [](bool) { return kMaxShades; };
    /// Prints a text, and lets other programs paste it.
    std::function<void(const std::string&)> copy = [](const std::string&) {};
    /// What the window shows, as the bytes of a PNG file with a note; "" if there is no window.
    std::function<std::string()> picture = [] { return std::string{}; };
    /// Prints a text for whoever stands before the class.
    std::function<void(const std::string&)> say = [](const std::string&) {};
    /// Makes the window fill the screen, or gives it its old place again; without a wish, the other than now.
    /// Returns true if it fills the screen; nothing if there is no screen.
    std::function<std::optional<bool>(std::optional<bool> wish)> fillScreen = [](auto) {
      return std::optional<bool>{};
    };
  };
  Workbench(Scene scene, const Setup& setup, Server server);
  Workbench(Workbench&&) = delete;  // the benches point to it
  ~Workbench() override = default;

  /// The size of the window, in pixels.
  void resize(int width, int height);
  /// How many pixels a unit of the layout is wide. Everything but the picture's samples grows with it. A
  /// window that fills the screen has the largest scale at which all fits, for readers at the back, until
  /// the user chooses another.
  void scale(int unit);
  /// True if the user has chosen the scale by a key.
  [[nodiscard]] bool scaleIsChosen() const { return scaleIsChosen_; }
  void press(const Key& key);
  /// A letter key was released. Only some views need to know.
  void release(char letter) { bench().release(letter); }
  /// Goes to a place of the window.
  void goTo(const WindowPlace& place);
  /// Begins where the options of a window say: in the lesson, in the list of lessons, or at a place.
  void begin(const Options& options, std::optional<Lesson> lesson);
  /// For somebody who starts without a wish: few controls, and the opening page over the picture.
  void welcome();
  /// Shows a lesson, beginning with this step; 0 is the first.
  void teach(Lesson lesson, int step = 0);
  /// For code that draws the frames of a lesson or of the stepper.
  [[nodiscard]] LessonView& lessons() { return *lessons_; }
  [[nodiscard]] SortView& stepper() { return *stepper_; }
  /// The pointer, in pixels of the window. The button was pressed. Returns true if a drag begins; it ends
  /// when the button is released and settle() is called.
  [[nodiscard]] bool grab(int x, int y);
  void dragTo(int x, int y) {
    line_.cancel();
    bench().dragTo(x / layout_.unit, y / layout_.unit);
  }
  /// True if press() will update() first.
  [[nodiscard]] bool waits(const Key& key) const { return !line_.isOpen() && bench().waits(key); }
  /// Ends a drag. What the drag left out becomes stale.
  void settle();
  /// The pointer moved with no button pressed.
  void hover(int x, int y);
  /// Zooms; a factor above 1 comes nearer. The wheel zooms only over the picture.
  void zoom(double factor);
  void wheel(int x, int y, double factor);

  /// Does what `q` does, even while the user types on a line.
  void askToQuit() {
    line_.cancel();
    press({NamedKey::Letter, 'q'});
  }
  /// True if quitting loses nothing.
  [[nodiscard]] bool isSaved() const { return work_.isSaved(); }
  /// True while the user types on a line.
  [[nodiscard]] bool isAsking() const { return line_.isOpen(); }
  [[nodiscard]] bool quitAsked() const { return quit_; }

  /// True if something moves by itself. Then tick() must be called at regular intervals.
  [[nodiscard]] bool moving() const { return bench().moving() || (lecture_ && lecture_->plays()); }
  void tick();

  /// What is out of date, from least to most: nothing; only the colours of the cells; the indices. The view
  /// of the colour table draws words about colours as indices. They follow the colours in a second update().
  enum class Stale { Nothing, Colors, Everything };
  [[nodiscard]] Stale stale() const;
  /// Brings image and palette up to date. If a setup cannot be drawn, update() restores the one shown before
  /// and notifies the user; if none was shown before, it throws. So it does if the work is given up
  /// (give_up.h). During a drag, slow parts are left out, and a slow picture is drawn with coarser settings.
  void update(bool dragging = false);
  /// Whether update() has a picture to go back to.
  [[nodiscard]] bool hasShown() const { return shown_.has_value(); }

  [[nodiscard]] const IndexImage& image() const { return image_; }
  [[nodiscard]] const Palette& palette() const { return palette_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const Scene& scene() const { return work_.pictures.scene(); }
  /// The picture that the last update() made. Precondition: hasShown().
  [[nodiscard]] const Picture& picture() const { return shown_.value().picture; }
  [[nodiscard]] View view() const { return layout_.roomy ? view_ : View::Picture; }
  /// True if an X server must fill the polygons at pictureArea().
  [[nodiscard]] bool serverFills() const {
    return work_.setup.fill == Fill::XFillPolygon && view() == View::Picture &&
           work_.setup.show == View::Picture;
  }
  /// The place of the picture of the first view in image().
  [[nodiscard]] Rect pictureArea() const { return inPixels(layout_.picture); }
  /// The parts of image() that lie over the picture.
  [[nodiscard]] std::vector<Rect> overPicture() const {
    std::vector<Rect> parts = drawnOverPicture(layout_, panel_);
    for (Rect& part : parts) part = inPixels(part);
    return parts;
  }
  /// The cells of the interface's colours in palette(). They depend on the table that picks the indices.
  [[nodiscard]] CellPlan plan() const { return server_.plan(painted().picture.table.kind); }
  /// The cell of the picture's background in image().
  [[nodiscard]] std::uint8_t ground() const { return plan()[Cell::Well]; }

  /// Shows the first page of a lecture. PgDn and PgUp turn its pages, in all views.
  void lecture(Lecture lecture);

  /// The view that is shown.
  [[nodiscard]] WindowView& bench() const { return *benches_[static_cast<std::size_t>(view())]; }
  /// What the last drawing has written.
  [[nodiscard]] const Writing& writing() const { return writing_; }
  /// What surrounds the view in the last drawing.
  [[nodiscard]] const PanelState& panel() const { return panel_; }
  /// Where the window is.
  [[nodiscard]] WindowPlace place() const;
  /// For a picture of the window: the beginning of its file's name, and the set-up that it carries.
  [[nodiscard]] std::string pictureName() const;
  [[nodiscard]] std::string pictureNote() const;
  /// The keys that turn the pages of a lecture.
  [[nodiscard]] KeyTable pageKeys();
  /// The keys that all views have.
  [[nodiscard]] KeyTable generalKeys();
  /// All keys that do something at the moment: those of the view and those that all views have.
  [[nodiscard]] KeyTable keys();

  // The functions of Host.
  [[nodiscard]] const Setup& setup() const override { return work_.setup; }
  [[nodiscard]] const Setup& defaults() const override { return work_.defaults; }
  void open(Scene scene, const Setup& setup) override;
  void close() override;
  void switchTo(View view) override;
  void explain(double x, double y) override;
  void explainWrong() override;
  void sortFrom(int step) override;
  void fill(const std::string& polygon) override;
  void compare(const Setup& B) override;
  void ask(Question question) override { line_.ask(std::move(question)); }
  void notify(std::string notice) override { notice_ = std::move(notice); }
  void tell(std::string news) override { told_ = std::move(news); }
  void change(char control, const std::function<void(Setup&)>& edit) override;
  void undo() override { done(work_.undo(), "undo"); }
  /// Buttons call this to do the same as their keys.
  void pressLetter(char letter) override { (void)pressIn(keys(), letter, *this); }

 private:
  /// What decides which cells the window shows, as far as the workbench knows. A bench may know more:
  /// WindowView::late().
  struct Indices {
    View view;
    int width, height, unit;
    Setup painted;  ///< without the colours of the cells
    std::string notice, told;
    std::optional<Pointed> pointed;
    std::optional<Typed> typed;
    bool help;
    Drawer drawer;
    std::string few;
    bool leftOut;  ///< true if the frame was drawn during a drag, which leaves out slow parts
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
    Picture picture;  ///< nothing else reaches a picture, so no key can ask for one before it is made
    bool whole;       ///< the view wanted its image
  };

  /// What the window has of an area of the layout.
  [[nodiscard]] Rect inPixels(const Rect& units) const {
    return intersection(units * layout_.unit, {0, 0, width_, height_});
  }
  [[nodiscard]] Work workOn(Scene scene, Setup setup);
  /// Asks the server for cells for the hues of a scene.
  void fit(const Scene& scene, const Setup& setup);
  void begin(Work work);
  void copyCommand();
  void writePicture();
  /// Writes the figure of what view 1 or 2 shows, and returns its name, or "" if there is none to write.
  std::string writeFigure(const std::string& file);
  void showPage();
  /// True if the key turns the page of the lecture.
  [[nodiscard]] bool turnsPage(const Key& key);
  /// How many pages of a lecture the key turns.
  [[nodiscard]] static int turning(const Key& key) {
    return key.name == NamedKey::PageDown ? 1 : key.name == NamedKey::PageUp ? -1 : 0;
  }
  void layOut();
  void fillScreen(std::optional<bool> wish);
  void takeNextScale();
  void askToSave();
  void askToOpen();
  void drawFrame(bool dragging);
  /// Makes the palette from the colours of the picture and these effects.
  void makePalette(const Picture& picture, const PaletteEffects& effects);
  [[nodiscard]] Palette plainPalette(const Picture& picture) const;
  /// What must be shown now.
  [[nodiscard]] Indices indices() const;
  [[nodiscard]] Colors colors() const { return {work_.setup, bench().stored(work_.setup)}; }
  /// The setup that the picture is painted with. It picks the indices.
  [[nodiscard]] Setup painted() const { return bench().painted(work_.setup); }
  /// The settings of that picture, in the size that the view has for it. The size is not part of the setup,
  /// so undo does not change it.
  [[nodiscard]] PictureSettings sized() const;
  [[nodiscard]] Subject subject() const;
  /// True if the view was drawn at its present size. Before that, it does not know where its parts are, so
  /// the pointer can do nothing.
  [[nodiscard]] bool isDrawn() const {
    return shown_ && shown_->indices.view == view() && shown_->indices.width == width_ &&
           shown_->indices.height == height_ && shown_->indices.unit == layout_.unit &&
           shown_->indices.drawer == layout_.drawer;
  }
  /// What the pointer presses there, if no control of the view has the place.
  [[nodiscard]] std::optional<Pointed> pressableAt(int x, int y);
  /// Goes where a count leads, or says why it leads nowhere.
  void follow(const Pointed& link);
  /// Goes to the place before.
  void goBack();
  /// Switches to a view that the user asked for, or says why it cannot be shown.
  void visit(View view);
  /// Begins a game about the picture (mistake_game.h).
  void play();
  /// True if the window shows the scene of a lesson's step in another view.
  [[nodiscard]] bool visitsFromLesson() const { return before_ && view() != View::Lesson; }
  /// Notifies the user if there was nothing to undo or redo.
  void done(bool something, const char* what);
  void quit();

  Work work_;
  std::unique_ptr<Work> before_;  ///< the work from before open(); null without one
  Server server_;
  int mostShades_ = kMaxShades;
  std::array<std::unique_ptr<WindowView>, kWindowViews.size()> benches_;
  LessonView* lessons_;  ///< one of the benches
  SortView* stepper_;    ///< another one
  PictureView* picture_;
  ColorsView* colors_;
  MachBandsView* bands_;
  SideBySideView* sides_;  ///< and another
  PixelView* pixel_;
  ViewingView* viewing_;
  ScanlineView* scanline_;
  View view_ = View::Picture;
  std::vector<WindowPlace> came_;  ///< the places before, the last one last, to which Esc goes back
  int width_ = 0, height_ = 0;     ///< of the window, in pixels
  int unit_ = 1;                   ///< the scale, unless the window fills the screen
  bool fillsScreen_ = false, largest_ = false, scaleIsChosen_ = false;
  bool sawScanline_ = false;
  unsigned games_ = 0;  ///< how many were played: the seed of the next
  bool shut_ = false;   ///< the user has put the controls away
  std::string few_;     ///< the keys of the controls that a page of a lecture names; "": all
  std::optional<Lecture> lecture_;
  Layout layout_;
  PanelState panel_;
  Writing writing_;                 ///< what the last drawing has written
  std::optional<Pointed> pointed_;  ///< under the pointer
  std::string notice_, told_;  ///< for the status line: a warning (until a key or click), news (until a key)
  TypedLine line_;
  bool help_ = false, quit_ = false;
  bool warned_ = false;    ///< true if the user was told that changes are not saved
  bool dragging_ = false;  ///< true if the last frame was drawn during a drag that is not settled
  bool slow_ = false;      ///< true if the whole picture is too slow for this drag
  std::optional<Shown> shown_;
  IndexImage image_;
  Palette palette_{};
};

}  // namespace xnewell
