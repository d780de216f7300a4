#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "x11/homework/answer_file.h"
#include "x11/lessons/exhibit.h"

namespace xnewell {

/// Lessons: files of `data/lessons`, one JSON object each.
///
///   "title"   its subject, in lower case; "number" its place in the list, from 1
///   "shows"   a sentence for the list
///   "steps"   1 to 12, each one an exhibit (read_exhibit.h) with
///     "heading"  at most 26 characters
///     "caption"  a list of paragraphs; the program replaces {cuts} by what it counts (lesson_facts.h)
///     "controls" names of kLessonControls: the controls that work in the step
///     "question" {"asks", "hint", "answers": 2 to 4 of {"text", "holds", "says", "shown"}}
///
/// Exactly one answer "holds". After an answer is given, the page shows what it "says", and what is "shown":
/// the step's exhibit with changes. A wrong answer is not marked wrong, so it needs an exhibit in which it
/// fails. A step without "scene" begins with the exhibit of the step before, and changes it.
/// Unknown keys, wrong types and values out of range are refused.

enum class LessonControl {
  Ia,
  Ip,
  Ka,
  Kd,
  Ks,
  N,
  Shades,
  I0,
  Light,
  Turn,
  Zoom,
  Shading,
  Normals,
  Order,
  Projection,
  Table,
  Hue,
  Bits,
  Pick,
  ConstantL,
  ConstantV,
  Names,
  Wrong,
  Event,
  Rotate,
  Gamma
};
struct LessonControlRow {
  LessonControl id;
  char key;  ///< the same as in the views that have the control too
  std::string_view name;
  char spare = 0;  ///< the key in a step where `key` chooses an answer, `a` to `d`
};
inline constexpr std::array kLessonControls{
    LessonControlRow{LessonControl::Ia, 'i', "Ia"},
    LessonControlRow{LessonControl::Ip, 'p', "Ip"},
    LessonControlRow{LessonControl::Ka, 'a', "ka", 'k'},
    LessonControlRow{LessonControl::Kd, 'd', "kd", 'f'},
    LessonControlRow{LessonControl::Ks, 's', "ks"},
    LessonControlRow{LessonControl::N, 'n', "n"},
    LessonControlRow{LessonControl::Shades, 'c', "shades", 'x'},
    LessonControlRow{LessonControl::I0, 'o', "I0"},
    LessonControlRow{LessonControl::Light, 'l', "light"},
    LessonControlRow{LessonControl::Turn, 't', "turn"},
    LessonControlRow{LessonControl::Zoom, 'z', "zoom"},
    LessonControlRow{LessonControl::Shading, 'S', "shading"},
    LessonControlRow{LessonControl::Normals, 'N', "normals"},
    LessonControlRow{LessonControl::Order, 'O', "order"},
    LessonControlRow{LessonControl::Projection, 'P', "projection"},
    LessonControlRow{LessonControl::Table, 'T', "table"},
    LessonControlRow{LessonControl::Hue, 'H', "hue"},
    LessonControlRow{LessonControl::Bits, 'B', "bits"},
    LessonControlRow{LessonControl::Pick, 'J', "nearest"},
    LessonControlRow{LessonControl::ConstantL, 'L', "L constant"},
    LessonControlRow{LessonControl::ConstantV, 'V', "V constant"},
    LessonControlRow{LessonControl::Names, 'M', "names"},
    LessonControlRow{LessonControl::Wrong, 'W', "wrong"},
    LessonControlRow{LessonControl::Event, 'v', "event"},
    LessonControlRow{LessonControl::Rotate, 'm', "rotate"},
    LessonControlRow{LessonControl::Gamma, 'g', "gamma"},
};
[[nodiscard]] constexpr const LessonControlRow& rowOf(LessonControl control) {
  return kLessonControls[static_cast<std::size_t>(control)];
}

struct LessonAnswer {
  std::string text;
  bool holds = false;
  std::string says;
  Exhibit shown;
};
struct LessonQuestion {
  std::string asks, hint;
  std::vector<LessonAnswer> answers;  ///< 2 to 4
};
struct LessonStep {
  std::string heading;
  std::vector<std::string> caption;  ///< paragraphs
  Exhibit exhibit;
  std::vector<LessonControl> controls;
  std::optional<LessonQuestion> question;
};
struct Lesson {
  std::string name, title, shows;
  int number = 1;
  std::vector<LessonStep> steps;
  std::string source = {};  ///< what opens it again: a built-in name, or the name of its file
};

/// Reads a file. Scene files are looked for in the same folder. @throws ParseError, std::system_error
[[nodiscard]] Lesson readLesson(const std::filesystem::path& file);
/// Reads the same from text.
[[nodiscard]] Lesson parseLesson(std::string_view text, const std::string& name,
                                 const std::filesystem::path& folder);

/// What the list shows of a lesson before it is read.
struct LessonEntry {
  std::string name, title, shows;
  int number = 1;
  std::filesystem::path file;
};
/// The lessons of the data folder, sorted by number. @throws ParseError, std::system_error
[[nodiscard]] std::vector<LessonEntry> builtInLessons();

struct LectureEntry {
  std::string name, shows;
};
/// The lectures of the data folder (read_lecture.h), sorted by name. @throws ParseError, std::system_error
[[nodiscard]] std::vector<LectureEntry> builtInLectures();

}  // namespace xnewell
