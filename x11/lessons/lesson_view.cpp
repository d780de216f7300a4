#include "x11/lessons/lesson_view.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/files/output_file.h"
#include "shading/scene/units.h"
#include "x11/drawing/wording.h"
#include "x11/homework/hand_ins.h"
#include "x11/kit/quiz.h"
#include "x11/lessons/lesson_facts.h"
#include "x11/lessons/lesson_figure.h"

namespace xnewell {

namespace {

// The buttons of a step, which have no letters.
constexpr ControlId kGive{0, -1}, kBack{0, -2}, kNext{0, -3};

char letterOf(std::size_t answer) { return static_cast<char>('a' + answer); }
ControlId idOf(std::size_t answer) { return {letterOf(answer), -1}; }

Rect columnOf(const Layout& at) {
  return {at.body.x + at.body.width - kLessonColumn, at.body.y, kLessonColumn, figureAreaOf(at).height};
}

}  // namespace

void LessonView::start(Lesson lesson) {
  lesson_ = std::move(lesson);
  taken_.assign(lesson_->steps.size(), {});
  listing_ = false;
  goTo(0);
}

void LessonView::goTo(int step) {
  step_ = step;
  captionOf_ = -1;
  openFigure();
  const Controls all = rows();
  const auto first = std::ranges::find_if(all, &Control::takesArrows);
  list_.setFocus(first == all.end() ? std::nullopt : std::optional{first->id()});
}

void LessonView::openFigure() {
  const Taken& t = taken();
  state_ = {.figure =
                t.given ? now().question->answers[static_cast<std::size_t>(*t.chosen)].shown : now().figure};
  state_.event = 0;  // set to the figure's event once the run is known
  lower_.reset();
  if (state_.figure.stage == View::SideBySide) lower_.emplace(Scene{*state_.figure.scene});
  Setup first;
  first.picture = state_.figure.settings;
  Scene scene = *state_.figure.scene;
  scene.name = lesson_->title;
  if (lesson_->number > 0)  // a game has none
    scene.name = "lesson " + std::to_string(lesson_->number) + " of " +
                 std::to_string(lessons_.entries().size()) + " \u00B7 " + lesson_->title;
  opened_ = true;
  drawn_.reset();
  host_.open(std::move(scene), first);
}

void LessonView::enter() {
  handing_ = false;
  lessons_.read();
  state_.late = true;
  if (!listing_) openFigure();
}

void LessonView::leave() {
  WindowView::leave();
  state_.moving = false;
  if (!opened_ || handing_) return;
  opened_ = false;
  host_.close();
  host_.tell("This is the window's own scene again; 7 goes back to the lesson.");
}

void LessonView::leaveForGood() {
  if (opened_) host_.close();
  opened_ = false;
  host_.switchTo(View::Picture);
}

void LessonView::choose(int answer) {
  const bool wasGiven = taken().given;
  taken().chosen = answer;
  taken().given = false;
  state_.late = true;
  if (wasGiven) openFigure();  // shows the question again, as it was asked
}

void LessonView::give() {
  if (!now().question || taken().given) return goOn(1);
  if (!taken().chosen) return host_.notify("Choose an answer with a letter first, or go on with PgDn.");
  taken().given = true;
  openFigure();
  try {
    answers_.add(*lesson_, step_, *taken().chosen);
  } catch (const std::exception& e) {
    host_.notify(std::string{"The answer is not kept: "} + e.what());
  }
}

void LessonView::goOn(int steps) {
  const int to = step_ + steps;
  if (to < 0) return host_.notify("This is the first step. 7 lists all lessons.");
  if (to < static_cast<int>(lesson_->steps.size())) return goTo(to);
  showList(true);
  const std::string score = answers_.score(lesson_->name);
  done_ = "Done: " + lesson_->title + (score.empty() ? "" : ", " + score);
  const auto after =
      std::ranges::find_if(lessons_.entries(), [&](const auto& e) { return e.number > lesson_->number; });
  if (after != lessons_.entries().end()) lessons_.choose(after->name);
}

void LessonView::showList(bool shown) {
  listing_ = shown;
  done_.clear();
  state_.late = true;
  state_.moving = false;
  if (shown) lessons_.choose(lesson_->name);
}

Controls LessonView::controls() {
  if (listing_) return lessons_.controls();
  Controls all = rows();
  const auto button = [&](ControlId id, std::function<void()> act) {
    all.push_back({.kind = Control::Kind::Button,
                   .key = id.key,
                   .part = id.part,
                   .set = [act = std::move(act)](double) { act(); }});
  };
  if (now().question)
    for (std::size_t k = 0; k < now().question->answers.size(); ++k)
      button(idOf(k), [this, k] { choose(static_cast<int>(k)); });
  button(kGive, [this] { give(); });
  button(kBack, [this] { goOn(-1); });
  button(kNext, [this] { goOn(1); });
  return all;
}

KeyTable LessonView::ownKeys() {
  KeyTable table = listing_ ? lessons_.keys() : KeyTable{};
  const auto add = [&](Key key, std::string legend, std::string does, std::function<void()> act) {
    table.push_back(
        {{key}, std::move(legend), std::move(does), [act = std::move(act)](const Key&) { act(); }});
  };
  if (!listing_) {
    const std::string steps = "the step before, the next";
    add(NamedKey::PageUp, "back", steps, [this] { goOn(-1); });
    add(NamedKey::PageDown, "next", steps, [this] { goOn(1); });
    if (const auto& question = now().question) {
      for (std::size_t k = 0; k < question->answers.size(); ++k)
        add(letterOf(k), "choose", "choose an answer; another letter answers again",
            [this, k] { choose(static_cast<int>(k)); });
      const bool given = taken().given;
      add(NamedKey::Return, given ? "go on" : "answer", "give the answer; then go on", [this] { give(); });
      if (!question->hint.empty())
        add('h', given ? "" : "hint", "a hint", [this] { taken().hint = state_.late = true; });
    } else {
      add(NamedKey::Return, "", "go on", [this] { give(); });
    }
    add('2', "open in the stepper", "the step's scene in the stepper", [this] {
      handing_ = true;  // the stepper keeps the lesson's scene
      host_.sortFrom(state_.figure.stage == View::DepthSort ? state_.event : 0);
    });
    add('8', "explain", "the pixel of the named face, or the middle, in view 8", [this] {
      handing_ = true;  // view 8 keeps the lesson's scene, too
      host_.explain(pixel_.x, pixel_.y);
    });
    table.back().waits = !drawn_;
    add('0', "fill", "fill the named face pixel by pixel in view 0", [this] {
      handing_ = true;
      const std::vector<NamedFace>& names = state_.figure.names;
      host_.fill(names.empty() ? "" : std::to_string(names.front().face));
    });
    add('7', "all lessons", "the list of all lessons", [this] { showList(true); });
    add(NamedKey::Escape, "leave", "leave the lesson: the window's own scene comes back",
        [this] { leaveForGood(); });
  } else if (opened_) {
    add(NamedKey::Escape, "back", "back to the lesson", [this] { showList(false); });
    add('7', "", "back to the lesson", [this] { showList(false); });
  } else {
    add(NamedKey::Escape, "back", "back to the picture", [this] { leaveForGood(); });
  }
  if (opened_)
    table.push_back({.keys = {'w', 'e'},
                     .does = "off in a lesson: it has its own scene and settings",
                     .off = "A lesson has its own scene and settings; Esc leaves the lesson."});
  return table;
}

void LessonView::tick() {
  if (state_.moving) state_.figure.effects.rotate = (state_.figure.effects.rotate + 1) % kMaxShades;
}

bool LessonView::late(const Setup& setup) const {
  return state_.late || drawn_ != setup || (listing_ && lessons_.late()) || list_.late();
}

Rect LessonView::picture(const Layout& at) const {
  if (!lesson_) return figureAreaOf(at);
  return layoutOfFigure(figureAreaOf(at), state_.figure, at.compact).picture;
}

PaletteEffects LessonView::stored(const Setup&) const {
  return listing_ ? PaletteEffects{} : state_.figure.effects;
}

void LessonView::draw(Painter paint, const DrawContext& context) {
  state_.late = false;
  drawn_ = context.setup;
  counts_ = "scene: " + (lesson_ ? state_.figure.sceneName : context.picture.scene().name) + ", " +
            counted(context.picture.snapped().polygons - context.picture.snapped().degenerate, "polygon");
  list_.forgetPlaces();
  Pen pen{paint, context.plan};
  if (listing_)
    lessons_.draw(pen, context.layout, list_, lesson(), answers_, done_);
  else
    drawStep(paint, context);
  list_.draw(pen, controls());
}

void LessonView::drawStep(Painter paint, const DrawContext& context) {
  const bool compact = context.layout.compact;
  const FigureLayout at = layoutOfFigure(figureAreaOf(context.layout), state_.figure, compact);
  aspect_ = static_cast<double>(at.picture.width) / at.picture.height;

  std::optional<Picture> lower;
  if (lower_) {
    PictureSettings settings = state_.figure.beside;
    const Rect place = at.lower * context.layout.unit;
    settings.width = place.width, settings.height = place.height;
    settings.table = context.setup.picture.table;  // the window has one table
    lower = lower_->make(settings, context.plan[Cell::Well]);
  }
  const IndexImage* const lowerImage = lower ? &lower->image() : nullptr;
  const bool sorts = state_.figure.stage == View::DepthSort;
  const Picture picture = sorts ? context.picture.withPlanes() : context.picture;
  std::optional<SortedScene> run;
  if (sorts) {
    run = textbookRun(picture);
    state_.events = static_cast<int>(run->events.size());
    if (state_.event == 0) state_.event = stepOf(*run, state_.figure.event).value_or(state_.events);
    state_.event = std::clamp(state_.event, 1, state_.events);
  }
  PaletteEffects effects = state_.figure.effects;
  effects.rotate = 0;  // the words do not describe the moving ramp
  const PictureSettings& shown = picture.settings();
  pixel_ = {0.5, 0.5};
  if (!state_.figure.names.empty())
    if (const auto place = placeOfLetter(picture.faceImage(), shown.width, shown.height,
                                         state_.figure.names.front().face, /*unit=*/1))
      pixel_ = {(place->x + 0.5) / shown.width, (place->y + 0.5) / shown.height};
  drawFigure(paint, at,
             {.figure = state_.figure,
              .picture = picture,
              .image = picture.image(),
              .lower = lowerImage,
              .run = run ? &*run : nullptr,
              .step = state_.event,
              .plan = context.plan,
              .palette = withEffects(context.palette, context.picture, context.plan, effects)});
  page_ = pageOf(context, lowerImage);
  at_ = layoutOfLesson(columnOf(context.layout), page_, rows(), list_, compact);
  placeButtons();
  if (std::ranges::find(now().controls, 't') != now().controls.end())
    list_.place({'t'}, {.area = at.picture, .grip = at.picture, .bare = true, .passive = true});
  Pen pen{paint, context.plan};
  drawLessonPage(pen, at_, page_);
}

void LessonView::placeButtons() {
  const auto place = [&](ControlId id, const Rect& area) { list_.place(id, {.area = area, .bare = true}); };
  for (std::size_t k = 0; k < at_.answers.size(); ++k) place(idOf(k), at_.answers[k]);
  if (!at_.answer.empty()) place(kGive, at_.answer);
  place(kBack, at_.back);
  place(kNext, at_.next);
}

LessonPage LessonView::pageOf(const DrawContext& context, const IndexImage* lower) {
  ShownFigure facts{context.picture, context.picture.image(), lower, state_.figure};
  const LessonStep& step = now();
  const Taken& t = taken();
  LessonPage page;
  page.heading = step.heading;
  page.step = step_;
  page.steps = static_cast<int>(lesson_->steps.size());
  // The words describe the step as it begins, not what the user tries in it.
  changed_ = context.setup != host_.defaults();
  if (captionOf_ != step_ || (!changed_ && !t.given)) {
    caption_.clear();
    for (const std::string& paragraph : step.caption) caption_.push_back(facts.filled(paragraph));
    captionOf_ = step_;
  }
  page.caption = caption_;
  if (!step.question) return page;
  PageQuestion question;
  question.asks = step.question->asks;
  question.chosen = t.chosen;
  question.given = t.given;
  for (const LessonAnswer& answer : step.question->answers) question.answers.push_back(answer.text);
  if (t.given) {
    const LessonAnswer& answer = step.question->answers[static_cast<std::size_t>(*t.chosen)];
    question.right = answer.holds;
    question.says = facts.filled(answer.says);
  }
  if (t.hint) question.hint = step.question->hint;
  page.question = std::move(question);
  return page;
}

std::string LessonView::aside() const {
  if (listing_) return "";
  if (changed_) return "changed: the words describe the step as it began";
  if (!now().question) return "";
  return taken().given ? "another letter answers again" : "the outcome is hidden until you answer";
}

namespace {

using Kind = Control::Kind;

Control toggle(bool& on, LessonState& state) {
  return {.kind = Kind::Toggle, .value = on ? 1.0 : 0.0, .set = [&](double value) {
            on = value != 0;
            state.late = true;
          }};
}

Control rotateControl(LessonState& state) {
  Control control = toggle(state.moving, state);
  control.set = [&state, set = control.set](double value) {
    set(value);
    if (!state.moving) state.figure.effects.rotate = 0;
  };
  return control;
}

Control eventControl(LessonState& state) {
  const auto go = [&state](int event) {
    state.event = std::clamp(event, 1, state.events);
    state.late = true;
  };
  return {.kind = Kind::Own,
          .value = static_cast<double>(state.event),
          .range = {1, static_cast<double>(state.events), 1, false, 0},
          .words = std::to_string(state.event) + " of " + std::to_string(state.events),
          .set = [go](double event) { go(static_cast<int>(event)); },
          .move = [&state, go](int along, int up) { go(state.event + along + up); }};
}

Control plainControl(char key, LessonState& state, Host& host, double aspect) {
  const ChangeSetup change = [&host](char control, const auto& edit) { host.change(control, edit); };
  const Scene& scene = *state.figure.scene;
  const Subject subject{scene, centreOf(scene), aspect};
  if (key == 'M') return toggle(state.figure.named, state);
  if (key == 'W') return toggle(state.figure.wrongMarked, state);
  if (key == 'm') return rotateControl(state);
  if (key == 'v') return eventControl(state);
  if (key == 'g')
    return gammaControl(state.figure.effects.gamma, [&state](double gamma) {
      state.figure.effects.gamma = gamma;
      state.late = true;
    });
  if (key == 'l') return lightControl(host.setup(), subject, change);
  const Controls camera = cameraControls(host.setup(), subject, change);
  const auto own = std::ranges::find(camera, key, &Control::key);
  return own != camera.end() ? *own : settingControl(key, host.setup(), host.defaults(), change);
}

/// The key in a step where `key` chooses an answer, `a` to `d`.
char spareOf(char key) { return key == 'a' ? 'k' : key == 'c' ? 'x' : key == 'd' ? 'f' : key; }

}  // namespace

Controls stepControls(const LessonStep& step, LessonState& state, Host& host, double aspect) {
  const std::size_t answers = step.question ? step.question->answers.size() : 0;
  Controls all;
  for (const char key : step.controls) {
    const LessonControl& row = *std::ranges::find(lessonControls(), key, &LessonControl::id);
    Control control = plainControl(key, state, host, aspect);
    const bool answer = key >= 'a' && static_cast<std::size_t>(key - 'a') < answers;
    control.key = answer ? spareOf(key) : key;
    control.label = row.label;
    if (!row.is.empty()) control.is = row.is;
    if (!row.words.empty()) control.words = row.words;
    all.push_back(std::move(control));
  }
  return all;
}

void LessonList::read() {
  if (entries_.empty()) entries_ = builtInLessons();
}

void LessonList::choose(const std::string& name) {
  const auto found = std::ranges::find(entries_, name, &LessonEntry::name);
  chosen_ = found == entries_.end() ? 0 : static_cast<int>(found - entries_.begin());
}

void LessonList::openRow(int row) {
  chosen_ = row;
  open_(entries_[static_cast<std::size_t>(row)]);
}

Controls LessonList::controls() {
  Controls all;
  for (int k = 0; k < static_cast<int>(entries_.size()); ++k)
    all.push_back({.kind = Control::Kind::Button, .part = k, .set = [this, k](double) { openRow(k); }});
  return all;
}

KeyTable LessonList::keys() {
  const int last = static_cast<int>(entries_.size()) - 1;
  if (last < 0) return {};
  const auto to = [this, last](int row) {
    return [this, row = std::clamp(row, 0, last)](const Key&) { chosen_ = row; };
  };
  const std::string does = "choose a lesson";
  return {{{NamedKey::Up}, "choose", does, to(chosen_ - 1)},
          {{NamedKey::Down}, "choose", does, to(chosen_ + 1)},
          {{NamedKey::Home}, "", does, to(0)},
          {{NamedKey::End}, "", does, to(last)},
          {{NamedKey::Return}, "begin", "begin the lesson; or click it", [this](const Key&) {
             openRow(chosen_);
           }}};
}

void LessonList::draw(Pen& pen, const Layout& at, ControlList& places, const Lesson* open,
                      const KeptAnswers& answers, std::string_view done) {
  const Rect& body = at.body;
  const int titleEnd = pen.paint.text(body.x, body.y + 21, "Lessons", pen(Cell::Ink), Voice::Title);
  pen.ink(titleEnd + 24, body.y + 21, done);
  pen.softRight(body.x + body.width, body.y + 21, "arrows, then Return; or the pointer");
  pen.rule(body.x, body.y + (at.compact ? 34 : 42), body.width);
  int top = body.y + (at.compact ? 44 : 60);
  const int count = std::max(1, static_cast<int>(entries_.size()));
  const int pitch = std::min(at.compact ? 34 : 44, (body.y + body.height - top) / count);
  const bool close = pitch < 33;  // two lines of text, and hardly anything between the rows
  for (int k = 0; k < static_cast<int>(entries_.size()); ++k, top += pitch) {
    const LessonEntry& lesson = entries_[static_cast<std::size_t>(k)];
    const Rect row{body.x, top, body.width, pitch - (close ? 1 : 4)};
    places.place({0, k}, {.area = row, .bare = true});
    const int y = row.y + (pitch < 26 ? 10 : close ? 11 : at.compact ? 13 : 16);
    if (k == chosen_) {
      pen.paint.fillRect(row, pen(Cell::Focus));
      pen.paint.fillRect({row.x, row.y, 2, row.height}, pen(Cell::Ink));
    }
    pen.softRight(row.x + 32, y, std::to_string(lesson.number));
    const int end = pen.bold(row.x + 48, y, lesson.title);
    if (open && open->name == lesson.name) pen.soft(end + 18, y, "open");
    pen.softRight(row.x + row.width - 8, y, answers.score(lesson.name));
    pen.soft(row.x + 48, y + (pitch < 26 ? 12 : close ? 13 : at.compact ? 14 : 17), lesson.shows);
  }
  drawn_ = chosen_;
}

void LessonView::keepAnswersAsUsual() {
  const std::string file = KeptAnswers::usualFile();
  try {
    if (!file.empty()) answers_.keepIn(file);
  } catch (const std::exception& e) {
    host_.notify(std::string{"Answers are not kept: "} + e.what());
  }
}

std::string KeptAnswers::usualFile() {
  const auto folder = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::filesystem::path{value && *value == '/' ? value : ""};
  };
  std::filesystem::path state = folder("XDG_STATE_HOME");
  if (state.empty() && !folder("HOME").empty()) state = folder("HOME") / ".local/state";
  return state.empty() ? "" : state / "xnewell/answers.json";
}

void KeptAnswers::keepIn(const std::string& file) {
  file_ = file;
  try {
    read();
  } catch (...) {
    file_.clear();
    throw;
  }
}

void KeptAnswers::read() {
  if (file_.empty() || !std::filesystem::exists(file_)) return;
  for (AnsweredQuestion& one : readAnswers(file_))
    lessons_[one.lesson][one.step - 1] = {.tries = std::move(one.tries), .right = one.right};
}

void KeptAnswers::add(const Lesson& lesson, int step, int answer) {
  const auto& answers = lesson.steps[static_cast<std::size_t>(step)].question->answers;
  const auto right = std::ranges::find(answers, true, &LessonAnswer::holds) - answers.begin();
  read();
  Question& question = lessons_[lesson.name][step];
  question.tries.push_back(answer);
  question.right = static_cast<int>(right);
  if (file_.empty()) return;
  std::vector<AnsweredQuestion> all;
  for (const auto& [name, steps] : lessons_)
    for (const auto& [number, kept] : steps) all.push_back({name, number + 1, kept.tries, kept.right});
  if (const auto folder = std::filesystem::path{file_}.parent_path(); !folder.empty())
    std::filesystem::create_directories(folder);
  rewriteFile(file_, answersText(all));
}

std::string KeptAnswers::score(const std::string& lesson) const {
  const auto found = lessons_.find(lesson);
  if (found == lessons_.end()) return "";
  Score score;
  for (const auto& [step, question] : found->second) score.add(question.tries.front() == question.right);
  return score.text();
}

}  // namespace xnewell
