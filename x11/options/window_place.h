#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/scene/settings.h"
#include "x11/views/difference.h"
#include "x11/views/view_table.h"

namespace xnewell {

/// Where a view begins, beside its scene and the set-up.
struct WindowPlace {
  View view = View::Picture;
  int step = 0;          ///< of the depth sort, or of the polygon that is filled; of view 9 the stage, from 1
  std::string run = {};  ///< of view 2, and of judge: the file with the run of another program; "" for none
  std::optional<int> scanline = {};         ///< of the view of Mach bands
  std::optional<int> cell = {};             ///< of the view of the colours
  std::optional<std::string> polygon = {};  ///< of view 0: "59.1", or "59" for the face's first part
  std::optional<glm::ivec2> pixel = {};     ///< of view 8: column and row in its picture
  /// Of view 9: FACE.CORNER, or the number of a vertex. "" or none: one in the middle of the picture.
  std::optional<std::string> vertex = {};
  std::optional<std::string> controls =
      {};  ///< the keys of the few in view 1; "": put away; none: all of them
  /// Of view 5: the settings of B that differ from those of A. None: an order worth comparing.
  std::optional<std::vector<Override>> beside = {};
  Unlike difference = Unlike::Face;  ///< of view 5
};

/// The options that say where the view begins, with their values; those that are as without an option are
/// left out. The view itself is not among them.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> optionsOf(const WindowPlace& place);

/// The value of --beside: "order=none shade=phong", or "same" for no settings at all.
[[nodiscard]] std::string besideText(const std::vector<Override>& own);
/// Reads it. @throws UsageError
[[nodiscard]] std::vector<Override> besideOf(const std::string& text);

}  // namespace xnewell
