#include "shading/diagnose/scene_for.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "depthsort/oracle.h"
#include "shading/course/course.h"
#include "shading/diagnose/diagnose.h"
#include "shading/scene/scene.h"

namespace xnewell {

namespace {

/// The faces by their nearest z, farthest first.
std::vector<int> byNearestZ(const SnappedScene& scene) {
  std::vector<int> order(scene.faces.size()), nearest(scene.faces.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t f = 0; f < order.size(); ++f) {
    const SnappedFace& face = scene.faces[f];
    nearest[f] = scene.vertices[face.first].z;
    for (int k = 1; k < face.count; ++k) nearest[f] = std::max(nearest[f], scene.vertices[face.first + k].z);
  }
  std::ranges::stable_sort(order, {}, [&](int f) { return nearest[f]; });
  return order;
}

}  // namespace

std::vector<int> paintedOver(const SnappedScene& scene, int width, int height,
                             const std::vector<int>& order) {
  std::vector<int> shown(static_cast<std::size_t>(width) * height, kNothing);
  for (const int f : order) {
    const SnappedFace& face = scene.faces[f];
    const std::span outline{scene.vertices.data() + face.first, static_cast<std::size_t>(face.count)};
    for (const ScanSpan& span : spansOf(edgesOf(outline))) {
      if (span.row < 0 || span.row >= height) continue;
      const int from = std::clamp(span.from, 0, width), to = std::clamp(span.to, from, width);
      const auto row = shown.begin() + static_cast<std::ptrdiff_t>(span.row) * width;
      std::fill(row + from, row + to, f);
    }
  }
  return shown;
}

std::vector<int> facesShown(const SnappedScene& scene, int width, int height, PaintWay way) {
  std::vector<int> order(scene.faces.size());
  std::iota(order.begin(), order.end(), 0);
  switch (way) {
    case PaintWay::Nearest:
      return visibleFaces(scene, width, height);
    case PaintWay::Listed:
      break;
    case PaintWay::Reversed:
      order = paintingOrder(scene, Order::ZSort);
      std::ranges::reverse(order);
      break;
    case PaintWay::NearestZ:
      order = byNearestZ(scene);
      break;
    case PaintWay::BacksOnly: {
      SnappedScene backs = scene;
      std::erase_if(backs.faces, [](const SnappedFace& f) { return !f.back; });
      std::erase_if(order, [&](int f) { return !scene.faces[f].back; });
      std::vector<int> shown = visibleFaces(backs, width, height);
      for (int& f : shown)
        if (f != kNothing) f = order[f];
      return shown;
    }
  }
  return paintedOver(scene, width, height, order);
}

using PairJson = nlohmann::ordered_json;

std::string stepName(const PaintStep& step) {
  if (!step.name.empty()) return step.name;
  return (step.piece.empty() ? "face " : "a piece of face ") + std::to_string(step.face);
}

std::string pairAsScene(const Picture& picture, const WrongPair& pair, std::span<const PaintStep> steps) {
  const double unit = std::ldexp(1.0, picture.scene().exponent);
  const auto list = [](const glm::dvec3& v) { return PairJson{v.x, v.y, v.z}; };
  const ViewSpec& view = picture.camera().view;
  PairJson camera{
      {"vrp", list(unit * view.vrp)},
      {"vpn", list(view.vpn)},
      {"vup", list(view.vup)},
      {"prp", list(unit * view.prp)},
      {"window",
       {unit * view.windowMin.x, unit * view.windowMax.x, unit * view.windowMin.y, unit * view.windowMax.y}},
      {"front", unit * view.front},
      {"back", unit * view.back}};
  if (view.projection == Projection::Parallel) camera["parallel"] = true;
  PairJson objects = PairJson::array();
  for (const auto& [step, color] :
       {std::pair{pair.hidden, PairJson{0.35, 0.6, 1}}, std::pair{pair.shown, PairJson{1, 0.6, 0.2}}}) {
    PairJson corners = PairJson::array();
    for (const glm::dvec3& p : stepInWorld(picture, steps[step])) corners.push_back(list(p));
    objects.push_back({{"name", stepName(steps[step])}, {"color", color}, {"polygons", {corners}}});
  }
  const PairJson scene{
      {"shows", "the first wrong pair: " + stepName(steps[pair.shown]) + " is painted over " +
                    stepName(steps[pair.hidden]) + ", which is nearer"},
      {"camera", camera},
      {"objects", objects},
      {"shading", {{"order", "none"}}}};
  return scene.dump(1) + '\n';
}

/// The pixel that tells two mistakes apart.

/// What a row shows at each sample, as far as a face or the ground is all around it.
std::vector<std::optional<Diagnoser::Predicted>> Diagnoser::insideFaces(const Hypothesis& h) {
  const std::vector<Predicted>& shown = known(h);
  const Approach way = approachWith(h);
  const std::vector<int>& faces = facesOf(way);
  const OtherProgram program{model_, way};
  std::vector<std::optional<Predicted>> all;
  all.reserve(samples_.size());
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const int face = faces[indexOf(samples_[k].i, samples_[k].j)];
    const bool isKnown =
        isInside(faces, samples_[k].i, samples_[k].j) && (face == kNothing || program.canShow(face));
    all.push_back(isKnown ? std::optional{shown[k]} : std::nullopt);
  }
  return all;
}

std::optional<Parting> Diagnoser::partingOf(std::string_view a, std::string_view b) {
  using Shown = std::vector<std::optional<Predicted>>;
  std::vector<Shown> first, second;
  for (const Hypothesis& h : hypotheses()) {
    if (!applies(h)) continue;
    if (h.key == a) first.push_back(insideFaces(h));
    if (h.key == b) second.push_back(insideFaces(h));
  }
  if (first.empty() || second.empty()) return std::nullopt;
  const Shown right = insideFaces(hypotheses().front());
  const auto valueOf = [](const Predicted& p) -> std::optional<double> {
    if (!p.shows) return std::nullopt;
    return p.value[0];
  };
  Parting best;
  best.shades = best.cells = -1.0;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    Parting here;
    here.i = samples_[k].i, here.j = samples_[k].j;
    here.shades = here.cells = 1e300;
    bool edge = !right[k];
    for (const Shown& f : first)
      for (const Shown& s : second) {
        if (edge || !f[k] || !s[k]) {
          edge = true;
          continue;
        }
        const Predicted &x = *f[k], &y = *s[k];
        const double shades = apart(x, y), cells = cellsApart(x.cell, y);
        if (std::pair{shades, cells} >= std::pair{here.shades, here.cells}) continue;
        here.shades = shades, here.cells = cells;
        here.first = valueOf(x), here.second = valueOf(y), here.right = valueOf(*right[k]);
        here.firstCell = x.cell, here.secondCell = y.cell, here.rightCell = right[k]->cell;
      }
    if (edge || std::pair{here.shades, here.cells} <= std::pair{best.shades, best.cells}) continue;
    best = here;
    best.face = picture_.snapped().faces[samples_[k].face].number;
  }
  if (best.shades < 0.0) return std::nullopt;
  return best;
}

namespace {

std::vector<PartingPicture> allOf(std::initializer_list<std::string_view> scenes) {
  std::vector<PartingPicture> all;
  for (const std::string_view scene : scenes)
    for (const TableKind table : {TableKind::Linear, TableKind::Corrected, TableKind::Brief})
      for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
        all.push_back({scene, method, table});
  return all;
}

/// The fewest letters to add, drop or change; upper and lower case count as one.
int lettersApart(std::string_view a, std::string_view b) {
  const auto low = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int before = std::exchange(row[0], static_cast<int>(i) + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int changed = before + (low(a[i]) != low(b[j]));
      before = std::exchange(row[j + 1], std::min({changed, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

}  // namespace

std::vector<PartingPicture> benchPictures() {
  std::vector<PartingPicture> all = allOf({"bench-n3", "bench"}), aside = allOf({"bench-n3"});
  for (PartingPicture& picture : aside) picture.window = {-1.8, 3.4, -1.4, 2.5};
  all.insert(all.end(), aside.begin(), aside.end());
  return all;
}

std::vector<PartingPicture> otherPictures() {
  return allOf({"coarse-teapot", "cubes", "highlight", "lamp", "saturated", "spotlight"});
}

SceneFor sceneFor(std::string_view a, std::string_view b, std::span<const PartingPicture> pictures) {
  SceneFor best;
  best.parting.shades = best.parting.cells = -1.0;
  std::string_view read;
  Scene scene;
  for (const PartingPicture& picture : pictures) {
    if (picture.window && best.parting.shades > kLeastParting) continue;  // told by the scene's own window
    if (picture.scene != read) scene = readScene(std::string{picture.scene}), read = picture.scene;
    PictureSettings settings = scene.settings;
    settings.camera = scene.camera;
    if (picture.window) settings.camera.window = picture.window, settings.camera.fov.reset();
    settings.shading = picture.method, settings.table.kind = picture.table;
    settings.width = kPartingSize.x, settings.height = kPartingSize.y;
    if (!whyNotDiagnosed(scene, settings).empty()) continue;
    const auto parting = Diagnoser{scene, settings}.partingOf(a, b);
    if (!parting) continue;
    ++best.tried;
    // Shades decide, unless neither picture has enough of them.
    const auto rank = [](const Parting& p) {
      return p.shades > kLeastParting ? std::pair{p.shades, 0.0} : std::pair{0.0, p.cells};
    };
    if (best.tried > 1 && rank(*parting) <= rank(best.parting)) continue;
    best.parting = *parting;
    best.picture = picture;
  }
  best.byCells = best.parting.shades <= kLeastParting;
  if (best.byCells && best.parting.cells < 1.0) best.picture.reset(), best.byCells = false;
  return best;
}

std::vector<std::string_view> nearestKeys(std::string_view word, std::size_t count) {
  std::vector<std::string_view> keys;
  for (const Hypothesis& h : hypotheses())
    if (std::ranges::find(keys, h.key) == keys.end()) keys.push_back(h.key);
  std::ranges::stable_sort(keys, {}, [&](std::string_view key) { return lettersApart(word, key); });
  keys.resize(std::min(count, keys.size()));
  return keys;
}

}  // namespace xnewell
