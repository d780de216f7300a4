#include "x11/install/manual.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "shading/scene/scene.h"
#include "x11/lessons/lesson.h"
#include "x11/options/exit_status.h"
#include "x11/options/option_rows.h"
#include "x11/options/options.h"

namespace xnewell {

namespace {

using Strings = std::vector<std::string>;

std::string joined(const Strings& words, std::string_view between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : std::string{between}) + word;
  return all;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

/// The first clause of a description.
std::string brief(std::string_view does) {
  std::size_t end = does.size();
  for (const std::string_view stop : {"; ", ". ", ": ", " ["}) end = std::min(end, does.find(stop));
  const std::string clause{does.substr(0, end)};
  // "trade: only these short cuts": the clause is only the name of a command.
  const bool command = std::ranges::any_of(
      kCommands, [&](const CommandRow& row) { return clause.substr(0, clause.find(',')) == row.name; });
  return command && end + 2 < does.size() ? clause + ": " + brief(does.substr(end + 2)) : clause;
}

/// The commands whose usage has this word.
Strings commandsWith(std::string_view word) {
  Strings names;
  for (const CommandRow& row : kCommands)
    if (row.usage.find(word) != std::string_view::npos) names.emplace_back(row.name);
  return names;
}

Strings allCommands() {
  Strings names;
  for (const CommandRow& row : kCommands) names.emplace_back(row.name);
  return names;
}

Strings namesOf(const std::function<bool(const OptionRow&)>& wanted) {
  Strings names;
  for (const OptionRow& row : optionRows()) {
    if (!wanted(row)) continue;
    if (!row.letter.empty()) names.push_back(row.letter);
    names.push_back(row.name);
  }
  return names;
}

bool takesValue(const OptionRow& row) { return row.takes != Takes::Nothing; }

/// Text with @name@ in place of what `parts` holds.
std::string filled(std::string text, const std::vector<std::pair<std::string_view, std::string>>& parts) {
  for (const auto& [name, part] : parts)
    text = replaced(std::move(text), "@" + std::string{name} + "@", part);
  return text;
}

/// "obj|ply|off"
std::string kindsOfScenes() {
  Strings kinds;
  for (const std::string_view kind : kSceneFiles) kinds.emplace_back(kind.substr(1));
  return joined(kinds, "|");
}

}  // namespace

std::string bashCompletion() {
  std::string values;
  for (const OptionRow& row : optionRows())
    if (!row.words.empty())
      values += "    " + row.name + ") mapfile -t COMPREPLY < <(compgen -W '" + joined(row.words, " ") +
                "' -- \"$word\"); return ;;\n";
  return filled(
      R"x(# Completes the words after xnewell in bash.
_xnewell() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]/#\~/$HOME}
  local places=() lines kinds='' k
  COMPREPLY=()
  # Bash makes three words of --order=newell.
  if [[ $word == = ]]; then
    word=''
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case $before in
@values@    @folders@)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      return ;;
    @files@) kinds='png' ;;
    @others@) return ;;
  esac
  if [[ ! $kinds && $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W '@options@' -- "$word")
    return
  fi
  if [[ ! $kinds ]]; then
    for ((k = 1; k < COMP_CWORD; ++k)); do
      case ${COMP_WORDS[k]} in
        @valued@)
          ((++k))
          [[ ${COMP_WORDS[k]} != = ]] || ((++k)) ;;
        -*) ;;
        *) places+=("${COMP_WORDS[k]}") ;;
      esac
    done
    case ${#places[@]}:${places[0]-} in
      0:) lines='/^le[a-z]* /d; s/ .*//' kinds='@kinds@'
        mapfile -t COMPREPLY < <(compgen -W '@commands@' -- "$word") ;;
      @scene@) lines='/^le[a-z]* /d; s/ .*//' kinds='@kinds@' ;;
      @lesson@) lines="/^${places[0]} /!d; s/^${places[0]} //; s/ .*//" kinds='json' ;;
      *) return ;;
    esac
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
      compgen -W "$("$program" scenes 2>/dev/null | sed "$lines")" -- "$word")
  fi
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
    compgen -d -- "$word"
    compgen -f -- "$word" | grep -iE "\.($kinds)\$")
}
complete -F _xnewell xnewell
)x",
      {{"values", values},
       {"folders", joined(namesOf([](auto& r) { return r.takes == Takes::Folder; }), " | ")},
       {"files", joined(namesOf([](auto& r) { return r.takes == Takes::File; }), " | ")},
       {"others", joined(namesOf([](auto& r) { return r.takes == Takes::Text && r.words.empty(); }), " | ")},
       {"options", joined(namesOf([](auto&) { return true; }), " ")},
       {"valued", joined(namesOf(takesValue), " | ")},
       {"commands", joined(allCommands(), " ")},
       {"kinds", kindsOfScenes()},
       {"scene", "1:" + joined(commandsWith("SCENE"), " | 1:")},
       {"lesson", "1:" + joined(commandsWith("NAME"), " | 1:")}});
}

std::string zshCompletion() {
  const auto quoted = [](const std::string& text) { return replaced(text, "'", "'\\''"); };
  std::string options, commands;
  for (const CommandRow& row : kCommands)
    commands += "    '" + std::string{row.name} + ":" + quoted(std::string{row.does}) + "'\n";
  for (const OptionRow& row : optionRows()) {
    std::string does = brief(row.does);
    for (const std::string_view special : {"\\", "[", "]", ":"})
      does = replaced(does, special, "\\" + std::string{special});
    std::string value;
    if (row.takes == Takes::File) value = ":file:_files -g \"*.png\"";
    if (row.takes == Takes::Folder) value = ":folder:_files -/";
    if (row.takes == Takes::Text)
      value = ":value:" + (row.words.empty() ? " " : '(' + joined(row.words, " ") + ')');
    options += "    ";
    if (row.letter.empty())
      options += '\'' + row.name + (value.empty() ? "" : "=");
    else
      options += "'(" + row.letter + ' ' + row.name + ")'{" + row.letter + ',' + row.name +
                 (value.empty() ? "" : "=") + "}'";
    options += '[' + quoted(does) + ']' + value + "' \\\n";
  }
  return filled(R"x(#compdef xnewell
# Completes the words after xnewell in zsh.

_xnewell_names() {
  local -a names
  names=(${(f)"$(_call_program names ${(q)xnewell} scenes 2>/dev/null | sed -n $1)"})
  _describe -t names name names
}

_xnewell_scenes() {
  _xnewell_names '/^le[a-z]* /!s/^\([^ ]*\) */\1:/p'
  _files -g '*.(@kinds@)'
}

_xnewell() {
  local curcontext=$curcontext state line ret=1 xnewell=$words[1]
  local -A opt_args
  local -a commands
  commands=(
@commands@  )
  _arguments -S : \
@options@    '1: :->first' '2: :->second' && ret=0
  case $state in
    first)
      _describe -t commands command commands && ret=0
      _xnewell_scenes && ret=0 ;;
    second)
      case $line[1] in
        @scene@) _xnewell_scenes && ret=0 ;;
        @lesson@)
          _xnewell_names "s/^$line[1] \([^ ]*\) */\1:/p" && ret=0
          _files -g '*.json' && ret=0 ;;
      esac ;;
  esac
  return ret
}

_xnewell "$@"
)x",
                {{"commands", commands},
                 {"options", options},
                 {"kinds", kindsOfScenes()},
                 {"scene", joined(commandsWith("SCENE"), "|")},
                 {"lesson", joined(commandsWith("NAME"), "|")}});
}

std::string fishCompletion() {
  const auto quoted = [](const std::string& text) {
    return '\'' + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + '\'';
  };
  std::string commands, options;
  for (const CommandRow& row : kCommands)
    commands += "complete -c xnewell -n 'contains first (__xnewell_place)' -a " + std::string{row.name} +
                " -d " + quoted(std::string{row.does}) + '\n';
  for (const OptionRow& row : optionRows()) {
    options += "complete -c xnewell -l " + row.name.substr(2);
    if (!row.letter.empty()) options += " -s " + row.letter.substr(1);
    if (row.takes == Takes::File) options += " -r -F";
    if (row.takes == Takes::Folder) options += " -x -a '(__fish_complete_directories)'";
    if (row.takes == Takes::Text)
      options += " -x" + (row.words.empty() ? "" : " -a '" + joined(row.words, " ") + '\'');
    options += " -d " + quoted(brief(row.does)) + '\n';
  }
  return filled(R"x(# Completes the words after xnewell in fish.

# What the next word is: first (a command or a scene), scene, lesson (or lecture) or nothing.
function __xnewell_place
    set -l words (commandline -opc)
    set -l places
    set -l skip no
    set -e words[1]
    for word in $words
        if test $skip = yes
            set skip no
            continue
        end
        switch $word
            case @valued@
                set skip yes
            case '-*'
            case '*'
                set -a places $word
        end
    end
    switch (count $places)
        case 0
            echo first
        case 1
            switch $places[1]
                case @scene@
                    echo scene
                case @lesson@
                    echo lesson
            end
    end
end

function __xnewell_files -a kinds
    for file in (commandline -ct)*
        if test -d $file
            echo $file/
        else if string match -q -r "\.($kinds)\$" -- $file
            echo $file
        end
    end
end

function __xnewell_scenes
    set -l words (commandline -opc)
    $words[1] scenes 2>/dev/null | string match -v -r '^le[a-z]* ' | string replace -r ' +' \t
    __xnewell_files '@kinds@'
end

function __xnewell_lessons
    set -l words (commandline -opc)
    $words[1] scenes 2>/dev/null | string replace -f -r "^$words[2] ([^ ]*) +" '$1\t'
    __xnewell_files json
end

complete -c xnewell -f
@commands@complete -c xnewell -n 'contains first (__xnewell_place)' -a '(__xnewell_scenes)'
complete -c xnewell -n 'contains scene (__xnewell_place)' -a '(__xnewell_scenes)'
complete -c xnewell -n 'contains lesson (__xnewell_place)' -a '(__xnewell_lessons)'
@options@)x",
                {{"valued", joined(namesOf(takesValue), " ")},
                 {"scene", joined(commandsWith("SCENE"), " ")},
                 {"lesson", joined(commandsWith("NAME"), " ")},
                 {"commands", commands},
                 {"options", options},
                 {"kinds", kindsOfScenes()}});
}

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

}  // namespace

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

}  // namespace xnewell
