#pragma once

#include <optional>
#include <string>
#include <vector>

#include "x11/pixel/pixel_words.h"

namespace xnewell {

/// Values of an explanation that a student may predict. The page hides the one that is asked, and all that
/// follows from it, so they are in the order of the chain.
enum class Predicted { NdotL, Cosine, Diffuse, Specular, I, Cell };

struct Prediction {
  Predicted what;
  std::string name;  ///< "N.L", "the diffuse term"
  double value = 0;
  double written = 0;             ///< as the page writes it; terms are rounded so that they add up
  int decimals = kPixelDecimals;  ///< 0: a whole number
};

/// What can be asked of one pixel: of its equation `at`, null if its method evaluates none, and of its cell.
[[nodiscard]] std::vector<Prediction> predictionsOf(const PixelStory& story, const Explanation& e,
                                                    const ExplainedEquation* at, int channel);

/// A typed value is right within half of its last digit. It needs two decimals, because with fewer a guess
/// would do; digits beyond those that the page shows do not count.
struct Judged {
  bool isRight = false;
  std::string complaint;  ///< a sentence if the text is no such number
};
[[nodiscard]] Judged judged(const Prediction& asked, const std::string& text);

}  // namespace xnewell
