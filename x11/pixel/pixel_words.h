#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// The words and numbers of an explanation, for the command `explain` and for view 8.

inline constexpr int kPixelDecimals = 4;

/// What there is to say about the sample of pixel (i, j).
struct PixelStory {
  /// The picture is painted and must outlive the story.
  PixelStory(const Picture& picture, int i, int j);

  const Picture& picture;
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

/// "painted over by 2"; `k` is an index into history.painted.
[[nodiscard]] std::string fateOf(const PixelStory& story, std::size_t k);

/// "I = ka Ia + f Ip [ kd N.L + ks (R.V)^n ]", with the mistake that is in force.
[[nodiscard]] std::string formulaOf(const Explanation& e, const Illumination& light);
/// What the mistake in the equation does, one sentence; empty if there is none, or if the method has no
/// equation.
[[nodiscard]] std::string mistakeWords(const Explanation& e, const Illumination& light);
/// Which of the two cosines a question mark stands for.
struct HiddenCosines {
  bool NL = false, RV = false;
};
/// The numbers put into the formula in one channel: one line, or one for the ambient term and each light.
[[nodiscard]] std::vector<std::string> numbersPutIn(const Explanation& e, const ExplainedEquation& at, int c,
                                                    Mistake mistake, HiddenCosines hidden = {});
/// "= 0.1800 + 0.5637 + 0.1012 = 0.8449": the ambient term, then the diffuse and the specular term of each
/// light, rounded so that they add up. If `together`, those of all lights are one diffuse and one specular
/// term. If a number of `known` terms is given, a question mark stands for each of the others and for the
/// sum.
[[nodiscard]] std::string sumOf(const ExplainedEquation& at, int c, bool together = false,
                                std::optional<std::size_t> known = {});
/// Shading by depth: the formula, the numbers put into it, and what they mean. No lines with another method.
/// The z of all corners are in it, or their sum where that line would have more than `widest` characters.
[[nodiscard]] std::vector<std::string> depthWords(const Explanation& e, std::size_t widest = 100);
/// The equation that is shown of an explanation: with Gouraud shading that of a vertex. Null if it has none.
[[nodiscard]] const ExplainedEquation* equationShown(const Explanation& e, int vertex);
/// "the weights on the screen count": which of the vertices' weights the method uses.
[[nodiscard]] std::string_view weightsThatCount(const Explanation& e);
/// "0.8449"; where the cells hold colours, the intensity of each channel.
[[nodiscard]] std::string intensityWords(const PixelStory& story, const Explanation& e);
/// "  -0.1182  -0.8214   0.5580"
[[nodiscard]] std::string componentsOf(const glm::dvec3& v);

/// The table of the face that an explanation is about.
[[nodiscard]] const ColorTable& tableOf(const PixelStory& story, const Explanation& e);
/// "I 0.8449 picks shade 202 of 240 (linear), cell 11 + 202 = 213", and "that shade is for 0.8431 <= I <
/// 0.8473". There are as many decimals as it takes to tell I from the borders.
struct PickedWords {
  std::string picks, range;
};
[[nodiscard]] PickedWords pickedWords(const PixelStory& story, const Explanation& e);

/// Where the cells hold single colours: "each channel is 1 + 254 I, rounded: 128, 129, 19; as a
/// colour 128, 129, 18".
[[nodiscard]] std::string channelsInWords(const Explanation& e);
/// "the nearest colour that a cell holds: cell 135 has 129, 137, 19 of 255".
[[nodiscard]] std::string heldInWords(const PixelStory& story, const Rgb16& held);
/// "this screen shows the upper 8 bits: 205, 0, 0", of a stored colour; `bits` is 1 to 16.
[[nodiscard]] std::string shownInWords(const Rgb16& stored, int bits);

/// A polygon of the history, an index into history.painted, in a few lines: its intensity and the formula
/// with the numbers put in, and the cell that is picked.
[[nodiscard]] std::vector<std::string> shortStory(const PixelStory& story, int chosen);

}  // namespace xnewell
