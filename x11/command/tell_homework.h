#pragma once

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// What is handed in for a scene: a picture, a painting order, the files of a class; and questions to hand
/// out. All return the exit status. `scene` and the settings say what is right.

/// Says which mistake the program made that drew options.handedIn, and writes a sheet that shows it. kDone if
/// the picture is right, else kOutside.
/// @throws UsageError for what cannot be diagnosed; ParseError, std::system_error for the picture
int tellDiagnosis(const Options& options, Scene scene);

/// Names the picture that tells the two mistakes of options.sceneFor apart. kDone if there is one, else
/// kOutside. @throws UsageError for names that are none
int tellSceneFor(const Options& options);

/// Says whether the painting order in options.handedIn is right, and writes the first wrong pair as a scene
/// of its own. kDone if the order is right, else kOutside. @throws ParseError, std::system_error for the file
int tellJudgement(const Options& options, Scene scene);

/// Says of the run of another depth sort in options.window.run which step is false first, and why. kDone if
/// none is, else kOutside. @throws ParseError, std::system_error for the file
int tellRun(const Options& options, Scene scene);

/// Marks all files in the folder options.handedIn, writes a row each, and prints a summary. An interrupt
/// leaves the files that were there before. @throws UsageError, std::system_error
int gradeFolder(const Options& options, Scene scene);

/// Prints questions about the scene with their solutions, and writes them for Moodle. @throws UsageError if
/// the scene has not as many
int tellQuestions(const Options& options, const Scene& scene);

}  // namespace xnewell
