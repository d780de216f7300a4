#include "x11/stepper/own_sort.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/files/output_file.h"
#include "shading/diagnose/scene_for.h"
#include "x11/drawing/wording.h"
#include "x11/homework/reports.h"
#include "x11/kit/typed_line.h"
#include "x11/options/setup_command.h"
#include "x11/options/shell_words.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_picture.h"
#include "x11/stepper/sort_view.h"
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

/// The part of the stepper's view in which the student sorts.

void SortView::sortOneself(bool on) {
  SortState& view = player_.view;
  view.playing = view.asking = false;
  if (!on) {
    if (newell_) player_.run = std::move(newell_);  // else it is recorded when the view is shown
    view.own.reset();
    view.step = newellStep_;
    return goTo(newellStep_);
  }
  if (!run()) return;
  newellStep_ = view.step;
  newell_ = std::move(player_.run);
  view.own.emplace();
  if (!own_) own_ = std::make_unique<OwnSort>(newell_->picture(), newell_->sorted().list);
  showOwn(-1, -1,
          {true, "What comes first?",
           "The list is sorted by farthest z. Choose P and Q. Then make a test, move Q, cut one of them, or "
           "paint P. Each step that is true is taken."});
}

void SortView::showOwn(int P, int Q, const OwnSort::Reply& reply) {
  SortState& view = player_.view;
  OwnState& own = *view.own;
  player_.run = own_->makeRun(ground_);
  view.step = run()->steps();
  endReply_ = reply;
  own.score = own_->score();
  if (P < 0 && own_->marked() >= 0) P = own_->marked();
  choose(P, Q);
  if (own.P < 0 && own_->events() > 0) {
    const OrderReport report = ownReport();
    endReply_ = {
        report.isRight(),
        std::string{"All is painted, and the picture is "} + (report.isRight() ? "right." : "wrong."),
        "The judge says " + verdictOf(report, own_->steps(*run())) + "."};
  }
  tellOwn();
}

OrderReport SortView::ownReport() const {
  return judgeOrder(player_.run->picture(), own_->steps(*player_.run));
}

/// Chooses P and Q; -1, or what is not there, for the first that is left, and for the next that overlaps P
/// in z.
void SortView::choose(int P, int Q) {
  OwnState& own = *player_.view.own;
  const std::vector<int> left = run()->waiting();
  const auto isLeft = [&](int id) { return std::ranges::find(left, id) != left.end(); };
  if (!isLeft(P)) P = left.empty() ? -1 : left.front();
  if (Q == P || !isLeft(Q)) Q = -1;
  if (own.P != P || own.Q != Q) own.passed.fill(std::nullopt);
  own.P = P, own.Q = Q;
  if (P >= 0 && Q < 0) chooseQ(1);
}

void SortView::chooseP(int along) {
  const std::vector<int> left = run()->waiting();
  const auto at = std::ranges::find(left, view().own->P) - left.begin() + along;
  if (at < 0 || at >= std::ssize(left))
    return host_.notify(along < 0 ? "P is the first of the list." : "P is the last of the list.");
  choose(left[at], -1);
}

/// The next polygon of the list that overlaps P in z, all around; if none does, the next.
void SortView::chooseQ(int along) {
  OwnState& own = *player_.view.own;
  const std::vector<int> left = run()->waiting();
  const int count = static_cast<int>(left.size());
  if (count < 2) return;
  const auto placeOf = [&](int id) { return static_cast<int>(std::ranges::find(left, id) - left.begin()); };
  const int from = placeOf(own.Q >= 0 ? own.Q : own.P);
  const auto at = [&](int k) { return left[((from + along * k) % count + count) % count]; };
  int next = -1;
  for (int k = 1; k <= count && next < 0; ++k)
    if (at(k) != own.P && run()->zExtent(at(k)).overlaps(run()->zExtent(own.P))) next = at(k);
  for (int k = 1; k <= count && next < 0; ++k)
    if (at(k) != own.P) next = at(k);
  if (next != own.Q) own.passed.fill(std::nullopt);
  own.Q = next;
}

void SortView::chooseAt(int column, int row) {
  std::vector<int> here;
  for (const int id : run()->waiting())
    if (owns(run()->scene(), run()->sorted(), fragmentOf(run()->scene(), run()->sorted(), id), column, row))
      here.push_back(id);
  if (here.empty()) return host_.notify("No polygon that is left to paint is there.");
  const int now = view().own->clicksQ ? view().own->Q : view().own->P;
  const auto at = std::ranges::find(here, now);
  chooseClicked(at == here.end() || at + 1 == here.end() ? here.front() : *(at + 1));
}

void SortView::chooseClicked(int id) {
  const OwnState& own = *view().own;
  player_.moveTo(run()->steps());
  if (const std::vector<int> left = run()->waiting(); std::ranges::find(left, id) == left.end())
    return host_.notify("That polygon is painted.");
  if (own.clicksQ && id == own.P) return host_.notify("That polygon is P.");
  own.clicksQ ? choose(own.P, id) : choose(id, id == own.P ? own.Q : -1);
}

void SortView::act(int index) {
  const int P = view().own->P, Q = view().own->Q;
  OwnSort::Reply reply;
  int nextP = P, nextQ = Q;
  switch (index) {
    case 0:
      reply = own_->paint(*run(), P, Q);
      nextP = nextQ = -1;
      break;
    case 1:
      reply = own_->move(*run(), P, Q);
      if (reply.valid) nextP = Q, nextQ = P;
      break;
    default:
      reply = index == 2 ? own_->cut(P, Q, true) : own_->cut(Q, P, false);
      if (reply.valid) (index == 2 ? nextP : nextQ) = own_->lastPiece();
  }
  showOwn(nextP, nextQ, reply);
}

void SortView::tellTest(int index) {
  const int P = view().own->P, Q = view().own->Q;
  const auto known = view().own->passed;
  const OwnSort::Reply reply = own_->tell(*run(), testAt(index), P, Q);
  showOwn(P, Q, reply);
  player_.view.own->passed = known;
  player_.view.own->passed[index] = reply.told;
}

void SortView::undoOwn() {
  const auto pair = own_->undo();
  if (!pair) return host_.notify("There is no step to take back.");
  showOwn(pair->first, pair->second,
          {true, "The last step is taken back.", "The count of valid steps stays."});
}

void SortView::tellOwn() {
  OwnState& own = *player_.view.own;
  const bool atEnd = view().step == run()->steps();
  static const OwnSort::Reply kStart{true, "Nothing is painted yet.", "This is the start of your sort."};
  const OwnSort::Reply* const then = atEnd ? &endReply_ : own_->replyAt(view().step);
  const OwnSort::Reply& reply = then ? *then : kStart;
  own.bold = reply.bold, own.why = reply.why, own.alarm = !reply.valid;
  own.spoilt = own_->spoilt(view().step);
}

void SortView::addOwnControls(Controls& all) {
  const auto add = [&](SortPart part, int index, char key) {
    all.push_back({.kind = Control::Kind::Button,
                   .part = sortId(part, index).part,
                   .set = [this, key](double) { (void)pressIn(ownKeys(), key, host_); }});
  };
  for (int k = 0; k < static_cast<int>(kActs.size()); ++k) add(SortPart::Act, k, kActKeys[k]);
  for (int k = 0; k < kOwnTests; ++k)
    all.push_back(
        {.kind = Control::Kind::Button, .part = sortId(SortPart::Test, k).part, .set = [this, k](double) {
           player_.view.own->naming = true;
           (void)pressIn(ownKeys(), static_cast<char>('1' + k), host_);
           player_.view.own->naming = false;
         }});
}

void SortView::addOwnKeys(KeyTable& table) {
  OwnState& own = *player_.view.own;
  const std::string past = run() && view().step < run()->steps()
                               ? "This is an earlier step of your sort; End goes on with it."
                               : "";
  const std::string noP = !past.empty() ? past : own.P < 0 ? "No polygon is left to paint." : "";
  const std::string noQ = !noP.empty() ? noP : own.Q < 0 ? "P is the only polygon that is left." : "";
  const auto add = [&](std::vector<Key> keys, std::string legend, const char* does, const std::string& off,
                       std::function<void(const Key&)> doIt) {
    append(table, {{std::move(keys), std::move(legend), does, std::move(doIt), off}});
  };
  for (int k = 0; own.naming && k < kOwnTests; ++k)
    add({static_cast<char>('1' + k)}, "make it", "make this test", noQ,
        [this, k](const Key&) { tellTest(k); });
  // Keys of one purpose share a line in the list of all keys.
  const char* const choosesQ = "choose the next Q, the one before; let clicks choose Q";
  const char* const steps = "paint P; move Q before P; cut P by Q's plane, Q by P's";
  const char* const keeps = "take the last step back; write your order for `xnewell judge`";
  add({NamedKey::Up, NamedKey::Down}, "P", "choose P, up or down the list", noP,
      [this](const Key& key) { chooseP(key.name == NamedKey::Up ? -1 : 1); });
  add({'n'}, "Q", choosesQ, noQ, [this](const Key&) { chooseQ(1); });
  add({'N'}, "Q", choosesQ, noQ, [this](const Key&) { chooseQ(-1); });
  add({'k'}, "click: P, Q", choosesQ, "", [&own](const Key&) { own.clicksQ = !own.clicksQ; });
  add({'t'}, "test", "and 1 to 5: make a test; one that tells that P may be painted before Q is a step", noQ,
      [&own](const Key&) { own.naming = true; });
  for (int k = 0; k < static_cast<int>(kActs.size()); ++k)
    add({kActKeys[k]},
        k == 0   ? "paint"
        : k == 1 ? "move"
        : k == 2 ? "cut P"
                 : "cut Q",
        steps, k == 0 ? noP : noQ, [this, k](const Key&) { act(k); });
  add({NamedKey::Backspace}, "take back", keeps, past, [this](const Key&) { undoOwn(); });
  add({'o'}, "write", keeps, run() && own_ && own_->steps(*run()).empty() ? "Nothing is painted yet." : "",
      [this](const Key&) { askToWrite(); });
}

/// Without --size, which the file says.
std::string SortView::judgeCommand(const std::string& what) const {
  constexpr std::string_view kDraw = "xnewell draw ", kTo = " -o picture.png";
  const PictureSettings& settings = picture_->settings();
  const std::string size =
      " --size " + std::to_string(settings.width) + 'x' + std::to_string(settings.height);
  std::string command;
  try {
    command = SetupCommand{picture_->scene()}.of(settings, picture_->scene().divisions);
  } catch (const std::exception&) {  // its file may have gone, or no options can say the camera
    return "";
  }
  if (!command.starts_with(kDraw) || !command.ends_with(kTo)) return "";
  if (const std::size_t at = command.find(size); at != std::string::npos) command.erase(at, size.size());
  return "xnewell judge " + command.substr(kDraw.size(), command.size() - kDraw.size() - kTo.size()) + ' ' +
         what;
}

void SortView::askToWrite() {
  host_.ask(fileQuestion(
      "write your order as", "order.jsonl",
      [this](const std::string& file) {
        // The picture may be another one by now.
        if (!view().own || own_->steps(*run()).empty()) return "Nothing is painted yet.";
        return file.ends_with(".jsonl") ? "" : "An order's name ends in .jsonl.";
      },
      [this](const std::string& file) {
        const std::vector<PaintStep> steps = own_->steps(*run());
        const glm::ivec2 size{picture_->settings().width, picture_->settings().height};
        writeFile(file, paintOrderText(steps, size));
        judges_ = judgeCommand(quoted(file));
        host_.tell(file + " is written: " + counted(std::ssize(steps), "step") + " in a picture of " +
                   sizeText(size.x, size.y) + "; C copies the command that judges it.");
      }));
}

}  // namespace xnewell
