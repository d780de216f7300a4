#include "shading/diagnose/scene_for.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "shading/scene/scene.h"

namespace xnewell {

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
