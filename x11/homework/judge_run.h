#pragma once

#include <array>
#include <string>
#include <vector>

#include "shading/picture/picture.h"
#include "x11/homework/run_record.h"
#include "x11/kit/page.h"

namespace xnewell {

/// Is a run of the depth sort right? Each step is checked by itself, with the exact tests of the sort. Any
/// legal choice is right: the order of the tests, the list, what is split in a cycle, which piece comes
/// first. The planes and corners of another program are rounded otherwise than ours: an answer that rounding
/// may change is right either way. So are tests 1, 2 and 5 of outlines that miss each other, or overlap, by a
/// pixel at most.
///
/// A false step often leads to others. A later one is told only if it is about other faces: not about a pair
/// that was told already, nor about a face that was split wrongly.

enum class Falsehood {
  Answer,    ///< a test has the other outcome
  LeftOut,   ///< a test was not made that tells that P may be painted before Q, or Q before P
  NotFirst,  ///< Q goes before P, and is nearer where they overlap
  TooEarly,  ///< P is painted before Q, and is nearer where they overlap
  Loop,      ///< the same steps again, with nothing painted or split between them
  NoCut,     ///< a split by a plane that does not cross the polygon
  Sides,     ///< the pieces behind and in front are exchanged
  Plane,     ///< the pieces are not those of that plane
  Cover,     ///< the pieces do not cover the polygon once
  Figure,    ///< the polygon has another outline in the scene
  Number,    ///< a piece has the number of another polygon
  Shade,     ///< a piece has not the shading of its polygon
  Gone,      ///< the polygon was painted or split before
  Unknown,   ///< there is no polygon of this number
  Itself,    ///< P and Q are one polygon
  Lost,      ///< a polygon that shows is never painted
};
inline constexpr std::array<std::string_view, 16> kFalsehoods{
    "answer", "left-out", "not-first", "too-early", "loop", "no-cut",  "sides",  "plane",
    "cover",  "outline",  "number",    "shade",     "gone", "unknown", "itself", "lost"};

[[nodiscard]] constexpr std::string_view nameOf(Falsehood kind) {
  return kFalsehoods[static_cast<std::size_t>(kind)];
}

struct FalseStep {
  Falsehood kind;
  int P = -1, Q = -1;  ///< polygons of the run (NamedRun); -1: none
  std::string says = {};
  page::Object numbers = {};
  std::optional<Test> test = {};
  std::vector<int> right = {};                     ///< polygons that would have been right
  std::vector<std::vector<glm::dvec2>> told = {};  ///< outlines of the run
  int line = 0;                                    ///< of the file; 0: at its end
  std::string nameP = {}, nameQ = {};
  int alike = 0;         ///< how many others of this kind are not listed
  bool follows = false;  ///< it may follow from one before
};

struct RunReport {
  int steps = 0;
  std::vector<FalseStep> wrong;   ///< the first one, and others that do not follow from those before
  std::vector<FalseStep> others;  ///< what is not listed
  int follow = 0;                 ///< how many of them may follow from those listed
  std::vector<int> unnamed;  ///< faces that the run never names and `wrong` or `others` do, in their order
  int untested = 0;          ///< pairs with one painted over the other, of z that overlap, and no test
};

/// `picture` has planes. @throws ParseError for what is no run of this scene
[[nodiscard]] RunReport judgeRun(const Picture& picture, const RunFile& run);

/// A run that was judged, with the picture of its own size.
struct JudgedRun {
  RunFile file;
  Picture picture;
  RunReport report;
};

/// One line, without a line break.
[[nodiscard]] std::string verdictOf(const RunReport& report);
[[nodiscard]] page::Page pageOf(const RunReport& report);

}  // namespace xnewell
