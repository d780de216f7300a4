#include "x11/sides/sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "depthsort/oracle.h"
#include "shading/color/color_difference.h"
#include "shading/color/quantize.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/settings.h"
#include "x11/drawing/wording.h"
#include "x11/views/views.h"
#include "x11/window/layout.h"

namespace xnewell {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr double kPatience = 300;  // milliseconds; after this no further run of a timing begins

/// For each sample, the part of a face that it shows, or the whole face if either picture divided parts
/// itself; kNothing at background.
std::vector<int> partImage(const Picture& picture, bool wholeFaces) {
  std::vector<int> image = picture.seen(0, picture.settings().height).faces;
  for (int& face : image)
    if (face != kNothing)
      face = wholeFaces ? picture.snapped().faces[face].number : picture.snapped().faces[face].part;
  return image;
}

std::vector<float> otherFaces(const Picture& A, const Picture& B) {
  const bool wholeFaces = A.settings().adapt > 0 || B.settings().adapt > 0;
  const std::vector<int> a = partImage(A, wholeFaces), b = partImage(B, wholeFaces);
  std::vector<float> at(a.size(), kNone);
  for (std::size_t k = 0; k < at.size(); ++k)
    if (a[k] != kNothing || b[k] != kNothing) at[k] = a[k] != b[k];
  return at;
}

std::vector<std::uint8_t> shown(const Picture& picture) {
  const SeenRows seen = picture.seen(0, picture.settings().height);
  std::vector<std::uint8_t> shows(seen.faces.size());
  std::ranges::transform(seen.faces, shows.begin(), [](int face) { return face != kNothing; });
  return shows;
}

/// `of(picture, cell)` is the value of a cell, `nothing` the value of background, and `apart` the distance of
/// two values.
template <class Of, class Value, class Apart>
std::vector<float> valuesApart(const ColoredPicture& A, const ColoredPicture& B, Of&& of,
                               const Value& nothing, Apart&& apart) {
  const std::vector<std::uint8_t> showsA = shown(A.picture), showsB = shown(B.picture);
  std::vector<float> at(showsA.size(), kNone),
      known(257 * 257, kNone);  // distances that were computed already, for each pair of cells
  for (std::size_t k = 0; k < at.size(); ++k)
    if (showsA[k] || showsB[k]) {
      float& d = known[257 * (showsA[k] ? A.picture.image().pixels[k] : 256) +
                       (showsB[k] ? B.picture.image().pixels[k] : 256)];
      if (std::isnan(d))
        d = static_cast<float>(apart(showsA[k] ? of(A, A.picture.image().pixels[k]) : nothing,
                                     showsB[k] ? of(B, B.picture.image().pixels[k]) : nothing));
      at[k] = d;
    }
  return at;
}

/// The number of differing samples in each rectangle from the upper left corner on.
class Sums {
 public:
  Sums(const std::vector<std::uint8_t>& differs, int width)
      : width_{width + 1}, sums_(std::size_t(width_) * (differs.size() / width + 1), 0) {
    const int height = static_cast<int>(differs.size()) / width;
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i)
        at(i + 1, j + 1) = at(i, j + 1) + at(i + 1, j) - at(i, j) + differs[std::size_t(j) * width + i];
  }
  [[nodiscard]] int in(const Rect& r) const {
    return at(r.x + r.width, r.y + r.height) - at(r.x, r.y + r.height) - at(r.x + r.width, r.y) +
           at(r.x, r.y);
  }

 private:
  [[nodiscard]] int at(int i, int j) const { return sums_[std::size_t(j) * width_ + i]; }
  int& at(int i, int j) { return sums_[std::size_t(j) * width_ + i]; }
  int width_;
  std::vector<int> sums_;
};

}  // namespace

bool hasIntensities(const Picture& A, const Picture& B) {
  return channelsOf(A.colors().plan()) != Channels::Rgb && channelsOf(B.colors().plan()) != Channels::Rgb;
}

Difference unlikeness(Unlike kind, const ColoredPicture& A, const ColoredPicture& B) {
  std::vector<float> at;
  switch (kind) {
    case Unlike::Face:
      at = otherFaces(A.picture, B.picture);
      break;
    case Unlike::Intensity:
      at = valuesApart(
          A, B, [](const ColoredPicture& p, int cell) { return p.picture.colors().intensityOf(cell); }, 0.0,
          [](double a, double b) { return std::abs(a - b); });
      break;
    case Unlike::Color: {
      std::array<std::array<Lab, 256>, 2> labs;
      for (int cell = 0; cell < 256; ++cell)
        labs[0][cell] = labFromSrgb(A.palette[cell]), labs[1][cell] = labFromSrgb(B.palette[cell]);
      const Lab well = labFromSrgb(withInterface({}, CellPlan{})[CellPlan{}[Cell::Well]]);
      at = valuesApart(
          A, B, [&](const ColoredPicture& p, int cell) { return labs[&p == &B][cell]; }, well,
          [](const Lab& a, const Lab& b) { return ciede2000(a, b); });
      break;
    }
  }
  return {errorMap(std::move(at), A.picture.settings().width, rowOf(kind).unit), kind};
}

std::vector<DifferingPlace> placesOf(const Difference& unlike, int frameWidth, int frameHeight) {
  std::vector<DifferingPlace> places;
  if (unlike.above == 0) return places;
  const int width = unlike.width, height = static_cast<int>(unlike.at.size()) / width;
  Rect frame{0, 0, std::min(frameWidth, width), std::min(frameHeight, height)};
  std::vector<std::uint8_t> differs(unlike.at.size());
  std::ranges::transform(unlike.at, differs.begin(),
                         [&](float d) { return d > unlike.unit; });  // false for NaN
  while (static_cast<int>(places.size()) < kMostPlaces) {
    const Sums sums{differs, width};
    DifferingPlace best;
    for (frame.y = 0; frame.y + frame.height <= height; ++frame.y)
      for (frame.x = 0; frame.x + frame.width <= width; ++frame.x)
        if (const int count = sums.in(frame); count > best.samples) best = {frame, count};
    if (best.samples == 0) break;
    // Many frames hold the same samples; this moves the frame so that they are in its middle.
    int left = width, right = 0, top = height, bottom = 0;
    for (int j = best.frame.y; j < best.frame.y + best.frame.height; ++j)
      for (int i = best.frame.x; i < best.frame.x + best.frame.width; ++i) {
        std::uint8_t& here = differs[std::size_t(j) * width + i];
        if (here) left = std::min(left, i), right = std::max(right, i), top = std::min(top, j), bottom = j;
        here = 0;
      }
    best.frame.x = std::clamp((left + right + 1 - best.frame.width) / 2, 0, width - best.frame.width);
    best.frame.y = std::clamp((top + bottom + 1 - best.frame.height) / 2, 0, height - best.frame.height);
    places.push_back(best);
  }
  return places;
}

std::array<BestTime, 2> timesOf(const Scene& scene, const PictureSettings& A, const PictureSettings& B) {
  constexpr int kRuns = 5;
  std::array<BestTime, 2> best;
  double spent = 0;
  for (int run = 0; run < kRuns && (run == 0 || spent < 2 * kPatience); ++run)
    for (std::size_t k = 0; k < best.size(); ++k) {
      BestTime& of = best[k];
      const double ms = makePicture(scene, k == 0 ? A : B, 0).times().total();
      spent += ms;
      if (of.runs++ == 0)
        of.ms = of.next = ms;
      else if (ms < of.ms)
        of.next = std::exchange(of.ms, ms);
      else if (ms < of.next || of.runs == 2)
        of.next = ms;
    }
  return best;
}

bool isDoubtful(const BestTime& a, const BestTime& b) {
  return std::abs(a.ms - b.ms) <= std::max(a.next - a.ms, b.next - b.ms);
}

OnePalette onePalette(const ColoredPicture& A, const ColoredPicture& B, const CellPlan& plan,
                      const Palette& own, int most) {
  OnePalette one{A.picture.image(), B.picture.image(), own};
  if (A.palette == B.palette) return one;

  const int width = A.picture.image().width, height = A.picture.image().height;
  const std::size_t samples = A.picture.image().pixels.size();
  std::vector<std::uint8_t> shows = shown(A.picture);
  const std::vector<std::uint8_t> showsB = shown(B.picture);
  shows.insert(shows.end(), showsB.begin(), showsB.end());
  RgbImage colors{width, 2 * height};
  for (std::size_t k = 0; k < 2 * samples; ++k) {
    const ColoredPicture& p = k < samples ? A : B;
    const Rgb16& c = p.palette[p.picture.image().pixels[k % samples]];
    colors.rgb[3 * k] = static_cast<std::uint8_t>(c.r >> 8);
    colors.rgb[3 * k + 1] = static_cast<std::uint8_t>(c.g >> 8);
    colors.rgb[3 * k + 2] = static_cast<std::uint8_t>(c.b >> 8);
  }
  IndexImage both{width, 2 * height, plan[Cell::Well]};
  const int first = A.picture.table().first();
  const std::vector<Rgb16> chosen = quantize(colors, shows, {.colors = most, .first = first}, both);
  for (std::size_t k = 0; k < 2 * samples && one.exact; ++k) {
    if (!shows[k]) continue;
    const Rgb16& c = chosen[both.pixels[k] - first];
    one.exact = colors.rgb[3 * k] == c.r >> 8 && colors.rgb[3 * k + 1] == c.g >> 8 &&
                colors.rgb[3 * k + 2] == c.b >> 8;
  }
  const auto half = both.pixels.begin() + static_cast<std::ptrdiff_t>(samples);
  one.A.pixels.assign(both.pixels.begin(), half);
  one.B.pixels.assign(half, both.pixels.end());
  one.shared = true;
  one.colors = static_cast<int>(chosen.size());
  std::fill_n(one.palette.begin() + first, most, Rgb16{});
  std::ranges::copy(chosen, one.palette.begin() + first);
  one.palette = withInterface(one.palette, plan);
  return one;
}

/// The words about two pictures beside each other: how they were made, and what was found.

namespace {

bool differs(const Setting& setting, const PictureSettings& A, const PictureSettings& B) {
  return setting.field.get(A) != setting.field.get(B);
}

/// "where body and spout meet", if most of the differing samples in the frame show faces of these two groups;
/// "" if groups have no names.
std::string meetingOf(const Picture& A, const Picture& B, const Difference& unlike, const Rect& frame) {
  const Mesh& mesh = A.scene().mesh;
  std::map<std::string, int> groups;
  const SeenRows a = A.seen(frame.y, frame.y + frame.height), b = B.seen(frame.y, frame.y + frame.height);
  const auto count = [&](const Picture& picture, int face) {
    if (face >= 0) ++groups[mesh.groupNames[mesh.group[picture.snapped().faces[face].number]]];
  };
  for (int j = 0; j < frame.height; ++j)
    for (int i = frame.x; i < frame.x + frame.width; ++i) {
      if (!(unlike.at[std::size_t(frame.y + j) * unlike.width + i] > rowOf(unlike.kind).unit)) continue;
      count(A, a.faces[std::size_t(j) * unlike.width + i]);
      count(B, b.faces[std::size_t(j) * unlike.width + i]);
    }
  groups.erase("");
  std::vector<std::pair<int, std::string>> most;
  for (const auto& [name, n] : groups) most.emplace_back(n, name);
  std::ranges::sort(most, std::greater{});
  if (most.empty()) return "";
  if (most.size() == 1) return "within \"" + most[0].second + '"';
  return "where " + most[0].second + " and " + most[1].second + " meet";
}

std::string shareOf(std::int64_t part, std::int64_t all) {
  return fixed(all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all), 2) + " %";
}

std::string whyOf(Order order, std::string_view other, std::int64_t cuts) {
  std::string why =
      rowOf(order).bits > 0 ? "Where two depths round to one level of the buffer, the later face shows"
      : order == Order::Unsorted
          ? "The scene's own order ignores depth"
          : "One z for each face cannot order faces that overlap in z or pass through each other";
  if (cuts > 0) why += "; " + std::string{other} + " cuts " + (cuts == 1 ? "once" : counted(cuts, "time"));
  return why + ".";
}

}  // namespace

std::vector<Phrase> phrasesOf(const PictureSettings& mine, const PictureSettings& other) {
  std::vector<Phrase> phrases;
  for (const Setting& setting : settingRows())
    if (differs(setting, mine, other)) phrases.push_back({phraseOf(setting, mine), true});
  for (const Setting& setting : settingRows())
    if (setting.alwaysNamed && !differs(setting, mine, other) && hasEffect(setting, factsOf(mine)))
      phrases.push_back({phraseOf(setting, mine), false});
  return phrases;
}

std::vector<std::string> differencesOf(const PictureSettings& A, const PictureSettings& B) {
  std::vector<std::string> what;
  for (const Setting& setting : settingRows()) {
    const std::string_view in = setting.differsIn.empty() ? setting.label : setting.differsIn;
    if (differs(setting, A, B) && std::ranges::find(what, in) == what.end()) what.emplace_back(in);
  }
  return what;
}

Finding findingOf(const Picture& A, const Picture& B, const Difference& ofA, const Difference& ofB,
                  const Difference& unlike, const std::optional<DifferingPlace>& place) {
  const std::vector<std::string> what = differencesOf(A.settings(), B.settings());
  if (unlike.errors.count == 0) return {"Nothing shows.", "Turn both with t, or zoom with z."};
  if (what.empty())
    return {"A and B have the same settings.",
            "Change one of them, for example its order with O. This page then shows what differs."};
  for (const auto& [picture, name] : {std::pair{&A, "A"}, {&B, "B"}})
    if (picture->snapped().faces.empty())
      return {std::string{name} + " shows nothing.", "All its faces are turned away or out of view."};
  const std::string meeting =
      place && unlike.kind == Unlike::Face ? meetingOf(A, B, unlike, place->frame) : "";
  const std::string where = meeting.empty() ? "" : ", " + grouped(place->samples) + " of them " + meeting;

  if (A.settings().order != B.settings().order && ofA.wrongFaces + ofB.wrongFaces > 0) {
    const bool aIsWorse = ofA.wrongFaces >= ofB.wrongFaces;
    const Difference &worse = aIsWorse ? ofA : ofB, &better = aIsWorse ? ofB : ofA;
    const std::string name = aIsWorse ? "A" : "B", other = aIsWorse ? "B" : "A";
    if (better.wrongFaces == 0)
      return {
          name + " is wrong at " + counted(worse.wrongFaces, "sample") + where + ".",
          whyOf((aIsWorse ? A : B).settings().order, other, (aIsWorse ? B : A).sorted().statistics.splits)};
    // Where an order is exact, only faces that are left out can make a sample wrong.
    const auto exact = [](const Picture& p) { return rowOf(p.settings().order).exact; };
    const std::string reason =
        exact(A) || exact(B) ? "Backs that can be seen are not painted."
                             : "Neither order is exact: those of Newell, the BSP tree and the oracle are.";
    if (better.wrongFaces == worse.wrongFaces)
      return {"Both are wrong at " + counted(worse.wrongFaces, "sample") + ".", reason};
    return {name + " is wrong at " + counted(worse.wrongFaces, "sample") + ", " + other + " at " +
                grouped(better.wrongFaces) + ".",
            reason};
  }
  const std::string share = shareOf(unlike.above, unlike.errors.count);
  const std::string they = unlike.above > 0 ? "They differ at " + share + " of the samples that show a face."
                           : unlike.kind == Unlike::Face ? "Both show the same face at every sample."
                                                         : "The two pictures differ nowhere by more than " +
                                                               std::string{rowOf(unlike.kind).unitText} + ".";
  const auto table = [](const Picture& picture) { return picture.settings().table.kind; };
  if (what.size() == 1 &&
      std::minmax({table(A), table(B)}) == std::pair{TableKind::Linear, TableKind::Corrected})
    return {"The same intensities get different shades. " + they,
            "In the linear table all steps are equally large. In the corrected table all are the same "
            "percentage, and that is what the eye compares. View 3 plots both."};
  const MistakeRow &inA = rowOf(A.settings().light.mistake), &inB = rowOf(B.settings().light.mistake);
  if (inA.id != inB.id)  // each is compared with what its own equation says
    return {
        (inA.id == Mistake::None   ? "B has " + std::string{inB.words}
         : inB.id == Mistake::None ? "A has " + std::string{inA.words}
                                   : "A has " + std::string{inA.words} + ", B " + std::string{inB.words}) +
            ".",
        they};
  const int decimals = rowOf(ofA.kind).decimals;
  const bool aIsNearer = ofA.errors.rootMeanSquare < ofB.errors.rootMeanSquare;
  const std::string least = fixed(std::min(ofA.errors.rootMeanSquare, ofB.errors.rootMeanSquare), decimals),
                    most = fixed(std::max(ofA.errors.rootMeanSquare, ofB.errors.rootMeanSquare), decimals);
  if (ofA.kind == ofB.kind && least != most)
    return {std::string{aIsNearer ? "A" : "B"} + " is closer to the truth overall.",
            "Its root mean square error is " + least + ", against " + most + ". " + they};
  if (unlike.above > 0)
    return {"A and B differ at " + share + " of the samples that show a face.",
            unlike.kind == Unlike::Color ? "The largest difference is " + fixed(unlike.errors.largest, 1) +
                                               "; the eye just sees a difference of 1."
                                         : ""};
  return {"A and B show the same picture.", they};
}

}  // namespace xnewell
