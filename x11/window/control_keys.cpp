#include "x11/window/control_keys.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// The controls that Tab visits: light, sliders, turn, zoom.
const std::string& focusOrder() {
  static const std::string keys = [] {
    std::string all = "l";
    for (const SliderRow& row : sliders()) all += row.key;
    return all + "tz";
  }();
  return keys;
}

bool has(std::string_view letters, char letter) { return letters.find(letter) != std::string_view::npos; }

/// The number that `text` spells; nothing if it has any other character, even a space.
std::optional<double> numberIn(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::string_view allControls() {
  static const std::string keys = [] {
    std::string all = focusOrder();
    for (const ToggleRow& row : toggles()) all += row.key;
    for (const ChoiceRow& row : choices()) all += row.key;
    for (const ChoiceRow& row : others()) all += row.key;
    return all + "H[]+-=";
  }();
  return keys;
}

Camera cameraOf(const Setup& setup, const ControlKeys::Subject& subject) {
  const Scene& scene = subject.scene;
  return placeCamera(setup.picture.camera, scene.mesh.points, scene.up, subject.aspect);
}

void turn(Host& host, const Setup& setup, const ControlKeys::Subject& subject, double azimuth,
          double elevation) {
  const Camera camera = cameraOf(setup, subject);
  host.change('t',
              [&](Setup& s) { s.picture.camera = moved(s.picture.camera, camera, azimuth, elevation, 1.0); });
}

void zoom(Host& host, const Setup& setup, const ControlKeys::Subject& subject, double factor) {
  const Camera camera = cameraOf(setup, subject);
  host.change('z', [&](Setup& s) { s.picture.camera = moved(s.picture.camera, camera, 0.0, 0.0, factor); });
}

void choose(Host& host, const ChoiceRow& row, int option) {
  host.change(row.key, [&](Setup& s) { row.set(s, option); });
}

bool ControlKeys::press(const Key& key, std::string_view which, const Setup& setup, const Subject& subject,
                        Host& host) {
  if (key.name == NamedKey::Letter)
    return has(which, key.letter) && pressLetter(key.letter, setup, subject, host);
  if (key.name == NamedKey::Tab) return nextFocus(key.shift ? -1 : 1, which), true;
  if (!has(which, focus_)) return false;
  const int times = key.shift ? 10 : 1;
  switch (key.name) {
    case NamedKey::Left:
      return move(-times, 0, setup, subject, host), true;
    case NamedKey::Right:
      return move(times, 0, setup, subject, host), true;
    case NamedKey::Up:
      return move(0, times, setup, subject, host), true;
    case NamedKey::Down:
      return move(0, -times, setup, subject, host), true;
    case NamedKey::Home:
      return toEnd(false, setup, host), true;
    case NamedKey::End:
      return toEnd(true, setup, host), true;
    default:
      return false;
  }
}

bool ControlKeys::pressLetter(char letter, const Setup& setup, const Subject& subject, Host& host) {
  if (has(focusOrder(), letter)) return setFocus(letter), true;
  if (const ChoiceRow* const row = choiceOf(letter)) return choose(host, *row, row->next(setup)), true;
  if (const ToggleRow* const row = toggleOf(letter))
    return host.change(letter, [&](Setup& s) { row->flip(s); }), true;
  switch (letter) {
    case '[':
      return host.change('[', [](Setup& s) { sliderOf('i')->set(s, 1.0); }), true;
    case ']':
      return host.change(']', [](Setup& s) { sliderOf('p')->set(s, 1.0); }), true;
    case 'H':
      return host.change('H', nextHue), true;
    case '+':
      return zoom(host, setup, subject, 1.1), true;
    case '-':
      return zoom(host, setup, subject, 1.0 / 1.1), true;
    case '=':
      return askForValue(setup, host), true;
    default:
      return false;
  }
}

void ControlKeys::move(int along, int up, const Setup& setup, const Subject& subject, Host& host) {
  if (focus_ == 't') return turn(host, setup, subject, -2.0 * along, -2.0 * up);
  if (focus_ == 'z') return zoom(host, setup, subject, std::pow(1.02, along + up));
  if (focus_ == 'l')
    return host.change(
        'l', [&](Setup& s) { turnLight(s.picture.light, subject.scene.up, along, up, subject.centre); });
  const SliderRow& row = *sliderOf(focus_);
  if (!row.enabled(setup)) return host.notify(row.whenOff());
  host.change(focus_, [&](Setup& s) { step(s, row, along + up); });
}

void ControlKeys::toEnd(bool high, const Setup& setup, Host& host) {
  const SliderRow* const row = sliderOf(focus_);
  if (row && !row->enabled(setup)) return host.notify(row->whenOff());
  if (row) host.change(row->key, [&](Setup& s) { row->set(s, high ? row->high : row->low); });
}

void ControlKeys::nextFocus(int direction, std::string_view which) {
  const std::string& order = focusOrder();
  const std::size_t n = order.size();
  std::size_t at = order.find(focus_);
  for (std::size_t tried = 0; tried < n; ++tried) {
    at = (at + n + direction) % n;
    if (has(which, order[at])) return setFocus(order[at]);
  }
}

void ControlKeys::askForValue(const Setup& setup, Host& host) {
  const SliderRow* row = sliderOf(focus_);
  if (!row) return host.notify("Only a slider takes a typed value: press its letter first.");
  if (!row->enabled(setup)) return host.notify(row->whenOff());
  const std::string low = fixed(row->low, row->decimals), high = fixed(row->high, row->decimals);
  host.ask({.asks = std::string{row->label} + ", " + low + " to " + high,
            .text = fixed(row->get(setup), row->decimals),
            .take = [row, low, high, &host](const std::string& text) -> std::string {
              const std::optional<double> value = numberIn(text);
              if (!value || !(*value >= row->low && *value <= row->high))
                return std::string{row->label} + " is a number from " + low + " to " + high + ".";
              host.change(row->key,
                          [&](Setup& s) { row->set(s, trackValue(*row, trackPosition(*row, *value))); });
              return {};
            }});
}

}  // namespace xnewell
