#include "x11/lessons/lesson_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "geometry/files/text_file.h"
#include "shading/explain/scanline_run.h"
#include "shading/explain/term_values.h"
#include "shading/laboratory/profile.h"
#include "shading/picture/cell_use.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/lessons/lesson_figure.h"
#include "x11/viewing/view_controls.h"
#include "x11/viewing/viewing_page.h"
#include "x11/views/plot.h"

namespace xnewell {

namespace {

using Found = const FactSources&;

template <Test test>
double settled(Found found) {
  return static_cast<double>(found.run->settled[static_cast<std::size_t>(test)]);
}
/// By kProfiled.
template <int method>
double bands(Found found) {
  return found.profiled->bands[method];
}
template <int method>
double jump(Found found) {
  return found.profiled->jumps[method];
}
/// Colours of the table that stay distinct at so many bits.
template <int bits>
double levels(Found found) {
  return distinctLevels(found.picture.settings().table, bits);
}

double ratio(Found found) {
  return found.picture.settings().table.kind == TableKind::Corrected
             ? ratioOf(found.picture.table())
             : std::numeric_limits<double>::quiet_NaN();
}

double stepsSeen(Found found) {
  const CellPlan plan{found.picture.settings().table.kind};
  std::ptrdiff_t seen = 0;
  for (const Curve& curve : stepCurves(found.picture, found.picture.palette(plan)))
    if (curve.chosen) seen += std::ranges::count_if(curve.y, [](double y) { return y >= kSeenStep; });
  return static_cast<double>(seen);
}

/// The least number of shades of a corrected table, from its I0 to 1, whose steps are all too small to be
/// seen.
double shadesUnseen(Found found) {
  const double I0 = found.picture.settings().table.I0;
  return 2 + std::floor(std::log(1 / I0) / std::log(1 + kSeenStep / 100));
}

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// A number of the equation of the named face; at the first vertex, if the method evaluates several.
template <class Of>
double ofEquation(Found found, const Of& of) {
  return found.explained && !found.explained->equations.empty() ? of(found.explained->equations.front())
                                                                : kMissing;
}
template <class Of>
double ofLight(Found found, const Of& of) {
  return ofEquation(found, [&](const ExplainedEquation& at) {
    return at.lights.empty() ? kMissing : of(at.lights.front());
  });
}
template <glm::dvec3 ExplainedEquation::*v, int axis>
double vectorOf(Found found) {
  return ofEquation(found, [](const ExplainedEquation& at) { return (at.*v)[axis]; });
}
template <int axis>
double towardsTheLight(Found found) {
  return ofLight(found, [](const ExplainedLight& light) { return light.L[axis]; });
}
template <double ExplainedLight::*number>
double lightNumber(Found found) {
  return ofLight(found, [](const ExplainedLight& light) { return light.*number; });
}
/// A term, rounded so that the three that are written add up.
template <Term term>
double termHere(Found found) {
  return ofEquation(found, [&](const ExplainedEquation& at) {
    std::vector<double> terms;
    for (const Term each : {Term::Ambient, Term::Diffuse, Term::Specular})
      terms.push_back(valueOf(at, each, found.explained->channels));
    return roundedTerms(terms, 4)[static_cast<std::size_t>(term)];
  });
}

constexpr std::array kFacts{
    FactRow{"polygons", "polygons that can be seen at all", 0, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.snapped().polygons - f.picture.snapped().degenerate; }},

    FactRow{"picture cuts", "splits in the order that the picture uses", 0, FactNeeds::Picture,
            [](Found f) { return static_cast<double>(f.picture.sorted().statistics.splits); }},
    FactRow{"tree nodes", "nodes of its BSP tree", 0, FactNeeds::Picture,
            [](Found f) { return static_cast<double>(f.picture.sorted().statistics.nodes); }},
    FactRow{"tree depth", "most nodes on a way from its root", 0, FactNeeds::Picture,
            [](Found f) -> double {
              const SortStatistics& s = f.picture.sorted().statistics;
              return s.nodes > 0 ? s.deepest : 0;
            }},
    FactRow{"depth tests", "depths that its z-buffer compared", 0, FactNeeds::Picture,
            [](Found f) { return static_cast<double>(f.picture.sorted().statistics.depthTests); }},
    FactRow{"order bytes", "memory that its order keeps while it paints", 0, FactNeeds::Picture,
            [](Found f) { return static_cast<double>(f.picture.sorted().statistics.bytes); }},

    FactRow{"painted", "polygons and pieces that the textbook run paints", 0, FactNeeds::Run,
            [](Found f) { return static_cast<double>(f.painted); }},
    FactRow{"cuts", "splits in the textbook run of the depth sort", 0, FactNeeds::Run,
            [](Found f) { return static_cast<double>(f.run->splits); }},
    FactRow{"moves", "moves of Q to the far end of the list in that run", 0, FactNeeds::Run,
            [](Found f) { return static_cast<double>(f.run->moves); }},
    FactRow{"cycles", "times that Q was marked already in that run", 0, FactNeeds::Run,
            [](Found f) { return static_cast<double>(f.run->cycles); }},
    FactRow{"impossible splits", "times that Q's plane did not cross P in that run", 0, FactNeeds::Run,
            [](Found f) { return static_cast<double>(f.run->impossible); }},
    FactRow{"vain splits", "splits that run tried but did not make, for the cycle would have stayed", 0,
            FactNeeds::Run, [](Found f) { return static_cast<double>(f.run->vain); }},
    FactRow{"steps", "events of that run", 0, FactNeeds::Run,
            [](Found f) { return static_cast<double>(f.steps); }},
    FactRow{"test 1", "pairs that test 1 settled in that run", 0, FactNeeds::Run, settled<Test::XExtents>},
    FactRow{"test 2", "pairs that test 2 settled in that run", 0, FactNeeds::Run, settled<Test::YExtents>},
    FactRow{"test 3", "pairs that test 3 settled in that run", 0, FactNeeds::Run, settled<Test::PBehindQ>},
    FactRow{"test 4", "pairs that test 4 settled in that run", 0, FactNeeds::Run, settled<Test::QInFrontOfP>},
    FactRow{"test 5", "pairs that test 5 settled in that run", 0, FactNeeds::Run, settled<Test::Projections>},

    FactRow{"samples", "samples that show a face", 0, FactNeeds::Oracle,
            [](Found f) -> double { return f.exactness->samples; }},
    FactRow{"wrong samples", "samples that show a wrong face are marked", 0, FactNeeds::Oracle,
            [](Found f) -> double { return f.exactness->wrong; }},

    FactRow{"shades", "shades in the colour table", 0, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.table().shades(); }},
    FactRow{"shades used", "shades that the picture shows", 0, FactNeeds::Picture,
            [](Found f) -> double { return usedCells(cellUse(f.image), sceneCells(f.picture)); }},
    FactRow{"levels at 8 bits", "colours of the table that stay different at 8 bits", 0, FactNeeds::Picture,
            levels<8>},
    FactRow{"levels at 16 bits", "colours of the table that stay different at 16 bits", 0, FactNeeds::Picture,
            levels<16>},
    FactRow{"lowest stored", "value in the first cell of the ramp, of 255", 0, FactNeeds::Picture,
            [](Found f) { return 255 * f.picture.table().level(0); }},
    FactRow{"highest stored", "value in the last cell of the ramp, of 255", 0, FactNeeds::Picture,
            [](Found f) { return 255 * f.picture.table().level(f.picture.table().shades() - 1); }},
    FactRow{"ratio", "r, from each corrected shade to the next", 6, FactNeeds::Picture, ratio},
    FactRow{"steps seen", "steps of 1 % or more from shade to shade", 0, FactNeeds::Picture, stepsSeen},
    FactRow{"shades unseen", "shades with which a corrected table has only steps below 1 %", 0,
            FactNeeds::Picture, shadesUnseen},
    FactRow{"clamped", "evaluations above 1", 0, FactNeeds::Picture,
            [](Found f) { return static_cast<double>(f.picture.saturated()); }},

    FactRow{"darkest", "the least intensity in the picture", 2, FactNeeds::Range,
            [](Found f) { return f.range->low; }},
    FactRow{"brightest", "the largest intensity in the picture", 2, FactNeeds::Range,
            [](Found f) { return f.range->high; }},

    FactRow{"bands flat", "Mach bands on the middle row, flat", 0, FactNeeds::Profile, bands<0>},
    FactRow{"bands gouraud", "the same, Gouraud", 0, FactNeeds::Profile, bands<1>},
    FactRow{"bands phong", "the same, Phong", 0, FactNeeds::Profile, bands<2>},
    FactRow{"bands spared", "how many fewer Phong has than Gouraud", 0, FactNeeds::Profile,
            [](Found f) { return f.profiled->bands[1] - f.profiled->bands[2]; }},
    FactRow{"jump flat", "largest change from pixel to pixel in shades of 240, flat", 1, FactNeeds::Profile,
            jump<0>},
    FactRow{"jump gouraud", "the same, Gouraud", 1, FactNeeds::Profile, jump<1>},
    FactRow{"jump phong", "the same, Phong", 1, FactNeeds::Profile, jump<2>},

    FactRow{"differing samples", "samples whose cells differ above and below", 0, FactNeeds::Beside,
            [](Found f) -> double { return f.difference->samples; }},
    FactRow{"largest difference", "the largest difference of two such cells, in shades", 0, FactNeeds::Beside,
            [](Found f) -> double { return f.difference->most; }},

    FactRow{"pixel x", "column of the pixel of the first named face", 0, FactNeeds::Face,
            [](Found f) { return f.pixel ? f.pixel->x : kMissing; }},
    FactRow{"pixel y", "its row", 0, FactNeeds::Face,
            [](Found f) { return f.pixel ? f.pixel->y : kMissing; }},
    FactRow{"N x", "N there, towards the side that is lit", 4, FactNeeds::Face,
            vectorOf<&ExplainedEquation::N, 0>},
    FactRow{"N y", "the same, y", 4, FactNeeds::Face, vectorOf<&ExplainedEquation::N, 1>},
    FactRow{"N z", "the same, z", 4, FactNeeds::Face, vectorOf<&ExplainedEquation::N, 2>},
    FactRow{"L x", "L there, of the first light", 4, FactNeeds::Face, towardsTheLight<0>},
    FactRow{"L y", "the same, y", 4, FactNeeds::Face, towardsTheLight<1>},
    FactRow{"L z", "the same, z", 4, FactNeeds::Face, towardsTheLight<2>},
    FactRow{"V x", "V there", 4, FactNeeds::Face, vectorOf<&ExplainedEquation::V, 0>},
    FactRow{"V y", "the same, y", 4, FactNeeds::Face, vectorOf<&ExplainedEquation::V, 1>},
    FactRow{"V z", "the same, z", 4, FactNeeds::Face, vectorOf<&ExplainedEquation::V, 2>},
    FactRow{"N.L", "N.L there", 4, FactNeeds::Face, lightNumber<&ExplainedLight::NdotL>},
    FactRow{"R.V", "R.V there, or what the form takes for it", 4, FactNeeds::Face,
            lightNumber<&ExplainedLight::cosine>},
    FactRow{"power", "its n-th power, 0 where it does not count", 4, FactNeeds::Face,
            lightNumber<&ExplainedLight::power>},
    FactRow{"ambient", "the ambient term there", 4, FactNeeds::Face, termHere<Term::Ambient>},
    FactRow{"diffuse", "the diffuse term there", 4, FactNeeds::Face, termHere<Term::Diffuse>},
    FactRow{"specular", "the specular term there", 4, FactNeeds::Face, termHere<Term::Specular>},
    FactRow{"I", "the intensity there", 4, FactNeeds::Face,
            [](Found f) { return f.explained ? f.explained->intensity : kMissing; }},
    FactRow{
        "shade", "its shade in the colour table, from 0", 0, FactNeeds::Face,
        [](Found f) { return f.explained ? f.explained->value[0] - f.picture.table().first() : kMissing; }},
    FactRow{"cell", "its cell", 0, FactNeeds::Face,
            [](Found f) { return f.explained ? f.explained->value[0] : kMissing; }},
    FactRow{
        "map column", "column of the environment's map that is looked up there", 0, FactNeeds::Face,
        [](Found f) { return f.explained && f.explained->place ? f.explained->place->column : kMissing; }},
    FactRow{"map row", "its row", 0, FactNeeds::Face,
            [](Found f) { return f.explained && f.explained->place ? f.explained->place->row : kMissing; }},

    FactRow{"polygon samples", "samples that the first named face owns", 0, FactNeeds::Scanline,
            [](Found f) { return f.filled ? f.filled->samples : kMissing; }},
    FactRow{"polygon rows", "rows with such samples", 0, FactNeeds::Scanline,
            [](Found f) { return f.filled ? f.filled->rows : kMissing; }},
    FactRow{"polygon drift", "the most that its stepped values are off, in shades", 6, FactNeeds::Scanline,
            [](Found f) { return f.filled ? f.filled->drift : kMissing; }},
    FactRow{"polygon other cells", "its samples that have another cell by steps", 0, FactNeeds::Scanline,
            [](Found f) { return f.filled ? f.filled->otherCells : kMissing; }},
    FactRow{"world N.L", "N.L of the vertex that is followed, in the world", 3, FactNeeds::Viewing,
            [](Found f) { return f.viewing->worldNdotL; }},
    FactRow{"world I", "I there", 3, FactNeeds::Viewing, [](Found f) { return f.viewing->worldI; }},
    FactRow{"stage N.L", "its N.L at the stage that is shown", 3, FactNeeds::Viewing,
            [](Found f) { return f.viewing->stageNdotL; }},
    FactRow{"stage I", "I there", 3, FactNeeds::Viewing, [](Found f) { return f.viewing->stageI; }},
    FactRow{"stage cells", "cells from the one I to the other", 0, FactNeeds::Viewing,
            [](Found f) { return f.viewing->cells; }},
    FactRow{"stage w", "w of the vertex there", 3, FactNeeds::Viewing, [](Found f) { return f.viewing->w; }},
    FactRow{"stage z", "z of the vertex there", 2, FactNeeds::Viewing, [](Found f) { return f.viewing->z; }},
    FactRow{"faces off", "faces whose cell is another one than with the world's light", 0, FactNeeds::Viewing,
            [](Found f) { return f.viewing->facesOff; }},
    FactRow{"outside", "corners of faces outside the planes that clip", 0, FactNeeds::Viewing,
            [](Found f) { return f.viewing->outside; }},

    FactRow{"Ia", "ambient intensity", 2, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().light.Ia; }},
    FactRow{"Ip", "intensity of the point light", 2, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().light.Ip; }},
    FactRow{"ka", "coefficient of ambient reflection", 2, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().light.ka; }},
    FactRow{"kd", "coefficient of diffuse reflection", 2, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().light.kd; }},
    FactRow{"ks", "coefficient of specular reflection", 2, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().light.ks; }},
    FactRow{"n", "exponent of specular reflection", 0, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().light.n; }},
    FactRow{"I0", "lowest intensity of the corrected table", 3, FactNeeds::Picture,
            [](Found f) -> double { return f.picture.settings().table.I0; }},
};

}  // namespace

std::span<const FactRow> allFacts() { return kFacts; }

std::optional<int> factNamed(std::string_view name) {
  const auto* const row = std::ranges::find(kFacts, name, &FactRow::name);
  return row == kFacts.end() ? std::nullopt : std::optional{static_cast<int>(row - kFacts.begin())};
}

std::string factNames() {
  std::string all;
  for (const FactRow& row : kFacts) all += (all.empty() ? "" : ", ") + std::string{row.name};
  return all;
}

SortedScene textbookRun(const Picture& picture) {
  return depthSort(picture.snapped(), {.width = picture.settings().width,
                                       .height = picture.settings().height,
                                       .textbook = true,
                                       .record = true});
}

void ShownFigure::find(FactNeeds needs) {
  const Picture& picture = found_.picture;
  switch (needs) {
    case FactNeeds::Picture:
      return;
    case FactNeeds::Run: {
      if (found_.run) return;
      const SortedScene run = textbookRun(picture.withPlanes());
      found_.run = run.statistics;
      found_.steps = run.events.size();
      found_.painted = run.fragments.size();
      return;
    }
    case FactNeeds::Oracle:
      if (!found_.exactness) found_.exactness = exactnessOf(picture);
      return;
    case FactNeeds::Profile: {
      if (found_.profiled) return;
      const Scanline line = scanlineOf(picture, defaultScanline(picture), 0);
      found_.profiled = FactSources::Profiled{};
      for (int k = 0; k < 3; ++k) {
        found_.profiled->bands[k] = static_cast<int>(line.profiles[k].bands.size());
        found_.profiled->jumps[k] = line.profiles[k].largestJump * (kMaxShades - 1);
      }
      return;
    }
    case FactNeeds::Face: {
      if (found_.explained || found_.face < 0) return;
      const PictureSettings& settings = picture.settings();
      const auto place =
          placeOfLetter(picture.faceImage(), settings.width, settings.height, found_.face, /*unit=*/1);
      if (!place) return;
      found_.pixel = {place->x, place->y};
      const int shown = picture.seen(place->y, place->y + 1).faces[static_cast<std::size_t>(place->x)];
      found_.explained = PixelExplainer{picture}(shown, place->x, place->y);
      return;
    }
    case FactNeeds::Scanline: {
      if (found_.filled || found_.face < 0) return;
      const std::unique_ptr<ScanlineRun> run = scanlineOfFace(picture, found_.face, found_.stepBits);
      if (!run) return;
      FactSources::Filled& filled = *(found_.filled = FactSources::Filled{});
      filled = {run->steps(), static_cast<int>(run->marks(ScanMark::Row).size()), run->differing(),
                run->mostDrift()};
      return;
    }
    case FactNeeds::Viewing:
      if (!found_.viewing) found_.viewing = viewingFactsOf(picture, figure_);
      return;
    case FactNeeds::Range:
      if (found_.range) return;
      found_.range = {1.0, 0.0};
      for (const double I : picture.intensities(picture.seen(0, picture.settings().height)))
        if (!std::isnan(I)) found_.range = {std::min(found_.range->low, I), std::max(found_.range->high, I)};
      return;
    case FactNeeds::Beside: {
      if (found_.difference) return;
      FactSources::Difference& difference = *(found_.difference = FactSources::Difference{});
      if (!found_.beside) return;
      const CellRange cells = sceneCells(picture);  // background against a face is no difference in shades
      for (std::size_t k = 0; k < found_.image.pixels.size(); ++k) {
        const std::uint8_t above = found_.image.pixels[k], below = found_.beside->pixels[k];
        difference.samples += above != below;
        if (cells.has(above) && cells.has(below))
          difference.most = std::max(difference.most, std::abs(above - below));
      }
      return;
    }
  }
}

double ShownFigure::value(const FactRow& fact) {
  find(fact.needs);
  return fact.value(found_);
}

std::string ShownFigure::text(const FactRow& fact) {
  const double v = value(fact);
  if (std::isnan(v)) return "none";
  return fact.decimals == 0 ? grouped(std::llround(v)) : fixed(v, fact.decimals);
}

bool ShownFigure::holds(const Claim& claim) {
  const double unit = std::pow(10.0, -kFacts[claim.fact].decimals);
  const auto rounded = [&](double v) { return std::round(v / unit); };
  const double v = rounded(value(kFacts[claim.fact]));
  return (!claim.is || v == rounded(*claim.is)) && (!claim.least || v >= rounded(*claim.least)) &&
         (!claim.most || v <= rounded(*claim.most));
}

std::string ShownFigure::filled(std::string_view words) {
  std::string text;
  while (true) {
    const std::size_t open = words.find('{');
    if (open == std::string_view::npos) return text + std::string{words};
    const std::size_t close = words.find('}', open);
    const std::optional<int> fact = factNamed(words.substr(open + 1, close - open - 1));
    text += std::string{words.substr(0, open)} + this->text(kFacts[*fact]);
    words.remove_prefix(close + 1);
  }
}

std::string checkPlaceholders(std::string_view words) {
  while (true) {
    const std::size_t open = words.find('{');
    if (open == std::string_view::npos)
      return words.find('}') == std::string_view::npos ? "" : "a } without a {";
    const std::size_t close = words.find('}', open);
    if (close == std::string_view::npos) return "a { without a }";
    const std::string name{words.substr(open + 1, close - open - 1)};
    if (!factNamed(name)) return "there is no fact " + inQuotes(name) + "; the facts are " + factNames();
    words.remove_prefix(close + 1);
  }
}

namespace {

double facesOff(const Picture& picture, const ViewingStory& story, ViewStage shadedIn) {
  const Palette none{};  // a plan of colours has no shades to compare
  const LitParts world{picture, none}, there{picture, none, &story.stages, shadedIn};
  const Mesh& mesh = picture.scene().mesh;
  int off = 0;
  for (int face = 0; face < mesh.faceCount(); ++face)
    if (const CellOnRamp* const ramp = world.ramp(face)) {
      const int corner = mesh.firstCorner[face];
      off += (*ramp)(world.at(corner, false)) != (*ramp)(there.at(corner, false));
    }
  return off;
}

}  // namespace

ViewingFacts viewingFactsOf(const Picture& picture, const StepFigure& figure) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  ViewingFacts facts{kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  if (figure.stage != View::Viewing) return facts;
  const ViewingStory story{picture, figure.vertex};
  const VertexAtStage &world = story.world(), &here = story.of(figure.viewStage);
  facts.worldNdotL = world.NdotL.value_or(kNone), facts.worldI = world.I;
  facts.stageNdotL = here.NdotL.value_or(kNone), facts.stageI = here.I;
  if (world.cell && here.cell) facts.cells = std::abs(*world.cell - *here.cell);
  facts.facesOff = facesOff(picture, story, figure.shadedIn);
  const glm::dvec4 at = shownAt(story, figure.viewStage, lengthUnit(picture.scene()));
  facts.w = at.w, facts.z = at.z;
  const Mesh& mesh = picture.scene().mesh;
  facts.outside = 0;
  for (const int corner : mesh.corners) facts.outside += story.stages.outside(mesh.points[corner]) != 0;
  return facts;
}

namespace {

/// Adds a sentence for each claim of the figure that does not hold where it is drawn.
void check(const StepFigure& figure, const std::string& place, const Layout& window,
           std::vector<std::string>& broken) {
  if (figure.claims.empty()) return;
  constexpr std::uint8_t kGround = 8;
  const FigureLayout at = layoutOfFigure(figureAreaOf(window), figure, window.compact);
  const auto drawn = [&](PictureSettings settings, const Rect& area) {
    settings.width = area.width, settings.height = area.height;
    return makePicture(*figure.scene, settings, kGround);
  };
  const Picture picture = drawn(figure.settings, at.picture);
  std::optional<Picture> lower;
  if (figure.stage == View::SideBySide) lower = drawn(figure.beside, at.lower);
  ShownFigure facts{picture, picture.image(), lower ? &lower->image() : nullptr, figure};
  for (const Claim& claim : figure.claims) {
    if (facts.holds(claim)) continue;
    const FactRow& fact = allFacts()[static_cast<std::size_t>(claim.fact)];
    broken.push_back(place + ": " + std::string{fact.name} + " is " + facts.text(fact) +
                     ", which is not what the lesson claims");
  }
}

}  // namespace

std::vector<std::string> brokenClaims(const Lesson& lesson, glm::ivec2 window) {
  const Layout at = layoutOf(window.x, window.y);
  std::vector<std::string> broken;
  for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
    const std::string place = "step " + std::to_string(k + 1);
    check(lesson.steps[k].figure, place, at, broken);
    if (!lesson.steps[k].question) continue;
    char letter = 'a';
    for (const LessonAnswer& answer : lesson.steps[k].question->answers)
      check(answer.shown, place + ", answer " + letter++, at, broken);
  }
  return broken;
}

}  // namespace xnewell
