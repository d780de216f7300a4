#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/drawing/painter.h"
#include "x11/options/options.h"
#include "x11/views/difference.h"

namespace xnewell {

/// Two pictures A and B of one scene in one view: where do they differ, by how much, and which is right?

/// A picture, painted, and its colours; both outlive it.
struct ColoredPicture {
  const Picture& picture;
  const Palette& palette;  ///< its own palette, with the CellPlan that is used without a server
};

/// |A - B| at every sample. A picture that shows no face there counts as intensity 0 and as the background
/// colour. Precondition: both have the same scene and size, and hasIntensities() if `kind` is
/// Unlike::Intensity.
[[nodiscard]] Difference unlikeness(Unlike kind, const ColoredPicture& A, const ColoredPicture& B);
/// False if a picture's cells hold colours, which have no intensity.
[[nodiscard]] bool hasIntensities(const Picture& A, const Picture& B);

/// Places where samples differ: frames of one size. The first frame has most of them, each later one most of
/// the rest.
struct DifferingPlace {
  Rect frame;
  std::int64_t samples = 0;  ///< differing samples that no earlier frame has
};
inline constexpr int kMostPlaces = 9;
[[nodiscard]] std::vector<DifferingPlace> placesOf(const Difference& unlike, int frameWidth, int frameHeight);

/// Milliseconds from the scene's points to the painted picture, with nothing kept from earlier runs: the best
/// of five runs, or of fewer if they take long.
struct BestTime {
  double ms = 0, next = 0;  ///< the best, and the one after it
  int runs = 0;
};
/// In turn, so that other work of the machine slows both alike.
[[nodiscard]] std::array<BestTime, 2> timesOf(const Scene& scene, const PictureSettings& A,
                                              const PictureSettings& B);
/// True if two runs of the same differ as much as these two.
[[nodiscard]] bool isDoubtful(const BestTime& a, const BestTime& b);

/// Both pictures in the cells of one colormap. If their tables hold the same colours, the indices stay.
/// Otherwise the cells hold the colours that either picture shows, at 8 bits a channel. If there are more
/// than `most`, that many are chosen for both (quantize.h), and samples get the nearest.
struct OnePalette {
  IndexImage A, B;
  Palette palette{};    ///< with the tool's colours
  bool shared = false;  ///< the colours were chosen for both
  bool exact = true;    ///< every sample has its own colour
  int colors = 0;       ///< the number of shared colours
};
/// `own` has the colours of A and of the plan. There are cells for `most` colours.
[[nodiscard]] OnePalette onePalette(const ColoredPicture& A, const ColoredPicture& B, const CellPlan& plan,
                                    const Palette& own, int most = kMaxShades);

/// A setting in words. Settings that differ come first.
struct Phrase {
  std::string text;
  bool differs = false;
};
[[nodiscard]] std::vector<Phrase> phrasesOf(const PictureSettings& mine, const PictureSettings& other);
/// The names of the settings that differ ("order", "shading", ...), except size and camera.
[[nodiscard]] std::vector<std::string> differencesOf(const PictureSettings& A, const PictureSettings& B);

/// The finding about two pictures, and why. `ofA` and `ofB` compare each with the truth about it. Both have
/// the same truth if their lights and surfaces are the same.
[[nodiscard]] Finding findingOf(const Picture& A, const Picture& B, const Difference& ofA,
                                const Difference& ofB, const Difference& unlike,
                                const std::optional<DifferingPlace>& place);

}  // namespace xnewell
