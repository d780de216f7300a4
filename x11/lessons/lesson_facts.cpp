#include "x11/lessons/lesson_facts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "geometry/files/text_file.h"
#include "shading/picture/cell_use.h"
#include "shading/picture/profile.h"
#include "x11/drawing/wording.h"
#include "x11/views/table_curves.h"

namespace xnewell {

std::optional<int> factNamed(std::string_view name) {
  const auto* const row = std::ranges::find(kFacts, name, &FactRow::name);
  return row == kFacts.end() ? std::nullopt : std::optional{static_cast<int>(row - kFacts.begin())};
}

std::string allFacts() {
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

void ShownExhibit::sort() {
  if (run_) return;
  const SortedScene run = textbookRun(picture_.withPlanes());
  run_ = run.statistics;
  steps_ = run.events.size();
  painted_ = run.fragments.size();
}

void ShownExhibit::compare() {
  if (compared_ || !beside_) return;
  for (std::size_t k = 0; k < image_.pixels.size(); ++k) {
    const int apart = std::abs(image_.pixels[k] - beside_->pixels[k]);
    differ_[0] += apart > 0;
    const CellRange cells = sceneCells(picture_);  // a ground beside a face is no difference in shades
    if (cells.has(image_.pixels[k]) && cells.has(beside_->pixels[k]))
      differ_[1] = std::max(differ_[1], apart);
  }
  compared_ = true;
}

double ShownExhibit::value(Fact fact) {
  const SnappedScene& snapped = picture_.snapped();
  const TableSettings& table = picture_.settings().table;
  const Illumination& light = picture_.settings().light;
  const FactNeeds needs = kFacts[static_cast<std::size_t>(fact)].needs;
  if (needs == FactNeeds::Run) sort();
  if (needs == FactNeeds::Oracle && !exactness_) exactness_ = exactnessOf(picture_);
  if (needs == FactNeeds::Beside) compare();
  if (needs == FactNeeds::Profile && !profiled_) {
    const Scanline line = scanlineOf(picture_, defaultScanline(picture_), 0);
    for (int k = 0; k < 3; ++k) {
      bands_[k] = line.profiles[k].bands;
      jumps_[k] = line.profiles[k].largestJump * (kMaxShades - 1);
    }
    profiled_ = true;
  }
  if ((fact == Fact::Darkest || fact == Fact::Brightest) && !range_) {
    range_ = {1.0, 0.0};
    for (const double I : picture_.intensities(picture_.seen(0, picture_.settings().height)))
      if (!std::isnan(I)) range_ = {std::min((*range_)[0], I), std::max((*range_)[1], I)};
  }
  const auto settled = [&](Test test) {
    return static_cast<double>(run_->settled[static_cast<std::size_t>(test)]);
  };
  switch (fact) {
    case Fact::Polygons:
      return snapped.polygons - snapped.degenerate;
    case Fact::Painted:
      return static_cast<double>(painted_);
    case Fact::Cuts:
      return static_cast<double>(run_->splits);
    case Fact::Moves:
      return static_cast<double>(run_->moves);
    case Fact::Cycles:
      return static_cast<double>(run_->cycles);
    case Fact::Impossible:
      return static_cast<double>(run_->impossible);
    case Fact::Steps:
      return static_cast<double>(steps_);
    case Fact::Test1:
      return settled(Test::XExtents);
    case Fact::Test2:
      return settled(Test::YExtents);
    case Fact::Test3:
      return settled(Test::PBehindQ);
    case Fact::Test4:
      return settled(Test::QInFrontOfP);
    case Fact::Test5:
      return settled(Test::Projections);
    case Fact::Samples:
      return exactness_->samples;
    case Fact::Wrong:
      return exactness_->wrong;
    case Fact::Shades:
      return picture_.table().shades();
    case Fact::ShadesUsed:
      return usedCells(cellUse(image_), sceneCells(picture_));
    case Fact::Levels8:
      return distinctLevels(table, 8);
    case Fact::Levels16:
      return distinctLevels(table, 16);
    case Fact::LowestStored:
      return 255 * picture_.table().level(0);
    case Fact::HighestStored:
      return 255 * picture_.table().level(picture_.table().shades() - 1);
    case Fact::Ratio:
      return table.kind == TableKind::Corrected ? ratioOf(picture_.table())
                                                : std::numeric_limits<double>::quiet_NaN();
    case Fact::StepsSeen: {
      double seen = 0;
      for (const Curve& curve : stepCurves(picture_, picture_.palette(CellPlan{table.kind})))
        if (curve.chosen)
          seen +=
              static_cast<double>(std::ranges::count_if(curve.y, [](double y) { return y >= kSeenStep; }));
      return seen;
    }
    case Fact::Clamped:
      return static_cast<double>(picture_.saturated());
    case Fact::Darkest:
      return (*range_)[0];
    case Fact::Brightest:
      return (*range_)[1];
    case Fact::BandsFlat:
    case Fact::BandsGouraud:
    case Fact::BandsPhong:
      return bands_[static_cast<std::size_t>(fact) - static_cast<std::size_t>(Fact::BandsFlat)];
    case Fact::BandsSpared:
      return bands_[1] - bands_[2];
    case Fact::JumpFlat:
    case Fact::JumpGouraud:
    case Fact::JumpPhong:
      return jumps_[static_cast<std::size_t>(fact) - static_cast<std::size_t>(Fact::JumpFlat)];
    case Fact::Differ:
      return differ_[0];
    case Fact::DifferMost:
      return differ_[1];
    case Fact::Ia:
      return light.Ia;
    case Fact::Ip:
      return light.Ip;
    case Fact::Ks:
      return light.ks;
    case Fact::N:
      return light.n;
    case Fact::I0:
      return table.I0;
  }
  return 0;
}

std::string ShownExhibit::text(Fact fact) {
  const int decimals = kFacts[static_cast<std::size_t>(fact)].decimals;
  const double v = value(fact);
  if (std::isnan(v)) return "none";
  return decimals == 0 ? grouped(std::llround(v)) : fixed(v, decimals);
}

bool ShownExhibit::holds(const Claim& claim) {
  const double unit = std::pow(10.0, -kFacts[claim.fact].decimals);
  const auto rounded = [&](double v) { return std::round(v / unit); };
  const double v = rounded(value(kFacts[claim.fact].id));
  return (!claim.is || v == rounded(*claim.is)) && (!claim.least || v >= rounded(*claim.least)) &&
         (!claim.most || v <= rounded(*claim.most));
}

std::string ShownExhibit::filled(std::string_view words) {
  std::string text;
  while (true) {
    const std::size_t open = words.find('{');
    if (open == std::string_view::npos) return text + std::string{words};
    const std::size_t close = words.find('}', open);
    const std::optional<int> fact = factNamed(words.substr(open + 1, close - open - 1));
    text += std::string{words.substr(0, open)} + this->text(kFacts[*fact].id);
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
    if (!factNamed(name)) return "no such fact: " + inQuotes(name) + "; there are " + allFacts();
    words.remove_prefix(close + 1);
  }
}

}  // namespace xnewell
