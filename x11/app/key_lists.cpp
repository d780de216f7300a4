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

/// The keys of one view, or of a part of it.
struct KeyList {
  std::string view, title;
  std::vector<HelpLine> lines;
};

/// The lines that several lists have are told once, with the views that have them.
std::string tablesOf(const std::vector<KeyList>& lists) {
  const auto viewsWith = [&](const HelpLine& line) {
    std::vector<std::string_view> views;
    for (const KeyList& list : lists)
      if (std::ranges::find(list.lines, line) != list.lines.end()) views.push_back(list.view);
    return views;
  };
  std::string shared, others;
  std::vector<HelpLine> told;
  for (const KeyList& list : lists) {
    others += "| | **" + list.title + "** |\n";
    for (const HelpLine& line : list.lines) {
      const std::string cells = "| " + inCell(line.keys) + " | " + inCell(line.does) + " |";
      const std::vector<std::string_view> views = viewsWith(line);
      if (views.size() < 2) {
        others += cells + "\n";
      } else if (std::ranges::find(told, line) == told.end()) {
        told.push_back(line);
        shared += cells;
        for (const std::string_view view : views)
          shared += (view == views.front() ? " " : ", ") + std::string{view};
        shared += " |\n";
      }
    }
  }
  return "\n## In several views\n\n| key | what it does | in |\n| --- | --- | --- |\n" + shared +
         "\n## In one view\n\n| key | what it does |\n| --- | --- |\n" + others;
}

}  // namespace

std::string keyLists() {
  Workbench bench{readScene("teapot"), {}, {}};
  bench.resize(kWindowSize.x, kWindowSize.y);
  std::vector<KeyList> lists{{"all", "In every view", helpOf(bench.generalKeys())}};
  for (const ViewRow& row : kWindowViews) {
    bench.switchTo(row.id);
    bench.update();
    const std::string key{row.key};
    lists.push_back({key, "View " + key + ", " + std::string{row.title}, helpOf(bench.bench().keys())});
    if (row.id != View::DepthSort) continue;
    const std::vector<HelpLine> before = lists.back().lines;
    bench.press('Y');
    bench.update();
    lists.push_back(
        {"2 by hand", "View 2, while you sort by hand: these, too", helpOf(bench.bench().keys())});
    std::erase_if(lists.back().lines,
                  [&](const HelpLine& line) { return std::ranges::find(before, line) != before.end(); });
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
  lists.push_back({"lessons", "A step of a lesson: each has some of these", helpOf(bench.bench().keys())});
  return "# All keys\n" + tablesOf(lists);
}

}  // namespace xnewell
