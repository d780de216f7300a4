#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/diagnose/diagnose.h"

namespace xnewell {

/// The scene that tells two mistakes apart.

/// A picture of 640 x 480 pixels of a built-in scene; all else is as the scene has it.
struct PartingPicture {
  std::string_view scene;
  Shading method = Shading::Flat;
  TableKind table = TableKind::Linear;
  std::optional<glm::dvec4> window = {};  ///< on the view plane, if it is not the scene's
};

inline constexpr glm::ivec2 kPartingSize{640, 480};
/// Values that are no further apart may come from the rounding of another program.
inline constexpr double kLeastParting = 2;

/// The scenes that are made to tell mistakes apart, and others, each with all methods and tables. The last
/// pictures of a bench have a window whose centre is aside: mistakes of the view show there.
[[nodiscard]] std::vector<PartingPicture> benchPictures();
[[nodiscard]] std::vector<PartingPicture> otherPictures();

struct SceneFor {
  std::optional<PartingPicture> picture;  ///< nothing: no picture tells them apart
  Parting parting;                        ///< there, or where they differ most
  bool byCells = false;                   ///< only the cells of an indexed picture tell
  int tried = 0;                          ///< pictures in which both keys have a row
};

/// The picture where the rows of two keys differ most.
[[nodiscard]] SceneFor sceneFor(std::string_view a, std::string_view b,
                                std::span<const PartingPicture> pictures);

/// The keys of hypotheses() that are spelled most like a word, the nearest first.
[[nodiscard]] std::vector<std::string_view> nearestKeys(std::string_view word, std::size_t count);

}  // namespace xnewell
