#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "shading/scene/json_node.h"
#include "x11/lessons/exhibit.h"

namespace xnewell {

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

/// Checks that an object has no keys except those of an exhibit and `more`. @throws ParseError
void expectExhibitKeys(const Node& node, std::initializer_list<std::string_view> more = {});

/// Reads `base` with the changes in the object. Without a base the object needs a scene. Claims are never
/// taken from the base.
///
///   "scene"      a built-in name, or a file in the folder; "divisions" of its patches
///   "listed"     all face numbers, in the order in which the scene lists them
///   "camera", "shading"  as in scene files (scene_file.h), in place of the scene's own
///   "window"     one of kStages
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
[[nodiscard]] Exhibit readExhibit(const Node& node, const Exhibit* base, SceneShelf& shelf);

}  // namespace xnewell
