#pragma once

#include <optional>

#include "shading/picture/profile.h"
#include "x11/drawing/rect.h"
#include "x11/views/views.h"

namespace xnewell {

/// Where does the eye see stripes that the picture does not hold? The picture with a scanline marked, and
/// under it for each method, exactly under the picture's columns: the scanline repeated as a strip, its
/// intensity, and the change from pixel to pixel; beside them the findings.
///
/// The picture is as wide as the profiles, of the view's own proportions, and cut off above and below where
/// there is no room. A plan of colours becomes one hue: a profile has one channel.
[[nodiscard]] ColoredImage drawMachBands(const Picture& picture, const ViewSettings& settings);
/// @throws std::invalid_argument where the scanline is not in the picture
[[nodiscard]] PictureSettings pictureForMachBands(const Scene& scene, const ViewSettings& settings);

/// For whoever shows it in a window: where its picture goes, in a view of this size.
struct MachBandsLayout {
  Rect picture;       ///< what is shown of it
  int pictureHeight;  ///< of the whole
};
[[nodiscard]] MachBandsLayout layoutOfMachBands(int width, int height);

struct MachBandsPage {
  IndexImage image;
  int firstRow = 0;  ///< of the picture: the first that is shown
  Rect controls{};   ///< left empty, for what changes the picture
};
struct MachBandsShown {
  int row = 0;  ///< of the picture: the scanline
  std::optional<int> firstRow =
      {};               ///< that is shown, as far as the picture reaches; else the scanline is in the middle
  bool grayed = false;  ///< colours had to become one hue
  int controls = 0;     ///< pixels left for controls; 0: words say what they would show
};
/// `picture` is painted, of the layout's size and by a plan of ramps.
[[nodiscard]] MachBandsPage drawMachBandsPage(const Picture& picture, const MachBandsShown& shown,
                                              const ViewSettings& settings);

}  // namespace xnewell
