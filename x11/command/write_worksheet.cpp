#include "x11/command/write_worksheet.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "x11/command/write_lesson.h"
#include "x11/homework/html.h"
#include "x11/lessons/lesson_bench.h"
#include "x11/lessons/lesson_sight.h"
#include "x11/options/shell_words.h"

namespace xnewell {

namespace {

constexpr std::string_view kHead = R"(<meta charset="utf-8">
<style>
body { font: 11pt/1.4 serif; max-width: 45em; margin: 2em auto }
img { width: 100%; image-rendering: pixelated }
section { break-inside: avoid; margin-top: 2em }
section + section { break-before: page }
.room { height: 7em; border-bottom: 1px solid; margin-bottom: 1em }
.try { font-size: smaller }
</style>
)";

/// What the page of a step shows beside its words.
std::string pictureOf(const Workbench& bench) {
  constexpr int kAround = 8;  // units: marks reach into the margins
  const Rect sight = sightOf(bench.layout());
  const Rect from =
      Rect{sight.x - kAround, sight.y, sight.width + 2 * kAround, sight.height} * bench.layout().unit;
  IndexImage part{from.width, from.height, 0};
  for (int y = 0; y < from.height; ++y)
    std::copy_n(bench.image().row(from.y + y) + from.x, from.width, part.row(y));
  return imageElement(encodePng(part, bench.palette()));
}

}  // namespace

void writeWorksheet(const Options& options, Lesson lesson, const std::function<void(int)>& tell) {
  std::string sheet = "<!DOCTYPE html>\n<html lang=\"en\">\n" + element("title", lesson.title) +
                      std::string{kHead} + element("h1", lesson.title) + "<p>Name:</p>\n";
  std::string solutions = "<section>\n" + element("h2", "Solutions") + "<ol>\n";
  const std::vector<LessonStep> steps = lesson.steps;
  const std::string source = lesson.source;
  visitSteps(options, std::move(lesson), tell, [&](Workbench& bench, int k) {
    const LessonPage asked = bench.lessons().page();
    sheet += "<section>\n" + element("h2", std::to_string(k + 1) + ". " + asked.heading) + pictureOf(bench);
    for (const std::string& paragraph : asked.caption) sheet += element("p", paragraph);
    const LessonStep& step = steps[static_cast<std::size_t>(k)];
    if (!step.controls.empty())
      sheet += "<p class=\"try\">To try it on a screen: <code>" +
               inHtml("xnewell lesson " + quoted(source) + " --step " + std::to_string(k + 1)) +
               "</code></p>\n";
    std::string solution = asked.heading + ": no question.";
    if (const auto& question = step.question) {
      sheet += element("p", question->asks) + "<ol type=\"a\">\n";
      for (const LessonAnswer& answer : question->answers) sheet += element("li", answer.text);
      sheet += "</ol>\n" + element("p", "Why?") + "<div class=\"room\"></div>\n";
      const auto right = std::ranges::find(question->answers, true, &LessonAnswer::holds);
      const char letter = static_cast<char>('a' + (right - question->answers.begin()));
      bench.press({NamedKey::Letter, letter});
      bench.press({NamedKey::Return});
      while (bench.stale() != Workbench::Stale::Nothing) bench.update();
      solution = std::string{letter} + ": " + right->text + ". " + bench.lessons().page().question->says;
    }
    sheet += "</section>\n";
    solutions += element("li", solution);
  });
  writeFile(options.worksheet, sheet + solutions + "</ol>\n</section>\n</html>\n");
}

}  // namespace xnewell
