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

/// Scenes that were read for a lesson: those that several steps show are read once.
class SceneShelf {
 public:
  /// Files that are not built in stand in `folder`.
  explicit SceneShelf(std::filesystem::path folder) : folder_{std::move(folder)} {}
  [[nodiscard]] std::shared_ptr<const Scene> scene(const Node& name, int divisions);

 private:
  std::filesystem::path folder_;
  std::map<std::pair<std::string, int>, std::shared_ptr<const Scene>> scenes_;
};

/// An object with no keys but those of an exhibit, and `more`. @throws ParseError
void expectExhibitKeys(const Node& node, std::initializer_list<std::string_view> more = {});

/// `base` with what the object says of it; without a base a scene is needed. Claims are the object's own.
///   "scene"      a built-in name, or a file beside the lesson; "divisions" of its patches
///   "listed"     all face numbers, in the order in which the scene is to list them
///   "camera", "shading"  as in scene files (scene_file.h), over what the scene says
///   "window"     one of kStages
///   "line"       what stands over the picture
///   "names"      {"A": 0, ...}: letters for faces; "extents" true: their z-extents below the picture
///   "wrong"      true: samples that show a wrong face are marked
///   "beside"     {"shading", "camera", "upper", "lower"}: the second picture of "side by side", below the
///                first, and what the two are called
///   "effects"    {"stored", "hue turn", "gamma", "rotate", "lit", "bend"} (palette_effects.h)
///   "event"      {"kind" (wordFor()) or "test", "number"}, of "depth sort"; "says" claims a part of its
///                sentence
///   "claims"     {"cuts": 3, "wrong samples": {"at least": 1}, ...}
/// @throws ParseError
[[nodiscard]] Exhibit readExhibit(const Node& node, const Exhibit* base, SceneShelf& shelf);

}  // namespace xnewell
