#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/record/explain.h"
#include "shading/color/images.h"
#include "shading/explain/explain.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture.h"
#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_page.h"

namespace xnewell {

/// The numbers of a stage of the viewing transformation that lessons tell: NaN where the figure shows none.
struct ViewingFacts {
  double worldNdotL, worldI, stageNdotL, stageI;  ///< of the vertex that is followed
  double cells;                                   ///< from the world's cell to the stage's, either way
  double facesOff;  ///< faces whose front has another cell if the light is computed where the figure says
  double w, z;      ///< of the vertex at the stage; z in units of the file up to the shear
  double outside;   ///< corners of faces outside the planes that clip
};
[[nodiscard]] ViewingFacts viewingFactsOf(const Picture& picture, const StepFigure& figure);

/// The numbers in lessons. A lesson's file holds none of them: the program replaces {cuts} in its words by
/// what it counts, and a claim says which number a sentence relies on.

/// Which part of the work a fact needs.
enum class FactNeeds { Picture, Run, Oracle, Profile, Range, Beside, Face, Scanline, Viewing };

/// What the facts of a figure are read from: the picture, and what the parts of the work have found.
struct FactSources {
  const Picture& picture;
  const IndexImage& image;   ///< the picture, painted
  const IndexImage* beside;  ///< the second picture of View::SideBySide, or null
  /// FactNeeds::Run: the textbook run.
  std::optional<SortStatistics> run = {};
  std::size_t steps = 0, painted = 0;
  /// FactNeeds::Oracle.
  std::optional<Exactness> exactness = {};
  /// FactNeeds::Profile: Mach bands, and the largest change from pixel to pixel in shades; by kProfiled.
  struct Profiled {
    std::array<double, 3> bands{}, jumps{};
  };
  std::optional<Profiled> profiled = {};
  /// FactNeeds::Range: of the intensities in the picture.
  std::optional<Range> range = {};
  /// FactNeeds::Beside: samples with different cells, and the largest difference in shades.
  struct Difference {
    int samples = 0, most = 0;
  };
  std::optional<Difference> difference = {};
  /// FactNeeds::Face: of the sample that the first named face is explained at; none where it does not show.
  int face = -1;
  std::optional<glm::ivec2> pixel = {};
  std::optional<Explanation> explained = {};
  /// FactNeeds::Scanline: of the first named face, with the figure's bits.
  int stepBits = 24;
  struct Filled {
    int samples = 0, rows = 0, otherCells = 0;
    double drift = 0;
  };
  std::optional<Filled> filled = {};
  /// FactNeeds::Viewing.
  std::optional<ViewingFacts> viewing = {};
};

struct FactRow {
  std::string_view name, counts;
  int decimals;
  FactNeeds needs;
  /// NaN where the picture has none.
  double (*value)(const FactSources& found);
};
[[nodiscard]] std::span<const FactRow> allFacts();
/// Index into allFacts().
[[nodiscard]] std::optional<int> factNamed(std::string_view name);
/// Their names, for error messages.
[[nodiscard]] std::string factNames();

/// The depth sort's textbook run over a picture with planes (Picture::withPlanes()), in whatever order that
/// was painted. Works for pictures of several channels too: sorting does not depend on colour.
[[nodiscard]] SortedScene textbookRun(const Picture& picture);

/// A figure as it is shown, and its facts. All that is passed must outlive this.
class ShownFigure {
 public:
  /// `image` is the picture painted, `beside` the second picture of View::SideBySide or null. A fact is
  /// computed when it is first asked for, each part of the work once.
  ShownFigure(const Picture& picture, const IndexImage& image, const IndexImage* beside,
              const StepFigure& figure)
      : figure_{figure}, found_{picture, image, beside} {
    if (!figure.names.empty()) found_.face = figure.names.front().face;
    found_.stepBits = figure.stepBits;
  }

  /// NaN where the picture has none: a linear table has no ratio. No claim about it holds.
  [[nodiscard]] double value(const FactRow& fact);
  /// With the fact's decimals, and commas between thousands; "none" for NaN.
  [[nodiscard]] std::string text(const FactRow& fact);
  /// True if the number, rounded to the fact's decimals, is what is claimed.
  [[nodiscard]] bool holds(const Claim& claim);
  /// The words with every {fact} replaced. Precondition: checkPlaceholders() found nothing wrong.
  [[nodiscard]] std::string filled(std::string_view words);

 private:
  /// Does a part of the work, if it was not done yet.
  void find(FactNeeds needs);

  const StepFigure& figure_;
  FactSources found_;
};

/// What is wrong with the placeholders in the words, or "".
[[nodiscard]] std::string checkPlaceholders(std::string_view words);

/// The claims of a lesson's steps and answers that do not hold in a window of so many units, one sentence
/// each: "step 2, answer b: cuts is 2, which is not what the lesson claims". A sentence of the lesson rests
/// on each.
[[nodiscard]] std::vector<std::string> brokenClaims(const Lesson& lesson, glm::ivec2 window);

}  // namespace xnewell
