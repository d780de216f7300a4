#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
  char key;     ///< the key in a lesson; never a to d, which choose answers
  char window;  ///< the key of the same control in the picture's view, 0 if there is none
  std::string_view name;
};
inline constexpr std::array kLessonControls{
    LessonControlRow{LessonControl::Ia, 'i', 'i', "Ia"},
    LessonControlRow{LessonControl::Ip, 'p', 'p', "Ip"},
    LessonControlRow{LessonControl::Ka, 'k', 'a', "ka"},
    LessonControlRow{LessonControl::Kd, 'f', 'd', "kd"},
    LessonControlRow{LessonControl::Ks, 's', 's', "ks"},
    LessonControlRow{LessonControl::N, 'n', 'n', "n"},
    LessonControlRow{LessonControl::Shades, 'e', 'c', "shades"},
    LessonControlRow{LessonControl::I0, '0', '0', "I0"},
    LessonControlRow{LessonControl::Light, 'g', 'l', "light"},
    LessonControlRow{LessonControl::Turn, 't', 't', "turn"},
    LessonControlRow{LessonControl::Zoom, 'z', 'z', "zoom"},
    LessonControlRow{LessonControl::Shading, 'S', 'S', "shading"},
    LessonControlRow{LessonControl::Normals, 'R', 'N', "normals"},
    LessonControlRow{LessonControl::Order, 'O', 'O', "order"},
    LessonControlRow{LessonControl::Projection, 'P', 'P', "projection"},
    LessonControlRow{LessonControl::Table, 'T', 'T', "table"},
    LessonControlRow{LessonControl::Hue, 'H', 'H', "hue"},
    LessonControlRow{LessonControl::Bits, 'B', 'B', "bits"},
    LessonControlRow{LessonControl::Pick, 'j', 'J', "nearest"},
    LessonControlRow{LessonControl::ConstantL, 'L', 'L', "L constant"},
    LessonControlRow{LessonControl::ConstantV, 'V', 'V', "V constant"},
    LessonControlRow{LessonControl::Names, 'N', 0, "names"},
    LessonControlRow{LessonControl::Wrong, 'W', 0, "wrong"},
    LessonControlRow{LessonControl::Event, 'v', 0, "event"},
    LessonControlRow{LessonControl::Rotate, 'm', 0, "rotate"},
    LessonControlRow{LessonControl::Gamma, 'G', 0, "gamma"},
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

}  // namespace xnewell
