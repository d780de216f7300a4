#include "shading/diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "depthsort/oracle.h"
#include "shading/diagnose/scene_for.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/scene_colors.h"

namespace xnewell {

namespace {

constexpr double kExplainsStrange = 0.8, kOffStrange = 0.8;  ///< a share; shades, where they are smooth
constexpr std::size_t kFewest = 50;                          ///< samples, without which nothing can be said

/// The settings of the picture that the faces come from: exact, not painted.
PictureSettings exactly(PictureSettings settings) {
  settings.order = Order::Unsorted;
  settings.adapt = 0.0;
  return settings;
}

/// True if the texels around a sample have its colour, or if there are none.
bool isOneTexel(OtherProgram& program, const DiagnosedSample& s) {
  const int here = program.texelAt(s.face, s.i, s.j);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (program.texelAt(s.face, s.i + x, s.j + y) != here) return false;
  return true;
}

}  // namespace

std::string whyNotDiagnosed(const Scene& scene, const PictureSettings& settings) {
  const Shading method = settings.shading;
  if (method != Shading::Flat && method != Shading::Gouraud && method != Shading::Phong)
    return "diagnose knows flat, Gouraud and Phong shading, not --shade " + std::string{rowOf(method).name};
  if (std::int64_t{settings.width} * settings.height > kMostDiagnosed)
    return "diagnose takes pictures of up to 4096 x 4096 pixels";
  if (settings.light.mistake != Mistake::None)
    return "diagnose looks for mistakes by itself: leave out --mistake";
  if (settings.adapt > 0.0) return "diagnose takes the polygons as they are: leave out --adapt";
  if (settings.dither) return "diagnose compares pixel by pixel: leave out --dither";
  const ColorPlan plan = planOf(scene, settings);
  if (plan != ColorPlan::OneHue && plan != ColorPlan::Hues && settings.table.kind == TableKind::Corrected)
    return "diagnose reads colours of several hues as even values: choose --table linear";
  return "";
}

Diagnoser::Diagnoser(Scene scene, const PictureSettings& settings)
    : picture_{makePicture(std::move(scene), exactly(settings)).withPlanes()},
      settings_{settings},
      model_{picture_} {
  chooseSamples();
  if (samples_.size() < kFewest)
    throw std::invalid_argument{"the picture shows too few pixels inside faces to tell anything: " +
                                std::to_string(samples_.size())};
}

const std::vector<int>& Diagnoser::facesOf(const Approach& way) {
  const int w = settings_.width, h = settings_.height;
  const SnappedScene& scene = picture_.snapped();
  if (way.view) {
    if (viewed_.first == way.view) return viewed_.second;
    const OtherView view{*way.view, picture_.camera(), model_.unit, w, h};
    viewed_ = {way.view, view.facesShown(static_cast<int>(scene.faces.size()), [&](int face) {
                 std::vector<glm::dvec3> polygon;
                 for (const int point : picture_.scene().parts.part(scene.faces[face].part))
                   polygon.push_back(model_.unit * picture_.scene().mesh.points[point]);
                 return polygon;
               })};
    return viewed_.second;
  }
  const auto [at, isNew] = faces_.try_emplace(way.paint);
  if (isNew) at->second = facesShown(scene, w, h, way.paint);
  return at->second;
}

bool Diagnoser::isInside(const std::vector<int>& faces, int i, int j) const {
  const int face = faces[indexOf(i, j)];
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (faces[indexOf(i + x, j + y)] != face) return false;
  return true;
}

std::vector<DiagnosedSample> Diagnoser::insideFaces() {
  const int w = settings_.width, h = settings_.height;
  const std::vector<int>& exact = facesOf({});
  OtherProgram right{model_, {}};
  const bool smooth = rowOf(settings_.shading).interpolates;
  const bool textured = !picture_.scene().textures.empty();
  std::vector<char> usable(picture_.snapped().faces.size());
  for (std::size_t f = 0; f < usable.size(); ++f)
    usable[f] = !(smooth || textured) || right.canShow(static_cast<int>(f));
  std::vector<DiagnosedSample> all;
  for (int j = 1; j + 1 < h; ++j)
    for (int i = 1; i + 1 < w; ++i) {
      const int face = exact[indexOf(i, j)];
      if (face != kNothing && usable[face] && isInside(exact, i, j)) all.push_back({i, j, face});
    }
  return all;
}

void Diagnoser::chooseSamples() {
  const SnappedScene& scene = picture_.snapped();
  const int w = settings_.width, h = settings_.height;
  const std::vector<int> mean = paintedOver(scene, w, h, paintingOrder(scene, Order::ZMean)),
                         far = paintedOver(scene, w, h, paintingOrder(scene, Order::ZSort));
  std::vector<std::vector<DiagnosedSample>> ofFace(scene.faces.size());
  for (const DiagnosedSample& s : insideFaces()) {
    const std::size_t at = static_cast<std::size_t>(s.j) * w + s.i;
    if (mean[at] == s.face && far[at] == s.face) ofFace[s.face].push_back(s);
  }
  OtherProgram right{model_, {}};
  const bool textured = !picture_.scene().textures.empty();
  for (const auto& one : ofFace) facesSampled_ += !one.empty();
  if (facesSampled_ == 0) return;
  // As many of each face as fit; what small faces leave goes to the large ones.
  const auto takenAt = [&](std::size_t most) {
    std::size_t sum = 0;
    for (const auto& one : ofFace) sum += std::min(most, one.size());
    return sum;
  };
  std::size_t most = 1;
  while (most < kMostSamples && takenAt(most + 1) <= kMostSamples) ++most;
  for (const auto& one : ofFace)
    for (std::size_t k = 0, take = std::min(most, one.size()); k < take; ++k)
      if (const DiagnosedSample& s = one[(2 * k + 1) * one.size() / (2 * take)];
          !textured || isOneTexel(right, s))
        samples_.push_back(s);
}

Approach Diagnoser::approachOf(const Fit& fit) const {
  if (!fit.number) return approachWith(*fit.first, fit.second);
  return {.number = fit.number};
}

Approach Diagnoser::approachWith(const Hypothesis& first, const Hypothesis* second) const {
  Approach way = first.way;
  if (second) way.add(second->way);
  return way;
}

Diagnoser::Predicted::Predicted(const ShownHere& shown)
    : step{static_cast<float>(shown.step)}, cell{static_cast<std::int16_t>(shown.cell)} {
  for (int c = 0; c < 3; ++c) value[c] = static_cast<float>(shown.value[c]);
}

Diagnoser::Predicted Diagnoser::predictedAt(OtherProgram& program, const DiagnosedSample& s, int face) {
  const ShownHere shown = program.at(face, s.i, s.j);
  Predicted p{shown};
  if (program.way().method == Shading::Gouraud || program.way().method == Shading::Phong)
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}}) {
      const ShownHere next = program.at(face, s.i + x, s.j + y);
      for (int c = 0; c < 3; ++c)
        p.slope = std::max(p.slope, static_cast<float>(std::abs(next.value[c] - shown.value[c])));
    }
  return p;
}

std::vector<Diagnoser::Predicted> Diagnoser::predicted(const Approach& way, std::size_t stride) {
  OtherProgram program{model_, way};
  const std::vector<int>& faces = facesOf(way);
  const bool isRight = way.paint == PaintWay::Nearest && !way.view;
  std::vector<Predicted> all;
  all.reserve(samples_.size());
  for (std::size_t k = 0; k < samples_.size(); k += stride) {
    const DiagnosedSample& s = samples_[k];
    const int face = isRight ? s.face : faces[indexOf(s.i, s.j)];
    Predicted p;
    if (face == kNothing)
      p.shows = false;
    else
      p = predictedAt(program, s, face);
    all.push_back(p);
  }
  return all;
}

const std::vector<Diagnoser::Predicted>& Diagnoser::known(const Hypothesis& h) {
  const auto [at, isNew] = known_.try_emplace(&h);
  if (isNew) at->second = predicted(approachWith(h));
  return at->second;
}

/// The commonest colour where no face shows; nothing if faces show almost everywhere.
std::optional<std::array<std::uint8_t, 3>> Diagnoser::groundOf(const HandedIn& handed,
                                                               const std::vector<int>& faces) const {
  std::map<std::array<std::uint8_t, 3>, int> counts;
  int all = 0;
  for (int j = 0; j < settings_.height; ++j)
    for (int i = 0; i < settings_.width; ++i) {
      if (faces[indexOf(i, j)] != kNothing) continue;
      const std::uint8_t* const p = handed.picture.pixel(i, j);
      ++counts[{p[0], p[1], p[2]}], ++all;
    }
  if (all * 100 < settings_.width * settings_.height) return std::nullopt;
  return std::ranges::max_element(counts, {}, [](const auto& c) { return c.second; })->first;
}

/// True if what the file's palette holds is one of the tables that a program may have stored.
bool Diagnoser::hasOurCells(const HandedIn& handed) {
  if (!handed.cells || model_.colors) return false;
  for (const StoreWay store :
       {StoreWay::AsAsked, StoreWay::Rounded8, StoreWay::Minus11, StoreWay::EightIn16, StoreWay::Ratio240,
        StoreWay::Ratio64, StoreWay::Backwards, StoreWay::Gamma, StoreWay::Gamma8}) {
    const OtherProgram program{model_, {.store = store}};
    std::size_t same = 0;
    for (const DiagnosedSample& s : samples_) {
      const int cell = handed.cells->row(s.j)[s.i];
      const auto& held = handed.held[cell];
      same += std::abs(std::max({held[0], held[1], held[2]}) - program.stored(cell)) <= 1.0;
    }
    if (100 * same >= 95 * samples_.size()) return true;
  }
  return false;
}

Diagnoser::Read Diagnoser::read(const HandedIn& handed, std::span<const DiagnosedSample> samples,
                                bool cells) const {
  Read all;
  for (const DiagnosedSample& s : samples) {
    const std::uint8_t* const p = handed.picture.pixel(s.i, s.j);
    all.value.push_back({p[0], p[1], p[2]});
    if (!model_.colors) all.value.back()[0] = std::max({p[0], p[1], p[2]});
    if (cells) all.cell.push_back(handed.cells->row(s.j)[s.i]);
  }
  return all;
}

Diagnosis Diagnoser::operator()(const HandedIn& handed) {
  Diagnosis d;
  d.samples = static_cast<int>(samples_.size());
  d.oneHue = !model_.colors;
  if (handed.picture.width != settings_.width || handed.picture.height != settings_.height) {
    d.verdict = Marking::OtherScene, d.outlines = {}, d.isOtherSize = true;
    return d;
  }
  d.readsCells = hasOurCells(handed);
  asHanded_ = read(handed, samples_, d.readsCells);
  const OtherProgram right{model_, {}};
  const double top = model_.colors ? 255.0 : right.stored(right.brightest());
  d.brightest = static_cast<double>(std::ranges::count_if(
                    asHanded_.value, [&](const auto& v) { return std::ranges::max(v) >= top; })) /
                static_cast<double>(samples_.size());
  // Black where nearly nothing should be.
  const std::vector<Predicted>& shades = known(hypotheses().front());
  const auto dark =
      std::ranges::count_if(asHanded_.value, [](const auto& v) { return std::ranges::max(v) <= 1; });
  const auto darkOnes =
      std::ranges::count_if(shades, [](const Predicted& p) { return std::ranges::max(p.value) <= 16.0F; });
  const double share = 1.0 / static_cast<double>(samples_.size());
  d.isBlack = static_cast<double>(dark) * share >= 0.99 && static_cast<double>(darkOnes) * share < 0.5;
  d.isOneColor = true;
  for (std::size_t k = 3; k < handed.picture.rgb.size() && d.isOneColor; ++k)
    d.isOneColor = handed.picture.rgb[k] == handed.picture.rgb[k % 3];
  d.outlines = {};
  for (const PaintWay paint : {PaintWay::Nearest, PaintWay::BacksOnly}) {
    const std::vector<int>& faces = facesOf({.paint = paint});
    const auto ground = groundOf(handed, faces);
    if (paint == PaintWay::Nearest && ground) ground_ = *ground;
    const Outlines outlines =
        ground ? outlinesOf(handed.picture, faces, *ground, kOverlap) : Outlines{.overlap = 1.0};
    if (outlines.overlap > d.outlines.overlap) d.outlines = outlines;
  }
  if (d.isBlack || d.isOneColor) {
    d.verdict = Marking::OtherScene;
    if (d.isOneColor) addWhatShowsNothing(handed, d);
    return d;
  }
  const bool overlaps = d.outlines.overlap >= kOverlap;
  if (overlaps) decide(d);
  const auto isRight = [&d] { return d.verdict == Marking::Right || d.verdict == Marking::Allowed; };
  if (!overlaps || d.verdict == Marking::Unknown || (isRight() && d.outlines.areOff())) {
    if (decidePlaced(handed, d)) return d;
    if (!overlaps) d.verdict = Marking::OtherScene;
    if (isRight()) d.verdict = Marking::Outlines;
  }
  if (isRight()) decideByEdges(handed, d);
  if (isRight()) countOthers(handed, d);
  return d;
}

/// True if another face that covers the sample has the picture's shade.
bool Diagnoser::isAnotherFace(OtherProgram& program, const Read& yours, std::size_t k,
                              const DiagnosedSample& s) {
  const SnappedScene& scene = picture_.snapped();
  const glm::ivec2 at{s.i * kGrid + kGrid / 2, s.j * kGrid + kGrid / 2};
  for (const SnappedFace& face : scene.faces) {
    const glm::ivec3* const p = &scene.vertices[face.first];
    bool covers = false;
    for (int a = 0, b = face.count - 1; a < face.count; b = a++)
      if ((p[a].y > at.y) != (p[b].y > at.y))
        covers ^= at.x < p[a].x + double(p[b].x - p[a].x) * (at.y - p[a].y) / (p[b].y - p[a].y);
    const auto number = static_cast<int>(&face - scene.faces.data());
    if (covers && number != s.face && apart(yours, k, predictedAt(program, s, number)) <= tolerance())
      return true;
  }
  return false;
}

/// True if a pixel at the edge of faces has a shade that none of the faces around it has, nor the ground.
bool Diagnoser::isStrange(OtherProgram& program, const Read& yours, const DiagnosedSample& s) {
  constexpr double kStrange = 20.0;  // shades
  const std::vector<int>& faces = facesOf({});
  Predicted ground;
  ground.shows = false;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      const int face = faces[static_cast<std::size_t>(s.j + y) * settings_.width + s.i + x];
      if (face != kNothing && !program.canShow(face)) return false;
      if (apart(yours, 0, face == kNothing ? ground : predictedAt(program, s, face)) <= kStrange)
        return false;
    }
  return true;
}

/// Looks at all pixels of faces: samples_ are some, and leave out what a sort by z hides. Where the picture
/// has the shade of another face, that shows. Other shades are those of mistakes that few samples show, if
/// one explains them.
void Diagnoser::countOthers(const HandedIn& handed, Diagnosis& d) {
  constexpr std::size_t kMostLookedAt = 5000, kMostTried = 300, kFewStrange = 6;
  const Fit& found = d.found.front();
  OtherProgram program{model_, approachOf(found)};
  std::vector<DiagnosedSample> all = insideFaces();
  const Read first = read(handed, all, false);
  d.inside = static_cast<int>(all.size());
  const bool textured = !picture_.scene().textures.empty();
  std::size_t kept = 0, lookedAt = 0;
  std::set<std::size_t> inside;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const DiagnosedSample s = all[k];
    inside.insert(inside.end(), static_cast<std::size_t>(s.j) * settings_.width + s.i);
    if (apart(first, k, predictedAt(program, s, s.face)) <= tolerance() ||
        (textured && !isOneTexel(program, s)))
      continue;
    if (lookedAt++ < kMostLookedAt && isAnotherFace(program, first, k, s))
      ++d.others;
    else
      all[kept++] = s;
  }
  all.resize(kept);
  const std::vector<int>& faces = facesOf({});
  for (int j = 1; j + 1 < settings_.height && !textured; ++j)
    for (int i = 1; i + 1 < settings_.width; ++i) {
      const std::size_t at = static_cast<std::size_t>(j) * settings_.width + i;
      const DiagnosedSample s{i, j, faces[at]};
      if (s.face == kNothing || inside.contains(at)) continue;
      const Read yours = read(handed, {&s, 1}, false);
      if (isStrange(program, yours, s) && !isAnotherFace(program, yours, 0, s)) all.push_back(s), ++kept;
    }
  d.strange = static_cast<int>(kept);
  if (kept < kFewStrange) return;
  for (std::size_t k = 0; k < std::min(kept, kMostTried); ++k)
    all[k] = all[k * kept / std::min(kept, kMostTried)];
  all.resize(std::min(kept, kMostTried));
  const Read yours = read(handed, all, false);
  const Hypothesis* const with = found.first->meaning == Meaning::Allowed ? found.first : nullptr;
  std::vector<Fit> explain;
  for (const Fit& one : d.all) {
    if (one.first->meaning != Meaning::Wrong || one.explained < kExplainsRight) continue;
    OtherProgram wrong{model_, approachWith(*one.first, with)};
    std::size_t told = 0;
    Fit fit = one;
    fit.second = with, fit.telling = d.strange, fit.off = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double off = apart(yours, k, predictedAt(wrong, all[k], all[k].face));
      told += off <= tolerance(), fit.off += std::min(off, 10.0) / static_cast<double>(all.size());
    }
    fit.informative = static_cast<double>(told) / static_cast<double>(all.size());
    if (tellsExactly() ? fit.informative < kExplainsStrange : fit.off > kOffStrange) continue;
    // What explains the few must not be worse for the others.
    const double cost = with ? this->fit(predicted(approachWith(*one.first, with))).cost : one.cost;
    if (cost <= found.cost + kClass &&
        std::ranges::none_of(explain, [&](const Fit& f) { return f.first->key == one.first->key; }))
      explain.push_back(fit);
  }
  if (explain.empty()) return;
  d.found = explain, d.doubts.clear();
  d.verdict = d.found.size() == 1 ? Marking::Mistake : Marking::OneOf;
  addPixel(d);
}

RgbImage Diagnoser::pictureBy(const Approach& way) {
  constexpr std::uint8_t kGround = 64;
  const int w = settings_.width, h = settings_.height;
  OtherProgram program{model_, way};
  const std::vector<int>& faces = facesOf(way);
  RgbImage image{w, h};
  for (int j = 0; j < h; ++j)
    for (int i = 0; i < w; ++i) {
      std::uint8_t* const rgb = image.pixel(i, j);
      const int face = faces[indexOf(i, j)];
      std::fill(rgb, rgb + 3, kGround);
      if (face == kNothing || !program.canShow(face)) continue;
      const ShownHere shown = program.at(face, i, j);
      for (int c = 0; c < 3; ++c) {
        const double value = model_.colors ? shown.value[c] : shown.value[0] * settings_.table.hue[c];
        rgb[c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
  return image;
}

Outlines outlinesOf(const RgbImage& handed, const std::vector<int>& faces, std::array<std::uint8_t, 3> ground,
                    double least) {
  constexpr int kFar = 40;  // pixels; farther ones count as that far
  const int w = handed.width, h = handed.height;
  const bool isDark = std::max({ground[0], ground[1], ground[2]}) <= 16;
  const auto shows = [&](int i, int j) { return faces[static_cast<std::size_t>(j) * w + i] != kNothing; };
  const auto isAllAlike = [&](int i, int j, int by) {
    for (int y = std::max(0, j - by); y <= std::min(h - 1, j + by); ++y)
      for (int x = std::max(0, i - by); x <= std::min(w - 1, i + by); ++x)
        if (shows(x, y) != shows(i, j)) return false;
    return true;
  };
  Outlines outlines;
  long both = 0, either = 0;
  std::vector<glm::ivec2> others;
  for (int j = 1; j + 1 < h; ++j)
    for (int i = 1; i + 1 < w; ++i) {
      if (!isAllAlike(i, j, 1)) continue;
      const bool ours = shows(i, j);
      const std::uint8_t* const p = handed.pixel(i, j);
      const bool theirs = p[0] != ground[0] || p[1] != ground[1] || p[2] != ground[2] || (isDark && ours);
      both += ours && theirs, either += ours || theirs;
      if (ours != theirs) others.push_back({i, j});
    }
  outlines.overlap = either == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(either);
  if (outlines.overlap < least) return outlines;
  for (const glm::ivec2& at : others) {
    if (!isAllAlike(at.x, at.y, 2)) continue;
    ++outlines.apart;
    while (outlines.farthest < kFar && isAllAlike(at.x, at.y, std::max(2, outlines.farthest)))
      outlines.farthest = std::max(3, outlines.farthest + 1), outlines.i = at.x, outlines.j = at.y;
  }
  return outlines;
}

}  // namespace xnewell
