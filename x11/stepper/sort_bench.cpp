#include "x11/stepper/sort_bench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_wording.h"
#include "x11/kit/typed_number.h"

namespace xnewell {

namespace {

constexpr int kShiftSteps = 10;

constexpr std::string_view kOwnLetters{"jJKg/bly+-"};
constexpr std::array kOwnKeys{NamedKey::Left, NamedKey::Right, NamedKey::Home, NamedKey::End,
                              NamedKey::Space};

}  // namespace

void SortBench::goTo(int step) {
  if (!run_) return;
  view_.step = std::clamp(step, 0, run_->steps());
  view_.answer.reset();
  view_.asking = view_.predict && view_.step > 0 && isQuestion(run_->sorted().events[view_.step - 1]);
}

void SortBench::stepBy(int steps) {
  view_.playing = false;
  // The first step forward answers the question.
  if (view_.asking && steps > 0) return reveal();
  goTo(view_.step + steps);
}

void SortBench::jump(bool forward) {
  if (!run_) return;
  view_.playing = false;
  const std::optional<int> step = forward ? run_->landmarks().next(view_.kind, view_.step)
                                          : run_->landmarks().previous(view_.kind, view_.step);
  const std::string name{kLandmarks[static_cast<int>(view_.kind)].name};
  if (step) return goTo(*step);
  host_.notify(run_->landmarks().steps(view_.kind).empty()
                   ? "This run has no " + name + " step; K chooses another kind."
                   : std::string{"There is no "} + name + " step " + (forward ? "after" : "before") +
                         " this one; K chooses another kind.");
}

void SortBench::goToPolygon(int number) {
  if (!run_) return;
  view_.playing = false;
  view_.polygon = number;
  const std::string face = "face " + std::to_string(number);
  if (const auto step = run_->landmarks().nextWith(run_->scene(), number, view_.step)) {
    goTo(*step);
    host_.tell("This is the next step with " + face + "; / and Return go to the one after it.");
  } else if (const auto first = run_->landmarks().nextWith(run_->scene(), number, 0)) {
    goTo(*first);
    host_.tell("No later step has " + face + ": this is the first that has it.");
  } else {
    host_.notify("No step has " + face + ": it is not visible, or no other polygon is as deep.");
  }
}

void SortBench::reveal() { view_.asking = false; }

void SortBench::answer(int which) {
  if (!view_.asking || !run_) return;
  view_.answer = static_cast<Verdict>(which);
  ++view_.asked;
  view_.right += *view_.answer == run_->sorted().events[view_.step - 1].verdict;
  reveal();
}

void SortBench::toggle(int index) {
  if (index == kPredict) {
    view_.predict = !view_.predict;
    if (!view_.predict) reveal();
    return;
  }
  view_.stops[index] = !view_.stops[index];
  if (index == kPolygonStop && view_.stops[index] && !view_.polygon) askPolygon();
}

void SortBench::speedUp(int notches) {
  const double factor = std::pow(2.0, notches / 2.0);
  view_.speed = std::clamp(view_.speed * factor, kSlowest, kFastest);
}

void SortBench::push(Transport button) {
  switch (button) {
    case Transport::Start:
      return stepBy(-view_.step);
    case Transport::TenBack:
      return stepBy(-kShiftSteps);
    case Transport::Back:
      return stepBy(-1);
    case Transport::Play:
      if (run_ && !view_.playing && view_.step == run_->steps()) goTo(0);
      if (view_.asking) reveal();
      view_.playing = run_ && !view_.playing && run_->steps() > 0;
      due_ = 0;
      return;
    case Transport::Forward:
      return stepBy(1);
    case Transport::TenForward:
      return stepBy(kShiftSteps);
    case Transport::End:
      if (!run_) return;
      view_.playing = false;
      return goTo(run_->steps());
  }
}

bool SortBench::stopsAt(int step) const {
  const Event& e = run_->sorted().events[step - 1];
  if (view_.predict && isQuestion(e)) return true;
  const std::optional<Landmark> kind = landmarkOf(e);
  if (kind && view_.stops[static_cast<int>(*kind)]) return true;
  return view_.stops[kPolygonStop] && view_.polygon &&
         run_->landmarks().has(run_->scene(), *view_.polygon, step);
}

void SortBench::tick() {
  if (!view_.playing || !run_) return;
  due_ += view_.speed * kTick / 1000.0;
  while (due_ >= 1.0 && view_.playing) {
    due_ -= 1.0;
    goTo(view_.step + 1);
    view_.playing = view_.step < run_->steps() && !stopsAt(view_.step);
  }
}

void SortBench::askStep() {
  if (!run_) return;
  view_.playing = false;
  host_.ask({.asks = "go to step, 0 to " + std::to_string(run_->steps()),
             .take = [this](const std::string& text) -> std::string {
               const std::optional<int> step = wholeNumber(text);
               if (!step || *step < 0 || *step > run_->steps())
                 return "A step is a whole number from 0 to " + std::to_string(run_->steps()) + ".";
               goTo(*step);
               return "";
             }});
}

void SortBench::askPolygon() {
  if (!run_) return;
  host_.ask({.asks = "go to the next step with face number",
             .text = view_.polygon ? std::to_string(*view_.polygon) : "",
             .take = [this](const std::string& text) -> std::string {
               // A piece, 12a or 12.1, counts as its face.
               const std::optional<int> number =
                   wholeNumber(text.substr(0, text.find_first_not_of("0123456789")));
               const auto& faces = run_->scene().faces;
               if (!number || std::ranges::find(faces, *number, &SnappedFace::number) == faces.end())
                 return "No face with that number is in the picture; the list shows some.";
               goToPolygon(*number);
               return "";
             }});
}

bool SortBench::pressNamed(const Key& key) {
  const int times = key.shift ? kShiftSteps : 1;
  switch (key.name) {
    case NamedKey::Left:
      return stepBy(-times), true;
    case NamedKey::Right:
      return stepBy(times), true;
    case NamedKey::Home:
      return push(Transport::Start), true;
    case NamedKey::End:
      return push(Transport::End), true;
    case NamedKey::Space:
      return push(Transport::Play), true;
    case NamedKey::Return:
      if (!view_.asking) return false;
      return reveal(), true;
    case NamedKey::Escape:
      if (!view_.playing && !view_.numbered) return false;
      view_.playing = view_.numbered = false;
      return true;
    default:
      return false;
  }
}

bool SortBench::press(const Key& key, const Setup&) {
  if (!run_) {
    // Keys typed before the run is recorded wait for it.
    const bool waits =
        !tooLong_ && (key.name == NamedKey::Letter ? kOwnLetters.find(key.letter) != std::string_view::npos
                                                   : std::ranges::find(kOwnKeys, key.name) != kOwnKeys.end());
    if (waits) early_.push_back(key);
    return waits;
  }
  // After `b` a digit ticks a box; any other key does what it always does.
  if (view_.numbered) {
    view_.numbered = false;
    if (key.name == NamedKey::Letter && key.letter >= '1' && key.letter < '1' + kStops)
      return toggle(key.letter - '1'), true;
    if (key.name == NamedKey::Escape || (key.name == NamedKey::Letter && key.letter == 'b')) return true;
  }
  if (key.name != NamedKey::Letter) return pressNamed(key);
  if (view_.asking) {
    const auto* const which = std::ranges::find(kAnswerKeys, key.letter);
    if (which != kAnswerKeys.end()) return answer(static_cast<int>(which - kAnswerKeys.begin())), true;
  }
  switch (key.letter) {
    case 'j':
      return jump(true), true;
    case 'J':
      return jump(false), true;
    case 'K':
      view_.kind =
          static_cast<Landmark>((static_cast<int>(view_.kind) + 1) % static_cast<int>(kLandmarks.size()));
      return true;
    case 'g':
      return askStep(), true;
    case '/':
      return askPolygon(), true;
    case 'b':
      view_.numbered = true;
      return true;
    case 'l':
      return view_.loupe = !view_.loupe, true;
    case 'y':
      return toggle(kPredict), true;
    case '+':
      return speedUp(1), true;
    case '-':
      return speedUp(-1), true;
    default:
      return false;
  }
}

void SortBench::hover(int x, int y) {
  if (!run_) return;
  SortSpot spot = spotAt(at_, x, y);
  // A polygon or a place on the timeline is not highlighted.
  if (spot.part == SortPart::Picture || spot.part == SortPart::Timeline) spot = {};
  if (spot.part == SortPart::Row &&
      (spot.index >= static_cast<int>(places_.rows.size()) || places_.rows[spot.index] < 0))
    spot = {};
  if (spot.part == SortPart::Answer && !view_.asking) spot = {};
  view_.hover = spot;
}

void SortBench::clickPicture(int x, int y) {
  if (places_.loupe.has(x, y)) return;
  const int id = run_->fragmentAt(x - at_.picture.x, y - at_.picture.y);
  if (id >= 0)
    goToPolygon(run_->fragments().face(id).number);
  else
    host_.notify("There is no polygon there.");
}

void SortBench::click(const SortSpot& spot, int x, int y) {
  switch (spot.part) {
    case SortPart::Picture:
      return clickPicture(x, y);
    case SortPart::Row:
      if (spot.index < static_cast<int>(places_.rows.size()) && places_.rows[spot.index] >= 0)
        goToPolygon(run_->fragments().face(places_.rows[spot.index]).number);
      return;
    case SortPart::Toggle:
      return toggle(spot.index);
    case SortPart::Transport:
      return push(static_cast<Transport>(spot.index));
    case SortPart::Kind:
      view_.kind = static_cast<Landmark>(spot.index);
      return jump(true);
    case SortPart::Answer:
      return answer(spot.index);
    case SortPart::Nothing:
    case SortPart::Speed:
    case SortPart::Timeline:
      return;
  }
}

bool SortBench::grab(int x, int y) {
  if (!run_) return false;
  view_.numbered = false;
  const SortSpot spot = spotAt(at_, x, y);
  if (spot.part != SortPart::Speed && spot.part != SortPart::Timeline) {
    click(spot, x, y);
    return false;
  }
  dragged_ = spot.part;
  view_.dragged = spot.part == SortPart::Speed;
  dragTo(x, y);
  return true;
}

void SortBench::dragTo(int x, int) {
  if (!run_) return;
  if (dragged_ == SortPart::Timeline) {
    view_.playing = false;
    goTo(stepAt(at_.timeline, x, run_->steps()));
  } else if (dragged_ == SortPart::Speed) {
    view_.speed = speedAt(at_.speed, x);
  }
}

void SortBench::drop() {
  dragged_ = SortPart::Nothing;
  view_.dragged = false;
}

void SortBench::leave() {
  view_.playing = view_.numbered = false;
  view_.hover = {};
  drop();
  // Another view makes the picture at its own size, so this run is no longer valid.
  run_.reset();
  tooLong_ = false;
  early_.clear();
  drawn_.reset();
  fullColor_ = false;
}

}  // namespace xnewell
