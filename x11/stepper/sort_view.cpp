#include "x11/stepper/sort_view.h"

#include <algorithm>
#include <utility>

#include "geometry/files/parse_error.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"
#include "x11/options/shell_words.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_wording.h"
#include "x11/window/layout.h"

namespace xnewell {

Control SortView::timeline() {
  return timelineControl(
      {view().step, run()->steps()}, [this](int step) { player_.moveTo(step); },
      [this](int steps) { player_.stepBy(steps); });
}

Controls SortView::controls() {
  Controls all;
  if (drawer_ == Drawer::Shut)
    all.push_back(handleControl([this](char letter) { host_.pressLetter(letter); }));
  if (!run()) return all;
  SortState& view = player_.view;
  Control kinds = kindsControl(*run(), view);
  kinds.set = [this, &view](double kind) {
    view.kind = static_cast<Landmark>(kind);
    player_.jump(true);
  };
  for (Control& control : transportControls(
           {view.step, run()->steps()}, std::move(kinds), view.speed,
           [this](int step) { player_.moveTo(step); }, [this](int steps) { player_.stepBy(steps); },
           [this](const Key& key) { (void)pressIn(ownKeys(), key, host_); }))
    all.push_back(std::move(control));
  for (int k = 0; k < kToggleCount; ++k) {
    all.push_back(toggleControl(view, k));
    all.back().set = [this, k](double) { k == kOwn ? sortOneself(!this->view().own) : player_.toggle(k); };
  }
  const auto add = [&](SortPart part, int index, const std::function<void()>& act) {
    all.push_back(
        {.kind = Control::Kind::Button, .part = sortId(part, index).part, .set = [act](double) { act(); }});
  };
  for (int k = 0; view.asking && k < static_cast<int>(kAnswers.size()); ++k)
    add(SortPart::Answer, k, [this, k] { player_.answer(k); });
  for (int k = 0; k < static_cast<int>(places_.rows.size()); ++k)
    if (const int id = places_.rows[k]; id >= 0)
      add(SortPart::Row, k, [this, id] { this->view().own ? chooseClicked(id) : goToFaceOf(id); });
  for (int k = 0; k < static_cast<int>(places_.ring.size()); ++k)
    add(SortPart::Ring, k,
        [this, to = places_.ring[k]] { to.id >= 0 ? goToFaceOf(to.id) : player_.moveTo(to.step); });
  if (view.own) addOwnControls(all);
  return all;
}

KeyTable SortView::ownKeys() {
  SortState& view = player_.view;
  KeyTable table;
  const auto add = [&](Key key, std::string legend, const char* does, std::string off, auto act) {
    append(table, {{{key}, std::move(legend), does, [act](const Key&) { act(); }, std::move(off)}});
  };
  if (view.own) addOwnKeys(table);
  // Both keys share a line in the list of all keys.
  const char* const learns = "predict what follows; sort it yourself; or no longer";
  if (view.asking) {
    for (std::size_t k = 0; k < kAnswers.size(); ++k)
      add(kAnswerKeys[k], std::string{kAnswers[k]}, "answer what follows", "",
          [this, k] { player_.answer(static_cast<int>(k)); });
    add(NamedKey::Return, "show", "show what follows", "", [&view] { view.asking = false; });
    add('y', "stop predicting", "predict no longer", "", [this] { player_.toggle(kPredict); });
  }
  for (int k = 0; view.numbered && k < kStops; ++k)
    add(static_cast<char>('1' + k), "tick a box", "tick a box", "", [this, k] { player_.toggle(k); });
  const bool names = view.own && view.own->naming;
  const std::string none = names ? "There are five tests, 1 to 5." : "There are six boxes, 1 to 6.";
  if (view.numbered || names)  // the digits of the other views wait for the next key
    for (const char digit : std::string_view{"1234567890"})
      append(table, {{.keys = {digit}, .does = none, .off = none}});

  const bool rests = run() && !view.playing;
  appendTransportKeys(
      table, view.playing,
      {.by = [this](int steps) { player_.stepBy(steps); },
       .play = [this] { player_.play(); },
       .start = [this] { player_.moveTo(0); },
       .end = [this] { player_.moveTo(run()->steps()); },
       .jump = [this](bool forward) { player_.jump(forward); },
       .nextKind =
           [&view] {
             view.kind = static_cast<Landmark>((static_cast<std::size_t>(view.kind) + 1) % kLandmarks.size());
           },
       .askStep =
           [this] {
             player_.view.playing = false;
             list_.askForValue(timeline());
           },
       .whyNoJump = [&](bool forward) { return run() ? player_.whyNoJump(forward) : ""; },
       .nothing = run() && run()->steps() == 0 ? "There is nothing to sort." : "",
       .atStart = rests && view.step == 0,
       .atEnd = rests && !view.asking && view.step == run()->steps()});
  if (!view.own) {
    add('/', "polygon", "go to the next step with a polygon", "", [this] { player_.askPolygon(); });
    add('b', "stop at", "and 1 to 6: tick what playing stops at", "",
        [&view, on = !view.numbered] { view.numbered = on; });
    add('y', "predict", learns, "", [this] { player_.toggle(kPredict); });
  }
  add('Y', view.own ? "Newell's sort" : "by hand", view.own ? "go back to the program's sort" : learns, "",
      [this] { sortOneself(!player_.view.own); });
  if (!view.own) {
    appendSpeedKeys(table, view.speed);
    add(kCodeKey, "", kCodeDoes,
        drawer_ == Drawer::Shut ? "The column of the book's lines is put away; D brings it back." : "",
        [&view] { view.code = !view.code; });
  }
  add('l', "", "show the loupe, or put it away", "", [&view] { view.loupe = !view.loupe; });
  if (view.playing || view.numbered || list_.focus() == transportId(TransportPart::Speed))
    add(NamedKey::Escape, "", "stop playing; select the timeline again", "", [this] {
      player_.view.playing = false;
      list_.setFocus(transportId(TransportPart::Timeline));
    });
  else if (view.own)
    add(NamedKey::Escape, "leave", "go back to the program's sort", "", [this] { sortOneself(false); });
  if (part_ && !view.playing && !view.numbered)
    add(NamedKey::Escape, "the whole picture", "leave the part that is sorted", "",
        [this] { part_.reset(); });
  table.push_back({.does = view.own ? "choose a polygon; make a test; do a step"
                                    : "go to the next step with a polygon; tick a box",
                   .gesture = "click"});
  for (KeyRow& row : table) row.waits = !run() && !tooLong_;
  if (tooLong_)
    for (KeyRow& row : table) row.legend.clear(), row.off = "This run is too long to step through.";
  if (tooLong_)
    table.push_back(
        {.legend = "sort there", .does = "sort only the polygons around that place", .gesture = "click"});
  return table;
}

bool SortView::press(const Key& key) {
  const KeyTable table = keys();
  player_.view.numbered = false;                           // the boxes have digits for one key only
  if (player_.view.own) player_.view.own->naming = false;  // and so have the tests
  return pressIn(table, key, host_);
}

bool SortView::grab(int x, int y) {
  if (tooLong_ && at_.picture.has(x, y)) choosePart(sampleAt(x, y));
  player_.view.numbered = false;
  if (player_.view.own) player_.view.own->naming = false;
  if (!run()) return list_.grab(controls(), x, y) && list_.dragging();
  if (list_.grab(controls(), x, y)) return list_.dragging();
  if (!at_.picture.has(x, y) || places_.loupe.has(x, y)) return false;
  const glm::ivec2 sample = sampleAt(x, y);
  if (view().own) {
    chooseAt(sample.x, sample.y);
    return false;
  }
  if (const int id = run()->fragmentAt(sample.x, sample.y); id >= 0)
    goToFaceOf(id);
  else
    host_.notify("There is no polygon there.");
  return false;
}

glm::ivec2 SortView::sampleAt(int x, int y) const {
  const PictureSettings& size = picture_->settings();
  return {(2 * (x - at_.picture.x) + 1) * size.width / (2 * at_.picture.width),
          (2 * (y - at_.picture.y) + 1) * size.height / (2 * at_.picture.height)};
}

void SortView::choosePart(glm::ivec2 sample) {
  constexpr std::int64_t kMost = 1000;  // so that the run, which grows with their square, stays short
  const glm::ivec2 size{picture_->settings().width, picture_->settings().height};
  for (int half = std::max(size.x, size.y) / 2; half > 0; half /= 2) {
    const Part part{glm::max(sample - half, glm::ivec2{0}), glm::min(sample + half, size)};
    const std::int64_t faces = picture_->facesWithin(part.low, part.high);
    if (faces > kMost) continue;
    if (faces == 0) return host_.notify("There is no polygon there.");
    part_ = part;
    return;
  }
  host_.notify("More than " + grouped(kMost) + " polygons lie there, one over the other.");
}

void SortView::goToFaceOf(int id) { player_.goToPolygon(run()->fragments().face(id).number); }

void SortView::enter() { list_.setFocus(transportId(TransportPart::Timeline)); }

bool SortView::reset() {
  if (!view().own) return false;
  sortOneself(false);
  return true;
}

void SortView::leave() {
  WindowView::leave();
  player_.view.playing = player_.view.numbered = false;
  // It needs much memory, and is soon made again.
  player_.run.reset();
  newell_.reset();
  tooLong_ = fullColor_ = false;
  drawn_.reset();
}

Setup SortView::painted(const Setup& setup) const {
  Setup newell = setup;
  newell.picture.order = Order::Newell;
  newell.picture.inPixels = false;
  // In full colour a picture chooses its colours after all of it is painted, but a run is painted piece by
  // piece.
  if (fullColor_) newell.picture.colors = ColorPlan::OneHue;
  newell.fill = Fill::Scanline;
  return newell;
}

void SortView::open(const std::string& file, const Scene& scene) {
  RunFile run{file};
  if (run.lines() > SortRun::kMostEvents)
    throw ParseError{file, 0,
                     "more than " + grouped(SortRun::kMostEvents) +
                         " lines, too many to step through; xnewell judge --run reads them"};
  PictureSettings settings = host_.setup().picture;
  const glm::ivec2 size = run.size().value_or(kPictureSize);
  settings.width = size.x, settings.height = size.y;
  settings.order = Order::Unsorted, settings.adapt = 0;
  Picture picture = makePicture(scene, settings).withPlanes();
  RunReport report = judgeRun(picture, run);
  theirs_ = std::make_shared<const JudgedRun>(std::move(run), std::move(picture), std::move(report));
  player_.run.reset(), about_.reset(), drawn_.reset();
  player_.view.step = 0;
}

Rect SortView::theirPicture(const Rect& room, int unit) const {
  const PictureSettings& size = theirs_->picture.settings();
  const double most = std::min(1.0 * room.width * unit / size.width, 1.0 * room.height * unit / size.height);
  const auto side = [&](int pixels) {
    return std::max(1, static_cast<int>(std::min(1.0, most) * pixels / unit));
  };
  const int width = side(size.width), height = side(size.height);
  return {room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height};
}

void SortView::record(const DrawContext& context) {
  SortState& view = player_.view;
  const bool sameScene = picture_ && &picture_->scene() == &context.picture.scene();
  const bool same = sameScene && picture_->snapped().vertices == context.picture.snapped().vertices;
  if (!sameScene) part_.reset();
  if (!sameScene && picture_) theirs_.reset();
  const bool theirs = showsTheirs();
  if ((run() || tooLong_) && same && theirs == view.theirs && part_ == recorded_ &&
      picture_->settings() == context.picture.settings())
    return;
  const bool otherPart = part_ != recorded_;
  recorded_ = part_;
  const int step = view.step;
  const bool atEnd = run() && step > 0 && step == run()->steps();
  player_.run.reset();
  newell_.reset();
  tooLong_ = false;
  if (!same || otherPart) own_.reset();
  if (!sameScene) view.polygon.reset(), about_.reset(), judges_.clear();
  if (picture_ &&
      picture_->scene().name != context.picture.scene().name)  // nobody asked this scene's questions
    view = {.kind = view.kind, .speed = view.speed, .loupe = view.loupe};
  picture_ = context.picture;
  ground_ = context.plan[Cell::Well];
  view.theirs = theirs;
  try {
    if (theirs)
      player_.run = std::make_unique<SortRun>(context.picture, theirs_, context.plan[Cell::Well]);
    else
      player_.run = std::make_unique<SortRun>(
          part_ ? context.picture.onlyWithin(part_->low, part_->high) : context.picture,
          context.plan[Cell::Well]);
  } catch (const TooLongRun&) {
    tooLong_ = true;
    view.playing = false;
    view.own.reset();
    return;
  }
  if (own_) own_->show(run()->picture());
  if (view.own) {
    const bool anew = !own_;
    const OwnState before = *std::exchange(view.own, std::nullopt);
    const OwnSort::Reply last = endReply_;
    view.step = 0;
    sortOneself(true);
    if (!anew) showOwn(before.P, before.Q, last);
    view.own->clicksQ = before.clicksQ;
    if (anew) host_.tell("The polygons have other places now, so your sort begins again.");
    return;
  }
  const bool asking = view.asking && same;
  const std::optional<Verdict> answer = same ? view.answer : std::nullopt;
  goTo(start_               ? *std::exchange(start_, std::nullopt)
       : same               ? step
       : atEnd && sameScene ? run()->steps()
                            : likeBefore());
  view.asking = view.asking && asking;
  view.answer = answer;
}

int SortView::likeBefore() {
  if (!about_ || view().step == 0) return 0;  // the user may have gone to the start since
  // The same picture at another size usually has the same run.
  if (view().step <= run()->steps() && run()->about(view().step) == *about_) return view().step;
  const std::optional<int> step = run()->stepAbout(*about_);
  host_.tell(step ? "The new view has its own run: this is its step most like the one before."
                  : "The new view has its own run, without such a step: this is its start.");
  return step.value_or(0);
}

void SortView::drawTooLong(Painter paint, const DrawContext& context) {
  const Rect &body = context.layout.body, picture = this->picture(context.layout);
  paint = paint.within(body);
  const IndexImage whole = context.picture.paint(context.plan[Cell::Well]).image;
  use_ = cellUse(whole);
  paint.fit(whole, picture);
  int y = picture.y + picture.height + 30;
  paint.text(body.x, y, "This run is too long to step through.", context.plan[Cell::Ink], Voice::Bold);
  for (const std::string& line :
       broken("Newell's sort of " +
                  counted(static_cast<std::int64_t>(context.picture.snapped().faces.size()), "polygon") +
                  " takes more than " + grouped(SortRun::kMostEvents) +
                  " steps. Click on the picture to sort only the polygons around that place. Fewer divisions "
                  "make a shorter run, if the scene has patches (k in view 4).",
              90)) {
    y += 16;
    paint.text(body.x, y, line, context.plan[Cell::Ink]);
  }
}

void SortView::draw(Painter paint, const DrawContext& context) {
  at_ = layoutIn(context.layout);
  drawer_ = context.layout.drawer;
  order_ = context.setup.picture.order;
  if (channelsOf(context.picture.colors().plan()) == Channels::Rgb) {
    fullColor_ = true;  // the view is still late, so it is drawn again at once
    drawn_.reset();
    return;
  }
  record(context);
  if (const auto kind = std::exchange(startKind_, std::nullopt); kind && run()) {
    const std::vector<int>& steps = run()->landmarks().steps(*kind);
    if (steps.empty()) {
      host_.notify("Newell's sort has no " + std::string{kLandmarks[static_cast<std::size_t>(*kind)].name} +
                   " here.");
    } else {
      player_.view.kind = *kind;
      goTo(steps.front());
    }
  }
  list_.forgetPlaces();
  if (!run()) {
    drawTooLong(paint, context);
    status_ = "Newell's sort of this scene is too long to step through.";
  } else {
    if (view().own) tellOwn();
    places_ = drawSortPage(paint, at_, *run(), view(), context.plan, &list_);
    status_ = view().own ? stepAsLines(*run(), view()).front() : stepText(*run());
    about_ = view().step > 0 ? std::optional{run()->about(view().step)} : std::nullopt;
    use_ = cellUse(run()->soFar());
  }
  Pen pen{paint, context.plan};
  const Controls all = controls();
  if (context.layout.drawer != Drawer::Whole) drawDrawer(pen, context.layout, all, {}, list_);
  list_.draw(pen, all);
  drawn_ = view();
}

std::string SortView::aside() const {
  if (!player_.run) return "";
  if (part_)
    return "a part: " + grouped(static_cast<std::int64_t>(player_.run->scene().faces.size())) + " of " +
           grouped(static_cast<std::int64_t>(picture_->snapped().faces.size())) + " polygons; Esc: all";
  if (view().own) return view().theirs ? "Y goes back to the run" : "Y goes back to the program's own sort";
  if (view().theirs) {
    const PictureSettings &run = theirs_->picture.settings(), &here = picture_->settings();
    return oneLine(theirs_->file.name()) + ": a picture of " + sizeText(run.width, run.height) +
           (run.width == here.width ? "" : ", shown smaller; numbers are in its pixels");
  }
  if (fullColor_) return "in one hue: the picture chooses its colours after all of it is painted";
  // Its numbers are those of this many pixels: another size rounds the corners otherwise.
  const std::string of = sizeText(picture_->settings().width, picture_->settings().height);
  return order_ == Order::Newell
             ? "the textbook's run at " + of + "; the picture uses a quicker one, which may cut others"
             : "Newell's sort at " + of + "; the picture itself: " + orderText(order_);
}

std::vector<std::string> SortView::report() const {
  if (!player_.run) return {status_};
  return stepAsLines(*player_.run, view());
}

std::optional<std::string> SortView::command() const {
  if (player_.run && view().theirs) return judgeCommand("--run " + quoted(theirs_->file.name()));
  if (!player_.run || !view().own) return {};
  return judges_.empty() ? judgeCommand("order.jsonl") : judges_;
}

}  // namespace xnewell
