#include "x11/app/workbench.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/scene/save_scene.h"
#include "x11/app/one_line.h"
#include "x11/sides/side_bench.h"
#include "x11/stepper/sort_bench.h"
#include "x11/window/colors_bench.h"
#include "x11/window/mach_bench.h"
#include "x11/window/moot.h"
#include "x11/window/picture_bench.h"

namespace xnewell {

namespace {

/// The setup with the colours of its cells left out: what the indices depend on.
Setup withoutColors(Setup s) {
  s.picture.table.hue = {};
  s.picture.table.bits = 0;
  return s;
}

/// What takes least and still shows where everything is.
PictureSettings coarse(PictureSettings settings) {
  settings.shading = settings.shading == Shading::Full ? Shading::Full : Shading::Flat;
  settings.order = Order::ZSort;
  settings.adapt = 0;
  settings.dither = false;
  return settings;
}

}  // namespace

Workbench::Work::Work(Scene scene, const Setup& s)
    : picture{std::move(scene)},
      centre{boxOf(picture.scene().mesh.points).centre()},
      setup{s},
      defaults{s},
      saved{s},
      divisions{picture.scene().origin.divisions} {}

void Workbench::fit(const Scene& scene, const Setup& setup) {
  mostShades_ = server_.mostShades(planOf(scene, setup.picture) != ColorPlan::OneHue);
}

Workbench::Work Workbench::workOn(Scene scene, Setup setup) {
  (void)keepFillable(setup);
  fit(scene, setup);
  TableSettings& table = setup.picture.table;
  table.shades = std::min(table.shades, mostShades_);
  return {std::move(scene), setup};
}

Workbench::Workbench(Scene scene, const Setup& setup, Server server)
    : work_{std::move(scene), setup}, server_{std::move(server)} {
  fit(work_.picture.scene(), setup);
  const auto at = [this](WindowView view) -> auto& { return benches_[static_cast<std::size_t>(view)]; };
  at(WindowView::Picture) = std::make_unique<PictureBench>(*this, keys_, [this] { return subject(); });
  auto stepper = std::make_unique<SortBench>(*this);
  stepper_ = stepper.get();
  at(WindowView::DepthSort) = std::move(stepper);
  at(WindowView::Colors) = std::make_unique<ColorsBench>(*this);
  at(WindowView::MachBands) = std::make_unique<MachBench>(*this, keys_, [this] { return subject(); });
  at(WindowView::SideBySide) = std::make_unique<SideBench>(
      *this, [this] { return subject(); }, [this] { return mostShades_; });
  auto lessons = std::make_unique<LessonBench>(*this);
  lessons_ = lessons.get();
  at(WindowView::Lesson) = std::move(lessons);
}

void Workbench::resize(int width, int height) {
  if (width == layout_.width && height == layout_.height) return;
  layout_ = layoutOf(width, height);
  repaint_ = true;
}

void Workbench::teach(Lesson lesson) {
  show(WindowView::Lesson);
  lessons_->start(std::move(lesson));
}

void Workbench::begin(Work work) {
  bench().drop();
  work_ = std::move(work);
  repaint_ = true;
  any_ = false;
}

void Workbench::open(Scene scene, const Setup& setup) {
  Work work = workOn(std::move(scene), setup);
  if (!before_) before_ = std::make_unique<Work>(std::move(work_));
  begin(std::move(work));
}

void Workbench::close() {
  if (!before_) return;
  fit(before_->picture.scene(), before_->setup);
  begin(std::move(*before_));
  before_.reset();
}

void Workbench::ask(Question question) {
  question_ = std::move(question);
  complaint_.clear();
  repaint_ = true;
}

void Workbench::notify(std::string notice) {
  notice_ = std::move(notice);
  repaint_ = true;
}

void Workbench::tell(std::string news) {
  told_ = std::move(news);
  repaint_ = true;
}

void Workbench::change(char control, const std::function<void(Setup&)>& edit) {
  const SceneLight& own = work_.picture.scene().light;
  if (!own.lights.empty() && (control == 'l' || control == 'p' || control == ']'))
    return notify("The scene brings its own lights: Ip and where the light is are theirs.");
  if (own.Ia && (control == 'i' || control == '['))
    return notify("The scene brings its own ambient light: Ia is the scene's.");
  Setup next = work_.setup;
  edit(next);
  if (const std::string_view why = keepFillable(next); !why.empty()) notify(std::string{why});
  if (next == work_.setup) return;
  if (control != work_.lastChanged || work_.undo.empty()) work_.undo.push_back(work_.setup);
  if (work_.undo.size() > kMostUndone) work_.undo.erase(work_.undo.begin());
  work_.lastChanged = control;
  work_.redo.clear();
  work_.setup = next;
  if (const std::string why = whyMoot(control, work_.picture, next); !why.empty()) notify(why);
}

void Workbench::press(const Key& key) {
  repaint_ = repaint_ || !notice_.empty() || !told_.empty();
  notice_.clear();
  told_.clear();
  if (key.letter != 'q') warned_ = false;
  if (question_) return answer(key);
  if (help_ && key.letter != '?') {  // whatever is done is to be seen
    pressLetter('?');
    if (key.name == NamedKey::Escape) return;
  }
  if (bench().press(key, work_.setup)) return;
  if (key.name == NamedKey::Escape && visitsFromLesson()) return show(WindowView::Lesson);
  if (key.name == NamedKey::Letter &&
      std::string_view{"uUrwe?q1234567"}.find(key.letter) != std::string_view::npos)
    return pressLetter(key.letter);
  const Setup before = work_.setup;
  keys_.press(key, bench().sharedKeys(), before, subject(), *this);
}

/// What all views have, and for a button what a key does.
void Workbench::pressLetter(char letter) {
  for (const WindowViewRow& row : kWindowViews)
    if (row.key == letter) return show(row.id);
  if (letter == '6') return notify("View 6, what accuracy costs, is not built yet.");
  const auto restore = [this](std::vector<Setup>& from, std::vector<Setup>& to, const char* what) {
    if (from.empty())
      return notify(std::string{"There is nothing to "} + what +
                    (stored_ == PaletteEffects{} ? " here." : " here; Esc puts the stored colours back."));
    to.push_back(std::exchange(work_.setup, from.back()));
    from.pop_back();
    work_.lastChanged = 0;
  };
  switch (letter) {
    case 'q':
      if (isSaved() || std::exchange(warned_, true))
        quit_ = true;
      else
        notify("What was changed since " + work_.file + " is not saved: w saves it, q again leaves it.");
      return;
    case '?':
      help_ = !help_;
      repaint_ = true;
      return;
    case 'w':
      return askToSave();
    case 'e':
      return askToOpen();
    case 'u':
      return restore(work_.undo, work_.redo, "undo");
    case 'U':
      return restore(work_.redo, work_.undo, "redo");
    case 'r':
      return change('r', [this](Setup& s) { s = work_.defaults; });
    default:
      keys_.press({NamedKey::Letter, letter}, allControls(), Setup{work_.setup}, subject(), *this);
  }
}

namespace {

/// How a scene that is opened is set up: as it says itself, and else as by default.
Setup setupOf(const Scene& scene) {
  Setup setup{scene.settings, scene.settings.inPixels ? Fill::XFillPolygon : Fill::Scanline};
  setup.picture.inPixels = false;
  setup.picture.camera = inSceneUnits(scene.camera, scene);
  toSceneUnits(setup.picture.light, scene);
  return setup;
}

}  // namespace

void Workbench::askToSave() {
  const Scene& scene = work_.picture.scene();
  const std::string stem = std::filesystem::path{scene.name}.stem().string();
  ask({.asks = "save the set-up as",
       .text = work_.file.empty() ? stem + "-set-up.json" : work_.file,
       .take = [this, replaced = std::string{}](const std::string& file) mutable -> std::string {
         if (!file.ends_with(".json")) return "A scene file's name ends in .json.";
         if (std::filesystem::is_directory(file)) return "That is a folder.";
         if (file != work_.file && file != replaced && std::filesystem::exists(file)) {
           replaced = file;
           return "It is there already: Return again replaces it.";
         }
         PictureSettings settings = work_.setup.picture;
         settings.inPixels = work_.setup.fill == Fill::XFillPolygon;
         try {
           writeFile(file,
                     savedScene(work_.picture.scene(), settings, std::filesystem::path{file}.parent_path()));
         } catch (const std::system_error& e) {
           return oneLine(e.what());
         }
         work_.file = file;
         work_.saved = work_.setup;
         told_ = "saved: xnewell " + file + " shows " +
                 (view() == WindowView::Picture ? "it" : "the picture of view 1") + " again";
         return {};
       }});
}

void Workbench::askToOpen() {
  std::vector<std::string> names;
  for (const BuiltInScene& scene : builtInScenes()) names.push_back(scene.name);
  ask({.asks = "open a scene: a file, or a built-in name",
       .text = work_.file,
       .offers = std::move(names),
       .take = [this, warned = std::string{}](const std::string& name) mutable -> std::string {
         if (name.empty()) return "Type a name, or Esc leaves it.";
         try {
           Scene scene = readScene(name);
           const Setup setup = setupOf(scene);
           Work work = workOn(std::move(scene), setup);
           if (name.ends_with(".json")) work.file = name;
           if (!isSaved() && std::exchange(warned, name) != name)
             return "What was changed is not saved: Return again opens this and forgets it.";
           before_.reset();
           begin(std::move(work));
         } catch (const std::exception& e) {
           return oneLine(e.what());
         }
         return {};
       }});
}

/// A key for the line that is typed.
void Workbench::answer(const Key& key) {
  repaint_ = true;
  complaint_.clear();
  std::string& text = question_->text;
  switch (key.name) {
    case NamedKey::Escape:
      return question_.reset();
    case NamedKey::Backspace:
      if (!text.empty()) text.pop_back();
      question_->fresh = false;  // the rest is kept
      return;
    case NamedKey::Return: {
      const Question asked = *std::exchange(question_, std::nullopt);
      complaint_ = asked.take(asked.text);
      if (!complaint_.empty()) question_ = asked;
      return;
    }
    case NamedKey::Space:
      text += ' ';
      return;
    case NamedKey::Up:
    case NamedKey::Down: {
      const std::vector<std::string>& offers = question_->offers;
      if (offers.empty()) return;
      const auto at = std::ranges::find(offers, text);
      if (key.name == NamedKey::Up)
        text = at == offers.begin() || at == offers.end() ? offers.back() : *(at - 1);
      else
        text = at == offers.end() || at + 1 == offers.end() ? offers.front() : *(at + 1);
      question_->fresh = true;
      return;
    }
    case NamedKey::Letter: {
      if (question_->fresh) text.clear();
      text += key.letter;
      question_->fresh = false;
      return;
    }
    default:
      return;
  }
}

void Workbench::show(WindowView view) {
  if (view_ == view) return;
  bench().leave();
  view_ = view;
  bench().enter();
  repaint_ = true;
}

ControlKeys::Subject Workbench::subject() const {
  const Rect at = bench().picture(layout_);
  return {work_.picture.scene(), work_.centre, static_cast<double>(at.width) / std::max(1, at.height)};
}

bool Workbench::grab(int x, int y) {
  repaint_ = repaint_ || !notice_.empty() || help_ || question_;
  notice_.clear();
  help_ = false;
  question_.reset();
  if (const std::optional<WindowView> tab = tabAt(layout_, x, y)) return show(*tab), false;
  return isDrawn() && bench().grab(x, y);
}

void Workbench::hover(int x, int y) {
  if (!question_ && isDrawn()) bench().hover(x, y);
}

void Workbench::settle() {
  bench().drop();
  repaint_ = repaint_ || dragged_;
}

void Workbench::wheel(int x, int y, double factor) {
  const bool overPicture = bench().picture(layout_).has(x, y);
  if (overPicture && !question_) zoom(factor);
}

void Workbench::zoom(double factor) {
  if (bench().sharedKeys().find('z') != std::string_view::npos)
    xnewell::zoom(*this, Setup{work_.setup}, subject(), factor);
}

Workbench::Stale Workbench::stale() const {
  if (!any_ || repaint_ || withoutColors(painted()) != drawnIndices_) return Stale::Everything;
  if (work_.setup != drawn_ || bench().stored(work_.setup) != stored_)
    return bench().colors() ? Stale::Everything : Stale::Colors;
  return bench().late(work_.setup) ? Stale::Everything : Stale::Nothing;
}

PictureSettings Workbench::sized() const {
  const Rect at = bench().picture(layout_);
  PictureSettings settings = painted().picture;
  settings.width = at.width;
  settings.height = at.height;
  settings.inPixels = serverFills();
  return settings;
}

/// Without effects.
Palette Workbench::plainPalette() const {
  const Palette palette = work_.picture.palette(plan(), server_.unneeded);
  return server_.gray ? forGrayScreen(palette, work_.picture) : palette;
}

void Workbench::makePalette() {
  stored_ = bench().stored(work_.setup);
  palette_ = withEffects(plainPalette(), work_.picture, plan(), stored_);
}

std::vector<Legend> Workbench::legend() const {
  std::vector<Legend> all = bench().legend();
  if (visitsFromLesson()) all.insert(all.begin(), {{"Esc"}, "the lesson"});
  all.push_back({{"?"}, "all keys"});
  return all;
}

std::vector<HelpLine> Workbench::helpLines() const {
  std::vector<HelpLine> lines = bench().help();
  lines.insert(lines.end(), {{"1 2 3 ...", "the views; or click their names"},
                             {"u U r", "undo, redo, reset"},
                             {"w e", "save the set-up as a scene file; open one"},
                             {"? or Esc", "close this; q quits"}});
  return lines;
}

/// The scene's patches as the setup wants them: as many divisions as it was read with, if it does not say.
void Workbench::divide() {
  const Scene& scene = work_.picture.scene();
  const int wanted = work_.setup.divisions > 0 ? work_.setup.divisions : work_.divisions;
  if (scene.divisions == 0 || scene.origin.of.empty() || scene.origin.divisions == wanted) return;
  Scene other = redivided(scene, wanted);
  work_.picture = Picture{std::move(other)};
  painted_.reset();
}

void Workbench::drawFrame(bool dragging) {
  const PictureSettings wanted = sized();
  Bench& view = bench();
  const bool whole = view.wantsImage();
  const bool quick = dragging && slow_ && whole && !serverFills() && coarse(wanted) != wanted;
  divide();
  Picture& picture = work_.picture;
  const PictureSettings made = quick ? coarse(wanted) : wanted;
  picture.make(made);
  const CellPlan cells = plan();
  const bool fresh = !any_ || !whole || painted_ != made;
  if (whole && fresh) picture.paint(pictureImage_, cells[Cell::Well]);
  painted_ = whole ? std::optional{made} : std::nullopt;
  slow_ = dragging && (quick || picture.times().total() > kFluid);
  dragged_ = dragging;

  makePalette();
  image_.width = layout_.width, image_.height = layout_.height;
  image_.pixels.assign(static_cast<std::size_t>(layout_.width) * layout_.height, cells[Cell::Paper]);
  const Palette plain = plainPalette();
  const CellUse use = whole ? cellUse(pictureImage_, view.countsPolygons() ? picture.faceImage()
                                                                           : std::vector<std::uint32_t>{})
                            : CellUse{};
  view.draw(image_, {.picture = picture,
                     .image = pictureImage_,
                     .plan = cells,
                     .palette = plain,
                     .use = use,
                     .setup = work_.setup,
                     .layout = layout_,
                     .fresh = fresh,
                     .dragging = dragging,
                     .coarse = quick,
                     .gray = server_.gray});
  const OwnColors* const own = view.colors();
  if (own) palette_ = own->palette;
  panel_ = {.title = titleOf(picture.scene()),
            .visual = server_.visual(),
            .view = this->view(),
            .words = own && own->words ? *own->words : wordsOf(picture, stored_),
            .use = view.use() ? *view.use() : use,
            .inspected = view.inspected(),
            .status = view.status(),
            .aside = view.aside(),
            .notice = notice_,
            .told = told_,
            .legend = legend(),
            .help = help_ ? helpLines() : std::vector<HelpLine>{}};
  if (question_)
    panel_.typed = Typed{question_->asks, question_->text, complaint_, !question_->offers.empty()};
  drawPanel(image_, layout_, panel_, cells);
  drawnIndices_ = withoutColors(painted());
  drawnView_ = this->view();
  drawnLayout_ = layout_;
}

void Workbench::update(bool dragging) {
  if (stale() == Stale::Colors) {
    work_.picture.make(sized());
    makePalette();
  } else if (stale() == Stale::Everything) {
    try {
      drawFrame(dragging);
    } catch (const std::runtime_error& e) {  // also of a file that was there before
      if (!any_) throw;
      work_.setup = drawn_;
      bench().leave();
      bench().enter();
      notify(e.what());
      drawFrame(dragging);
    }
  }
  drawn_ = work_.setup;
  any_ = true;
  repaint_ = false;
}

}  // namespace xnewell
