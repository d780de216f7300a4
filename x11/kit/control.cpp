#include "x11/kit/control.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"

namespace xnewell {

double shareOf(const TrackRange& range, double value) {
  if (range.high <= range.low) return 0;
  const double v = std::clamp(value, range.low, range.high);
  return range.logarithmic ? std::log(v / range.low) / std::log(range.high / range.low)
                           : (v - range.low) / (range.high - range.low);
}

double valueAt(const TrackRange& range, double share) {
  const double p = std::clamp(share, 0.0, 1.0);
  const double v = range.logarithmic ? range.low * std::pow(range.high / range.low, p)
                                     : range.low + p * (range.high - range.low);
  const double unit = std::pow(10.0, range.decimals);
  return std::clamp(std::round(v * unit) / unit, range.low, range.high);
}

double stepped(const TrackRange& range, double value, int steps) {
  const double share = range.logarithmic ? range.step : range.step / (range.high - range.low);
  const double unit = std::pow(10.0, -range.decimals);
  const double after = valueAt(range, shareOf(range, value) + steps * share);
  // On a logarithmic track a step may be smaller than the last decimal. Then the value moves by one unit of
  // that decimal.
  if (std::abs(after - value) >= unit / 2) return after;
  return std::clamp(value + (steps > 0 ? unit : -unit), range.low, range.high);
}

std::string textOf(const TrackRange& range, double value) {
  return range.decimals == 0 ? grouped(std::llround(value)) : fixed(value, range.decimals);
}

ControlPlace placeInRow(const Control& control, int x, int baseline, const RowStyle& style, int parts) {
  constexpr int kBox = 11, kReach = 5;  // a box's side; how far a thumb reaches beyond its track's ends
  ControlPlace place{
      .x = x, .y = baseline, .area = {x, baseline - 14, style.width, style.pitch}, .style = style};
  const int value = x + style.value;
  switch (control.kind) {
    case Control::Kind::Slider:
      place.track = {value, baseline - 5, style.track + 1, 2};
      place.grip = {value - kReach, place.area.y, style.track + 2 * kReach + 1, style.pitch};
      break;
    case Control::Kind::Choice:
      place.options = optionFrames(control.options, value, baseline, style.width - style.value,
                                   std::min(19, style.pitch));
      if (!place.options.empty()) place.area.height += place.options.back().y - place.options.front().y;
      break;
    case Control::Kind::Toggle:
      place.box = {style.boxAfterKey ? x + style.label : value, baseline - 10, kBox, kBox};
      break;
    case Control::Kind::Number: {
      const int right = x + style.width - style.numbers * (parts - 1 - control.part);
      place.box = place.grip = {right - style.numbers + 8, baseline - 12, style.numbers - 4, 15};
      if (parts > 1) place.area = place.box;
      break;
    }
    case Control::Kind::Button:
      place.box = place.area;
      break;
    case Control::Kind::Own:
      break;
  }
  return place;
}

std::vector<Rect> optionFrames(const std::vector<std::string>& options, int x, int baseline, int width,
                               int height) {
  constexpr int kLeastGap = 8;  // the frame of one option reaches 7 units beyond its text
  constexpr int kMostGap = 14, kGapInLines = 12;
  const auto widthOf = [&](std::size_t first, std::size_t count) {
    int sum = 0;
    for (std::size_t k = first; k < first + count; ++k) sum += textWidth(options[k]);
    return sum;
  };
  const auto gaps = [](std::size_t count) { return std::max(1, static_cast<int>(count) - 1); };
  const std::size_t all = options.size();
  const int wordGap = widthOf(0, all) + gaps(all) * kLeastGap <= width ? kLeastGap : kGapInLines;
  std::vector<Rect> frames;
  for (std::size_t first = 0; first < all;) {
    std::size_t fit = 1;
    while (first + fit < all && widthOf(first, fit + 1) + gaps(fit + 1) * wordGap <= width) ++fit;
    const int gap = std::clamp((width - widthOf(first, fit)) / gaps(fit), kLeastGap, kMostGap);
    int left = x - 6;
    for (std::size_t k = first; k < first + fit; ++k) {
      frames.push_back({left, baseline - (height + 9) / 2, textWidth(options[k]) + 13, height});
      left += textWidth(options[k]) + gap;
    }
    baseline += height;
    first += fit;
  }
  return frames;
}

void drawOptions(Pen& pen, const std::vector<std::string>& options, const std::vector<Rect>& frames,
                 int chosen, int hovered, const std::vector<bool>& lacking) {
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    const Rect& box = frames[i];
    const int baseline = box.y + (box.height + 9) / 2;
    if (i == chosen) {
      pen.paint.fillRect(box, pen(Cell::White));
      pen.paint.frame(box, pen(Cell::Ink));
      pen.bold(box.x + 6, baseline, options[i]);
      continue;
    }
    if (i == hovered)
      pen.paint.fillRect({box.x + 2, box.y + 1, box.width - 4, box.height - 2}, pen(Cell::Panel));
    const bool lacks = !lacking.empty() && lacking[i];
    const Cell ink = lacks ? Cell::Faint : i == hovered ? Cell::Ink : Cell::Soft;
    pen.paint.text(box.x + 6, baseline, options[i], pen(ink));
  }
}

void drawTrack(Pen& pen, const ControlPlace& place, double share, std::optional<double> initially,
               bool enabled, const Look& look) {
  const int x = place.track.x, width = place.track.width - 1, middle = place.track.y + 1;
  const int height = std::min(15, (place.area.height - 2) | 1);  // thumbs of two rows stay apart
  const auto at = [&](double s) {
    return x + static_cast<int>(std::lround(std::clamp(s, 0.0, 1.0) * width));
  };
  const int thumb = at(share);
  pen.paint.fillRect({x, middle - 1, width, 2}, pen(Cell::Rule));
  pen.paint.fillRect({x, middle - 1, thumb - x, 2}, pen(enabled ? Cell::Soft : Cell::Rule));
  for (int quarter = 0; quarter <= 4; ++quarter)
    pen.paint.vline(x + quarter * width / 4, middle + 7, 2, pen(Cell::Faint));
  if (enabled && initially)
    pen.paint.triangle(at(*initially) - 2, middle - 8, 3, Direction::Down, pen(Cell::Faint));
  const Rect box{thumb - 4, middle - height / 2, 9, height};
  const Cell face = !enabled       ? Cell::Panel
                    : look.dragged ? Cell::Ink
                    : look.hovered ? Cell::White
                                   : Cell::Paper;
  pen.paint.fillRect(box, pen(face));
  pen.paint.frame(box, pen(enabled ? Cell::Ink : Cell::Faint));
  if (!enabled) return;
  if (!look.dragged) pen.paint.vline(box.x + 7, box.y + 1, box.height - 2, pen(Cell::Rule));
  pen.paint.vline(thumb, middle - 3, 7, pen(look.dragged ? Cell::White : Cell::Ink));
}

namespace {

void drawToggle(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  const Rect& box = place.box;
  pen.paint.fillRect(box, pen(look.hovered ? Cell::Panel : Cell::White));
  pen.paint.frame(box, pen(control.enabled() ? Cell::Ink : Cell::Faint));
  if (control.value != 0) pen.paint.tick(box.x + 2, box.y + 2, pen(Cell::Ink));
  const std::string& words = place.style.boxAfterKey ? control.label : control.words;
  pen.paint.text(box.x + (place.style.boxAfterKey ? 17 : 18), place.y, words,
                 pen(control.enabled() ? Cell::Ink : Cell::Faint));
}

void drawButton(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  const Rect& box = place.box;
  pen.paint.fillRect(box, pen(look.dragged ? Cell::Rule : look.hovered ? Cell::White : Cell::Panel));
  pen.paint.frame(box, pen(Cell::Faint));
  pen.paint.hline(box.x + 1, box.y + box.height, box.width, pen(Cell::Rule));
  const int width = textWidth(control.label) + 12, x = box.x + (box.width - width) / 2;
  pen.ink(x, place.y, control.label);
  pen.soft(x + width - 6, place.y, std::string{control.key});
}

void drawNumber(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  const int right = place.box.x + place.box.width - 4;
  if (look.focused) {
    pen.paint.fillRect(place.box, pen(Cell::White));
    pen.paint.frame(place.box, pen(Cell::Ink));
  } else if (look.hovered) {
    pen.paint.fillRect(place.box, pen(Cell::Panel));
  }
  pen.paint.textRight(right, place.y, textOf(control.range, control.value),
                      pen(control.enabled() ? Cell::Ink : Cell::Faint), Voice::Bold);
}

}  // namespace

void drawControl(Pen& pen, const Control& control, const ControlPlace& place, const Look& look) {
  if (control.kind == Control::Kind::Button) return drawButton(pen, control, place, look);
  const Cell ink = control.enabled() ? Cell::Ink : Cell::Faint;
  const bool labelled = control.kind != Control::Kind::Toggle || !place.style.boxAfterKey;
  if (control.part == 0) {
    if (control.key != 0) pen.key(place.x, place.y - 11, std::string{control.key});
    if (labelled) pen.paint.text(place.x + place.style.label, place.y, control.name(), pen(ink));
  }
  const auto valueAtTheRight = [&](const std::string& value) {
    pen.paint.textRight(place.x + place.style.width, place.y, value, pen(ink),
                        control.enabled() ? Voice::Bold : Voice::Plain);
  };
  switch (control.kind) {
    case Control::Kind::Slider: {
      const auto share = [&](double value) { return shareOf(control.range, value); };
      drawTrack(pen, place, share(control.value),
                control.initially ? std::optional{share(*control.initially)} : std::nullopt,
                control.enabled(), look);
      return valueAtTheRight(textOf(control.range, control.value));
    }
    case Control::Kind::Choice:
      return drawOptions(pen, control.options, place.options, static_cast<int>(control.value), look.option,
                         control.lacking);
    case Control::Kind::Toggle:
      return drawToggle(pen, control, place, look);
    case Control::Kind::Number:
      return drawNumber(pen, control, place, look);
    case Control::Kind::Own:
      if (!place.style.wordsAtValue) return valueAtTheRight(control.words);
      pen.bold(place.x + place.style.value, place.y, control.words);
      return;
    case Control::Kind::Button:
      return;
  }
}

namespace {

using Kind = Control::Kind;

const Control* among(const Controls& controls, std::optional<ControlId> id) {
  if (!id) return nullptr;
  const auto control = std::ranges::find(controls, *id, &Control::id);
  return control == controls.end() ? nullptr : &*control;
}

/// The option that the key chooses: usually the one after the value, and the first one after the last.
double nextOption(const Control& choice) {
  if (choice.next) return *choice.next;
  return (static_cast<int>(choice.value) + 1) % static_cast<int>(choice.options.size());
}

/// "next shading, normals, order": the words that controls of one kind share in the list of all keys.
std::string wordsOfAll(const Controls& controls, std::string_view verb, Kind kind) {
  std::string words;
  char last = 0;
  for (const Control& control : controls) {
    if (control.kind != kind || control.key == last) continue;
    words += (words.empty() ? std::string{verb} + " " : ", ") + control.name();
    last = control.key;
  }
  return words;
}

/// What a letter does, for the list of all keys. Controls of one kind share a line.
std::string wordsOf(const Controls& controls, const Control& control) {
  switch (control.kind) {
    case Kind::Choice:
      return wordsOfAll(controls, "next", control.kind);
    case Kind::Toggle:
      return wordsOfAll(controls, "switch", control.kind);
    case Kind::Slider:
    case Kind::Number:
      return wordsOfAll(controls, "select", control.kind);
    case Kind::Button:
    case Kind::Own:
      return control.is;
  }
  return {};
}

/// A gap between options belongs to the nearest one; -1 before all of them, at the name.
int nearestOption(const ControlPlace& place, int x, int y) {
  constexpr int kBefore = 10;
  if (place.options.empty() || x < place.options.front().x - kBefore) return -1;
  const auto apart = [&](const Rect& r) {
    const int dx = std::max({r.x - x, x - (r.x + r.width - 1), 0}),
              dy = std::max({r.y - y, y - (r.y + r.height - 1), 0});
    return dx + 100 * dy;
  };
  return static_cast<int>(std::ranges::min_element(place.options, {}, apart) - place.options.begin());
}

}  // namespace

void activate(const Control& control, int option) {
  if (control.kind == Kind::Choice)
    control.set(option >= 0 ? option : nextOption(control));
  else if (control.set)
    control.set(control.kind == Kind::Toggle ? control.value == 0 : 1);
}

int ControlList::placeRow(const Controls& controls, char key, int x, int baseline, const RowStyle& style) {
  const int parts = static_cast<int>(std::ranges::count(controls, key, &Control::key));
  int height = style.pitch;
  for (const Control& control : controls) {
    if (control.key != key) continue;
    ControlPlace at = placeInRow(control, x, baseline, style, parts);
    height = std::max(height, at.area.height);
    place(control.id(), std::move(at));
  }
  return baseline + height;
}

int ControlList::placeColumn(const Controls& controls, int x, int baseline, const RowStyle& style) {
  for (const Control& control : controls)
    if (control.part == 0) baseline = placeRow(controls, control.key, x, baseline, style);
  return baseline;
}

const ControlPlace* ControlList::find(ControlId id) const {
  const auto at = std::ranges::find(places_, id, &std::pair<ControlId, ControlPlace>::first);
  return at == places_.end() ? nullptr : &at->second;
}

Look ControlList::look(ControlId id) const {
  const bool hovered = state_.hovered && state_.hovered->id == id;
  return {.focused = state_.focus == id,
          .hovered = hovered,
          .dragged = state_.dragged == id,
          .option = hovered ? state_.hovered->option : -1};
}

void ControlList::draw(Pen& pen, const Controls& controls) {
  if (const Control* const control = focused(controls); control && control->kind != Kind::Number)
    if (const ControlPlace* const at = find(control->id()); at && !at->bare)
      drawFocus(pen, at->area, at->style.beyond);
  for (const auto& [id, at] : places_)
    if (const Control* const control = among(controls, id); control && !at.bare)
      drawControl(pen, *control, at, look(id));
  drawn_ = state_;
}

std::optional<ControlList::Hit> ControlList::at(int x, int y) const {
  for (const auto& [id, place] : places_)
    for (std::size_t k = 0; k < place.options.size(); ++k)
      if (place.options[k].has(x, y)) return Hit{id, static_cast<int>(k)};
  for (const bool above : {true, false})
    for (const auto& [id, place] : places_)
      if (place.above == above && (place.area.has(x, y) || place.grip.has(x, y)))
        return Hit{id, nearestOption(place, x, y), place.grip.has(x, y)};
  return std::nullopt;
}

bool ControlList::has(int x, int y) const {
  const std::optional<Hit> hit = at(x, y);
  return hit && !find(hit->id)->passive;
}

void ControlList::hover(const Controls& controls, int x, int y) {
  const std::optional<Hit> hit = at(x, y);
  state_.hovered = hit && among(controls, hit->id) ? hit : std::nullopt;
}

bool ControlList::grab(const Controls& controls, int x, int y) {
  hover(controls, x, y);
  x_ = x, y_ = y;
  if (!state_.hovered) return false;
  const Hit hit = *state_.hovered;
  const Control& control = *among(controls, hit.id);
  if (control.takesArrows() && !find(hit.id)->passive) state_.focus = hit.id;
  if (!control.enabled()) {
    prompt_.notify(control.off);
    return true;
  }
  // A click on a name or a value selects the control and does not change its value.
  if (hit.grip) {
    state_.dragged = hit.id;
    dragTo(controls, x, y);
    return true;
  }
  if (!control.takesArrows()) activate(control, hit.option);
  return true;
}

void ControlList::dragTo(const Controls& controls, int x, int y) {
  const Control* const control = among(controls, state_.dragged);
  const ControlPlace* const at = control ? find(control->id()) : nullptr;
  const int dx = x - std::exchange(x_, x), dy = y - std::exchange(y_, y);
  if (!at) return;
  if (control->drag) return control->drag(x, y, dx, dy);
  if (control->kind == Kind::Number) {
    if (dx != 0) control->set(stepped(control->range, control->value, dx));
  } else if (at->track.width > 1) {
    control->set(valueAt(control->range, double(x - at->track.x) / (at->track.width - 1)));
  }
}

const Control* ControlList::focused(const Controls& controls) const { return among(controls, state_.focus); }

const Control* ControlList::hovered(const Controls& controls) const {
  return state_.hovered ? among(controls, state_.hovered->id) : nullptr;
}

void ControlList::select(const Controls& controls, char key) {
  const int parts = static_cast<int>(std::ranges::count(controls, key, &Control::key));
  const bool again = state_.focus && state_.focus->key == key;
  state_.focus = {key, again ? (state_.focus->part + 1) % parts : 0};
}

void ControlList::selectNext(const Controls& controls, int direction) {
  std::vector<ControlId> all;
  for (const Control& control : controls)
    if (control.takesArrows()) all.push_back(control.id());
  if (all.empty()) return;
  const auto n = static_cast<std::ptrdiff_t>(all.size());
  const auto now = state_.focus ? std::ranges::find(all, *state_.focus) : all.end();
  const std::ptrdiff_t from = now != all.end() ? now - all.begin() : direction > 0 ? -1 : 0;
  state_.focus = all[static_cast<std::size_t>((from + direction + n) % n)];
}

void ControlList::move(const Control& control, int along, int up) {
  if (control.move)
    control.move(along, up);
  else
    control.set(stepped(control.range, control.value, along + up));
}

void ControlList::press(const Controls& controls, const Control& control) {
  if (control.takesArrows())
    select(controls, control.key);
  else
    activate(control);
}

void ControlList::askForValue(const Control& control) {
  const TrackRange range = control.range;
  const std::string low = textOf(range, range.low), high = textOf(range, range.high), name = control.label;
  prompt_.ask({.asks = name + ", " + low + " to " + high,
               .text = fixed(control.value, range.decimals),
               .take = [=, set = control.set, off = control.off](const std::string& text) -> std::string {
                 if (!off.empty()) return off;
                 const std::optional<double> value = typedNumber(text);
                 const bool whole = range.decimals == 0;
                 if (!value || !(*value >= range.low && *value <= range.high) ||
                     (whole && *value != std::round(*value)))
                   return name + (whole ? " is a whole number from " : " is a number from ") + low + " to " +
                          high + ".";
                 set(valueAt(range, shareOf(range, *value)));
                 return {};
               }});
}

std::string ControlList::focusOutOfSight(const Controls& controls) const {
  const Control* const now = focused(controls);
  if (!now || find(now->id())) return {};
  if (now->kind == Kind::Own) return now->words.empty() ? now->label : now->label + " " + now->words;
  return now->label + " " + textOf(now->range, now->value);
}

void ControlList::appendKeys(KeyTable& table, const Controls& controls) {
  KeyTable arrows, letters;
  const auto all = std::make_shared<const Controls>(controls);
  const std::string types = "type the value of the selected control";
  bool typed = false;
  if (const Control* const now = focused(*all)) {
    const auto arrow = [&](int along, int up) {
      return [this, all, now, along, up](const Key& key) {
        const int times = key.shift ? 10 : 1;
        move(*now, times * along, times * up);
      };
    };
    const std::string does = "change the selected control; Shift: ten steps";
    arrows = {{{NamedKey::Left}, now->label, does, arrow(-1, 0), now->off},
              {{NamedKey::Right}, now->label, does, arrow(1, 0), now->off},
              {{NamedKey::Up}, "", does, arrow(0, 1), now->off},
              {{NamedKey::Down}, "", does, arrow(0, -1), now->off}};
    if (now->set) {
      const auto setTo = [&](double value) { return [all, now, value](const Key&) { now->set(value); }; };
      const std::string ends = "its lowest and its highest value";
      arrows.push_back({{NamedKey::Home}, "", ends, setTo(now->range.low), now->off});
      arrows.push_back({{NamedKey::End}, "", ends, setTo(now->range.high), now->off});
      // The question opens also if the value has no effect now, so that digits never change the view.
      arrows.push_back({{'='}, "type", types, [this, all, now](const Key&) { askForValue(*now); }});
      typed = true;
    }
  }
  if (!typed && std::ranges::any_of(*all, [](const Control& one) { return one.takesArrows() && one.set; }))
    arrows.push_back(
        {{'='}, "", types, {}, "Select a control that has a value first: press its letter, or Tab."});
  if (std::ranges::any_of(*all, &Control::takesArrows))
    arrows.push_back(
        {{NamedKey::Tab}, "", "select the next control; Shift: the one before", [this, all](const Key& key) {
           selectNext(*all, key.shift ? -1 : 1);
         }});
  Controls lettered = *all;
  std::erase_if(lettered,
                [&](const Control& one) { return one.key == 0 || rowOf(table, one.key) != nullptr; });
  for (const Kind kind : {Kind::Slider, Kind::Number, Kind::Own, Kind::Choice, Kind::Toggle})
    for (const Control& control : lettered)
      if (control.kind == kind && control.part == 0)
        letters.push_back({{control.key},
                           control.legend,
                           wordsOf(lettered, control),
                           [this, all, id = control.id()](const Key&) { press(*all, *among(*all, id)); },
                           control.takesArrows() ? std::string{} : control.off});
  append(table, std::move(arrows));
  append(table, std::move(letters));
}

}  // namespace xnewell
