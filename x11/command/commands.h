#pragma once

#include <functional>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"
#include "x11/kit/page.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// What main() runs for the commands. What returns an int returns the exit status. `scene` and the settings
/// say what is right; an interrupt of a long command ends it, and it prints what is known.

/// `figure`: writes the picture of a scene as areas, to the file of -o. With --ids it also writes the figure
/// in the colours of the faces' numbers: both files or neither. With --stats it prints one JSON object. If
/// the colours come from samples, one line on standard error tells how far they are off.
/// @throws ViewError, TooManyPieces, std::system_error
void drawFigure(const Options& options, const Scene& scene);

/// `trade`: measures what each short cut saves and costs.
[[nodiscard]] int tellTrade(const Options& options, Scene scene);
/// --accuracy: puts the short cuts of the cheapest point of the measured front within `limit` into the
/// options, and the divisions into the scene. Options that the user gave stay. Says on standard error what
/// was chosen and why, and returns the same for --stats.
[[nodiscard]] page::Data keepWithin(const AccuracyLimit& limit, Options& options, Scene& scene);

/// `extremes`: drives a scene to its extremes and tells what becomes wrong first.
[[nodiscard]] int tellExtremes(const Options& options, const Scene& scene);

/// `diagnose`: says which mistake the program made that drew options.handedIn, and writes a sheet that shows
/// it. @throws UsageError for what cannot be diagnosed; ParseError, std::system_error for the picture
[[nodiscard]] int tellDiagnosis(const Options& options, Scene scene);
/// --scene-for: names the picture that tells two mistakes apart. @throws UsageError for names that are none
[[nodiscard]] int tellSceneFor(const Options& options);
/// `judge`: says whether the painting order in options.handedIn is right, and writes the first wrong pair as
/// a scene of its own. @throws ParseError, std::system_error for the file
[[nodiscard]] int tellJudgement(const Options& options, Scene scene);
/// --run: says which step is false first in the run of another depth sort, and why. @throws as
/// tellJudgement()
[[nodiscard]] int tellRun(const Options& options, Scene scene);
/// `grade`: marks all files in the folder options.handedIn, writes them in a format of marks_formats.h, and a
/// page a student with --feedback, and prints a summary. With --rubric each student has a row a stage.
/// @throws UsageError, std::system_error
[[nodiscard]] int gradeFolder(const Options& options, Scene scene);
/// `questions`: prints questions about the scene with their solutions, and writes them for Moodle.
/// @throws UsageError if the scene has not as many
[[nodiscard]] int tellQuestions(const Options& options, const Scene& scene);

/// `trace --frames`: writes a numbered PNG for each step of the kind that --every names, and one of the whole
/// picture at the end. Makes the folder if it does not exist.
/// @throws UsageError if the run has no such step or more than 9,998 of them, or if the folder holds frames
/// already; std::system_error
void writeFrames(const Options& options, const Picture& picture, const SortedScene& sorted);
/// With --whole-window: the window's stepper at each of these steps. It calls `tell` with the number of the
/// frame and the number of all frames before it draws each.
void writeStepperFrames(const Options& options, Scene scene, const std::function<void(int, int)>& tell);

/// The lesson of `xnewell lesson NAME`: a built-in one, or a .json file. @throws UsageError for an unknown
/// name; ParseError, std::system_error
[[nodiscard]] Lesson lessonNamed(const std::string& nameOrFile);
/// `lesson --frames`: a picture of the whole window at each step, before its question is answered. `tell`
/// gets the number of each step, from 1. @throws as writeFrames()
void writeLesson(const Options& options, Lesson lesson, const std::function<void(int)>& tell);
/// --worksheet: one HTML file to be printed, with the picture and the words of each step, its question with
/// room to write, and all solutions on a page of their own at the end, or in the file of --solutions.
void writeWorksheet(const Options& options, Lesson lesson, const std::function<void(int)>& tell);

/// What a shell may put in place of the last of the words after `xnewell`, each with a tab and what it does.
/// Commands, options and their words come from the rows of --help, and scenes and lessons from the data
/// folder, so a new file is proposed at once. The files in x11/install ask with `xnewell complete -- WORDS`.
[[nodiscard]] std::string proposalsFor(std::vector<std::string> words);

/// `trace`: describes a run of the depth sort.

/// The run of a picture with planes (Picture::withPlanes()), with its events: the textbook's, or with --quick
/// the accelerated one.
/// @throws std::runtime_error if the run has too many steps to record
[[nodiscard]] SortedScene recordedRun(const Options& options, const Picture& picture);

/// Writes one JSON object per line. The first, "event": "run", describes the run; the last, "summary", gives
/// its counts. Between them stand, in the order of the run, the events take, test, move, cycle, impossible,
/// vain, contact, cut and paint. Before a test that settles a pair stand the tests that were made earlier and
/// failed; together they are one step. Lengths are in pixels, a larger z is nearer, and numbers have ten
/// digits.
/// @throws std::system_error if `out` accepts no more
void printTrace(const Options& options, const Picture& picture, const SortedScene& sorted, std::ostream& out);

/// The page of build.sh, which begins with this lesson or lecture. It also holds the files that were read for
/// it, at their places relative to each other, but those of the data folder, which every page has.
/// @throws std::runtime_error if the page is of another version
[[nodiscard]] std::string pageThatBeginsWith(const Options& options, const std::set<std::string>& read,
                                             std::string page);

/// Writes this page. @throws std::runtime_error if build.sh has made none; as writeFile() does
void writePage(const Options& options);

}  // namespace xnewell
