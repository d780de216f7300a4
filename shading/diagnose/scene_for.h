#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/order.h"
#include "geometry/view/project.h"
#include "shading/diagnose/approach.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/judge_order.h"

namespace xnewell {

/// The face that each sample shows, an index into scene.faces or kNothing, row by row from the top.

/// As a program paints that works in some way. The scene has planes.
[[nodiscard]] std::vector<int> facesShown(const SnappedScene& scene, int width, int height, PaintWay way);

/// These faces, painted one over the other in this order.
[[nodiscard]] std::vector<int> paintedOver(const SnappedScene& scene, int width, int height,
                                           const std::vector<int>& order);

/// "face 17", or "a piece of face 17".
[[nodiscard]] std::string stepName(const PaintStep& step);

/// The text of a scene file with the two polygons of the first wrong pair alone, in the same view, painted as
/// they are listed: `xnewell draw` shows the mistake again.
[[nodiscard]] std::string pairAsScene(const Picture& picture, const WrongPair& pair,
                                      std::span<const PaintStep> steps);

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
