#include "x11/stepper/own_sort.h"

#include <algorithm>
#include <array>
#include <utility>

#include "shading/diagnose/pair_scene.h"
#include "x11/drawing/wording.h"
#include "x11/homework/reports.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

namespace {

/// "Test 3".
std::string testText(Test test) { return "Test " + std::string{shortNameOf(test)}; }

/// The page's name of a polygon, in a sentence: `polygon a`, `polygon a.b`, `face 12`, `face 12b`.
std::string polygonName(const Fragments& fragments, int id) {
  return (fragments.hasName(id) ? "polygon " : "") + fragments.name(id);
}

/// Why only a cut helps: "polygons must be painted a before b before c before a".
std::string circleText(const SortRun& run, const std::vector<int>& cycle) {
  constexpr std::size_t kMostNamed = 5;
  if (cycle.size() > kMostNamed)
    return std::to_string(cycle.size() - 1) + " polygons must each be painted before the next, in a circle";
  std::string way;
  for (const int number : cycle) {
    const auto& faces = run.scene().faces;
    const auto at = std::ranges::find(faces, number, &SnappedFace::number);
    way += (way.empty() ? "" : " before ") + run.name(static_cast<int>(at - faces.begin()));
  }
  return "polygons must be painted " + way;
}

}  // namespace

std::unique_ptr<SortRun> OwnSort::makeRun(std::uint8_t ground) const {
  auto run = std::make_unique<SortRun>(picture_, record_.sorted(), ground);
  run->goTo(run->steps());
  return run;
}

OwnSort::Reply OwnSort::refuse(std::string bold, std::string why) {
  score_.add(false);
  return {false, std::move(bold), std::move(why)};
}

OwnSort::Reply OwnSort::done(Reply reply, std::vector<SampleRow> spoilt) {
  score_.add(reply.valid);
  done_.back().after = events();
  done_.back().reply = reply;
  done_.back().spoilt = std::move(spoilt);
  return reply;
}

OwnSort::Reply OwnSort::paint(const SortRun& run, int P, int Q) {
  Hidden most;
  int covers = -1;
  std::vector<SampleRow> spoilt;
  for (const int R : run.waiting()) {
    if (R == P) continue;
    Hidden here = record_.hidden(P, R);
    spoilt.insert(spoilt.end(), here.rows.begin(), here.rows.end());
    if (here.samples > most.samples) most = std::move(here), covers = R;
  }
  const std::string name = capitalized(polygonName(run.fragments(), P));
  Reply reply{true, name + " is painted.", "No polygon that is left lies behind it at a common sample."};
  if (covers >= 0) {
    const std::array two{stepOf(run, covers), stepOf(run, P)};
    WrongPair pair{.shown = 0, .hidden = 1, .i = most.i, .j = most.j, .samples = most.samples};
    tellPair(picture_, two, pair, run.fragments().faceIndex(covers), run.fragments().faceIndex(P));
    const bool circle = pair.needsCut && pair.cycle.size() > 3;
    const std::string lesson =
        circle ? "Only a cut helps: " + circleText(run, pair.cycle) : capitalized(lessonOf(pair, two));
    reply = {false, name + " is painted too early.",
             "It is nearer than " + two[0].name + ", which is left to paint, at " + most.text() + ". " +
                 lesson + "."};
  }
  begin(P, Q);
  record_.paint(P);
  return done(std::move(reply), std::move(spoilt));
}

OwnSort::Reply OwnSort::tell(const SortRun& run, Test test, int P, int Q) {
  const Event compare{.kind = Event::Kind::Compare, .test = test, .P = P, .Q = Q};
  const std::string numbers = numbersOf(run.explainer(), compare, test).front();
  if (!record_.tests().passes(test, record_.shape(P), record_.shape(Q)))
    return {true, testText(test) + " does not tell.",
            std::string{questionOf(test)} + " No: " + numbers + ". That is no step, and does not count.",
            false};
  begin(P, Q);
  record_.take(P);
  record_.add(compare);
  return done({true, testText(test) + " tells: P may be painted before Q.",
               std::string{questionOf(test)} + " Yes: " + numbers + "."});
}

OwnSort::Reply OwnSort::move(const SortRun& run, int P, int Q) {
  if (const Hidden here = record_.hidden(Q, P); here.samples > 0)
    return refuse("Q is not moved.",
                  "Q is nearer than P at " + here.text() + ", so P must be painted before Q.");
  begin(P, Q);
  record_.move(P, Q);
  const std::string first = polygonName(run.fragments(), Q), old = polygonName(run.fragments(), P);
  return done({true, capitalized(first) + " goes first.",
               "It is nowhere nearer than " + old + ". It is P now; " + old + " is Q, and marked."});
}

OwnSort::Reply OwnSort::cut(int polygon, int by, bool isP) {
  if (!record_.crosses(polygon, by))
    return isP ? refuse("P is not cut.", "The plane of Q does not cross P.")
               : refuse("Q is not cut.", "The plane of P does not cross Q.");
  isP ? begin(polygon, by) : begin(by, polygon);
  const int behind = record_.cut(polygon, by);
  const Fragments now{picture_.scene().mesh, picture_.snapped(), record_.sorted()};
  return done({true, capitalized(polygonName(now, polygon)) + " is cut in two.",
               "The plane of " + polygonName(now, by) + " crosses it. Behind lies " +
                   polygonName(now, behind) + ", in front " + polygonName(now, behind + 1) + "."});
}

std::optional<std::pair<int, int>> OwnSort::undo() {
  if (done_.empty()) return std::nullopt;
  Done& last = done_.back();
  const std::pair pair{last.P, last.Q};
  record_.restore(std::move(last.before));
  done_.pop_back();
  return pair;
}

int OwnSort::lastPiece() const {
  const std::vector<Event>& events = record_.sorted().events;
  return events.empty() || events.back().kind != Event::Kind::Split ? -1 : record_.parts() - 2;
}

std::vector<SampleRow> OwnSort::spoilt(int events) const {
  std::vector<SampleRow> all;
  for (const Done& step : done_)
    if (step.after <= events) all.insert(all.end(), step.spoilt.begin(), step.spoilt.end());
  return all;
}

const OwnSort::Reply* OwnSort::replyAt(int events) const {
  const Reply* reply = nullptr;
  for (const Done& step : done_)
    if (step.after <= events) reply = &step.reply;
  return reply;
}

PaintStep OwnSort::stepOf(const SortRun& run, int id) const {
  const SnappedFace& face = run.fragments().face(id);
  const auto parts = std::ranges::count(picture_.snapped().faces, face.number, &SnappedFace::number);
  PaintStep step{.face = face.number, .name = polygonName(run.fragments(), id)};
  if (!run.fragments().isPiece(id) && parts == 1) return step;
  for (const Place& corner : outlineOf(run.fragments().region(id)))
    step.piece.push_back({corner.x, corner.y});
  return step;
}

std::vector<PaintStep> OwnSort::steps(const SortRun& run) const {
  std::vector<PaintStep> all;
  for (int n = 0; n < static_cast<int>(record_.sorted().fragments.size()); ++n) {
    all.push_back(stepOf(run, run.paintedId(n)));
    all.back().line = n + 2;  // the first has the size
  }
  return all;
}

}  // namespace xnewell
