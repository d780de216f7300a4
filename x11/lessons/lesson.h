#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/scene/json_text.h"
#include "x11/homework/hand_ins.h"
#include "x11/lessons/lesson_page.h"

namespace xnewell {

/// Lessons: files of `data/lessons`, one JSON object each.
///
///   "title"   its subject, in lower case; "number" its place in the list, from 1
///   "shows"   a sentence for the list
///   "steps"   1 to 12, each one a figure (below) with
///     "heading"  at most 26 characters
///     "caption"  a list of paragraphs; the program replaces {cuts} by what it counts (lesson_facts.h)
///     "controls" names of lessonControls(): the controls that work in the step
///     "question" {"asks", "hint", "answers": 2 to 4 of {"text", "holds", "says", "shown"}}
///
/// Exactly one answer "holds". After an answer is given, the page shows what it "says", and what is "shown":
/// the step's figure with changes. A wrong answer is shown to fail, so it needs a figure in which it
/// fails. A step without "scene" begins with the figure of the step before, and changes it.
/// Unknown keys, wrong types and values out of range are refused.

/// A control that a step may have: each of a setting of the picture, under its label, and a few that are no
/// settings or have other words in a lesson.
struct LessonControl {
  char id;  ///< its key, the same as in the views that have the control too
  std::string_view name, label;
  std::string_view is = {}, words = {};  ///< if they are not those of the views
  std::string_view setting = {};         ///< the Setting::key of the setting that a lesson calls by this name
};
[[nodiscard]] const std::vector<LessonControl>& lessonControls();

struct LessonAnswer {
  std::string text;
  bool holds = false;
  std::string says;
  StepFigure shown;
};
struct LessonQuestion {
  std::string asks, hint;
  std::vector<LessonAnswer> answers;  ///< 2 to 4
};
struct LessonStep {
  std::string heading;
  std::vector<std::string> caption;  ///< paragraphs
  StepFigure figure;
  std::vector<char> controls;  ///< their keys
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
/// The lectures of the data folder (readLecture()), sorted by name. @throws ParseError, std::system_error
[[nodiscard]] std::vector<LectureEntry> builtInLectures();

/// The scenes of a lesson. A scene that several steps show is read once.
class SceneShelf {
 public:
  /// Scene files that are not built in are in `folder`.
  explicit SceneShelf(std::filesystem::path folder) : folder_{std::move(folder)} {}
  [[nodiscard]] std::shared_ptr<const Scene> scene(const Node& name, int divisions);

 private:
  std::filesystem::path folder_;
  std::map<std::pair<std::string, int>, std::shared_ptr<const Scene>> scenes_;
};

/// Checks that an object has no keys except those of a figure and `more`. @throws ParseError
void expectFigureKeys(const Node& node, std::initializer_list<std::string_view> more = {});

/// Reads `base` with the changes in the object. Without a base the object needs a scene. Claims are never
/// taken from the base.
///
///   "scene"      a built-in name, or a file in the folder; "divisions" of its patches
///   "listed"     all face numbers, in the order in which the scene lists them
///   "camera", "shading"  as in scene files (data/SCENES.md), in place of the scene's own
///   "window"     one of stageRows()
///   "line"       a line of words over the picture
///   "names"      {"A": 0, ...}: letters for faces; "extents" true: their z-extents below it
///   "wrong"      true: samples that show a wrong face are marked
///   "beside"     {"shading", "camera", "upper", "lower"}: the second picture of "side by side", below the
///                first, and the names of both
///   "effects"    {"stored", "hue turn", "gamma", "rotate", "lit", "bend"} (palette_effects.h)
///   "event"      {"kind" (wordFor()) or "test", "number"}, for "depth sort"; "says" claims a part of its
///                sentence
///   "scanline"   {"bits": 8, 16 or 24, "filled": 0 to 1}; for "scanline" and for facts of the first named
///                face
///   "viewing"    {"stage", "shaded in", "vertex"}, for "viewing": two of kViewStages, and a vertex as
///                cornerOf() reads it
///   "claims"     {"cuts": 3, "wrong samples": {"at least": 1}, ...}
/// @throws ParseError
[[nodiscard]] StepFigure readFigure(const Node& node, const StepFigure* base, SceneShelf& shelf);

}  // namespace xnewell
