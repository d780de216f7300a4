#include "x11/lessons/lesson_list.h"

#include <algorithm>

namespace xnewell {

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
                      const KeptAnswers& answers) {
  const Rect& body = at.body;
  pen.paint.text(body.x, body.y + 21, "Lessons", pen(Cell::Ink), Voice::Title);
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

}  // namespace xnewell
