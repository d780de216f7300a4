#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/picture/picture.h"
#include "x11/kit/page.h"
#include "x11/pixel/pixel_drawings.h"

namespace xnewell {

/// What there is to say about the sample of pixel (i, j) of a picture that is painted.
struct PixelStory {
  PixelStory(Picture picture, int i, int j);

  Picture picture;
  int i, j;
  PixelHistory history;
  std::vector<Explanation> explained;  ///< of each of history.painted

  /// What shows; null where no face does.
  [[nodiscard]] const Explanation* shown() const {
    return history.shown < 0 ? nullptr : &explained[static_cast<std::size_t>(history.shown)];
  }
  [[nodiscard]] int cell() const { return picture.image().row(j)[i]; }
  /// True if the cells hold single colours, so there is no shade to explain.
  [[nodiscard]] bool inColors() const { return channelsOf(picture.colors().plan()) == Channels::Rgb; }
  /// True if the chain ends in the picture's cell. Where the cells hold single colours, that is the one that
  /// quantize.h gives the wanted colour at this place.
  [[nodiscard]] bool isExplained() const;
  /// One word: ground, shaded, clamped or wrong face.
  [[nodiscard]] std::string_view verdict() const;
};

/// A pixel and its numbers from before the last change, for comparison.
struct PixelBefore {
  std::string I;  ///< as it is written
  int cell = 0;
  bool operator==(const PixelBefore&) const = default;
};
/// "0.8449"; where the cells hold colours, the intensity of each channel.
[[nodiscard]] std::string intensityWords(const PixelStory& story, const Explanation& e);

/// What a window shows of a pixel. A text has all vertices and channels.
struct PixelChoice {
  int chosen = -1;  ///< index into history.painted: the polygon that is explained; -1: what shows
  std::optional<int> vertex = {}, channel = {};
  std::optional<PixelBefore> before = {};
  BallTurn ball = {};
  const Palette* palette = nullptr;
  int shownBits = 0;  ///< as VisualInfo::shownBits(); 0 without a server
};
/// What can be pressed.
inline constexpr int kPressHistory = 1, kPressBall = 2, kPressAround = 3;

namespace page {

/// The four links of a pixel, and all of it in JSON.
[[nodiscard]] Page ofPixel(const std::shared_ptr<const PixelStory>& story, const PixelChoice& choice = {});
/// The pixels around and the facts beside them, for the place below the picture.
[[nodiscard]] Page besidePixel(const std::shared_ptr<const PixelStory>& story, const PixelChoice& choice);

}  // namespace page

}  // namespace xnewell
