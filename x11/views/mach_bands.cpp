#include "x11/views/mach_bands.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/plot.h"

namespace xnewell {

namespace {

constexpr int kMethodNames = 84;  // the names of profiles, at their left
constexpr int kFindings = 320;    // at the right edge
constexpr int kBetweenParts = 4;  // between the parts of one method's block
constexpr int kAfter = 8;         // from block to block
constexpr double kLeastScale = 0.001;

/// The layout. All space beyond the least that the view needs goes to pictures and plots.
struct BandsPlaces {
  Rect picture;           ///< the part of the picture that is shown
  int pictureHeight;      ///< of the whole picture
  int findings;           ///< x
  int firstBlock, block;  ///< y; height with what follows it
  int strip, intensity, slope;

  /// A picture of three to two, or of the view's proportions.
  BandsPlaces(int width, int height, bool framed) {
    const int left = Sheet::kMargin + kMethodNames, top = Sheet::kMargin;
    findings = width - Sheet::kMargin - kFindings;
    const int free = findings - Sheet::kGutter - left, plotWidth = framed ? free / 3 * 3 : free;
    pictureHeight = framed ? plotWidth / 3 * 2
                           : std::clamp(static_cast<int>(std::lround(double(plotWidth) * height / width)), 1,
                                        kMaxPicture);
    const int room = height - 2 * Sheet::kMargin - kAfter;
    const int shown = std::min(pictureHeight, room / 3 + (height - rowOf(View::MachBands).least.y) / 8);
    picture = {left, top, plotWidth, shown};
    firstBlock = top + shown + kAfter;
    block = (room - shown) / static_cast<int>(kProfiled.size());
    strip = std::clamp(block / 8, 12, 40);
    const int plots = block - Sheet::kLine - strip - 2 * kBetweenParts - kAfter;
    intensity = plots * 4 / 7;
    slope = plots - intensity;
  }
};

std::string shadesIn(double intensity) { return fixed(intensity * (kMaxShades - 1), 1); }

std::string_view behaviour(Shading method) {
  switch (method) {
    case Shading::Flat:
      return "jumps from face to face";
    case Shading::Gouraud:
      return "kinks where faces share vertices";
    default:
      return "smooth where the normals are";
  }
}

/// The slope that a full bar stands for: the largest of all, or five times the mean if a few slopes are far
/// larger. It never is so small that bars show rounding errors.
double scaleOf(const std::vector<double>& slopes) {
  double sum = 0, largest = 0;
  int count = 0;
  for (const double s : slopes)
    if (s != 0.0 && !std::isnan(s)) sum += std::abs(s), ++count, largest = std::max(largest, std::abs(s));
  return std::max(kLeastScale, std::min(largest, 5.0 * sum / std::max(1, count)));
}

class MachBands {
 public:
  MachBands(const ViewSettings& settings, const BandsPlaces& at, const Scanline& line,
            const MachBandsShown& shown)
      : chosen_{settings.picture.shading},
        at_{at},
        line_{line},
        firstRow_{shown.firstRow},
        unit_{shown.unit},
        sheet_{settings.picture.width, settings.picture.height, settings.cells, unit_} {
    for (const Profile& p : line.profiles)
      if (p.method != Shading::Flat) smoothScale_ = std::max(smoothScale_, scaleOf(p.slope));
  }

  void drawPicture(const IndexImage& image) {
    const int first = firstRow();
    const Rect& p = at_.picture;
    Painter inside = sheet_.painter().within(p);
    inside.place(image, {0, first, image.width, p.height * unit_}, p.x, p.y);
    const int y = p.y + (line_.row - first) / unit_;
    inside.hline(p.x, y - 1, p.width, sheet_.cell(Cell::Black));
    inside.hline(p.x, y, p.width, sheet_.cell(Cell::White));
    inside.hline(p.x, y + 1, p.width, sheet_.cell(Cell::Black));
    Painter painter = sheet_.painter();
    painter.triangle(p.x - 8, y - 5, 6, Direction::Right, sheet_.cell(Cell::Ink));
    painter.triangle(p.x + p.width + 2, y - 5, 6, Direction::Left, sheet_.cell(Cell::Ink));
    // Beside the mark of the scanline, but not cut off.
    const int words = std::clamp(y - 13, p.y, std::max(p.y, p.y + p.height - 2 * Sheet::kLine));
    painter.text(Sheet::kMargin, words + Sheet::kAscent, "scanline", sheet_.cell(Cell::Soft));
    painter.text(Sheet::kMargin, words + Sheet::kLine + Sheet::kAscent, grouped(line_.row),
                 sheet_.cell(Cell::Ink), Voice::Bold);
  }

  void drawBlocks() {
    int y = at_.firstBlock;
    for (const Profile& profile : line_.profiles) {
      drawBlock(profile, y);
      y += at_.block;
    }
  }

  /// `explains`: there is room to explain the words. `grayed`: the colours had to become one hue. Returns
  /// the place left for controls of this height.
  Rect drawFindings(bool explains, bool grayed, int controls);

  [[nodiscard]] const IndexImage& image() const { return sheet_.image(); }
  [[nodiscard]] const Writing& writing() const { return sheet_.writing(); }
  [[nodiscard]] const std::vector<std::string>& report() const { return sheet_.report(); }

  /// The first row of the picture that is shown.
  [[nodiscard]] int firstRow() const {
    const int first = firstRow_.value_or(line_.row - at_.picture.height * unit_ / 2);
    return std::clamp(first, 0, (at_.pictureHeight - at_.picture.height) * unit_);
  }

 private:
  [[nodiscard]] bool chosen(const Profile& p) const { return p.method == chosen_; }
  /// The curve of the chosen method is twice as thick.
  [[nodiscard]] int thickness(const Profile& p) const { return chosen(p) ? 2 : 1; }

  void drawBlock(const Profile& profile, int y);
  void drawIntensity(const Profile& profile, int y);
  void drawSlope(const Profile& profile, int y);
  void axes(const Rect& plot);

  Shading chosen_;
  const BandsPlaces& at_;
  const Scanline& line_;
  std::optional<int> firstRow_;
  int unit_;
  Sheet sheet_;
  double smoothScale_ = kLeastScale;  ///< scale of slopes, the same for all methods except flat shading
};

void MachBands::drawBlock(const Profile& profile, int y) {
  const ShadingRow& method = rowOf(profile.method);
  Painter painter = sheet_.painter();
  const int x = at_.picture.x;
  painter.text(x, y + Sheet::kAscent, method.label, sheet_.cell(Cell::Ink), Voice::Bold);
  painter.text(x + 60, y + Sheet::kAscent, behaviour(profile.method), sheet_.cell(Cell::Soft));
  y += Sheet::kLine;
  drawStrip(painter, {x, y, at_.picture.width, at_.strip}, profile.cells);
  y += at_.strip + kBetweenParts;
  drawIntensity(profile, y);
  drawSlope(profile, y + at_.intensity + kBetweenParts);
}

/// Draws the left and the bottom axis only.
void MachBands::axes(const Rect& plot) {
  Painter painter = sheet_.painter();
  painter.vline(plot.x - 1, plot.y, plot.height, sheet_.cell(Cell::Faint));
  painter.hline(plot.x - 1, plot.y + plot.height - 1, plot.width + 1, sheet_.cell(Cell::Faint));
}

void MachBands::drawIntensity(const Profile& profile, int y) {
  Painter painter = sheet_.painter(), fine = painter.pixels();
  const Rect plot{at_.picture.x, y, at_.picture.width, at_.intensity};
  const auto height = [&](double I, int unit) {
    return plot.y * unit + static_cast<int>(std::lround((1.0 - I) * (plot.height - 1) * unit));
  };
  for (const double I : {0.25, 0.5, 0.75, 1.0})
    painter.hline(plot.x, height(I, 1), plot.width, sheet_.cell(Cell::Panel));
  axes(plot);
  painter.text(Sheet::kMargin, y + Sheet::kAscent, "intensity", sheet_.cell(Cell::Soft));
  painter.textRight(plot.x - 5, y + Sheet::kAscent - 1, "1", sheet_.cell(Cell::Soft));
  painter.textRight(plot.x - 5, y + plot.height, "0", sheet_.cell(Cell::Soft));

  const int first = plot.x * unit_, samples = plot.width * unit_;
  for (int i = 0; i < samples; ++i) {
    if (std::isnan(profile.I[i])) continue;
    const bool joins = i + 1 < samples && !std::isnan(profile.slope[i]);
    fine.line(first + i, height(profile.I[i], unit_), first + i + joins, height(profile.I[i + joins], unit_),
              sheet_.cell(Cell::Ink), {thickness(profile)});
  }
  for (const int i : profile.bands) {
    const double I = profile.I[i];
    if (std::isnan(I)) continue;  // a face narrower than a pixel
    painter.vline(plot.x + i / unit_, std::max(plot.y, height(I, 1) - 7), 15, sheet_.cell(Cell::Alarm));
  }
}

void MachBands::drawSlope(const Profile& profile, int y) {
  Painter painter = sheet_.painter();
  const Rect plot{at_.picture.x, y, at_.picture.width, at_.slope};
  const double scale = profile.method == Shading::Flat ? scaleOf(profile.slope) : smoothScale_;
  const int middle = plot.y + plot.height / 2, reach = (plot.height - 1) / 2;
  painter.vline(plot.x - 1, plot.y, plot.height, sheet_.cell(Cell::Faint));
  painter.hline(plot.x - 1, middle, plot.width + 1, sheet_.cell(Cell::Rule));
  painter.text(Sheet::kMargin, y + Sheet::kAscent - 1, "derivative", sheet_.cell(Cell::Soft));
  const bool more = std::ranges::any_of(profile.slope, [&](double slope) { return std::abs(slope) > scale; });
  painter.textRight(plot.x - 5, y + Sheet::kAscent + 12, (more ? "cut at " : "to ") + fixed(scale, 4),
                    sheet_.cell(Cell::Soft));
  Painter fine = painter.pixels();
  for (int i = 0; i + 1 < plot.width * unit_; ++i) {
    if (std::isnan(profile.slope[i])) continue;
    const double share = std::clamp(profile.slope[i] / scale, -1.0, 1.0);
    const int bar = static_cast<int>(std::lround(share * reach * unit_));
    fine.fillRect({plot.x * unit_ + i, middle * unit_ - std::max(0, bar), 1, std::abs(bar) + unit_},
                  sheet_.cell(chosen(profile) ? Cell::Ink : Cell::Soft));
  }
}

/// What the numbers of this scanline show.
Finding findingOf(const Scanline& line, bool inWindow) {
  const auto& [flat, gouraud, phong] = line.profiles;
  if (line.samples == 0)
    return {"Nothing shows on this scanline.",
            inWindow ? "Move it up or down." : "Choose another with --scanline."};
  const auto bands = [](const Profile& p) { return grouped(std::ssize(p.bands)); };
  if (std::ranges::all_of(line.profiles, [](const Profile& p) { return p.bands.empty(); }))
    return {"No bands in any method.", line.edges == 0 ? "No two faces of one surface meet here."
                                                       : "At no edge of a face does I jump or bend enough."};
  Finding finding{"Bands: " + bands(flat) + " in flat shading, " + bands(gouraud) + " in Gouraud's, " +
                      bands(phong) + " in Phong's.",
                  ""};
  finding.why = "The largest jump between neighbours is " + shadesIn(flat.largestJump) +
                " shades of 240 in flat shading, " + shadesIn(gouraud.largestJump) + " in Gouraud's and " +
                shadesIn(phong.largestJump) + " in Phong's.";
  if (gouraud.bands.size() > phong.bands.size() && gouraud.largestJump < flat.largestJump / 2)
    finding.why +=
        " Gouraud shading has kinks instead of jumps: across an edge the intensity is continuous, its slope "
        "is not.";
  return finding;
}

Rect MachBands::drawFindings(bool explains, bool grayed, int controls) {
  const int x = at_.findings;
  const std::vector<int> ends{148, 234, kFindings};
  int y = sheet_.title(x, Sheet::kMargin, "Mach bands");
  y = sheet_.paragraph(x, y, kFindings, "Where does the eye see stripes that are not in the picture?",
                       Cell::Ink);
  if (explains)
    y = sheet_.paragraph(x, y + 6, kFindings,
                         "The eye sharpens edges. It responds to a change of slope, not only to a jump. Each "
                         "strip repeats the marked scanline in one shading method.",
                         Cell::Soft);

  y = sheet_.section(x, y + 8, kFindings, "picture");
  const Rect place{x, y, kFindings, controls};
  y += controls;
  if (controls == 0) {
    y = sheet_.tableRow(x, y, "shading", {std::string{rowOf(chosen_).label}}, {kFindings});
    y = sheet_.tableRow(x, y, "scanline", {grouped(line_.row) + " of 0.." + grouped(at_.pictureHeight - 1)},
                        {kFindings});
  }
  y = sheet_.tableRow(x, y, "it shows",
                      {grouped(line_.samples) + " pixels, " + counted(line_.edges, "edge") + ", " +
                       counted(line_.outlines, "outline")},
                      {kFindings});

  if (grayed) y = sheet_.tableRow(x, y, "colours", {"by their gray value"}, {kFindings});

  y = sheet_.section(x, y + 6, kFindings, "on this scanline");
  const auto row = [&](std::string_view label, auto&& value) {
    std::vector<std::string> values;
    for (const Profile& profile : line_.profiles) values.push_back(value(profile));
    y = sheet_.tableRow(x, y, label, values, ends);
  };
  std::vector<std::string> names;
  for (const Profile& profile : line_.profiles) names.emplace_back(rowOf(profile.method).label);
  y = sheet_.tableRow(x, y, "method", names, ends, Cell::Soft, Voice::Plain);
  row("largest jump", [](const Profile& q) { return fixed(q.largestJump, 4); });
  row("largest kink", [](const Profile& q) { return fixed(q.largestKink, 4); });
  row("bands", [](const Profile& q) { return grouped(std::ssize(q.bands)); });
  constexpr std::string_view kWords =
      "A jump is the change of I from one pixel of a surface to the next. A kink is the "
      "change of that change. An edge is where two faces of a surface meet. It is a band, marked "
      "on the curve, if I jumps there by 1/240 or its slope, over all that the row shows, "
      "changes by 1/2 and by 1/8 of itself.";
  const Finding finding = findingOf(line_, controls > 0);
  const int end = sheet_.image().height / sheet_.painter().unit() - Sheet::kMargin -
                  Sheet::findingHeight(kFindings, finding.bold, finding.why);
  if (explains && y + 6 + Sheet::paragraphHeight(kFindings, kWords) + 10 <= end)
    y = sheet_.paragraph(x, y + 6, kFindings, kWords, Cell::Soft);
  sheet_.finding(x, y + 10, kFindings, finding.bold, finding.why);
  return place;
}

/// Whether the picture's colours become one hue.
bool becomesGray(const Scene& scene, const ViewSettings& settings) {
  return channelsOf(planOf(scene, settings.picture)) == Channels::Rgb;
}

}  // namespace

PictureSettings pictureForMachBands(const Scene& scene, const ViewSettings& settings) {
  const BandsPlaces at{settings.picture.width, settings.picture.height, /*framed=*/false};
  PictureSettings shown = settings.picture;
  shown.width = at.picture.width, shown.height = at.pictureHeight;
  if (becomesGray(scene, settings)) shown.colors = ColorPlan::OneHue;
  if (settings.scanline && *settings.scanline >= shown.height)
    throw std::invalid_argument{"--scanline: " + std::to_string(*settings.scanline) +
                                " is below the picture: in this view its rows are 0 to " +
                                std::to_string(shown.height - 1)};
  return shown;
}

ColoredImage drawMachBands(const Picture& picture, const ViewSettings& settings) {
  const int row = settings.scanline.value_or(defaultScanline(picture));
  const bool grayed = becomesGray(picture.scene(), settings);
  MachBandsPage page = drawMachBandsPage(picture, {.row = row, .grayed = grayed}, settings);
  return {std::move(page.image), picture.palette(settings.cells, settings.unneeded)};
}

MachBandsLayout layoutOfMachBands(int width, int height) {
  const BandsPlaces at{width, height, /*framed=*/true};
  return {at.picture, at.pictureHeight};
}

MachBandsPage drawMachBandsPage(const Picture& picture, const MachBandsShown& shown,
                                const ViewSettings& settings) {
  const BandsPlaces at{settings.picture.width, settings.picture.height, shown.framed};
  const Scanline line = scanlineOf(picture, shown.row, settings.cells[Cell::Well]);
  MachBands view{settings, at, line, shown};
  view.drawPicture(picture.image());
  view.drawBlocks();
  const Rect place = view.drawFindings(settings.picture.height >= 600, shown.grayed, shown.controls);
  return {view.image(), view.writing(), view.firstRow(), place, view.report()};
}

}  // namespace xnewell
