/// make_manual VERSION DATE FILE: writes the man page xnewell(1), for the macros of man(7). Commands,
/// options, exit statuses, scenes and lessons come from the rows that the program itself uses. DATE is the
/// day of the release, 2026-11-25.

#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "shading/scene/scene.h"
#include "x11/lessons/lesson.h"
#include "x11/options/exit_status.h"
#include "x11/options/option_rows.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

constexpr std::size_t kLineLength = 72;

/// As roff shows it letter by letter. `words` in backquotes become bold.
std::string roff(std::string_view text) {
  std::string out;
  bool bold = false;
  for (const char c : text) switch (c) {
      case '`':
        out += (bold = !bold) ? "\\fB" : "\\fR";
        break;
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;  // else it becomes a hyphen, which no one can paste into a shell
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      default:
        out += c;
    }
  return out;
}

/// With a full stop, unless the words end with dots.
std::string sentence(std::string_view words) {
  return std::string{words} + (words.ends_with('.') ? "" : ".");
}

/// Text in lines of at most kLineLength, except for a word longer than that.
class Page {
 public:
  /// A macro with words that are not split.
  void macro(const std::string& line) { page_ += line + '\n'; }
  void paragraph(std::string_view text) {
    std::string line;
    const auto end = [&] {
      if (line.front() == '.' || line.front() == '\'') line.insert(0, "\\&");  // else it is a macro
      page_ += line + '\n';
      line.clear();
    };
    const std::string whole = roff(text);
    for (std::size_t at = 0; at < whole.size();) {
      const std::size_t blank = std::min(whole.find(' ', at), whole.size());
      const std::string word = whole.substr(at, blank - at);
      if (!line.empty() && line.size() + 1 + word.size() > kLineLength) end();
      line += (line.empty() ? "" : " ") + word;
      if (line.ends_with('.')) end();  // roff sets the blank after a sentence itself
      at = blank + 1;
    }
    if (!line.empty()) end();
  }
  void section(const std::string& name) { macro(".SH " + name); }
  /// A term, and below it a text.
  void entry(std::string_view term, std::string_view text) {
    macro(".TP");
    macro(std::string{term});
    paragraph(text);
  }
  [[nodiscard]] std::string take() { return std::move(page_); }

 private:
  std::string page_;
};

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }

void addCommands(Page& page) {
  page.section("COMMANDS");
  for (const CommandRow& row : kCommands) {
    const std::size_t end = row.usage.find(']') == 5 ? 6 : std::min(row.usage.find(' '), row.usage.size());
    page.entry(bold("xnewell " + std::string{row.usage.substr(0, end)}) + roff(row.usage.substr(end)),
               sentence(row.does));
  }
}

void addOptions(Page& page) {
  page.section("OPTIONS");
  page.paragraph(
      "Defaults are in brackets; a scene file may set others. An option overrides only the same setting of "
      "the scene file.");
  for (const OptionRow& row : optionRows()) {
    std::string term = row.letter.empty() ? "" : bold(row.letter) + ", ";
    term += bold(row.name);
    if (row.takes != Takes::Nothing)
      term += row.takes == Takes::File     ? " \\fIFILE\\fR"
              : row.takes == Takes::Folder ? " \\fIFOLDER\\fR"
                                           : " \\fIVALUE\\fR";
    page.entry(term, row.does);
  }
}

std::string manPage(std::string_view version, std::string_view date) {
  Page page;
  page.macro(".TH XNEWELL 1 " + std::string{date} + " \"xnewell " + std::string{version} + '"');
  page.section("NAME");
  page.macro("xnewell \\- " + roff(kAbout));
  page.section("SYNOPSIS");
  for (const CommandRow& row : kCommands) {
    if (&row != kCommands.data()) page.macro(".br");
    page.macro(bold("xnewell") + ' ' + roff(row.usage));
  }
  page.section("DESCRIPTION");
  page.paragraph(
      "A teaching program for shading and hidden surfaces. It works the way the field began: with real X11 "
      "colormaps, the teapot, and polygons sorted by depth. It is named after Martin Newell, who gave us "
      "both "
      "the teapot and the depth sort.");
  page.macro(".PP");
  std::string kinds;
  for (const std::string_view kind : kSceneFiles) kinds += (kinds.empty() ? "" : ", ") + std::string{kind};
  page.paragraph("SCENE is a file (" + kinds +
                 ") or a built-in name. A .png is a picture that xnewell wrote, a .svg, .pdf or .eps a "
                 "figure: it carries its scene's name and all "
                 "settings. Every pixel of a picture is a number from 0 to 255; a table of "
                 "colours, the colormap, says which colour each number shows. In the window, `?` shows all "
                 "keys.");
  addCommands(page);
  addOptions(page);
  page.section("SCENES");
  for (const BuiltInScene& scene : builtInScenes()) page.entry(bold(scene.name), sentence(scene.shows));
  page.section("LESSONS");
  for (const LessonEntry& lesson : builtInLessons()) page.entry(bold(lesson.name), sentence(lesson.shows));
  page.section("LECTURES");
  for (const LectureEntry& lecture : builtInLectures())
    page.entry(bold(lecture.name), sentence(lecture.shows));
  page.section("\"EXIT STATUS\"");
  for (const StatusRow& row : kStatuses) page.entry(bold(std::to_string(row.id)), sentence(row.means));
  page.section("ENVIRONMENT");
  page.entry(bold("DISPLAY"),
             "the X server of `view`, `snapshot`, `visuals` and of a lesson in the window. "
             "The other commands use no server.");
  page.section("FILES");
  page.entry("\\fI../share/xnewell\\fR",
             "seen from the folder of the program: scenes, lessons and models. "
             "A new file in its folders `scenes` and `lessons` is in the list at once.");
  page.section("EXAMPLES");
  page.entry(bold("xnewell"), "opens the teapot.");
  page.entry(bold("xnewell draw teapot -o teapot.png --shade phong"), "draws it without a server.");
  page.entry(bold("xnewell lesson cycles"), "begins a lesson.");
  return page.take();
}

}  // namespace

}  // namespace xnewell

int main(int argc, char** argv) {
  if (argc != 4) return std::cerr << "usage: make_manual VERSION DATE FILE\n", 2;
  std::ofstream file{argv[3]};
  file << xnewell::manPage(argv[1], argv[2]);
  file.close();
  if (!file) std::cerr << argv[3] << ": cannot be written\n";
  return file ? 0 : 1;
}
