#include "x11/viewing/view_handles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace xnewell {

namespace {

constexpr double kEndOn = 0.1;   // of an axis' length: what is seen shorter cannot be aimed at
constexpr double kAside = 30.0;  // units from PRP to the handles that move it along u and v

/// The view when one number of a handle has grown.
ViewSpec grown(ViewSpec view, ViewHandle handle, double by) {
  switch (handle) {
    case ViewHandle::Vrp:
      break;
    case ViewHandle::PrpU:
      view.prp.x += by;
      break;
    case ViewHandle::PrpV:
      view.prp.y += by;
      break;
    case ViewHandle::PrpN:
      view.prp.z += by;
      break;
    case ViewHandle::Front:
      view.front += by;
      break;
    case ViewHandle::Back:
      view.back += by;
      break;
    case ViewHandle::Umin:
      view.windowMin.x += by;
      break;
    case ViewHandle::Umax:
      view.windowMax.x += by;
      break;
    case ViewHandle::Vmin:
      view.windowMin.y += by;
      break;
    case ViewHandle::Vmax:
      view.windowMax.y += by;
      break;
  }
  return view;
}

/// The place of a handle in a volume: planes have it at a corner, and the window's edges in their middle.
glm::dvec3 placeIn(const StageVolume& volume, ViewHandle handle, const glm::dvec3& vrp) {
  const auto edge = [&](std::size_t a, std::size_t b) { return (volume.window[a] + volume.window[b]) / 2.0; };
  switch (handle) {
    case ViewHandle::Vrp:
      return vrp;
    case ViewHandle::PrpU:
    case ViewHandle::PrpV:
    case ViewHandle::PrpN:
      return volume.eye.value_or(vrp);
    case ViewHandle::Front:
      return volume.front[3];
    case ViewHandle::Back:
      return volume.back[3];
    case ViewHandle::Umin:
      return edge(0, 3);
    case ViewHandle::Umax:
      return edge(1, 2);
    case ViewHandle::Vmin:
      return edge(0, 1);
    case ViewHandle::Vmax:
      return edge(2, 3);
  }
  return vrp;
}

/// The longest of 1, 2 and 5 times a power of ten that is not above `most`.
double tidyStep(double most) {
  const double ten = std::pow(10.0, std::floor(std::log10(most)));
  for (const double times : {5.0, 2.0})
    if (times * ten <= most) return times * ten;
  return ten;
}

const Control* numberOf(const Controls& controls, ViewHandle handle, int k) {
  const ViewHandleRow& row = rowOf(handle);
  const auto at = std::ranges::find(controls, ControlId{row.number.key, row.number.part + k}, &Control::id);
  return at == controls.end() ? nullptr : &*at;
}

}  // namespace

std::vector<HandleAt> handlesAt(const ViewingStory& story, const ViewSpec& view, ViewStage stage,
                                const StageImage& image, double shownUnit, int scale) {
  std::vector<HandleAt> handles;
  const OutsideCamera& camera = image.camera();
  const auto onImage = [&](const glm::dvec3& p) { return glm::dvec2{camera(p)}; };
  const auto inside = [size = glm::dvec2{image.image().width, image.image().height}](const glm::dvec2& p,
                                                                                     double band) {
    return p.x >= 0.0 && p.y >= band && p.x < size.x && p.y < size.y - band;
  };
  const StageVolume volume = volumeAt(story, view, stage);
  for (const ViewHandleRow& row : kViewHandles) {
    if (stage > row.last) continue;
    const glm::dvec3 place = placeIn(volume, row.id, view.vrp);
    HandleAt handle{.id = row.id, .at = onImage(place), .along = {}, .pace = camera.scale * shownUnit};
    if (row.numbers == 3) {
      for (int k = 0; k < 3; ++k) {
        glm::dvec3 step{0.0};
        step[k] = shownUnit;
        handle.along[static_cast<std::size_t>(k)] = onImage(place + step) - handle.at;
      }
    } else {
      // All maps up to the shear are affine, so the way is the same from everywhere.
      const glm::dvec3 next =
          placeIn(volumeAt(story, grown(view, row.id, shownUnit), stage), row.id, view.vrp);
      handle.along[0] = onImage(next) - handle.at;
      const double length = camera.scale * glm::length(next - place);
      handle.pace = glm::length(handle.along[0]);
      if (!(handle.pace > kEndOn * length)) continue;
      if (row.id == ViewHandle::PrpU || row.id == ViewHandle::PrpV) {
        const glm::dvec2 aside = handle.along[0] / handle.pace * (kAside * scale);
        handle.at += inside(handle.at + aside, kWordBand * scale) ? aside : -aside;
      }
    }
    if (inside(handle.at, 0.0)) handles.push_back(handle);
  }
  return handles;
}

HandleDrag::HandleDrag(const HandleAt& handle, const OutsideCamera& camera, const Controls& controls,
                       glm::ivec2 pointer, int scale)
    : handle_{handle}, camera_{camera}, from_{pointer}, scale_{scale} {
  for (int k = 0; k < rowOf(id()).numbers; ++k)
    if (const Control* const number = numberOf(controls, id(), k))
      begun_[static_cast<std::size_t>(k)] = number->value;
}

void HandleDrag::to(glm::ivec2 pointer, const Controls& controls, const Host& host) {
  moved_ = moved_ || pointer != from_;
  if (!moved_) return;
  const glm::dvec2 moved = glm::dvec2{pointer - from_} * double(scale_);
  for (int k = 0; k < rowOf(id()).numbers; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (const Control* const number = numberOf(controls, id(), k))
      set(*number, begun_[at] + glm::dot(handle_.along[at], moved) / (handle_.pace * handle_.pace), host);
  }
}

void HandleDrag::set(const Control& number, double wanted, const Host& host) const {
  const double digits = std::pow(10.0, number.range.decimals);
  const double step = std::max(tidyStep(scale_ / handle_.pace), 1.0 / digits);
  const auto valueOf = [&](double steps) { return std::round(steps * step * digits) / digits; };
  const auto takes = [&](double steps) {
    const Setup before = host.setup();
    number.set(valueOf(steps));
    return host.setup() != before;
  };
  if (number.kind == Control::Kind::Number) wanted = std::clamp(wanted, number.range.low, number.range.high);
  double bad = std::round(wanted / step), good = std::round(number.value / step);
  if (valueOf(bad) == number.value || takes(bad)) return;
  // It was refused. What is a view lies between two ends, so halving finds the last step that is one.
  while (std::abs(bad - good) > 1.0) {
    const double middle = std::trunc((good + bad) / 2.0);
    (takes(middle) ? good : bad) = middle;
  }
}

}  // namespace xnewell
