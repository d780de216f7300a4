#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/picture/palette_effects.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// What a step of a lesson shows: a scene, how it is set up, and what is told beside it.

/// What stands below the picture, or in its place.
enum class Stage { Picture, DepthSort, Colors, MachBands, SideBySide };
struct StageRow {
  Stage id;
  std::string_view name, shows;
};
inline constexpr std::array kStages{
    StageRow{Stage::Picture, "picture", "the picture, and its numbers"},
    StageRow{Stage::DepthSort, "depth sort", "the picture so far, P and Q, and the tests of one step"},
    StageRow{Stage::Colors, "colours", "what the cells hold, and the step from each to the next"},
    StageRow{Stage::MachBands, "mach bands", "the intensity along the middle row, for three methods"},
    StageRow{Stage::SideBySide, "side by side", "two ways to draw the scene, and how much differs"},
};

/// Which step of the depth sort's textbook run: the n-th of a kind, or the n-th that a test settled.
struct EventChoice {
  std::optional<Event::Kind> kind = {};  ///< else any
  std::optional<Test> test = {};         ///< then `kind` does not count
  int number = 1;                        ///< from 1
  std::string says = {};                 ///< claimed: a part of the step's sentence
};
/// The step in the run, from 1; nothing if there are not so many.
[[nodiscard]] std::optional<int> stepOf(const SortedScene& run, const EventChoice& choice);

struct NamedFace {
  int face;  ///< number in the model
  std::string name;
};

/// A number that a step's words rely on, to be held against what the program shows (lesson_facts.h).
struct Claim {
  int fact = 0;                                     ///< index into kFacts
  std::optional<double> is, least = {}, most = {};  ///< any of them
};

struct Exhibit {
  std::shared_ptr<const Scene> scene;
  std::string sceneName;
  PictureSettings settings;  ///< size aside; camera and light in the scene's units
  Stage stage = Stage::Picture;
  std::string line;  ///< over the picture
  std::vector<NamedFace> names;
  bool extents = false;      ///< those of the named faces are drawn below
  bool named = true;         ///< whether the names are shown
  bool wrongMarked = false;  ///< samples that show a wrong face
  PaletteEffects effects;
  EventChoice event;       ///< of Stage::DepthSort
  PictureSettings beside;  ///< of Stage::SideBySide, below the other
  std::string upperLine, lowerLine;
  std::vector<Claim> claims;
};

}  // namespace xnewell
