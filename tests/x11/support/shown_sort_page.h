#pragma once

#include <memory>
#include <optional>

#include "shading/picture/picture_cache.h"
#include "x11/stepper/sort_page.h"

namespace xnewell {

inline constexpr Rect kWide{16, 48, 992, 612}, kCompact{16, 43, 768, 428};

/// The page of a scene's run in a body, on a ground that nothing else uses.
struct ShownSortPage {
  static constexpr std::uint8_t kGround = 77;

  std::optional<Picture> picture;
  CellPlan plan;
  SortLayout at;
  std::unique_ptr<SortRun> run;
  IndexImage image;
  SortState view;
  SortDrawn drawn;

  explicit ShownSortPage(Scene scene, const Rect& body = kWide, Cull cull = Cull::Keep)
      : at{layoutOfSort(body)}, image{body.x + body.width + 16, body.y + body.height + 16, kGround} {
    PictureSettings settings;
    settings.width = at.picture.width;
    settings.height = at.picture.height;
    settings.cull = cull;
    settings.camera = completed({}, scene.camera);
    picture = makePicture(std::move(scene), settings);
    run = std::make_unique<SortRun>(*picture, plan[Cell::Well]);
  }
  const IndexImage& show(int step) {
    view.step = step;
    drawn = drawSortPage(image, at, *run, view, plan);
    return image;
  }
  [[nodiscard]] const Event& event(int step) const { return run->sorted().events[step - 1]; }
  [[nodiscard]] std::uint8_t operator()(Cell c) const { return plan[c]; }
};

}  // namespace xnewell
