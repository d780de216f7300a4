#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/explain/viewing_story.h"
#include "x11/drawing/painter.h"
#include "x11/kit/control.h"
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

/// The drawings of a stage: the scene from outside with the viewing volume around it, large or small.

/// The images of the stages that were drawn last: the large one, and the small ones. One is made again only
/// if what it shows has changed.
class StageImages {
 public:
  /// What an image shows, beside its stage. `made` counts the pictures that were drawn: each has its own
  /// scene, view and light.
  struct Shows {
    int made;
    OutsideTurn turn;
    glm::ivec2 size;
    std::uint8_t ground;
    std::optional<OutsideCamera> held;
    bool operator==(const Shows&) const = default;
  };
  template <class Make>
  const StageImage& get(ViewStage stage, bool large, const Shows& shows, const Make& make) {
    std::optional<Cached>& kept = kept_[large ? 0 : static_cast<std::size_t>(stage) + 1];
    if (kept && kept->shows == shows && kept->stage == stage) return kept->image;
    StageMemory memory = kept ? kept->image.release() : StageMemory{};
    kept.reset();
    return kept.emplace(Cached{stage, shows, make(std::move(memory))}).image;
  }

 private:
  struct Cached {
    ViewStage stage;
    Shows shows;
    StageImage image;
  };
  std::array<std::optional<Cached>, kViewStages.size() + 1> kept_;
};

struct OutsideView {
  const Picture& picture;
  const LitParts& lit;
  const ViewingStory& story;
  const StagePoints& points;
  StageImages& images;
  int made = 0;  ///< as StageImages::Shows
  ViewStage stage = ViewStage::World;
  OutsideTurn turn = {};
  bool programs = true;                 ///< the small viewport is the program's picture, not drawn with `lit`
  bool handles = false;                 ///< the large drawing has handles; a lesson's has none
  const OutsideCamera* held = nullptr;  ///< the large drawing keeps this camera; null: it fits the volume
  std::optional<ViewHandle> handle = {};  ///< the one that stands out,
  std::string handleName = {};            ///< with this name
};

/// The turn of the viewport and of the grid begins straight before the picture.
[[nodiscard]] OutsideTurn turnAt(ViewStage stage, const OutsideTurn& turn);

/// Draws the stage large: with names, axes, handles, the vertex with its N and L, and what the volume was
/// before. Returns the image of the scene, which is one of view.images, so that a click finds a face; the
/// grid has none.
const StageImage* drawStage(Pen& pen, const Rect& area, const OutsideView& view);
/// Draws it small, without words: the volume, and the vertex as a dot. The viewport is the program's picture.
void drawSmallStage(Pen& pen, const Rect& area, const OutsideView& view);

}  // namespace xnewell
