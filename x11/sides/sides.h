#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/drawing/rect.h"
#include "x11/views/difference.h"

namespace xnewell {

/// Two pictures of one scene in one view, A and B: where do they differ, by how much, and which of them is
/// right?

/// In what two pictures may differ at a sample, a row each.
enum class Unlike { Face, Intensity, Color };
struct UnlikeRow {
  Unlike id;
  std::string_view name;
  double unit;  ///< samples count that differ by more
  std::string_view differs, same, unitInWords;
};
inline constexpr std::array kUnlikes{
    UnlikeRow{Unlike::Face, "face", 0.0, "another face", "same in A and B", ""},
    UnlikeRow{Unlike::Intensity, "intensity", 1.0 / 240, "differs", "below 1/240", "x 1/240"},
    UnlikeRow{Unlike::Color, "colour", 1.0, "differs", "below 1", "CIEDE2000"},
};
[[nodiscard]] constexpr const UnlikeRow& rowOf(Unlike kind) {
  return kUnlikes[static_cast<std::size_t>(kind)];
}

/// A picture, painted, and its colours; both outlive it.
struct ColoredPicture {
  const Picture& picture;
  const Palette& palette;  ///< its own, as CellPlan has it without a server
};

/// A - B at every sample, as an amount. Where one of them shows nothing, that has intensity 0 and the colour
/// of the well.
struct Unlikeness {
  Unlike kind = Unlike::Face;
  int width = 0;
  std::vector<float> at = {};  ///< row by row; of faces 0 or 1; NaN where neither shows anything
  std::int64_t samples = 0;    ///< those that show something in A or in B
  std::int64_t differ = 0;     ///< of them, those that differ by more than the unit
  double largest = 0, rootMeanSquare = 0;
};
/// Precondition: both of one scene and size, and hasIntensities() where kind says so.
[[nodiscard]] Unlikeness unlikeness(Unlike kind, const ColoredPicture& A, const ColoredPicture& B);
/// Cells of colours stand for no intensity.
[[nodiscard]] bool hasIntensities(const Picture& A, const Picture& B);
/// Steps that double from the unit on; faces are the same or not.
[[nodiscard]] IndexImage unlikenessImage(const Unlikeness& unlike, const CellPlan& plan);

/// Where samples differ: frames of one size, the one with most of them first, then with most of the others.
struct DifferingPlace {
  Rect frame;
  std::int64_t samples = 0;  ///< in no earlier frame
};
inline constexpr int kMostPlaces = 9;
[[nodiscard]] std::vector<DifferingPlace> placesOf(const Unlikeness& unlike, int frameWidth, int frameHeight);

/// What is measured of each. Intensities, or colours, are compared with Phong's method at every pixel in the
/// picture's own light and material, unquantised, and the faces that the oracle sees (difference.h): one
/// reference for both as long as these are the same.
struct SideNumbers {
  int samples = 0, wrong = 0;  ///< exactnessOf()
  Measure measure = Measure::Intensity;
  double largest = 0, rootMeanSquare = 0;
  std::int64_t painted = 0;  ///< polygons and pieces
  std::int64_t cuts = 0;
};
/// `picture` is painted.
[[nodiscard]] SideNumbers numbersOf(const Picture& picture);

/// Milliseconds from the scene's points to the painted picture, nothing kept from before: the best of up to
/// three runs, fewer where they take long.
struct BestTime {
  double ms = 0;
  int runs = 0;
};
[[nodiscard]] BestTime timeOf(const Scene& scene, const PictureSettings& settings);

/// Both in the cells of one colormap. Where their tables hold the same colours the indices stay. Else the
/// cells hold the colours that either shows, as 8 bits a channel show them; beyond `most` the nearest of as
/// many as are chosen for both (quantize.h).
struct OnePalette {
  IndexImage A, B;
  Palette palette{};    ///< with the tool's colours
  bool shared = false;  ///< chosen for both
  bool exact = true;    ///< every sample has its own colour
  int colors = 0;       ///< that are shared
};
/// `own` has A's own colours and the plan's; there are cells for `most` colours.
[[nodiscard]] OnePalette onePalette(const ColoredPicture& A, const ColoredPicture& B, const CellPlan& plan,
                                    const Palette& own, int most = kMaxShades);

/// A setting in words. What differs comes first.
struct Phrase {
  std::string text;
  bool differs = false;
};
[[nodiscard]] std::vector<Phrase> phrasesOf(const PictureSettings& mine, const PictureSettings& other);
/// "order", "shading", ...: what they were made differently by, size and camera apart.
[[nodiscard]] std::vector<std::string> differencesOf(const PictureSettings& A, const PictureSettings& B);

/// What there is to say about two pictures: one finding, and why.
[[nodiscard]] Finding findingOf(const Picture& A, const Picture& B, const SideNumbers& ofA,
                                const SideNumbers& ofB, const Unlikeness& unlike,
                                const std::optional<DifferingPlace>& place);

}  // namespace xnewell
