#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/picture/exactness.h"
#include "shading/picture/picture.h"
#include "x11/lessons/exhibit.h"

namespace xnewell {

/// Numbers that lessons tell. None stands in a lesson's words: {cuts} there is filled in with what the
/// program counts, and a claim says which number a sentence relies on.

enum class Fact {
  Polygons,
  Painted,
  Cuts,
  Moves,
  Cycles,
  Impossible,
  Steps,
  Test1,
  Test2,
  Test3,
  Test4,
  Test5,
  Samples,
  Wrong,
  Intensities,
  ShadesUsed,
  Levels8,
  Levels16,
  LowestStored,
  HighestStored,
  Ratio,
  StepsSeen,
  Clamped,
  Darkest,
  Brightest,
  BandsFlat,
  BandsGouraud,
  BandsPhong,
  BandsSpared,
  JumpFlat,
  JumpGouraud,
  JumpPhong,
  Differ,
  DifferMost,
  Ia,
  Ip,
  Ks,
  N,
  I0
};
/// Which part of the work a fact needs.
enum class FactNeeds { Picture, Run, Oracle, Profile, Beside };
struct FactRow {
  Fact id;
  std::string_view name, counts;
  int decimals;
  FactNeeds needs = FactNeeds::Picture;
};
inline constexpr std::array kFacts{
    FactRow{Fact::Polygons, "polygons", "polygons that can be seen at all", 0},
    FactRow{Fact::Painted, "painted", "polygons and pieces that the textbook run paints", 0, FactNeeds::Run},
    FactRow{Fact::Cuts, "cuts", "splits of the depth sort's textbook run", 0, FactNeeds::Run},
    FactRow{Fact::Moves, "moves", "its moves of Q to the far end of the list", 0, FactNeeds::Run},
    FactRow{Fact::Cycles, "cycles", "its Q's that were marked already", 0, FactNeeds::Run},
    FactRow{Fact::Impossible, "impossible splits", "its P's not crossed by Q's plane", 0, FactNeeds::Run},
    FactRow{Fact::Steps, "steps", "its events", 0, FactNeeds::Run},
    FactRow{Fact::Test1, "test 1", "pairs that test 1 settled in it", 0, FactNeeds::Run},
    FactRow{Fact::Test2, "test 2", "pairs that test 2 settled in it", 0, FactNeeds::Run},
    FactRow{Fact::Test3, "test 3", "pairs that test 3 settled in it", 0, FactNeeds::Run},
    FactRow{Fact::Test4, "test 4", "pairs that test 4 settled in it", 0, FactNeeds::Run},
    FactRow{Fact::Test5, "test 5", "pairs that test 5 settled in it", 0, FactNeeds::Run},
    FactRow{Fact::Samples, "samples", "samples that show a face", 0, FactNeeds::Oracle},
    FactRow{Fact::Wrong, "wrong samples", "those that show a wrong one", 0, FactNeeds::Oracle},
    FactRow{Fact::Shades, "shades", "shades of the colour table", 0},
    FactRow{Fact::ShadesUsed, "shades used", "those that the picture shows", 0},
    FactRow{Fact::Levels8, "levels at 8 bits", "colours of the table that differ if 8 bits are kept", 0},
    FactRow{Fact::Levels16, "levels at 16 bits", "the same of 16 bits", 0},
    FactRow{Fact::LowestStored, "lowest stored", "of 255, in the ramp's first cell", 0},
    FactRow{Fact::HighestStored, "highest stored", "of 255, in its last", 0},
    FactRow{Fact::Ratio, "ratio", "r, from each corrected shade to the next", 6},
    FactRow{Fact::StepsSeen, "steps seen", "steps from shade to shade of 1 % or more", 0},
    FactRow{Fact::Clamped, "clamped", "evaluations above 1", 0},
    FactRow{Fact::Darkest, "darkest", "the least intensity in the picture", 2},
    FactRow{Fact::Brightest, "brightest", "the largest", 2},
    FactRow{Fact::BandsFlat, "bands flat", "Mach bands on the middle row, flat", 0, FactNeeds::Profile},
    FactRow{Fact::BandsGouraud, "bands gouraud", "the same, Gouraud", 0, FactNeeds::Profile},
    FactRow{Fact::BandsPhong, "bands phong", "the same, Phong", 0, FactNeeds::Profile},
    FactRow{Fact::BandsSpared, "bands spared", "how many fewer Phong has than Gouraud", 0,
            FactNeeds::Profile},
    FactRow{Fact::JumpFlat, "jump flat", "largest change from pixel to pixel in shades of 240, flat", 1,
            FactNeeds::Profile},
    FactRow{Fact::JumpGouraud, "jump gouraud", "the same, Gouraud", 1, FactNeeds::Profile},
    FactRow{Fact::JumpPhong, "jump phong", "the same, Phong", 1, FactNeeds::Profile},
    FactRow{Fact::Differ, "differing samples", "samples with other cells above and below", 0,
            FactNeeds::Beside},
    FactRow{Fact::DifferMost, "largest difference", "of two such cells, in shades", 0, FactNeeds::Beside},
    FactRow{Fact::Ia, "Ia", "ambient intensity", 2},
    FactRow{Fact::Ip, "Ip", "intensity of the point light", 2},
    FactRow{Fact::Ks, "ks", "share of the specular reflection", 2},
    FactRow{Fact::N, "n", "the power of its cosine", 0},
    FactRow{Fact::I0, "I0", "lowest intensity of the corrected table", 3},
};
[[nodiscard]] std::optional<int> factNamed(std::string_view name);
/// Their names, for complaints.
[[nodiscard]] std::string allFacts();

/// The depth sort's textbook run over a picture with planes (Picture::withPlanes()), in whatever order that
/// is painted. Also for pictures of several channels: what is sorted has no colour.
[[nodiscard]] SortedScene textbookRun(const Picture& picture);

/// An exhibit as it is shown: what numbers are taken from. All of it outlives this.
class ShownExhibit {
 public:
  /// `image` is the picture painted, `beside` the second one of Stage::SideBySide or null. Facts are found
  /// when they are asked for, each part of the work once.
  ShownExhibit(const Picture& picture, const IndexImage& image, const IndexImage* beside)
      : picture_{picture}, image_{image}, beside_{beside} {}

  /// NaN where the picture has none: a linear table has no ratio. No claim about it holds.
  [[nodiscard]] double value(Fact fact);
  /// With the fact's decimals, thousands with commas; "none" for NaN.
  [[nodiscard]] std::string text(Fact fact);
  /// Whether the number, rounded as it is told, is what is claimed.
  [[nodiscard]] bool holds(const Claim& claim);
  /// Words with every {fact} replaced. Precondition: checked by checkPlaceholders().
  [[nodiscard]] std::string filled(std::string_view words);

 private:
  void sort();
  void compare();

  const Picture& picture_;
  const IndexImage& image_;
  const IndexImage* beside_;
  std::optional<SortStatistics> run_;
  std::size_t steps_ = 0, painted_ = 0;
  std::optional<Exactness> exactness_;
  std::array<double, 3> bands_{}, jumps_{};  ///< by kProfiled
  bool profiled_ = false;
  std::optional<std::array<double, 2>> range_;
  std::array<int, 2> differ_{};
  bool compared_ = false;
};

/// "" or what is wrong with the words' placeholders.
[[nodiscard]] std::string checkPlaceholders(std::string_view words);

}  // namespace xnewell
