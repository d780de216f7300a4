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
#include "x11/trade/trade_bench.h"
#include "x11/window/colors_bench.h"
#include "x11/window/mach_bench.h"
#include "x11/window/moot.h"
#include "x11/window/picture_bench.h"

namespace xnewell {

Workbench::Work::Work(Scene scene, const Setup& s)
    : pictures{std::move(scene)},
      centre{boxOf(pictures.scene().mesh.points).centre()},
      setup{s},
      defaults{s},
      saved{s},
      divisions{pictures.scene().origin.divisions} {}

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
  fit(this->scene(), setup);
  const auto at = [this](WindowView view) -> auto& { return benches_[static_cast<std::size_t>(view)]; };
  at(WindowView::Picture) = std::make_unique<PictureBench>(*this, [this] { return subject(); });
  auto stepper = std::make_unique<SortBench>(*this);
  stepper_ = stepper.get();
  at(WindowView::DepthSort) = std::move(stepper);
  at(WindowView::Colors) = std::make_unique<ColorsBench>(*this);
  at(WindowView::MachBands) = std::make_unique<MachBench>(*this, [this] { return subject(); });
  auto sides = std::make_unique<SideBench>(
      *this, [this] { return subject(); }, [this] { return mostShades_; });
  sides_ = sides.get();
  at(WindowView::SideBySide) = std::move(sides);
  at(WindowView::Trade) = std::make_unique<TradeBench>(*this);
  auto lessons = std::make_unique<LessonBench>(*this);
  lessons_ = lessons.get();
  at(WindowView::Lesson) = std::move(lessons);
}

void Workbench::resize(int width, int height) {
  width_ = width, height_ = height;
  layout_ = layoutOf(width, height, layout_.unit);
}

void Workbench::scale(int unit) { layout_ = layoutOf(width_, height_, unit); }

void Workbench::teach(Lesson lesson) {
  switchTo(WindowView::Lesson);
  lessons_->start(std::move(lesson));
}

void Workbench::begin(Work work) {
  bench().drop();
  work_ = std::move(work);
  shown_.reset();
}

void Workbench::open(Scene scene, const Setup& setup) {
  Work work = workOn(std::move(scene), setup);
  if (!before_) before_ = std::make_unique<Work>(std::move(work_));
  begin(std::move(work));
}

void Workbench::close() {
  if (!before_) return;
  fit(before_->pictures.scene(), before_->setup);
  begin(std::move(*before_));
  before_.reset();
}

void Workbench::ask(Question question) {
  question_ = std::move(question);
  complaint_.clear();
}

void Workbench::notify(std::string notice) { notice_ = std::move(notice); }

void Workbench::tell(std::string news) { told_ = std::move(news); }

void Workbench::change(char control, const std::function<void(Setup&)>& edit) {
  const SceneLight& own = scene().light;
  if (!own.lights.empty() && (control == 'l' || control == 'p' || control == ']'))
    return notify("The scene has its own lights, so Ip and the light's direction cannot be changed.");
  if (own.Ia && (control == 'i' || control == '['))
    return notify("The scene has its own ambient light, so Ia cannot be changed.");
  Setup next = work_.setup;
  edit(next);
  if (const std::string_view why = keepFillable(next); !why.empty()) notify(std::string{why});
  if (next == work_.setup) return;
  if (control != work_.lastChanged || work_.undo.empty()) work_.undo.push_back(work_.setup);
  if (work_.undo.size() > kMostUndone) work_.undo.erase(work_.undo.begin());
  work_.lastChanged = control;
  work_.redo.clear();
  work_.setup = next;
  if (!work_.pictures.hasLast()) return;
  if (const std::string why = whyMoot(control, picture(), next); !why.empty()) notify(why);
}

void Workbench::press(const Key& key) {
  notice_.clear();
  told_.clear();
  if (key.letter != 'q') warned_ = false;
  if (question_) return answer(key);
  if (help_ && key.letter != '?') {  // the list of keys closes, so that the user sees what the key does
    help_ = false;
    if (key.name == NamedKey::Escape) return;
  }
  if (bench().press(key) || pressIn(generalKeys(), key, *this)) return;
  notify(nameOf(key) + " does nothing here; ? lists all keys.");
}

KeyTable Workbench::keys() {
  KeyTable table = bench().keys();
  append(table, generalKeys());
  return table;
}

KeyTable Workbench::generalKeys() {
  KeyTable table;
  const auto add = [&](char letter, const char* legend, const char* does, auto act) {
    table.push_back({{letter}, legend, does, [act](const Key&) { act(); }});
  };
  if (visitsFromLesson())
    table.push_back({{NamedKey::Escape}, "the lesson", "go back to the lesson", [this](const Key&) {
                       switchTo(WindowView::Lesson);
                     }});
  const char* const undoes = "undo, redo";
  add('u', "undo", undoes, [this] { undo(); });
  add('U', "", undoes, [this] { restore(work_.redo, work_.undo, "redo"); });
  add('r', "reset", "reset everything", [this] { change('r', [this](Setup& s) { s = work_.defaults; }); });
  add('w', "save", "save the set-up as a scene file", [this] { askToSave(); });
  add('e', "", "open a scene", [this] { askToOpen(); });
  for (const WindowViewRow& row : kWindowViews)
    add(row.key, "", "the views; or click their names", [this, id = row.id] { switchTo(id); });
  add('q', "quit", "quit", [this] { quit(); });
  add('?', "all keys", "open this list, close it", [this] { help_ = !help_; });
  return table;
}

/// Buttons call this to do the same as their keys.
void Workbench::pressLetter(char letter) { (void)pressIn(keys(), letter, *this); }

void Workbench::quit() {
  if (isSaved() || std::exchange(warned_, true))
    quit_ = true;
  else
    notify("Changes since " + work_.file + " are not saved: press w to save, or q again to quit.");
}

void Workbench::restore(std::vector<Setup>& from, std::vector<Setup>& to, const char* what) {
  if (from.empty())
    return notify(std::string{"There is nothing to "} + what +
                  (!shown_ || shown_->colors.effects == PaletteEffects{}
                       ? " here."
                       : " here; Esc restores the stored colours."));
  to.push_back(std::exchange(work_.setup, from.back()));
  from.pop_back();
  work_.lastChanged = 0;
}

namespace {

/// The setup of a scene that is opened: what its file asks for, and defaults for the rest.
Setup setupOf(const Scene& scene) {
  Setup setup{scene.settings, scene.settings.inPixels ? Fill::XFillPolygon : Fill::Scanline};
  setup.picture.inPixels = false;
  setup.picture.camera = inSceneUnits(scene.camera, scene);
  toSceneUnits(setup.picture.light, scene);
  return setup;
}

}  // namespace

void Workbench::askToSave() {
  const Scene& scene = this->scene();
  const std::string stem = std::filesystem::path{scene.name}.stem().string();
  ask({.asks = "save the set-up as",
       .text = work_.file.empty() ? stem + "-set-up.json" : work_.file,
       .take = [this, replaced = std::string{}](const std::string& file) mutable -> std::string {
         if (!file.ends_with(".json")) return "A scene file's name ends in .json.";
         if (std::filesystem::is_directory(file)) return "That is a folder.";
         if (file != work_.file && file != replaced && std::filesystem::exists(file)) {
           replaced = file;
           return "The file exists. Press Return again to replace it.";
         }
         PictureSettings settings = work_.setup.picture;
         settings.inPixels = work_.setup.fill == Fill::XFillPolygon;
         try {
           writeFile(file, savedScene(this->scene(), settings, std::filesystem::path{file}.parent_path()));
         } catch (const std::system_error& e) {
           return oneLine(e.what());
         }
         work_.file = file;
         work_.saved = work_.setup;
         told_ = "Saved. \"xnewell " + file + "\" shows " +
                 (view() == WindowView::Picture ? "it" : "the picture of view 1") + " again.";
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
         if (name.empty()) return "Type a name, or press Esc to cancel.";
         try {
           Scene scene = readScene(name);
           const Setup setup = setupOf(scene);
           Work work = workOn(std::move(scene), setup);
           if (name.ends_with(".json")) work.file = name;
           if (!isSaved() && std::exchange(warned, name) != name)
             return "Your changes are not saved. Press Return again to open this and lose them.";
           before_.reset();
           begin(std::move(work));
         } catch (const std::exception& e) {
           return oneLine(e.what());
         }
         return {};
       }});
}

/// Handles a key for the line that the user types.
void Workbench::answer(const Key& key) {
  complaint_.clear();
  std::string& text = question_->text;
  switch (key.name) {
    case NamedKey::Escape:
      return question_.reset();
    case NamedKey::Backspace:
      if (!text.empty()) text.pop_back();
      question_->fresh = false;  // the next letter is added to the text that is left
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

void Workbench::switchTo(WindowView view) {
  if (view_ == view) return;
  bench().leave();
  view_ = view;
  bench().enter();
}

void Workbench::compare(const Setup& B) {
  switchTo(WindowView::SideBySide);
  sides_->put(B);  // after the view was entered, because then B follows what was changed elsewhere
}

void Workbench::keepWithin(std::optional<AccuracyLimit> limit, std::vector<std::string> mine,
                           double seconds) {
  keeper_.reset();
  if (limit) keeper_.emplace(*limit, std::move(mine), TradeRequest{.brief = true, .seconds = seconds});
}

std::optional<AccuracyLimit> Workbench::keptWithin() const {
  return keeper_ ? std::optional{keeper_->limit()} : std::nullopt;
}

AccuracyKeeper::Seen Workbench::seen() const {
  const Rect at = pictureArea();
  return {scene(), work_.setup, work_.divisions, at.width, at.height};
}

bool Workbench::mustMeasure() const {
  // View 6 measures by itself, and a lesson must stay as it is told.
  return keeper_ && !before_ && view() != WindowView::Trade && view() != WindowView::Lesson &&
         work_.pictures.hasLast() && !keeper_->rests(seen());
}

void Workbench::tick() {
  if (bench().moving()) bench().tick();
  if (!mustMeasure() || dragging_ || question_) return;
  std::optional<AccuracyKeeper::News> news = keeper_->tick(seen());
  if (!news) return;
  work_.setup = std::move(news->setup);
  tell(std::move(news->says));
}

Subject Workbench::subject() const {
  const Rect at = bench().picture(layout_);
  return {scene(), work_.centre, static_cast<double>(at.width) / std::max(1, at.height)};
}

bool Workbench::grab(int x, int y) {
  notice_.clear();
  help_ = false;
  question_.reset();
  x /= layout_.unit, y /= layout_.unit;
  if (const std::optional<WindowView> tab = tabAt(layout_, x, y)) return switchTo(*tab), false;
  return isDrawn() && bench().grab(x, y);
}

void Workbench::hover(int x, int y) {
  if (!question_ && isDrawn()) bench().hover(x / layout_.unit, y / layout_.unit);
}

void Workbench::settle() {
  bench().drop();
  dragging_ = false;
}

void Workbench::wheel(int x, int y, double factor) {
  const bool overPicture = bench().picture(layout_).has(x / layout_.unit, y / layout_.unit);
  if (overPicture && !question_) zoom(factor);
}

void Workbench::zoom(double factor) {
  const Controls controls = bench().controls();
  if (std::ranges::find(controls, 'z', &Control::key) == controls.end()) return;
  const auto edit = [this](char control, const auto& change) { this->change(control, change); };
  xnewell::zoom(edit, Setup{work_.setup}, subject(), factor);
}

}  // namespace xnewell
