#include "x11/window/caption.h"

#include "shading/scene/settings.h"
#include "x11/window/setting_controls.h"

namespace xnewell {

std::string orderText(Order order) { return std::string{rowOf(order).text}; }

std::string shadingText(Shading shading) { return std::string{rowOf(shading).words}; }

std::string mistakeIn(const Setup& setup) {
  const MistakeRow& row = rowOf(setup.picture.light.mistake);
  const bool has = row.id != Mistake::None && hasEffect(*settingOf("--mistake"), factsOf(setup.picture));
  return has ? std::string{row.words} : "";
}

std::string captionOf(const Setup& setup) {
  const Control projection = settingControl('P', setup, setup, {});
  const std::string mistake = mistakeIn(setup);
  return shadingText(setup.picture.shading) + (mistake.empty() ? "" : " with " + mistake) + "; " +
         orderText(setup.picture.order) + "; " +
         (setup.fill == Fill::Scanline ? "own scanline" : "XFillPolygon") + "; " +
         projection.options[static_cast<std::size_t>(projection.value)];
}

}  // namespace xnewell
