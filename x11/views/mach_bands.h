#pragma once

#include <optional>

#include "shading/laboratory/profile.h"
#include "x11/drawing/painter.h"
#include "x11/views/views.h"

namespace xnewell {

/// Where does the eye see stripes that are not in the picture? The view shows the picture with a scanline
/// marked. Under it, exactly under the picture's columns, each method has the scanline repeated as a strip,
/// its intensity, and the change from pixel to pixel. The findings are beside them.
///
/// The picture is as wide as the profiles and has the view's proportions; it is cut off above and below if
/// there is no room. A plan of colours becomes one hue, since a profile has one channel.
[[nodiscard]] ColoredImage drawMachBands(const Picture& picture, const ViewSettings& settings);
/// @throws std::invalid_argument where the scanline is not in the picture
[[nodiscard]] PictureSettings pictureForMachBands(const Scene& scene, const ViewSettings& settings);

/// For a window: where the picture goes in a view of this size.
struct MachBandsLayout {
  Rect picture;       ///< the part of the picture that is shown
  int pictureHeight;  ///< of the whole picture
};
[[nodiscard]] MachBandsLayout layoutOfMachBands(int width, int height);

struct MachBandsPage {
  IndexImage image;
  Writing writing;
  int firstRow = 0;                      ///< the first row of the picture that is shown
  Rect controls{};                       ///< left empty for the window's controls
  std::vector<std::string> report = {};  ///< the finding and the table
};
struct MachBandsShown {
  int row = 0;  ///< the row of the picture that is the scanline
  std::optional<int> firstRow =
      {};  ///< the first row to show, as far as the picture reaches; without it the scanline is in the middle
  bool framed = false;  ///< the picture has three to two, as in a window
  bool grayed = false;  ///< the colours had to become one hue
  int controls = 0;     ///< height left for controls; 0: words tell their values instead
  int unit = 1;         ///< the image has so many pixels for each unit, each way
};
/// The size in the settings is in units. `picture` is painted, of all pixels of the layout's, by a plan of
/// ramps.
[[nodiscard]] MachBandsPage drawMachBandsPage(const Picture& picture, const MachBandsShown& shown,
                                              const ViewSettings& settings);

}  // namespace xnewell
