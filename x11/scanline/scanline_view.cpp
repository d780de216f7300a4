#include "x11/scanline/scanline_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "depthsort/oracle.h"
#include "x11/drawing/wording.h"
#include "x11/kit/pseudocode.h"
#include "x11/kit/quiz.h"

namespace xnewell {

namespace {

constexpr std::array kBitChoices{8, 16, 24};
/// The parts of the page that the pointer presses.
constexpr int kOverview = 31, kGridPart = 32;

}  // namespace

Control ScanlineView::bitsControl() {
  Control bits{.kind = Control::Kind::Choice,
               .key = 'B',
               .label = "bits",
               .is = "bits after the point of a value that is stepped; the picture has 24",
               .set = [this](double k) { view_.bits = kBitChoices[static_cast<std::size_t>(k)]; }};
  for (const int one : kBitChoices) bits.options.push_back(std::to_string(one));
  const bool chooses = !run_ || run_->choosesBits();
  const int shown = chooses ? view_.bits : 24;
  bits.value = static_cast<double>(std::ranges::find(kBitChoices, shown) - kBitChoices.begin());
  if (!chooses) bits.off = "Only Gouraud and Phong shading have values of chosen bits.";
  return bits;
}

Control ScanlineView::polygonsControl() {
  Control by{.kind = Control::Kind::Choice,
             .key = 'G',
             .label = "n-gons",
             .is = "how Gouraud shading fills a polygon with more than three corners",
             .value = static_cast<double>(host_.setup().picture.polygons),
             .set = [this](double k) {
               host_.change('G', [k](Setup& s) { s.picture.polygons = static_cast<Polygons>(k); });
             }};
  for (const PolygonsRow& row : kPolygons) by.options.emplace_back(row.name);
  if (host_.setup().picture.shading != Shading::Gouraud)
    by.off = "Only Gouraud shading fills n-gons by rows.";
  return by;
}

Controls ScanlineView::controls() {
  Controls all{bitsControl(), polygonsControl()};
  for (Control& control : settingControls(host_.setup(), host_.defaults(), change(), subject_().scene))
    if (control.key != 'W' && control.key != 'B') all.push_back(std::move(control));
  for (Control& control : cameraControls(host_.setup(), subject_(), change())) {
    control.drag = {};
    all.push_back(std::move(control));
  }
  if (!run_) return all;
  Control kinds = scanKindsControl(*run_, view_);
  kinds.set = [this](double kind) {
    view_.kind = static_cast<ScanMark>(kind);
    jump(true);
  };
  for (Control& control : transportControls(
           {view_.step, run_->steps()}, std::move(kinds), view_.speed, [this](int step) { moveTo(step); },
           [this](int steps) { moveTo(view_.step + steps); },
           [this](const Key& key) { (void)pressIn(ownKeys(), key, host_); }))
    all.push_back(std::move(control));
  all.push_back({.kind = Control::Kind::Own, .part = kOverview, .drag = [this](int x, int y, int dx, int dy) {
                   if (dx == 0 && dy == 0) pressOverview(x, y);
                 }});
  all.push_back({.kind = Control::Kind::Own, .part = kGridPart, .drag = [this](int x, int y, int, int) {
                   pressGrid(x, y);
                 }});
  return all;
}

KeyTable ScanlineView::ownKeys() {
  KeyTable table;
  const auto add = [&](Key key, std::string legend, const char* does, std::string off, auto act) {
    append(table, {{{key}, std::move(legend), does, [act](const Key&) { act(); }, std::move(off)}});
  };
  const bool rests = run_ && !view_.playing;
  appendTransportKeys(
      table, view_.playing,
      {.by = [this](int steps) { moveTo(view_.step + steps); },
       .play = [this] { play(); },
       .start = [this] { moveTo(0); },
       .end = [this] { moveTo(run_ ? run_->steps() : 0); },
       .jump = [this](bool forward) { jump(forward); },
       .nextKind =
           [this] {
             view_.kind =
                 static_cast<ScanMark>((static_cast<std::size_t>(view_.kind) + 1) % kScanMarks.size());
           },
       .askStep =
           [this] {
             view_.playing = false;
             if (run_)
               list_.askForValue(timelineControl(
                   {view_.step, run_->steps()}, [this](int step) { moveTo(step); }, [](int) {}));
           },
       .whyNoJump = [this](bool forward) { return whyNoJump(forward); },
       .nothing = run_ && run_->steps() == 0 ? "This polygon owns no sample." : "",
       .atStart = rests && view_.step == 0,
       .atEnd = rests && view_.step == run_->steps()});
  add('/', "polygon", "fill another polygon, by its number; or click one in the small picture", "",
      [this] { askPolygon(); });
  const char* const walks = "the polygon before, the next one that shows";
  add(NamedKey::PageUp, "", walks, "", [this] { walk(-1); });
  add(NamedKey::PageDown, "", walks, "", [this] { walk(1); });
  add('h', "", walks, "", [this] { walk(1); });  // also in a lecture, which has the other two
  add('y', "predict", "predict the cell of the next pixel",
      run_ && view_.step == run_->steps() ? "This is the end of the run." : "", [this] { predict(); });
  table.back().waits = late(host_.setup());
  appendSpeedKeys(table, view_.speed);
  add(kCodeKey, "", kCodeDoes, "", [this] { view_.code = !view_.code; });
  add('8', "this pixel", "explain this pixel in view 8", "", [this] {
    if (!run_ || view_.step == 0) return host_.switchTo(View::Pixel);
    const ScanSample& sample = run_->samples()[static_cast<std::size_t>(view_.step - 1)];
    const PictureSettings& settings = picture_->settings();
    host_.explain((sample.column + 0.5) / settings.width, (run_->spanOf(sample).row + 0.5) / settings.height);
  });
  if (view_.playing || list_.focus() != transportId(TransportPart::Timeline))
    add(NamedKey::Escape, "", "stop playing; select the timeline again", "", [this] {
      view_.playing = false;
      list_.setFocus(transportId(TransportPart::Timeline));
    });
  return table;
}

void ScanlineView::goTo(int step) {
  if (!run_) {  // the picture is not ready
    start_ = step;
    return;
  }
  view_.step = std::clamp(step, 0, run_->steps());
  if (run_->steps() > 0) share_ = 1.0 * view_.step / run_->steps();
}

void ScanlineView::moveTo(int step) {
  view_.playing = false;
  goTo(step);
}

std::optional<int> ScanlineView::stepOfKind(bool forward) const {
  if (!run_) return std::nullopt;
  const std::vector<int>& steps = run_->marks(view_.kind);
  if (forward) {
    const auto next = std::ranges::upper_bound(steps, view_.step);
    return next == steps.end() ? std::nullopt : std::optional{*next};
  }
  const auto next = std::ranges::lower_bound(steps, view_.step);
  return next == steps.begin() ? std::nullopt : std::optional{*std::prev(next)};
}

std::string ScanlineView::whyNoJump(bool forward) const {
  if (!run_ || stepOfKind(forward)) return {};
  const ScanMarkRow& kind = kScanMarks[static_cast<std::size_t>(view_.kind)];
  if (kind.id == ScanMark::Differs && run_->marks(kind.id).empty())
    return "By steps every sample has its direct cell; K chooses another kind.";
  return (run_->marks(kind.id).empty()
              ? "This run has no step of the kind " + std::string{kind.name}
              : "There is no such step " + std::string{forward ? "after" : "before"} + " this one") +
         "; K chooses another kind.";
}

void ScanlineView::jump(bool forward) {
  view_.playing = false;
  if (const std::optional<int> step = stepOfKind(forward))
    goTo(*step);
  else
    host_.notify(whyNoJump(forward));
}

void ScanlineView::play() {
  if (!run_) return;
  if (!view_.playing && view_.step == run_->steps()) goTo(0);
  view_.playing = !view_.playing && run_->steps() > 0;
  clock_.restart();
}

void ScanlineView::tick() {
  if (!view_.playing || !run_) return;
  clock_.tick(view_.speed);
  while (view_.playing && clock_.takeStep()) {
    goTo(view_.step + 1);
    view_.playing = view_.step < run_->steps();
  }
}

void ScanlineView::askPolygon() {
  host_.ask(
      {.asks = "fill the face number", .text = name_, .take = [this](const std::string& text) -> std::string {
         if (!picture_ || faceNamed(*picture_, text) < 0)
           return "No face with that number is in the picture; click one in the small picture.";
         choose(text);
         return {};
       }});
}

void ScanlineView::predict() {
  if (!run_) return host_.notify("There is no run yet.");
  if (view_.step >= run_->steps()) return host_.notify("This is the end of the run.");
  const ScanSample next = run_->samples()[static_cast<std::size_t>(view_.step)];
  view_.asking = true;
  const double cell = next.steppedCell;
  askNumber(
      host_,
      {1, "the cell of the next pixel, " + std::to_string(next.column), cell, cell, 0,
       [](double typed) { return static_cast<int>(std::lround(typed)); }},
      view_.score, [this](std::optional<int> guess) { view_.guess = guess; },
      [this, next](bool isRight) {
        view_.asking = false, view_.guess.reset();
        goTo(view_.step + 1);
        host_.tell((isRight ? "Right: cell " : "The next cell is ") + std::to_string(next.steppedCell) +
                   ", at pixel " + std::to_string(next.column) + "." +
                   (view_.score.asked > 0 ? " " + view_.score.text() + "." : ""));
      });
}

void ScanlineView::walk(int direction) {
  if (!run_) return;
  const int count = static_cast<int>(shows_.size());
  for (int f = run_->face() + direction; f >= 0 && f < count; f += direction)
    if (shows_[static_cast<std::size_t>(f)] > 0) {
      choose(nameOfFace(*picture_, f));
      return;
    }
  host_.notify(direction < 0 ? "This is the first polygon that shows."
                             : "This is the last polygon that shows.");
}

void ScanlineView::pressOverview(int x, int y) {
  if (!picture_) return;
  const int scale = overviewScale(at_.overview, picture_->image(), unit_);
  const int i = (x - at_.overview.x) * unit_ * scale, j = (y - at_.overview.y) * unit_ * scale;
  const PictureSettings& settings = picture_->settings();
  if (i < 0 || j < 0 || i >= settings.width || j >= settings.height) return;
  const SeenRows seen = picture_->seen(j, j + 1);
  const int face = seen.faces[static_cast<std::size_t>(i)];
  if (face == kNothing) return host_.notify("There is no polygon there.");
  choose(nameOfFace(*picture_, face));
}

void ScanlineView::pressGrid(int x, int y) {
  if (!run_) return;
  const GridWindow window = gridWindow(at_.grid, *run_, view_.step);
  const int column = window.column + (x - at_.grid.x) / window.side,
            row = window.row + (y - at_.grid.y) / window.side;
  for (int k = 0; k < run_->steps(); ++k) {
    const ScanSample& sample = run_->samples()[static_cast<std::size_t>(k)];
    if (sample.column == column && run_->spanOf(sample).row == row) return moveTo(k + 1);
  }
  host_.notify("The polygon does not own the sample of that pixel.");
}

void ScanlineView::enter() { list_.setFocus(transportId(TransportPart::Timeline)); }

void ScanlineView::leave() {
  WindowView::leave();
  view_.playing = view_.asking = false;
  run_.reset(), eight_.reset();
  picture_.reset();
  fullColor_ = false;
  drawn_.reset();
}

Setup ScanlineView::painted(const Setup& setup) const {
  Setup own = setup;
  if (fullColor_) own.picture.colors = ColorPlan::OneHue;
  own.picture.inPixels = false;
  own.fill = Fill::Scanline;
  return own;
}

int ScanlineView::faceToBegin() const {
  // About two hundred samples fill the grid well.
  const auto unfit = [](int samples) { return samples == 0 ? 1e9 : std::abs(std::log(samples / 200.0)); };
  const auto best = std::ranges::min_element(shows_, {}, unfit);
  return best == shows_.end() || *best == 0 ? -1 : static_cast<int>(best - shows_.begin());
}

void ScanlineView::follow(const DrawContext& context) {
  const bool samePicture = picture_ && &picture_->scene() == &context.picture.scene() &&
                           picture_->settings() == context.picture.settings();
  if (!samePicture) {
    if (picture_ && &picture_->scene() != &context.picture.scene()) name_.clear();
    run_.reset(), eight_.reset();
    picture_ = context.picture;
    shows_.assign(picture_->snapped().faces.size(), 0);
    for (const int face : picture_->seen(0, picture_->settings().height).faces)
      if (face != kNothing) ++shows_[static_cast<std::size_t>(face)];
  }
  int face = name_.empty() ? -1 : faceNamed(*picture_, name_);
  if (face < 0) {
    if (!name_.empty()) host_.tell("The picture has no face " + name_ + ": this is another one.");
    face = faceToBegin();
  }
  if (face < 0) {
    run_.reset(), eight_.reset();
    return;
  }
  name_ = nameOfFace(*picture_, face);
  if (run_ && run_->face() == face && run_->bits() == view_.bits) return;
  run_ = std::make_unique<ScanlineRun>(*picture_, face, view_.bits);
  eight_ = run_->choosesBits() ? std::make_unique<ScanlineRun>(*picture_, face, 8) : nullptr;
  finding_ = findingOf(*run_, eight_.get());
  if (start_)
    goTo(*std::exchange(start_, std::nullopt));
  else
    goTo(static_cast<int>(std::lround(share_ * run_->steps())));
}

void ScanlineView::draw(Painter paint, const DrawContext& context) {
  late_ = false;
  setup_ = context.setup;
  at_ = layoutOfScanline(context.layout.body);
  unit_ = context.layout.unit;
  if (channelsOf(context.picture.colors().plan()) == Channels::Rgb) {
    fullColor_ = true;  // the view is still late, so it is drawn again at once
    drawn_.reset();
    return;
  }
  follow(context);
  Pen pen{paint, context.plan};
  list_.forgetPlaces();
  if (!run_) {
    status_ = kNothingShows;
    pen.bold(at_.body.x, at_.body.y + 20, status_);
    drawn_ = view_;
    return;
  }
  drawScanlinePage(pen, at_,
                   {.run = *run_,
                    .view = view_,
                    .finding = finding_,
                    .polygon = faceName(*picture_, run_->face()),
                    .image = context.picture.image()},
                   &list_);
  const Controls all = controls();
  placeTransport(list_, at_);
  constexpr int kBits = 132, kPolygonsBy = 172;
  list_.placeRow(all, 'B', at_.column.x, at_.choices, {.width = kBits, .value = 60, .beyond = 2});
  list_.placeRow(all, 'G', at_.column.x + at_.column.width - kPolygonsBy, at_.choices,
                 {.width = kPolygonsBy, .value = 68, .beyond = 2});
  list_.place({0, kOverview}, {.area = at_.overview, .grip = at_.overview, .bare = true, .passive = true});
  list_.place({0, kGridPart}, {.area = at_.grid, .grip = at_.grid, .bare = true, .passive = true});
  list_.draw(pen, all);
  status_ = stepText(*run_, view_.step) + (fullColor_ ? ", " + std::string{kInOneHue} : "") + "; of " +
            sizeText(picture_->settings().width, picture_->settings().height) + " pixels";
  drawn_ = view_;
}

std::string ScanlineView::aside() const {
  if (!run_) return "";
  return (fullColor_ ? "the scene has colours; " : "") + methodText(*run_);
}

std::vector<std::string> ScanlineView::report() const {
  if (!run_ || view_.asking) return {status_};
  std::vector<std::string> lines = scanAsLines(*run_, view_.step, eight_.get());
  lines.insert(lines.begin(), "face " + faceName(*picture_, run_->face()));
  return lines;
}

std::optional<int> ScanlineView::inspected() const {
  if (view_.guess) return view_.guess;
  if (!run_ || view_.step == 0 || view_.step > run_->steps()) return std::nullopt;
  return run_->samples()[static_cast<std::size_t>(view_.step - 1)].steppedCell;
}

}  // namespace xnewell
