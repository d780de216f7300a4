#include "x11/app/work.h"

#include <filesystem>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "shading/scene/divide_anew.h"
#include "shading/scene/save_scene.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/units.h"

namespace xnewell {

Work::Work(Scene scene, const Setup& s)
    : pictures{std::move(scene)},
      centre{centreOf(pictures.scene())},
      setup{s},
      defaults{s},
      saved{s},
      divisions{pictures.scene().origin.divisions} {}

void Work::change(char control, const Setup& next) {
  if (control != lastChanged_ || before_.empty()) before_.push_back(setup);
  if (before_.size() > kMostUndone) before_.erase(before_.begin());
  lastChanged_ = control;
  after_.clear();
  setup = next;
}

bool Work::restore(std::vector<Setup>& from, std::vector<Setup>& to) {
  if (from.empty()) return false;
  to.push_back(std::exchange(setup, from.back()));
  from.pop_back();
  lastChanged_ = 0;
  return true;
}

void Work::save(const std::string& name) {
  PictureSettings settings = setup.picture;
  settings.inPixels = setup.fill == Fill::XFillPolygon;
  const std::string text = savedScene(pictures.scene(), settings, std::filesystem::path{name}.parent_path());
  const bool opened = isInput(name) && isSetup(name);
  (opened ? rewriteFile : writeFile)(name, text);
  file = name;
  saved = setup;
}

void Work::divide() {
  const Scene& scene = pictures.scene();
  const int wanted = setup.divisions > 0 ? setup.divisions : divisions;
  if (scene.divisions == 0 || scene.divisions == wanted) return;
  pictures = PictureCache{dividedAnew(scene, wanted)};
}

PictureSettings coarse(PictureSettings settings) {
  settings.shading = settings.shading == Shading::Full ? Shading::Full : Shading::Flat;
  settings.order = Order::ZSort;
  settings.adapt = 0;
  settings.dither = false;
  return settings;
}

}  // namespace xnewell
