#include "x11/lessons/lesson_page.h"

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

/// What stands around the controls of the step.
void drawControlsFrame(Pen& pen, const LessonLayout& at) {
  if (!at.controls) return;
  pen.rule(at.column.x, *at.controls - 16, at.column.width);
  pen.caps(at.column.x, *at.controls, "in this step");
  if (const int y = at.end + 14; !at.compact && y + 6 < at.back.y)
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
  const int onward = pen.ink(at.next.x + (last ? 16 : 46), y, last ? "all lessons" : "next");
  pen.soft(onward + 8, y, "PgDn");
  pen.paint.triangle(at.next.x + at.next.width - 24, middle, 6, Direction::Right, pen(Cell::Ink));
}

}  // namespace

LessonLayout layoutOfLesson(const Rect& column, const LessonPage& page, const Controls& rows,
                            ControlList& list, bool compact) {
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
    const std::string confirmed = question.right ? "Right. " : "Not so. ";
    if (const std::string words = question.given ? confirmed + question.says : question.hint;
        !words.empty()) {
      y += 11;
      flow(at.after, column.x, y, words, kLetters, pitch.text);
      y += -11 + pitch.gap;
    }
  }
  if (!rows.empty()) {
    at.controls = y + 16;
    y = list.placeColumn(rows, column.x, *at.controls + (compact ? 19 : 22),
                         {.width = column.width, .pitch = pitch.control, .beyond = 2});
    y -= 12;  // from a baseline to the top of the next part
  }
  at.end = y;
  const int half = (column.width - 16) / 2, top = column.y + column.height - pitch.button;
  at.back = {column.x, top, half, pitch.button};
  at.next = {column.x + half + 16, top, half, pitch.button};
  return at;
}

void drawLessonPage(Pen& pen, const LessonLayout& at, const LessonPage& page) {
  drawTop(pen, at, page);
  drawLines(pen, at.words, Cell::Ink);
  if (page.question) drawQuestion(pen, at, *page.question);
  drawControlsFrame(pen, at);
  drawWays(pen, at, page);
}

}  // namespace xnewell
