#include "x11/stepper/sort_player.h"

#include <algorithm>

#include "x11/kit/typed_line.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

void SortPlayer::goTo(int step) {
  if (!run) return;  // a question may outlast it
  view.step = std::clamp(step, 0, run->steps());
  view.answer.reset();
  view.asking = view.predict && !view.own && view.step > 0 && asks(view.step);
}

bool SortPlayer::asks(int step) const {
  const std::vector<Event>& events = run->sorted().events;
  const Event& e = events[step - 1];
  if (!isQuestion(e) || !run->theirs() || step == 1) return isQuestion(e);
  const Event& before = events[step - 2];  // their tests of one pair are one question
  return !isQuestion(before) || before.P != e.P || before.Q != e.Q;
}

void SortPlayer::moveTo(int step) {
  view.playing = false;
  goTo(step);
}

void SortPlayer::stepBy(int steps) {
  if (view.asking && steps > 0)
    view.playing = view.asking = false;
  else
    moveTo(view.step + steps);
}

std::optional<int> SortPlayer::stepOfKind(bool forward) const {
  const Landmarks& landmarks = run->landmarks();
  return forward ? landmarks.next(view.kind, view.step) : landmarks.previous(view.kind, view.step);
}

std::string SortPlayer::whyNoJump(bool forward) const {
  if (stepOfKind(forward)) return {};
  const std::string step = std::string{nameOf(*run, view.kind)} + " step";
  return (run->landmarks().steps(view.kind).empty()
              ? "This run has no " + step
              : "There is no " + step + (forward ? " after" : " before") + " this one") +
         "; K chooses another kind.";
}

void SortPlayer::jump(bool forward) {
  view.playing = false;
  if (const std::optional<int> step = stepOfKind(forward))
    goTo(*step);
  else
    prompt_.notify(whyNoJump(forward));
}

void SortPlayer::goToPolygon(int number) {
  view.playing = false;
  view.polygon = number;
  const std::string face = "face " + std::to_string(number);
  if (const auto step = run->landmarks().nextWith(run->scene(), number, view.step)) {
    goTo(*step);
    prompt_.tell("This is the next step with " + face + "; / and Return go to the one after it.");
  } else if (const auto first = run->landmarks().nextWith(run->scene(), number, 0)) {
    goTo(*first);
    prompt_.tell("No later step has " + face + ": this is the first that has it.");
  } else {
    prompt_.notify("No step has " + face + ": it is not visible, or no other polygon is as deep.");
  }
}

void SortPlayer::askPolygon() {
  prompt_.ask({.asks = "go to the next step with face number",
               .text = view.polygon ? std::to_string(*view.polygon) : "",
               .take = [this](const std::string& text) -> std::string {
                 if (!run) return "There is no run.";
                 // A piece, 12a or 12.1, counts as its face.
                 const std::optional<int> number =
                     wholeNumber(text.substr(0, text.find_first_not_of("0123456789")));
                 const auto& faces = run->scene().faces;
                 if (!number || std::ranges::find(faces, *number, &SnappedFace::number) == faces.end())
                   return "No face with that number is in the picture; the list shows some.";
                 goToPolygon(*number);
                 return "";
               }});
}

void SortPlayer::toggle(int index) {
  if (index == kPredict) {
    view.predict = !view.predict;
    if (!view.predict) view.asking = false;
    return;
  }
  view.stops[index] = !view.stops[index];
  if (index == kPolygonStop && view.stops[index] && !view.polygon) askPolygon();
}

void SortPlayer::answer(int which) {
  view.answer = static_cast<Verdict>(which);
  view.score.add(*view.answer == run->verdict());
  view.asking = false;
}

void SortPlayer::play() {
  if (!view.playing && view.step == run->steps()) goTo(0);
  view.asking = false;
  view.playing = !view.playing && run->steps() > 0;
  clock_.restart();
}

bool SortPlayer::stopsAt(int step) const {
  if (view.predict && !view.own && asks(step)) return true;
  for (const LandmarkRow& row : kLandmarks)
    if (view.stops[static_cast<int>(row.id)] &&
        std::ranges::binary_search(run->landmarks().steps(row.id), step))
      return true;
  return view.stops[kPolygonStop] && view.polygon && run->landmarks().has(run->scene(), *view.polygon, step);
}

void SortPlayer::tick() {
  if (!view.playing) return;
  clock_.tick(view.speed);
  while (view.playing && clock_.takeStep()) {
    goTo(view.step + 1);
    view.playing = view.step < run->steps() && !stopsAt(view.step);
  }
}

}  // namespace xnewell
