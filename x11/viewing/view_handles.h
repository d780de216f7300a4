#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "shading/explain/viewing_story.h"
#include "x11/kit/control_list.h"
#include "x11/viewing/stage_image.h"
#include "x11/window/host.h"

namespace xnewell {

/// Handles in the view from outside: small squares that are dragged to change numbers of the view. Each moves
/// along its own axis; VRP moves in the plane of the drawing. From the warp on there are none, because there
/// the volume is always the same box.

/// The height of the band at the top of a large drawing where its title stands, and of that at its bottom.
inline constexpr int kWordBand = 26;

enum class ViewHandle { Vrp, PrpN, Front, Back, Umin, Umax, Vmin, Vmax, PrpU, PrpV };
struct ViewHandleRow {
  ViewHandle id;
  ControlId number;  ///< the control that has its number, or the first of them
  int numbers;       ///< 1, or 3 for those of a place in the world
  ViewStage last;    ///< the last stage whose space stays as it is while this number changes
  std::string_view is;
};
inline constexpr std::array kViewHandles{
    ViewHandleRow{ViewHandle::Vrp, {'v', 0}, 3, ViewStage::World, "VRP: drag it, and all of the view moves"},
    ViewHandleRow{ViewHandle::PrpN, {'p', 2}, 1, ViewStage::Vrc, "PRP: drag it along n"},
    ViewHandleRow{ViewHandle::Front, {'f', 0}, 1, ViewStage::Sheared, "the front plane: drag it along n"},
    ViewHandleRow{ViewHandle::Back, {'b', 0}, 1, ViewStage::Sheared, "the back plane: drag it along n"},
    ViewHandleRow{ViewHandle::Umin, {'o', 0}, 1, ViewStage::Vrc, "the window's left edge: drag it along u"},
    ViewHandleRow{ViewHandle::Umax, {'o', 1}, 1, ViewStage::Vrc, "the window's right edge: drag it along u"},
    ViewHandleRow{ViewHandle::Vmin, {'o', 2}, 1, ViewStage::Vrc, "the window's lower edge: drag it along v"},
    ViewHandleRow{ViewHandle::Vmax, {'o', 3}, 1, ViewStage::Vrc, "the window's upper edge: drag it along v"},
    ViewHandleRow{ViewHandle::PrpU, {'p', 0}, 1, ViewStage::Vrc, "PRP: drag it along u"},
    ViewHandleRow{ViewHandle::PrpV, {'p', 1}, 1, ViewStage::Vrc, "PRP: drag it along v"},
};
[[nodiscard]] constexpr const ViewHandleRow& rowOf(ViewHandle handle) {
  return kViewHandles[static_cast<std::size_t>(handle)];
}

/// A handle of a drawing. Lengths are pixels of its image.
struct HandleAt {
  ViewHandle id;
  glm::dvec2 at;
  std::array<glm::dvec2, 3> along;  ///< where it goes when each of its numbers grows by 1
  /// How far it goes for 1: a drag of one pixel along `along` changes the number by 1 / pace.
  double pace;
};

/// The handles of a stage, at a place inside a drawing of this size. One whose axis is seen nearly end on is
/// left out. A shown 1 is `shownUnit` of the scene's lengths; `scale` is the number of pixels in a unit of
/// the window.
[[nodiscard]] std::vector<HandleAt> handlesAt(const ViewingStory& story, const ViewSpec& view,
                                              ViewStage stage, const StageImage& image, double shownUnit,
                                              int scale);

/// A drag of a handle. All changes are counted from where it began, so that the handle stays under the
/// pointer; and the drawing must keep its camera.
class HandleDrag {
 public:
  /// `pointer` is in units of the window, `scale` pixels each.
  HandleDrag(const HandleAt& handle, const OutsideCamera& camera, const Controls& controls,
             glm::ivec2 pointer, int scale);

  [[nodiscard]] ViewHandle id() const { return handle_.id; }
  [[nodiscard]] const OutsideCamera& camera() const { return camera_; }
  /// The pointer is here now. Sets the numbers, rounded to a step that is no longer than a pixel of the drag.
  /// What is no view is refused with the control's own sentence; the number stops at the last step before
  /// that.
  void to(glm::ivec2 pointer, const Controls& controls, const Host& host);

 private:
  void set(const Control& number, double wanted, const Host& host) const;

  HandleAt handle_;
  OutsideCamera camera_;
  std::array<double, 3> begun_{};  ///< the numbers when the drag began
  glm::ivec2 from_;
  int scale_;
  bool moved_ = false;
};

}  // namespace xnewell
