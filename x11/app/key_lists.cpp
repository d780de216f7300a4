#include "x11/app/key_lists.h"

#include <algorithm>

#include "x11/app/workbench.h"

namespace xnewell {

namespace {

/// A bar would end the cell of a table.
std::string inCell(std::string_view words) {
  std::string cell;
  for (const char c : words) cell += c == '|' ? "\\|" : std::string{c};
  return cell;
}

/// The rows that `others` has too are left out.
std::string tableOf(std::string_view name, const KeyTable& keys, const KeyTable& others = {}) {
  const std::vector<HelpLine> there = helpOf(others);
  std::string table = "## " + std::string{name} + "\n\n| key | what it does |\n| --- | --- |\n";
  for (const HelpLine& line : helpOf(keys)) {
    if (std::ranges::find(there, line) != there.end()) continue;
    table += "| " + inCell(line.keys) + " | " + inCell(line.does) + " |\n";
  }
  return table + "\n";
}

}  // namespace

std::string keyLists() {
  Workbench bench{readScene("teapot"), {}, {}};
  bench.resize(kWindowSize.x, kWindowSize.y);
  std::string lists = "# All keys\n\n" + tableOf("In every view", bench.generalKeys());
  for (const WindowViewRow& row : kWindowViews) {
    bench.switchTo(row.id);
    bench.update();
    lists += tableOf("View " + std::string{row.key} + ", " + std::string{row.name}, bench.bench().keys());
    if (row.id != WindowView::DepthSort) continue;
    const KeyTable before = bench.bench().keys();
    bench.press('Y');
    bench.update();
    lists += tableOf("View 2, while you sort by hand: these, too", bench.bench().keys(), before);
    bench.press('Y');
  }
  // A step that asks a question, with the controls of all steps.
  Lesson lesson = readLesson(builtInLessons().front().file);
  const auto asks =
      std::ranges::find_if(lesson.steps, [](const LessonStep& step) { return step.question.has_value(); });
  const auto number = static_cast<int>(asks - lesson.steps.begin());
  asks->controls.clear();
  for (const LessonControl& row : lessonControls()) asks->controls.push_back(row.id);
  bench.teach(std::move(lesson));
  bench.lessons().goTo(number);
  bench.update();
  lists += tableOf("A step of a lesson: each has some of these", bench.bench().keys());
  lists.pop_back();  // the empty line after the last table
  return lists;
}

}  // namespace xnewell
