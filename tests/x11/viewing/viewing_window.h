#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "shading/scene/units.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/viewing/viewing_view.h"

namespace xnewell {

/// A window at view 9.
struct ViewingWindow : ReadyWorkbench {
  explicit ViewingWindow(const char* scene = "teapot", int width = 1024, int height = 768)
      : ReadyWorkbench{{}, width, height, scene} {
    does('9');
  }
  [[nodiscard]] ViewingView& viewing() { return dynamic_cast<ViewingView&>(bench()); }
  [[nodiscard]] ViewingLayout places() const { return layoutOfViewing(layout()); }
  [[nodiscard]] std::string words() const {
    std::string all;
    for (const std::string& line : bench().report()) all += line + '\n';
    return all;
  }
  [[nodiscard]] Camera camera() const { return placeCamera(scene(), setup().picture.camera, aspect()); }
  [[nodiscard]] double aspect() const {
    const Rect at = bench().frame(layout());
    return static_cast<double>(at.width) / at.height;
  }
  /// Types the value of the control that is selected.
  void typeValue(const std::string& text) {
    press('=');
    for (const char c : text) press(c);
    does(NamedKey::Return);
  }
  [[nodiscard]] IndexImage part(const Rect& area) const {
    IndexImage copy{area.width, area.height, 0};
    for (int j = 0; j < area.height; ++j)
      std::copy_n(image().row(area.y + j) + area.x, area.width, copy.row(j));
    return copy;
  }
};

/// The numbers of a view, in one list.
inline std::vector<double> numbersOf(const ViewSpec& v) {
  return {v.vrp.x,       v.vrp.y,       v.vrp.z,       v.vpn.x,       v.vpn.y, v.vpn.z,
          v.vup.x,       v.vup.y,       v.vup.z,       v.prp.x,       v.prp.y, v.prp.z,
          v.windowMin.x, v.windowMax.x, v.windowMin.y, v.windowMax.y, v.front, v.back};
}

}  // namespace xnewell
