#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "x11/drawing/pen.h"
#include "x11/viewing/stage_image.h"
#include "x11/viewing/view_handles.h"

namespace xnewell {

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
    std::optional<Kept>& kept = kept_[large ? 0 : static_cast<std::size_t>(stage) + 1];
    if (kept && kept->shows == shows && kept->stage == stage) return kept->image;
    StageMemory memory = kept ? kept->image.release() : StageMemory{};
    kept.reset();
    return kept.emplace(Kept{stage, shows, make(std::move(memory))}).image;
  }

 private:
  struct Kept {
    ViewStage stage;
    Shows shows;
    StageImage image;
  };
  std::array<std::optional<Kept>, kViewStages.size() + 1> kept_;
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
