#include "x11/lessons/lesson_bench.h"

#include <algorithm>
#include <stdexcept>

namespace xnewell {

// This file handles keys and pointer. Drawing: lesson_bench_drawing.cpp.

namespace {

bool isOffered(const LessonStep& step, LessonControl control) {
  return std::ranges::find(step.controls, control) != step.controls.end();
}

}  // namespace

void LessonBench::start(Lesson lesson) {
  lesson_ = std::move(lesson);
  taken_.assign(lesson_->steps.size(), {});
  listing_ = false;
  goTo(0);
}

const Exhibit& LessonBench::exhibit() const {
  const Taken& t = taken_[static_cast<std::size_t>(step_)];
  return t.given ? now().question->answers[static_cast<std::size_t>(*t.chosen)].shown : now().exhibit;
}

void LessonBench::goTo(int step) {
  step_ = step;
  focus_.reset();
  for (const LessonControl control : now().controls)
    if (!focus_ && takesArrows(control)) focus_ = control;
  captionOf_ = -1;
  openExhibit();
}

void LessonBench::openExhibit() {
  state_ = {.exhibit = exhibit()};
  state_.event = 0;  // set to the exhibit's event once the run is known
  lower_.reset();
  if (state_.exhibit.stage == Stage::SideBySide) lower_.emplace(Scene{*state_.exhibit.scene});
  first_ = {};
  first_.picture = state_.exhibit.settings;
  Scene scene = *state_.exhibit.scene;
  scene.name = "lesson " + std::to_string(lesson_->number) + " of " + std::to_string(entries_.size()) +
               " \u00B7 " + lesson_->title;
  opened_ = late_ = true;
  host_.open(std::move(scene), first_);
}

void LessonBench::enter() {
  handing_ = false;
  if (entries_.empty()) entries_ = builtInLessons();
  late_ = true;
  if (lesson_ && !listing_) openExhibit();
}

void LessonBench::leave() {
  drop();
  state_.moving = false;
  if (!opened_ || handing_) return;
  opened_ = false;
  host_.close();
  host_.tell("This is the window's own scene again; 7 goes back to the lesson.");
}

void LessonBench::leaveForGood() {
  if (opened_) host_.close();
  opened_ = false;
  host_.switchTo(WindowView::Picture);
}

void LessonBench::choose(int answer) {
  if (!now().question || answer >= static_cast<int>(now().question->answers.size())) return;
  const bool wasGiven = taken().given;
  taken().chosen = answer;
  taken().given = false;
  late_ = true;
  if (wasGiven) openExhibit();  // shows the question again, as it was asked
}

void LessonBench::give() {
  if (!now().question || taken().given) return goOn(1);
  if (!taken().chosen) return host_.notify("Choose an answer with a letter first, or go on with PgDn.");
  taken().given = true;
  openExhibit();
}

void LessonBench::goOn(int steps) {
  const int to = step_ + steps;
  if (to < 0) return host_.notify("This is the first step. l lists all lessons.");
  if (to < static_cast<int>(lesson_->steps.size())) return goTo(to);
  const auto after =
      std::ranges::find_if(entries_, [&](const auto& e) { return e.number > lesson_->number; });
  if (after == entries_.end()) return showList(true);
  start(readLesson(after->file));
}

LessonList LessonBench::list() const {
  LessonList list{.rows = {}, .chosen = listed_, .current = {}};
  for (const LessonEntry& entry : entries_) {
    if (lesson_ && lesson_->name == entry.name) list.current = static_cast<int>(list.rows.size());
    list.rows.push_back({entry.number, entry.title, entry.shows});
  }
  return list;
}

void LessonBench::showList(bool shown) {
  listing_ = shown;
  late_ = true;
  state_.moving = false;
  if (shown) listed_ = list().current.value_or(0);
}

void LessonBench::openListed() {
  if (entries_.empty()) return;
  start(readLesson(entries_[static_cast<std::size_t>(listed_)].file));
}

bool LessonBench::pressInList(const Key& key) {
  const int last = static_cast<int>(entries_.size()) - 1;
  late_ = true;
  switch (key.name) {
    case NamedKey::Up:
      return listed_ = std::max(0, listed_ - 1), true;
    case NamedKey::Down:
      return listed_ = std::min(last, listed_ + 1), true;
    case NamedKey::Home:
      return listed_ = 0, true;
    case NamedKey::End:
      return listed_ = last, true;
    case NamedKey::Return:
      return openListed(), true;
    case NamedKey::Escape:
      return lesson_ && opened_ ? showList(false) : leaveForGood(), true;
    default:
      break;
  }
  if (key.letter == 'l' && lesson_ && opened_) return showList(false), true;
  return key.letter != 'q' && key.letter != '?' && (key.letter < '1' || key.letter > '7');
}

bool LessonBench::press(const Key& key, const Setup&) {
  if (listing_ || !lesson_) return pressInList(key);
  const int times = key.shift ? 10 : 1;
  switch (key.name) {
    case NamedKey::PageUp:
      return goOn(-1), true;
    case NamedKey::PageDown:
      return goOn(1), true;
    case NamedKey::Return:
      return give(), true;
    case NamedKey::Escape:
      return leaveForGood(), true;
    case NamedKey::Tab:
      return nextFocus(key.shift ? -1 : 1), true;
    case NamedKey::Left:
      return arrow(-times, 0), true;
    case NamedKey::Right:
      return arrow(times, 0), true;
    case NamedKey::Up:
      return arrow(0, times), true;
    case NamedKey::Down:
      return arrow(0, -times), true;
    case NamedKey::Home:
      return end(false), true;
    case NamedKey::End:
      return end(true), true;
    default:
      break;
  }
  if (now().question && key.letter >= 'a' && key.letter <= 'd') return choose(key.letter - 'a'), true;
  if (pressControl(key.letter)) return true;
  switch (key.letter) {
    case 'h':
      if (!now().question || now().question->hint.empty()) return true;
      taken().hint = late_ = true;
      return true;
    case 'l':
      return showList(true), true;
    case '2':
      handing_ = true;  // the stepper keeps the lesson's scene
      host_.switchTo(WindowView::DepthSort);
      return true;
    default:
      // These keys work in all views; the others are off.
      if (key.name != NamedKey::Letter ||
          std::string_view{"uUr?q134567"}.find(key.letter) != std::string_view::npos)
        return false;
      host_.notify("That key is off in this step; Esc leaves the lesson.");
      return true;
  }
}

bool LessonBench::pressControl(char letter) {
  const auto* const row = std::ranges::find(kLessonControls, letter, &LessonControlRow::key);
  if (row == kLessonControls.end() || !isOffered(now(), row->id)) return false;
  late_ = true;
  if (takesArrows(row->id))
    focus_ = row->id;
  else if (isLessonsOwn(row->id))
    actOn(state_, row->id);
  else
    change(row->id, [&](Setup& s) { actOn(s, row->id); });
  return true;
}

void LessonBench::change(LessonControl control, const std::function<void(Setup&)>& edit) {
  late_ = true;
  host_.change(rowOf(control).window, edit);
}

void LessonBench::arrow(int along, int up) {
  if (!focus_) return;
  late_ = true;
  if (*focus_ == LessonControl::Event)
    state_.event = std::clamp(state_.event + along + up, 1, state_.events);
  else
    change(*focus_, [&](Setup& s) { move(s, *focus_, along, up, *state_.exhibit.scene, aspect_); });
}

void LessonBench::end(bool high) {
  if (!focus_) return;
  late_ = true;
  if (*focus_ == LessonControl::Event)
    state_.event = high ? state_.events : 1;
  else
    change(*focus_, [&](Setup& s) { moveToEnd(s, *focus_, high); });
}

void LessonBench::nextFocus(int direction) {
  std::vector<LessonControl> all;
  std::ranges::copy_if(now().controls, std::back_inserter(all), takesArrows);
  if (all.empty()) return;
  const auto at = focus_ ? std::ranges::find(all, *focus_) - all.begin() : 0;
  const auto n = static_cast<std::ptrdiff_t>(all.size());
  focus_ = all[static_cast<std::size_t>((at + n + direction) % n)];
  late_ = true;
}

bool LessonBench::grab(int x, int y) {
  x_ = x, y_ = y;
  if (listing_ || !lesson_) {
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (rows_[k].has(x, y)) {
        listed_ = static_cast<int>(k);
        openListed();
        break;
      }
    return false;
  }
  for (std::size_t k = 0; k < at_.answers.size(); ++k)
    if (at_.answers[k].has(x, y)) return choose(static_cast<int>(k)), false;
  if (at_.answer.has(x, y)) return give(), false;
  if (at_.back.has(x, y)) return goOn(-1), false;
  if (at_.next.has(x, y)) return goOn(1), false;
  for (std::size_t k = 0; k < at_.controls.size() && k < now().controls.size(); ++k) {
    if (!at_.controls[k].has(x, y)) continue;
    const LessonControl control = now().controls[k];
    const PageControl& row = page_.controls[k];
    if (takesArrows(control)) {
      focus_ = control;
      late_ = true;
      const auto share = row.track ? trackAt(at_.controls[k], x) : std::nullopt;
      if (!share) return false;
      held_ = control;
      change(control, [&](Setup& s) { moveTo(s, control, *share); });
      return true;
    }
    const std::optional<int> option = optionAt(at_.controls[k], row, x, y);
    if (!option && !row.toggle) return false;
    late_ = true;
    if (isLessonsOwn(control))
      actOn(state_, control, option);
    else
      change(control, [&](Setup& s) { actOn(s, control, option); });
    return false;
  }
  if (!sight_.has(x, y) || !isOffered(now(), LessonControl::Turn)) return false;
  held_ = LessonControl::Turn;
  return true;
}

void LessonBench::dragTo(int x, int y) {
  if (!held_) return;
  if (*held_ == LessonControl::Turn) {
    const int dx = x - x_, dy = y - y_;
    x_ = x, y_ = y;
    const Scene& scene = *state_.exhibit.scene;
    change(*held_, [&](Setup& s) {
      CameraSettings& camera = s.picture.camera;
      camera =
          moved(camera, placeCamera(camera, scene.mesh.points, scene.up, aspect_), -0.5 * dx, 0.5 * dy, 1.0);
    });
    return;
  }
  for (std::size_t k = 0; k < at_.controls.size() && k < now().controls.size(); ++k)
    if (now().controls[k] == *held_) {
      const int left = at_.controls[k].x + 84;  // beyond the ends of the track the thumb stays at its end
      const auto share = trackAt(at_.controls[k], std::clamp(x, left, left + 168));
      change(*held_, [&](Setup& s) { moveTo(s, *held_, share.value_or(0)); });
    }
}

void LessonBench::tick() {
  if (state_.moving) state_.exhibit.effects.rotate = (state_.exhibit.effects.rotate + 1) % kMaxShades;
}

}  // namespace xnewell
