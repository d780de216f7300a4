#include "x11/window/picture_view.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/view/view.h"
#include "shading/color/quantize.h"
#include "shading/laboratory/errors.h"
#include "shading/light/equation.h"
#include "shading/scene/units.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/cell_facts.h"
#include "x11/window/layout.h"

namespace xnewell {

namespace {

/// The cells that shade the ball: the ramp if there is one. Otherwise the scene's cells may hold any colours,
/// so the ball uses the grays of the interface.
BallCells ballCells(const Picture& picture, const CellPlan& plan, bool ramp) {
  struct Gray {
    Cell cell;
    int k;
  };
  static const std::vector<Gray> grays = [] {
    const CellPlan usual;
    const Palette palette = withInterface({}, usual);
    std::vector<Gray> all;
    for (const Cell cell :
         {Cell::Black, Cell::Well, Cell::WellLine, Cell::Soft, Cell::Faint, Cell::WellText, Cell::White})
      all.push_back({cell, palette[usual[cell]].g >> 8});
    return all;
  }();
  BallCells ball;
  for (int k = 0; k < 256; ++k) {
    if (ramp) {
      ball.low[k] = ball.high[k] = static_cast<std::uint8_t>(picture.table().cell(k / 255.0));
      continue;
    }
    const auto above = std::ranges::find_if(grays.begin() + 1, grays.end() - 1,
                                            [&](const Gray& gray) { return gray.k > k; });
    const Gray &low = *(above - 1), &high = *above;
    ball.low[k] = plan[low.cell], ball.high[k] = plan[high.cell];
    ball.share[k] = (64 * (k - low.k) + (high.k - low.k) / 2) / (high.k - low.k);
  }
  return ball;
}

std::string countsOf(const Picture& picture) {
  const SnappedScene& snapped = picture.snapped();
  const auto backs = std::ranges::count(snapped.faces, true, &SnappedFace::back);
  const SortedScene& sorted = picture.sorted();
  const std::int64_t splits = sorted.statistics.splits, areas = sorted.statistics.areas;
  // Orders that decide at each sample paint no polygon as a whole.
  const bool whole = !rowOf(picture.settings().order).bySample;
  const int polygons = snapped.polygons - snapped.degenerate, faces = picture.scene().mesh.faceCount();
  return (polygons != faces ? counted(faces, "face") + ", " : "") + counted(polygons, "polygon") + ", " +
         (splits > 0 ? counted(splits, "cut") + ", " : "") +
         (whole ? grouped(static_cast<std::int64_t>(sorted.fragments.size())) + " painted" : "") +
         (whole && areas > 0 ? " in " + counted(areas, "area") : "") + (whole ? ", " : "") +
         counted(backs + snapped.culled, "back face") + "   " + grouped(picture.saturated()) + " clamped";
}

/// A sentence about how wrong the picture is; "" if it is right, or if that is not known.
std::string inexactness(const Picture& picture, bool compact) {
  constexpr std::size_t kMost = 100'000;  // polygons; with more, counting would take too long
  const Order order = picture.settings().order;
  if (rowOf(order).exact || picture.snapped().faces.size() > kMost) return {};
  const Exactness e = exactnessOf(picture);
  if (e.wrong == 0) return {};
  return (compact ? "A" : "Not exact: " + orderText(order) + ", a") + " wrong face at " + grouped(e.wrong) +
         " of " + grouped(e.samples) + " samples of " +
         sizeText(picture.settings().width, picture.settings().height) + ".";
}

double IaOf(const Setup& setup, const Scene& scene) {
  return largest(ambientOf(scene.light, setup.picture.light));
}

/// The intensities in force: Ia and the sum of all Ip, those of the scene where it has its own.
struct InForce {
  double Ia, Ip;
  InForce(const Setup& setup, const Scene& scene) : Ia{IaOf(setup, scene)} {
    glm::dvec3 sum{0.0};
    for (const Light& light : lampsOf(setup, scene)) sum += light.Ip;
    Ip = largest(sum);
  }
};

/// Makes the one light of the illumination one of a list, so that there can be more.
std::vector<Light>& listedLamps(Setup& setup, const Scene& scene) {
  if (!setup.picture.lights) setup.picture.lights = lampsOf(setup, scene);
  return *setup.picture.lights;
}

/// Words for the colours that the picture of normals or of a term has of its own. They are in the cells from
/// `first` on.
SceneCellWords wordsOfOwnColors(View show, const CellUse& use, int first) {
  int last = first + kMaxShades - 1;
  while (last > first && use.samples[last] == 0) --last;
  if (rowOf(show).term)
    return {.cells = {first, last - first + 1},
            .rule = "the values of " + std::string{rowOf(show).name},
            .shortRule = std::string{rowOf(show).name},
            .what = "values"};
  return {.cells = {first, last - first + 1},
          .rule = "directions of N, chosen from the picture",
          .shortRule = "directions of N",
          .what = "colours"};
}

}  // namespace

Controls PictureView::controls() {
  const Setup& now = host_.setup();
  const Subject subject = subject_();
  const std::vector<Light> lamps = lampsOf(now, subject.scene);
  const bool own = hasOwnLamps(now, subject.scene);
  const bool chooses = list_.focus() && list_.focus()->key == 'l';
  lamp_ = std::min(chooses ? static_cast<std::size_t>(list_.focus()->part) : lamp_, lamps.size() - 1);
  if (chooses) list_.setFocus(ControlId{'l', static_cast<int>(lamp_)});
  Controls all;
  for (std::size_t k = 0; k < lamps.size(); ++k) {
    all.push_back(lightControl(now, subject, change(), k));
    all.back().drag = [this, k](int x, int y, int, int) {
      const glm::dvec3 towards = glm::transpose(toView_) * directionOnBall(column_, x, y);
      host_.change('l', [&](Setup& s) {
        const Subject at = subject_();
        Light lamp = lampsOf(s, at.scene)[k];
        aimLight(lamp, towards, inSceneUnits(at.centre, at.scene));
        putLamp(s, at.scene, k, lamp);
      });
    };
  }
  const InForce inForce{now, subject.scene};
  const auto leftOf = [](double share) { return std::max(0.0, std::floor((1 - share) * 100 + 1e-9) / 100); };
  const auto setIp = [this, lamp = lamp_, ip = lamps[lamp_].Ip](double Ip) {
    const glm::dvec3 hue = largest(ip) > 0 ? ip / largest(ip) : glm::dvec3{1};
    host_.change(kLampChange, [&](Setup& s) { listedLamps(s, subject_().scene)[lamp].Ip = Ip * hue; });
  };
  for (Control& control : settingControls(now, host_.defaults(), change(), subject.scene)) {
    const double others = own ? inForce.Ip - largest(lamps[lamp_].Ip) : 0;
    if (own && control.key == 'p') {
      control.off.clear(), control.initially.reset();
      control.label = "Ip of light " + std::to_string(lamp_ + 1);
      control.value = largest(lamps[lamp_].Ip);
      control.range.high = leftOf(inForce.Ia + others);
      control.set = setIp;
    }
    if (own && control.key == 'i') control.range.high = leftOf(inForce.Ip);
    if (control.key == 'p')  // its thumb stands at Ia + Ip
      control.drag = [this, own, others, inForce, setIp](int x, int, int, int) {
        const TrackRange share{};
        const double sum = valueAt(share, double(x - column_.bar.x) / (column_.bar.width - 1));
        if (own) return setIp(valueAt(share, sum - inForce.Ia - others));
        host_.change('p', [&](Setup& s) {
          s.picture.light.Ia = std::min(s.picture.light.Ia, sum);
          (void)applyOverrides(s.picture, {{settingOf('p'), valueAt(share, sum - s.picture.light.Ia)}});
        });
      };
    if (control.key == 'H' || control.key == 'E')
      control.legend = control.label;  // it has no row in the column
    all.push_back(std::move(control));
  }
  for (Control& control : cameraControls(now, subject, change())) all.push_back(std::move(control));
  for (Control& button : buttonControls([this](char letter) { host_.pressLetter(letter); })) {
    button.off = ownOfScene(button.key, now, subject.scene);
    if (button.key == kDrawerKey && forBeginners_) button.label = "all", button.is = "show all controls";
    all.push_back(std::move(button));
  }
  if (opening_) addOpening(all);
  return all;
}

namespace {

constexpr std::array<std::string_view, 6> kOpening{"Turn me", "Move my light",  "Why am I wrong here?",
                                                   "Lessons", "Your own model", "Which mistake is it?"};
constexpr int kLessonsDoor = 3;
/// Numbers that no row of controls has.
ControlId openingId(std::size_t k) { return {0, 100 + static_cast<int>(k)}; }

}  // namespace

void PictureView::addOpening(Controls& all) {
  const std::array<std::function<void()>, kOpening.size()> acts{
      [this] {
        list_.setFocus(ControlId{'t'});
        turn(change(), Setup{host_.setup()}, subject_(), 20, 0);
        host_.tell("Drag the picture, or press the arrows.");
      },
      [this] {
        list_.setFocus(ControlId{'l'});
        lightControl(host_.setup(), subject_(), change()).move(20, 0);
        host_.tell("Drag the ring on the ball, or press the arrows.");
      },
      [this] {
        host_.change('O', [](Setup& s) { s.picture.order = Order::ZSort; });
        host_.explainWrong();
      },
      [this] { host_.switchTo(View::Lesson); },
      [this] { host_.pressLetter('e'); },
      [this] { host_.pressLetter('G'); }};
  for (std::size_t k = 0; k < kOpening.size(); ++k)
    all.push_back({.kind = Control::Kind::Button,
                   .part = openingId(k).part,
                   .label = std::string{kOpening[k]},
                   .set = [act = acts[k]](double) { act(); }});
}

void PictureView::drawOpening(Pen& pen) {
  constexpr int kHeight = 24, kGap = 12, kDot = 10;
  const std::vector<bool> done = done_();
  const Rect& well = at_.well;
  int x = well.x + kGap, y = well.y + well.height - kHeight - kGap;
  for (std::size_t k = 0; k < kOpening.size(); ++k) {
    if (k == kLessonsDoor) x = well.x + kGap, y = well.y + kGap;
    const int dots = k == kLessonsDoor ? kDot * static_cast<int>(done.size()) : 0;
    const int width = textWidth(kOpening[k]) + 24 + dots;
    if (x + width > well.x + well.width) x = well.x + kGap, y += kHeight + kGap;
    const Rect box{x, y, width, kHeight};
    const Look look = list_.look(openingId(k));
    pen.paint.fillRect(box, pen(look.hovered ? Cell::White : Cell::Panel));
    pen.paint.frame(box, pen(Cell::Ink));
    int dot = pen.bold(x + 12, y + 16, kOpening[k]) + 8;
    for (std::size_t lesson = 0; dots > 0 && lesson < done.size(); ++lesson, dot += kDot) {
      pen.paint.ring(dot, y + 12, 3, pen(Cell::Ink));
      if (done[lesson]) pen.paint.disc(dot, y + 12, 3, pen(Cell::Ink));
    }
    list_.place(openingId(k), {.area = box, .bare = true, .above = true});
    x += box.width + kGap;
  }
}

bool PictureView::grab(int x, int y) {
  const bool drags = WindowView::grab(x, y);
  clicked_.reset();
  if (drags && at_.picture.has(x, y)) clicked_ = {x, y};
  return drags;
}

void PictureView::addLamp() {
  const std::size_t from = lamp_;
  host_.change('A', [&](Setup& s) {
    std::vector<Light>& lamps = listedLamps(s, subject_().scene);
    Light& chosen = lamps[lamp_];
    Light added = chosen;
    added.Ip = glm::floor(chosen.Ip * 50.0 + 1e-9) / 100.0;  // numbers that the panel writes whole
    chosen.Ip -= added.Ip;
    const glm::dvec3 centre = inSceneUnits(subject_().centre, subject_().scene);
    const UpAxis up = subject_().scene.up;
    turnLight(added, up, 100, lightAngles(added, up, centre).elevation > 60 ? -40 : 0, centre);
    lamp_ = lamps.size();
    lamps.push_back(added);
  });
  list_.setFocus(ControlId{'l', static_cast<int>(lamp_)});
  host_.tell("Light " + std::to_string(from + 1) + " gave half its Ip to light " + std::to_string(lamp_ + 1) +
             ". l chooses a light, p changes its Ip, X takes it away.");
}

void PictureView::removeLamp() {
  const std::size_t lamps = lampsOf(host_.setup(), subject_().scene).size();
  if (lamps < 2) return host_.notify("This is the only light. p = 0 puts it out.");
  host_.change('X', [&](Setup& s) {
    std::vector<Light>& all = listedLamps(s, subject_().scene);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(lamp_));
  });
  lamp_ = 0;
  list_.setFocus(ControlId{'l'});
}

void PictureView::dragTo(int x, int y) {
  constexpr int kStill = 2;  // units that a hand may tremble in a click
  if (clicked_ && std::abs(x - clicked_->x) <= kStill && std::abs(y - clicked_->y) <= kStill) return;
  clicked_.reset();
  opening_ = false;
  WindowView::dragTo(x, y);
}

void PictureView::drop() {
  if (list_.look({'t'}).dragged && !clicked_ && !std::exchange(toldOfTurning_, true))
    host_.tell(
        "The light turned with the scene, so its ring on the ball moved. Drag the ring to light it anew.");
  WindowView::drop();
  if (!clicked_) return;
  const glm::ivec2 at = *clicked_;
  clicked_.reset();
  host_.explain((at.x - at_.picture.x + 0.5) / at_.picture.width,
                (at.y - at_.picture.y + 0.5) / at_.picture.height);
}

KeyTable PictureView::ownKeys() {
  const auto all = [this](char key) {
    return [this, key](const Key&) {
      host_.change(key == 'i' ? '[' : ']', [&](Setup& s) {
        (void)applyOverrides(s.picture, {{settingOf(key), 1.0}});
      });
    };
  };
  KeyTable table = zoomKeys(host_.setup(), subject_(), change());
  table.insert(table.begin(), {{.legend = "turn", .does = "turn the scene", .gesture = "drag"},
                               {.does = "explain the pixel under the pointer", .gesture = "click"}});
  const char* const opening = "the opening page, or no longer; a game: which mistake is it?";
  table.push_back({{'h'}, "", opening, [this](const Key&) { opening_ = !opening_; }});
  table.push_back({{'G'}, "", opening, [this](const Key&) { play_(); }});
  if (opening_)
    table.push_back(
        {{NamedKey::Escape}, "", "end the opening page", [this](const Key&) { opening_ = false; }});
  const char* const lamps = "a new light; take the chosen one away";
  table.push_back({{'A'}, "", lamps, [this](const Key&) { addLamp(); }});
  table.push_back({{'X'}, "", lamps, [this](const Key&) { removeLamp(); }});
  const char* const only = "only ambient light; only the light of the point";
  table.push_back({{'['}, "Ia = 1", only, all('i')});
  table.push_back({{']'}, "Ip = 1", only, all('p')});
  return table;
}

void PictureView::draw(Painter paint, const DrawContext& context) {
  at_ = context.layout;
  drawn_ = {opening_, forBeginners_};
  const View show = at_.roomy ? context.setup.show : View::Picture;
  if (context.fresh || show != shownAs_) {
    shown_ = xnewell::shownAs(show, context.picture, context.palette, context.plan, truth_, at_.unit);
    shownAs_ = show;
  }
  use_ = cellUse(shown_.image);
  colors_ = {shown_.palette, {}};
  if (rowOf(show).hasOwnColors() && context.picture.colors().plan() != ColorPlan::Cube)
    colors_.words = wordsOfOwnColors(show, use_, context.picture.colors().table().first());
  paint.fillRect(at_.well, context.plan[Cell::Well]);
  paint.place(shown_.image, at_.picture.x, at_.picture.y);
  counts_ = countsOf(context.picture);
  drawColumn(paint, context);
  if (!at_.roomy) return;
  findInexactness(context);
  if (at_.drawer == Drawer::Whole)
    drawCaption(paint, context);
  else
    drawHeadlines(paint, context);
}

void PictureView::findInexactness(const DrawContext& context) {
  if (context.fresh || !counted_)
    inexact_ = context.dragging ? std::string{} : inexactness(context.picture, at_.compact);
  counted_ = !context.dragging;
}

void PictureView::drawHeadlines(Painter paint, const DrawContext& context) {
  Pen pen{paint, context.plan};
  const auto large = [&](const Rect& line, std::string_view text, Cell cell) {
    paint.text(line.x, line.y + 23, beginningOf(std::string{text}, line.width, Voice::Title),
               context.plan[cell], Voice::Title);
  };
  large(at_.headline, context.title, Cell::Ink);
  const std::string made = captionOf(context.setup);
  std::string found = shown_.finding;
  if (found.empty() && !context.coarse) found = inexact_;
  const Cell cell = shown_.finding.empty() && !found.empty() ? Cell::Alarm : Cell::Ink;
  // Large letters where they fit; else the finding in bold, and below it how the picture was made.
  const std::string& main = found.empty() ? made : found;
  if (textWidth(main, Voice::Title) <= at_.finding.width) return large(at_.finding, main, cell);
  const int y = at_.finding.y + 13;
  pen.bold(at_.finding.x, y, beginningOf(main, at_.finding.width), cell);
  if (found.empty()) return;
  pen.soft(at_.finding.x, y + 16, beginningOf(made, at_.finding.width));
}

void PictureView::drawColumn(Painter paint, const DrawContext& context) {
  const Controls all = controls();
  // A line that is all there is keeps the counts until the pointer asks for something else.
  const Control* const pointed =
      list_.hovered(all) || context.layout.low ? list_.hovered(all) : list_.focused(all);
  aside_ = msText(context.picture.times().total()) + " ms";
  if (pointed && !pointed->is.empty()) {
    const std::string is =
        (pointed->kind == Control::Kind::Slider ? pointed->label + ": " : "") + pointed->is;
    // What a control is for has the line to itself if it must.
    const int room = context.layout.width - 2 * Sheet::kMargin - textWidth(is) - 18;
    if (textWidth(counts_ + "   " + aside_) <= room)
      aside_ += "   " + is;
    else if (textWidth(counts_) <= room)
      aside_ = is;
    else
      counts_ = is, aside_.clear();
  }
  list_.forgetPlaces();
  list_.place({'t'}, {.area = at_.picture, .grip = at_.picture, .bare = true, .passive = true});
  Pen pen{paint, context.plan};
  if (opening_ && mistakeIn(context.setup).empty()) drawOpening(pen);
  if (!at_.roomy) return list_.draw(pen, all);

  if (at_.drawer != Drawer::Whole) {
    drawDrawer(pen, at_, all, context.few, list_);
    return list_.draw(pen, all);
  }
  const Subject subject = subject_();
  const bool ramp =
      !rowOf(context.setup.show).hasOwnColors() && context.picture.colors().plan() == ColorPlan::OneHue;
  toView_ = vrcRotation(context.picture.camera().view);
  const Scene& scene = context.picture.scene();
  const InForce inForce{context.setup, scene};
  std::vector<Light> lamps = lampsOf(context.setup, scene);
  const glm::dvec3 centre = inSceneUnits(subject.centre, scene);
  const LightAngles angles = lightAngles(lamps[lamp_], scene.up, centre);
  for (Light& lamp : lamps)
    lamp.direction = toView_ * lamp.direction, lamp.position = toView_ * (lamp.position - centre);
  column_ = layoutOfControls(at_, all, {inForce.Ia, inForce.Ia + inForce.Ip}, forBeginners_);
  for (const auto& [id, place] : column_.places)
    if (id != ControlId{'l'}) list_.place(id, place);
  constexpr int kRing = 7;
  for (std::size_t k = 0; k < lamps.size(); ++k) {
    const glm::ivec2 ring = ringOf(column_, lamps[k]);
    ControlPlace place =
        std::ranges::find(column_.places, ControlId{'l'}, &std::pair<ControlId, ControlPlace>::first)->second;
    if (k != lamp_)  // the ball and the angles are of the chosen one
      place.area = place.grip = {ring.x - kRing, ring.y - kRing, 2 * kRing + 1, 2 * kRing + 1},
      place.above = true;
    list_.place({'l', static_cast<int>(k)}, place);
  }
  drawLightControls(pen, column_,
                    {.setup = context.setup,
                     .angles = angles,
                     .lamps = std::move(lamps),
                     .lamp = lamp_,
                     .size = boxOf(scene.mesh.points).side(),
                     .unit = scene.light.unit,
                     .ball = ballCells(context.picture, context.plan, ramp),
                     .ambient = inForce.Ia,
                     .lights = inForce.Ip,
                     .IaIsOwn = scene.light.Ia.has_value(),
                     .light = list_.look({'l', static_cast<int>(lamp_)}),
                     .Ia = list_.look({'i'}),
                     .Ip = list_.look({'p'})});
  list_.draw(pen, all);
}

void PictureView::drawCaption(Painter paint, const DrawContext& context) {
  Pen pen{paint, context.plan};
  const PictureSettings& p = context.setup.picture;
  const int x = at_.well.x;
  int y = at_.well.y + at_.well.height + (at_.compact ? 16 : 19);
  const std::string made = captionOf(context.setup);
  if (at_.compact)
    pen.ink(x, y, made);
  else
    pen.ink(pen.soft(x, y, "The picture: "), y, made);
  y += 16;
  const Illumination& l = p.light;
  const InForce inForce{context.setup, context.picture.scene()};
  std::string line = "Ia " + fixed(inForce.Ia, 2) + "  Ip " + fixed(inForce.Ip, 2) + "  ka " +
                     fixed(l.ka, 2) + "  kd " + fixed(l.kd, 2) + "  ks " + fixed(l.ks, 2) + "  n " +
                     std::to_string(l.n);
  if (!at_.compact) {
    if (l.constantL) line += "  L constant";
    if (l.constantV) line += "  V constant";
    line += "; " + std::string{kTables[static_cast<int>(p.table.kind)].name} + " table, " +
            shadesText(context.picture);
  }
  const std::string inexact =
      context.coarse ? "Coarse while dragging: " + captionOf({context.picture.settings()}) : inexact_;
  const std::string& finding = shown_.finding;  // of any view but the shaded one
  if (!at_.compact || (inexact.empty() && finding.empty())) pen.soft(x, y, line);
  if (!at_.compact) y += 17;
  if (!finding.empty()) {
    pen.ink(x, y, finding);
    return;
  }
  const int end = pen.paint.text(x, y, inexact, context.plan[Cell::Alarm]);
  if (at_.compact || inexact.empty() || context.coarse) return;
  int cap = end + 18;
  for (const auto& [key, does] : {std::pair{"O", "next order"}, std::pair{"5", "beside Newell"}}) {
    if (cap + 20 + textWidth(does) > x + at_.well.width) break;
    cap = pen.soft(cap + pen.key(cap, y - 11, key) + 5, y, does) + 12;
  }
}

}  // namespace xnewell
