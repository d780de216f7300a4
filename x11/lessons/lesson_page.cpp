#include "x11/lessons/lesson_page.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/pen.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kLetters = 53;  // in a line of a paragraph
constexpr int kBoxLeft = 16, kAnswerText = 64;
constexpr int kAnswerLetters = (kLessonColumn - kAnswerText - 8) / 6;

/// Distances in pixels, which are smaller in a small window.
struct Pitches {
  int text, paragraph, answer, control, button, gap;
};
constexpr Pitches kRoomy{16, 8, 26, 22, 30, 12}, kCompact{14, 5, 20, 19, 24, 6};

void drawLines(Pen& pen, const std::vector<LessonLayout::Line>& lines, Cell cell,
               Voice voice = Voice::Plain) {
  for (const auto& line : lines) pen.paint.text(line.x, line.baseline, line.text, pen(cell), voice);
}

/// Draws a raised area. If `strong`, with an ink edge and the colour of the keyboard focus.
void drawButton(Pen& pen, const Rect& r, bool strong) {
  pen.paint.fillRect(r, pen(strong ? Cell::Focus : Cell::Panel));
  pen.paint.frame(r, pen(strong ? Cell::Ink : Cell::Faint));
  if (strong) return;
  pen.paint.hline(r.x + 1, r.y + 1, r.width - 2, pen(Cell::White));
  pen.paint.vline(r.x + 1, r.y + 1, r.height - 2, pen(Cell::White));
}

/// Adds the lines of a text from `baseline` on, and moves `baseline` below them.
void flow(std::vector<LessonLayout::Line>& lines, int x, int& baseline, std::string_view text, int letters,
          int pitch) {
  for (const std::string& line : broken(text, letters)) {
    lines.push_back({x, baseline, line});
    baseline += pitch;
  }
}

void drawTop(Pen& pen, const LessonLayout& at, const LessonPage& page) {
  const Rect& c = at.column;
  pen.paint.text(c.x, c.y + 21, page.heading, pen(Cell::Ink), Voice::Title);
  pen.paint.text(c.x, at.dots + 4,
                 "step " + std::to_string(page.step + 1) + " of " + std::to_string(page.steps),
                 pen(Cell::Soft));
  constexpr int kPitch = 16;
  for (int k = 0; k < page.steps; ++k) {
    const int x = c.x + c.width - 12 - (page.steps - 1 - k) * kPitch;
    if (k < page.step) pen.paint.disc(x, at.dots, 3, pen(Cell::Ink));
    if (k > page.step) pen.paint.ring(x, at.dots, 3, pen(Cell::Faint));
    if (k != page.step) continue;
    pen.paint.disc(x, at.dots, 5, pen(Cell::Ink));
    pen.paint.disc(x, at.dots, 2, pen(Cell::Paper));
  }
  pen.rule(c.x, at.dots + 13, c.width);
}

void drawQuestion(Pen& pen, const LessonLayout& at, const PageQuestion& question) {
  pen.paint.fillRect(at.box, pen(Cell::White));
  pen.paint.fillRect({at.box.x, at.box.y, 3, at.box.height}, pen(Cell::Ink));
  drawLines(pen, at.asks, Cell::Ink, Voice::Bold);
  for (std::size_t k = 0; k < at.answers.size(); ++k) {
    const Rect& row = at.answers[k];
    const bool chosen = question.chosen == static_cast<int>(k);
    if (chosen) {
      pen.paint.fillRect({row.x + 10, row.y, row.width - 20, row.height}, pen(Cell::Focus));
      pen.paint.fillRect({row.x + 10, row.y, 2, row.height}, pen(Cell::Ink));
    }
    const int baseline = row.y + (at.compact ? 14 : 16);
    pen.paint.disc(row.x + 26, baseline - 4, 6, pen(Cell::White));
    pen.paint.ring(row.x + 26, baseline - 4, 6, pen(Cell::Ink));
    if (chosen) pen.paint.disc(row.x + 26, baseline - 4, 3, pen(Cell::Ink));
    const char letter = static_cast<char>('a' + k);
    pen.key(row.x + 42, baseline - 11, std::string_view{&letter, 1});
    int y = baseline;
    for (const std::string& line : at.answerLines[k]) {
      pen.ink(row.x + kAnswerText, y, line);
      y += at.compact ? kCompact.text : kRoomy.text;
    }
  }
  if (!at.answer.empty()) {
    const bool ready = question.chosen.has_value();
    drawButton(pen, at.answer, ready);
    const int y = at.answer.y + (at.answer.height + 9) / 2;
    const int x = pen.paint.text(at.answer.x + 10, y, "answer", pen(ready ? Cell::Ink : Cell::Soft),
                                 ready ? Voice::Bold : Voice::Plain);
    pen.soft(x + 6, y, "Return");
    pen.soft(at.answer.x + at.answer.width + 16, y, "or go on without one");
  }
  drawLines(pen, at.after, question.given ? Cell::Ink : Cell::Soft);
}

std::vector<std::string_view> optionsOf(const PageControl& control) {
  return {control.options.begin(), control.options.end()};
}

/// The frames of the options of a control, in a row of the column.
std::vector<Rect> framesOf(const PageControl& control, const Rect& row) {
  return optionFrames(optionsOf(control), row.x + kColumnTrackAt, row.y + 14,
                      kLessonColumn - kColumnTrackAt - 6);
}

void drawControl(Pen& pen, const PageControl& control, const Rect& row) {
  const int x = row.x, y = row.y + 14;
  if (control.focused) drawFocus(pen, {x, row.y, kLessonColumn, row.height});
  pen.key(x, y - 11, std::string_view{&control.key, 1});
  pen.paint.text(x + 24, y, control.label, pen(control.enabled ? Cell::Ink : Cell::Faint));
  if (control.track)
    drawTrack(pen, x + kColumnTrackAt, y, kColumnTrack,
              {.share = *control.track, .initially = control.usual, .enabled = control.enabled});
  if (control.toggle) {
    const Rect box{x + kColumnTrackAt, y - 10, 11, 11};
    pen.paint.fillRect(box, pen(Cell::White));
    pen.paint.frame(box, pen(Cell::Ink));
    if (control.chosen) pen.paint.tick(box.x + 2, box.y + 2, pen(Cell::Ink));
    pen.ink(box.x + 18, y, control.value);
    return;
  }
  drawOptions(pen, optionsOf(control), framesOf(control, row), control.chosen);
  pen.paint.textRight(x + kLessonColumn, y, control.value, pen(control.enabled ? Cell::Ink : Cell::Faint),
                      control.enabled ? Voice::Bold : Voice::Plain);
}

void drawControls(Pen& pen, const LessonLayout& at, const LessonPage& page) {
  if (page.controls.empty()) return;
  pen.rule(at.column.x, at.controlsTop - 16, at.column.width);
  pen.caps(at.column.x, at.controlsTop, "in this step");
  for (std::size_t k = 0; k < page.controls.size(); ++k) drawControl(pen, page.controls[k], at.controls[k]);
  const Rect& last = at.controls.back();
  if (const int y = last.y + last.height + 16; !at.compact && y + 6 < at.back.y)
    pen.soft(at.column.x, y, "The other controls are off. Esc leaves the lesson.");
}

void drawWays(Pen& pen, const LessonLayout& at, const LessonPage& page) {
  const int y = at.back.y + (at.back.height + 9) / 2, middle = at.back.y + at.back.height / 2 - 5;
  const bool first = page.step == 0, last = page.step + 1 == page.steps;
  drawButton(pen, at.back, false);
  pen.paint.triangle(at.back.x + 20, middle, 6, Direction::Left, pen(first ? Cell::Faint : Cell::Ink));
  const int x = pen.paint.text(at.back.x + 46, y, "back", pen(first ? Cell::Faint : Cell::Ink));
  pen.paint.text(x + 8, y, "PgUp", pen(first ? Cell::Faint : Cell::Soft));
  drawButton(pen, at.next, false);
  const int onward = pen.ink(at.next.x + (last ? 16 : 46), y, last ? "next lesson" : "next");
  pen.soft(onward + 8, y, "PgDn");
  pen.paint.triangle(at.next.x + at.next.width - 24, middle, 6, Direction::Right, pen(Cell::Ink));
}

}  // namespace

LessonLayout layoutOfLesson(const Rect& column, const LessonPage& page, bool compact) {
  const Pitches& pitch = compact ? kCompact : kRoomy;
  LessonLayout at;
  at.column = column, at.compact = compact;
  at.dots = column.y + (compact ? 36 : 42);
  int y = at.dots + (compact ? 29 : 35);
  for (const std::string& paragraph : page.caption) {
    flow(at.words, column.x, y, paragraph, kLetters, pitch.text);
    y += pitch.paragraph;
  }
  y += -11 - pitch.paragraph + pitch.gap;  // from a baseline to the top of the next part
  if (page.question) {
    const PageQuestion& question = *page.question;
    at.box = {column.x, y, column.width, 0};
    y += compact ? 17 : 22;
    flow(at.asks, column.x + kBoxLeft, y, question.asks, kLetters - 5, pitch.text);
    y += compact ? -10 : -4;
    for (const std::string& answer : question.answers) {
      at.answerLines.push_back(broken(answer, kAnswerLetters));
      const int more = static_cast<int>(at.answerLines.back().size() - 1) * pitch.text;
      at.answers.push_back({column.x, y, column.width, pitch.answer - 2 + more});
      y += pitch.answer + more;
    }
    y += compact ? 2 : 8;
    at.box.height = y - at.box.y;
    y += pitch.gap;
    if (!question.given) {
      at.answer = {column.x, y, 100, compact ? 22 : 26};
      y += at.answer.height + pitch.gap;
    }
    if (const std::string& words = question.given ? question.says : question.hint; !words.empty()) {
      y += 11;
      flow(at.after, column.x, y, words, kLetters, pitch.text);
      y += -11 + pitch.gap;
    }
  }
  if (!page.controls.empty()) {
    at.controlsTop = y + 16;
    y = at.controlsTop + (compact ? 5 : 8);
    for (std::size_t k = 0; k < page.controls.size(); ++k) {
      const std::vector<Rect> frames = framesOf(page.controls[k], column);
      const int more = frames.empty() ? 0 : frames.back().y - frames.front().y;  // if they need a second line
      at.controls.push_back({column.x, y, column.width, pitch.control + more});
      y += pitch.control + more;
    }
    y += 2;
  }
  at.end = y;
  const int half = (column.width - 16) / 2, top = column.y + column.height - pitch.button;
  at.back = {column.x, top, half, pitch.button};
  at.next = {column.x + half + 16, top, half, pitch.button};
  return at;
}

std::vector<std::string> tooWide(const LessonPage& page) {
  std::vector<std::string> found;
  if (textWidth(page.heading, Voice::Title) > kLessonColumn) found.push_back(page.heading);
  for (const PageControl& control : page.controls) {
    if (24 + textWidth(control.label) > kColumnTrackAt - 4) found.push_back(control.label);
    const std::vector<Rect> frames = framesOf(control, {});
    const auto wordsEnd = [&](const Rect& frame) { return frame.x + frame.width - 7; };
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if (wordsEnd(frames[k]) > kLessonColumn) found.push_back(control.options[k]);
      if (k > 0 && frames[k].y == frames[k - 1].y && frames[k].x + 6 - wordsEnd(frames[k - 1]) < 6)
        found.push_back(control.options[k]);
    }
    const int room = control.track ? kLessonColumn - kColumnTrackAt - kColumnTrack - 8
                                   : kLessonColumn - kColumnTrackAt - 18;
    if (textWidth(control.value) > room) found.push_back(control.value);
  }
  return found;
}

void drawLessonPage(IndexImage& image, const LessonLayout& at, const LessonPage& page, const CellPlan& plan) {
  Pen pen{Painter{image}, plan};
  drawTop(pen, at, page);
  drawLines(pen, at.words, Cell::Ink);
  if (page.question) drawQuestion(pen, at, *page.question);
  drawControls(pen, at, page);
  drawWays(pen, at, page);
}

std::optional<double> trackAt(const Rect& row, int x) {
  const int along = x - row.x - kColumnTrackAt;
  if (along < -6 || along > kColumnTrack + 6) return std::nullopt;
  return std::clamp(static_cast<double>(along) / kColumnTrack, 0.0, 1.0);
}

std::optional<int> optionAt(const Rect& row, const PageControl& control, int x, int y) {
  const std::vector<Rect> frames = framesOf(control, row);
  if (frames.empty()) return std::nullopt;
  y = std::clamp(y, frames.front().y,
                 frames.back().y + frames.back().height - 1);  // a row is a little higher
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (frames[k].has(x, y)) return static_cast<int>(k);
  return std::nullopt;
}

std::vector<Rect> layoutOfList(const Rect& body, const LessonList& list, bool compact) {
  const int pitch = compact ? 34 : 44, top = body.y + (compact ? 44 : 60);
  std::vector<Rect> rows;
  for (int k = 0; k < static_cast<int>(list.rows.size()); ++k)
    rows.push_back({body.x, top + k * pitch, body.width, pitch - 4});
  return rows;
}

void drawLessonList(IndexImage& image, const Rect& body, const LessonList& list, const CellPlan& plan,
                    bool compact) {
  Pen pen{Painter{image}, plan};
  pen.paint.text(body.x, body.y + 21, "Lessons", pen(Cell::Ink), Voice::Title);
  pen.paint.textRight(body.x + body.width, body.y + 21, "arrows, then Return; or the pointer",
                      pen(Cell::Soft));
  pen.rule(body.x, body.y + (compact ? 34 : 42), body.width);
  const std::vector<Rect> rows = layoutOfList(body, list, compact);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LessonList::Row& lesson = list.rows[k];
    const Rect& row = rows[k];
    const int y = row.y + (compact ? 13 : 16);
    if (static_cast<int>(k) == list.chosen) {
      pen.paint.fillRect({row.x, row.y, row.width, row.height}, pen(Cell::Focus));
      pen.paint.fillRect({row.x, row.y, 2, row.height}, pen(Cell::Ink));
    }
    pen.softRight(row.x + 32, y, std::to_string(lesson.number));
    const int end = pen.bold(row.x + 48, y, lesson.title);
    if (list.current == static_cast<int>(k)) pen.soft(end + 18, y, "open");
    pen.soft(row.x + 48, y + (compact ? 14 : 17), lesson.shows);
  }
}

}  // namespace xnewell
