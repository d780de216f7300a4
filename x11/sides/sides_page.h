#pragma once

#include <optional>
#include <string>
#include <vector>

#include "x11/sides/sides.h"

namespace xnewell {

/// What differs between two pictures, where, and how much? A and B beside each other, below them where they
/// differ and the numbers of both.

/// Where things are, in pixels. The pictures, all three of one scale, take what is free.
struct SidesLayout {
  bool compact = false;
  Rect A, B;
  Rect difference;  ///< as many rows of it as there is room for
  Rect captionA, captionB, sections, numbers;
  int frameWidth = 0, frameHeight = 0;  ///< of what is framed in all three
};
/// `body` is at least 768 x 428.
[[nodiscard]] SidesLayout layoutOfSides(const Rect& body);

/// What is known of one of the two.
struct SideFacts {
  std::vector<Phrase> made;  ///< how, in words
  SideNumbers numbers;
  BestTime time;
};

/// All that the page shows.
struct SidesPage {
  const IndexImage &A, &B;  ///< of the layout's size, in cells of one palette
  const Unlikeness& unlike;
  SideFacts ofA, ofB;
  Finding finding;
  bool known = true;  ///< the numbers are these pictures'; else they follow, and are faint
  std::optional<DifferingPlace> place = {};
  int number = 0, places = 0;  ///< which of how many it is
  char focus = 0;              ///< 'A' or 'B': which one keys change; 0 on paper
  bool blinking = false;       ///< B stands in A's place
  std::string colors = {};     ///< how both share the cells, "" where they have the same ones
  std::string pairs = {};      ///< which settings are known to make a lesson, for a window
};
void drawSidesPage(IndexImage& image, const SidesLayout& at, const SidesPage& page, const CellPlan& plan);

/// "same scene, same view, same light   only the order differs"
[[nodiscard]] std::string sidesStatus(const PictureSettings& A, const PictureSettings& B);

}  // namespace xnewell
