#pragma once

#include <optional>
#include <string>
#include <vector>

#include "x11/sides/sides.h"

namespace xnewell {

/// What differs between two pictures, where, and how much? A and B stand beside each other; below them are
/// the image of their difference and the numbers of both.

/// The places of the page's parts, in units. The three pictures have one scale and take the space that is
/// free.
struct SidesLayout {
  bool compact = false;
  Rect A, B;
  Rect difference;  ///< as many rows of the difference as fit
  Rect captionA, captionB, sections, numbers;
  int frameWidth = 0, frameHeight = 0;  ///< the size of the frame in all three
};
/// `body` is at least 768 x 428.
[[nodiscard]] SidesLayout layoutOfSides(const Rect& body);

/// What is known of one of the two pictures.
struct SideFacts {
  std::vector<Phrase> made;    ///< how the picture was made, in words
  const Difference& errors;    ///< beside the truth
  std::int64_t painted, cuts;  ///< polygons and pieces
  BestTime time;
};

/// All that the page shows.
struct SidesPage {
  const IndexImage &A, &B;  ///< of the proportions of the layout's A, in the cells of one palette
  const Difference& unlike;
  SideFacts ofA, ofB;
  Finding finding;
  bool known = true;  ///< the numbers belong to these pictures; otherwise new ones will follow, and these are
                      ///< drawn faint
  std::optional<DifferingPlace> place = {};
  int number = 0, places = 0;  ///< the number of the place, and how many there are
  char focus = 0;              ///< 'A' or 'B': the one that keys change; 0 if nobody can press keys
  bool blinking = false;       ///< B is shown in the place of A
  std::string colors = {};     ///< how both share the cells, "" if they have the same ones
  std::string pairs = {};      ///< pairs of settings that are worth comparing, for a window
};
/// Returns the finding and the table in words.
std::vector<std::string> drawSidesPage(Painter paint, const SidesLayout& at, const SidesPage& page,
                                       const CellPlan& plan);

/// "same scene, same view, same light   only the order differs"
[[nodiscard]] std::string sidesStatus(const PictureSettings& A, const PictureSettings& B);

}  // namespace xnewell
