#include <algorithm>

#include "x11/drawing/wording.h"
#include "x11/lessons/lesson_bench.h"
#include "x11/lessons/lesson_facts.h"

namespace xnewell {

// This file draws a lesson and writes the words of the window's bands. Keys and pointer: lesson_bench.cpp.

namespace {

/// Above the bars of the strip.
int heightOf(const Layout& at) { return at.body.height - (at.compact ? 2 : 12); }

Rect columnOf(const Layout& at) {
  return {at.body.x + at.body.width - kLessonColumn, at.body.y, kLessonColumn, heightOf(at)};
}

Rect sightOf(const Layout& at) {
  return {at.body.x, at.body.y, at.body.width - kLessonColumn - kMargin, heightOf(at)};
}

}  // namespace

Rect LessonBench::picture(const Layout& at) const {
  if (!lesson_) return sightOf(at);
  return layoutOfSight(sightOf(at), state_.exhibit, at.compact).picture;
}

PaletteEffects LessonBench::stored(const Setup&) const {
  return lesson_ && !listing_ ? state_.exhibit.effects : PaletteEffects{};
}

void LessonBench::draw(IndexImage& image, const Desk& desk) {
  late_ = false;
  counts_ = "scene: " + (lesson_ && !listing_ ? state_.exhibit.sceneName : desk.picture.scene().name) + ", " +
            counted(desk.picture.snapped().polygons - desk.picture.snapped().degenerate, "polygon");
  if (listing_ || !lesson_) {
    rows_ = layoutOfList(desk.layout.body, list(), desk.layout.compact);
    drawLessonList(image, desk.layout.body, list(), desk.plan, desk.layout.compact);
    return;
  }
  drawStep(image, desk);
}

void LessonBench::drawStep(IndexImage& image, const Desk& desk) {
  const bool compact = desk.layout.compact;
  const SightLayout at = layoutOfSight(sightOf(desk.layout), state_.exhibit, compact);
  sight_ = at.picture;
  aspect_ = static_cast<double>(at.picture.width) / at.picture.height;

  std::optional<Picture> lower;
  if (lower_) {
    PictureSettings settings = state_.exhibit.beside;
    settings.width = at.lower.width, settings.height = at.lower.height;
    settings.table = desk.setup.picture.table;  // the window has one table
    lower = lower_->make(settings, desk.plan[Cell::Well]);
  }
  const IndexImage* const lowerImage = lower ? &lower->image() : nullptr;
  const bool sorts = state_.exhibit.stage == Stage::DepthSort;
  const Picture picture = sorts ? desk.picture.withPlanes() : desk.picture;
  std::optional<SortedScene> run;
  if (sorts) {
    run = textbookRun(picture);
    state_.events = static_cast<int>(run->events.size());
    if (state_.event == 0) state_.event = stepOf(*run, state_.exhibit.event).value_or(state_.events);
    state_.event = std::clamp(state_.event, 1, state_.events);
  }
  PaletteEffects effects = state_.exhibit.effects;
  effects.rotate = 0;  // the words do not describe the moving ramp
  drawSight(image, at,
            {.exhibit = state_.exhibit,
             .picture = picture,
             .image = picture.image(),
             .lower = lowerImage,
             .run = run ? &*run : nullptr,
             .step = state_.event,
             .plan = desk.plan,
             .palette = withEffects(desk.palette, desk.picture, desk.plan, effects)});
  page_ = pageOf(desk, lowerImage);
  at_ = layoutOfLesson(columnOf(desk.layout), page_, compact);
  drawLessonPage(image, at_, page_, desk.plan);
}

LessonPage LessonBench::pageOf(const Desk& desk, const IndexImage* lower) {
  ShownExhibit facts{desk.picture, desk.picture.image(), lower};
  const LessonStep& step = now();
  LessonPage page;
  page.heading = step.heading;
  page.step = step_;
  page.steps = static_cast<int>(lesson_->steps.size());
  // The words describe the step as it begins, not what the user tries in it.
  const bool asItBegins = desk.setup == first_ && !(step.question && taken().given);
  if (captionOf_ != step_ || asItBegins) {
    caption_.clear();
    for (const std::string& paragraph : step.caption) caption_.push_back(facts.filled(paragraph));
    captionOf_ = step_;
  }
  changed_ = desk.setup != first_;
  page.caption = caption_;
  for (const LessonControl control : step.controls) {
    page.controls.push_back(pageControl(control, desk.setup, first_, state_));
    page.controls.back().focused = focus_ == control;
  }
  if (!step.question) return page;
  const Taken& t = taken();
  PageQuestion question;
  question.asks = step.question->asks;
  question.chosen = t.chosen;
  question.given = t.given;
  for (const LessonAnswer& answer : step.question->answers) question.answers.push_back(answer.text);
  if (t.given) question.says = facts.filled(step.question->answers[static_cast<std::size_t>(*t.chosen)].says);
  if (t.hint) question.hint = step.question->hint;
  page.question = std::move(question);
  return page;
}

std::string LessonBench::status() const { return counts_; }

std::string LessonBench::aside() const {
  if (listing_ || !lesson_) return "";
  if (changed_) return "changed: the words describe the step as it began";
  if (!now().question) return "";
  return taken_[static_cast<std::size_t>(step_)].given ? "another letter answers again"
                                                       : "the outcome is hidden until you answer";
}

std::vector<Legend> LessonBench::legend() {
  if (listing_ || !lesson_) return {{{"^", "v"}, "choose"}, {{"Return"}, "begin"}, {{"Esc"}, "back"}};
  std::vector<Legend> words{{{"PgUp"}, "back"}, {{"PgDn"}, "next"}};
  if (const auto& question = now().question) {
    static constexpr std::array<std::string_view, 4> kLetters{"a", "b", "c", "d"};
    Legend letters{{}, "choose"};
    for (std::size_t k = 0; k < question->answers.size(); ++k) letters.keys.emplace_back(kLetters[k]);
    words.push_back(letters);
    const bool given = taken_[static_cast<std::size_t>(step_)].given;
    words.push_back({{"Return"}, given ? "go on" : "answer"});
    if (!given && !question->hint.empty()) words.push_back({{"h"}, "hint"});
  }
  if (focus_) words.push_back({{"<", ">"}, std::string{rowOf(*focus_).name}});
  words.push_back({{"2"}, "open in the stepper"});
  words.push_back({{"l"}, "all lessons"});
  words.push_back({{"Esc"}, "leave"});
  return words;
}

std::vector<HelpLine> LessonBench::help() {
  return {{"PgUp PgDn", "the step before, the next"},
          {"a b c d", "choose an answer; another letter answers again"},
          {"Return", "give the answer; then go on"},
          {"h", "a hint"},
          {"Tab, arrows", "go through the step's controls; change one"},
          {"l", "all lessons"},
          {"2", "the step's scene in the stepper"},
          {"Esc", "leave the lesson: the window's own scene comes back"}};
}

}  // namespace xnewell
