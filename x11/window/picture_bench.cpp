#include "x11/window/picture_bench.h"

#include <algorithm>

#include "geometry/view/view.h"
#include "shading/picture/exactness.h"
#include "x11/drawing/pen.h"
#include "x11/drawing/wording.h"
#include "x11/window/caption.h"

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
  return counted(snapped.polygons - snapped.degenerate, "polygon") + ", " +
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
  return "Not exact: " + (compact ? "" : orderInWords(order) + ", ") + "the wrong face at " +
         grouped(e.wrong) + " of " + grouped(e.samples) + " samples.";
}

/// Words for the colours chosen for the picture of normals. They are in the cells from `first` on.
SceneCellWords wordsOfNormals(const CellUse& use, int first) {
  int last = first + kMaxShades - 1;
  while (last > first && use.samples[last] == 0) --last;
  return {.cells = {first, last - first + 1},
          .rule = "directions of N, chosen from the picture",
          .shortRule = "directions of N",
          .what = "colours"};
}

}  // namespace

void PictureBench::hover(int x, int y) { hover_ = controlAt(column_, host_.setup(), x, y); }

bool PictureBench::grab(int x, int y) {
  x_ = x, y_ = y;
  if (at_.picture.has(x, y)) return dragged_ = 't', true;
  hover(x, y);
  if (!hover_) return false;
  grabControl(*hover_);
  if (dragged_ != 0) dragControl(x, y);
  return dragged_ != 0;
}

void PictureBench::grabControl(const ControlHit& hit) {
  const ControlPlace* const place = column_.find(hit.key);
  switch (place->kind) {
    case ControlPlace::Kind::Choice: {
      const ChoiceRow& row = *choiceOf(hit.key);
      choose(host_, row, hit.option >= 0 ? hit.option : row.next(host_.setup()));
      return;
    }
    case ControlPlace::Kind::Toggle:
    case ControlPlace::Kind::Button:
      host_.pressLetter(hit.key);
      return;
    case ControlPlace::Kind::Slider:
    case ControlPlace::Kind::Light:
    case ControlPlace::Kind::Intensity:
      keys_.setFocus(hit.key);
      if (const SliderRow* const row = sliderOf(hit.key); row && !row->enabled(host_.setup()))
        return host_.notify(row->whenOff());
      // A click on a name or a value gives the control the focus and does not change its value.
      const bool onTrack = place->kind == ControlPlace::Kind::Light
                               ? column_.ball.has(x_, y_)
                               : x_ >= place->track.x - 5 && x_ < place->track.x + place->track.width + 5 &&
                                     (place->kind == ControlPlace::Kind::Slider || y_ >= place->track.y - 4);
      if (onTrack) dragged_ = hit.key;
      return;
  }
}

void PictureBench::dragTo(int x, int y) {
  if (x == x_ && y == y_) return;
  if (dragged_ == 't')
    turn(host_, host_.setup(), subject_(), -0.5 * (x - x_), 0.5 * (y - y_));
  else if (dragged_ != 0)
    dragControl(x, y);
  x_ = x, y_ = y;
}

void PictureBench::dragControl(int x, int y) {
  const ControlPlace* const place = column_.find(dragged_);
  const double share = place->track.width > 1
                           ? std::clamp(double(x - place->track.x) / (place->track.width - 1), 0.0, 1.0)
                           : 0.0;
  const auto hundredth = [](double v) { return std::round(v * 100) / 100; };
  switch (dragged_) {
    case 'l': {
      const glm::dvec3 towards = glm::transpose(toView_) * directionOnBall(column_, x, y);
      return host_.change('l', [&](Setup& s) { aimLight(s.picture.light, towards, subject_().centre); });
    }
    case 'i':
      return host_.change('i', [&](Setup& s) { sliderOf('i')->set(s, hundredth(share)); });
    case 'p':  // the thumb of Ip stands at Ia + Ip
      return host_.change('p', [&](Setup& s) {
        s.picture.light.Ia = std::min(s.picture.light.Ia, hundredth(share));
        sliderOf('p')->set(s, hundredth(share - s.picture.light.Ia));
      });
    default: {
      const SliderRow* const row = sliderOf(dragged_);
      return host_.change(dragged_, [&](Setup& s) { row->set(s, trackValue(*row, share)); });
    }
  }
}

void PictureBench::drop() { dragged_ = 0; }

bool PictureBench::late(const Setup&) const {
  return keys_.focus() != focus_ || hover_ != drawnHover_ || dragged_ != drawnDragged_;
}

void PictureBench::draw(IndexImage& image, const Desk& desk) {
  at_ = desk.layout;
  const Show show = at_.roomy ? desk.setup.show : Show::Shaded;
  if (desk.fresh || show != shownAs_) {
    shown_ = xnewell::shownAs(show, desk.picture, desk.palette, desk.plan, truth_);
    shownAs_ = show;
  }
  use_ = cellUse(shown_.image);
  colors_ = {shown_.palette, {}};
  if (show == Show::Normals && desk.picture.colors().plan() != ColorPlan::Cube)
    colors_.words = wordsOfNormals(use_, desk.picture.colors().table().first());
  Painter{image}.place(shown_.image, at_.picture.x, at_.picture.y);
  counts_ = countsOf(desk.picture);
  focus_ = keys_.focus(), drawnDragged_ = dragged_, drawnHover_ = hover_;
  const char pointed = hover_ ? hover_->key : focus_;
  const std::string_view tells = whatIs(pointed);
  const SliderRow* const slider = sliderOf(pointed);
  aside_ = fixed(desk.picture.times().total(), 1) + " ms";
  if (!tells.empty())
    aside_ += "   " + (slider ? std::string{slider->label} + ": " : "") + std::string{tells};
  if (!at_.roomy) return;

  const ControlKeys::Subject subject = subject_();
  const Illumination& light = desk.setup.picture.light;
  toView_ = vrcRotation(desk.picture.camera().view);
  column_ = layoutOfControls(at_);
  drawControls(image, column_,
               {.setup = desk.setup,
                .defaults = host_.defaults(),
                .light = lightAngles(light, subject.scene.up, subject.centre),
                .lightInView = toView_ * towardsLight(light, subject.centre),
                .ball = ballCells(desk.picture, desk.plan,
                                  show != Show::Normals && desk.picture.colors().plan() == ColorPlan::OneHue),
                .ownLights = !desk.picture.scene().light.lights.empty(),
                .focus = focus_,
                .hover = hover_,
                .dragged = dragged_},
               desk.plan);
  drawCaption(image, desk);
}

void PictureBench::drawCaption(IndexImage& image, const Desk& desk) {
  Pen pen{Painter{image}, desk.plan};
  const PictureSettings& p = desk.setup.picture;
  const int x = at_.picture.x;
  int y = at_.picture.y + at_.picture.height + (at_.compact ? 16 : 19);
  const std::string made = captionOf(desk.setup);
  if (at_.compact)
    pen.ink(x, y, made);
  else
    pen.ink(pen.soft(x, y, "The picture: "), y, made);
  y += 16;
  const Illumination& l = p.light;
  std::string line = "Ia " + fixed(l.Ia, 2) + "  Ip " + fixed(l.Ip, 2) + "  ka " + fixed(l.ka, 2) + "  kd " +
                     fixed(l.kd, 2) + "  ks " + fixed(l.ks, 2) + "  n " + std::to_string(l.n);
  if (!at_.compact) {
    if (l.constantL) line += "  L constant";
    if (l.constantV) line += "  V constant";
    line += "; " + std::string{kTables[static_cast<int>(p.table.kind)].name} + " table, " +
            std::to_string(p.table.shades) + " shades";
  }
  if (desk.fresh || !counted_)
    inexact_ = desk.dragging ? std::string{} : inexactness(desk.picture, at_.compact);
  counted_ = !desk.dragging;
  const std::string inexact =
      desk.coarse ? "Coarse while dragging: " + captionOf({desk.picture.settings()}) : inexact_;
  const std::string& finding = shown_.finding;  // of any view but the shaded one
  if (!at_.compact || (inexact.empty() && finding.empty())) pen.soft(x, y, line);
  if (!at_.compact) y += 17;
  if (!finding.empty()) {
    pen.ink(x, y, finding);
    return;
  }
  const int end = pen.paint.text(x, y, inexact, desk.plan[Cell::Alarm]);
  if (at_.compact || inexact.empty() || desk.coarse) return;
  int cap = end + 18;
  for (const Legend& way : {Legend{{"O"}, "next order"}, Legend{{"5"}, "beside Newell"}}) {
    if (cap + 20 + textWidth(way.does) > x + at_.picture.width) break;
    cap = pen.soft(cap + pen.key(cap, y - 11, way.keys.front()) + 5, y, way.does) + 12;
  }
}

std::vector<Legend> PictureBench::legend() const {
  const char focus = keys_.focus();
  const SliderRow* const row = sliderOf(focus);
  const std::string_view name = row ? row->label : focus == 'l' ? "light" : focus == 't' ? "turn" : "zoom";
  std::vector<Legend> legend{{{"<", ">"}, name}};
  if (row) legend.push_back({{"="}, "type"});
  legend.insert(legend.end(), {{{"drag"}, "turn"},
                               {{"+", "-"}, "zoom"},
                               {{"["}, "Ia = 1"},
                               {{"]"}, "Ip = 1"},
                               {{"H"}, "hue"},
                               {{"w"}, "save"},
                               {{"u"}, "undo"},
                               {{"r"}, "reset"},
                               {{"q"}, "quit"}});
  return legend;
}

std::vector<HelpLine> PictureBench::help() const {
  return {{"drag, wheel, + -", "turn the scene; zoom in or out"},
          {"i p a d s n c 0 l", "go to a slider, or to the light"},
          {"t z", "select turning or zooming"},
          {"arrows", "change the selected control; Shift: ten steps"},
          {"Tab, Shift-Tab", "next slider, previous slider"},
          {"Home End, =", "lowest and highest value; type a value"},
          {"[ ]", "only ambient light; only point light"},
          {"L V", "keep L constant; keep V constant"},
          {"S N O F P K T", "next shading, normals, order, fill, projection, backs, table"},
          {"W", "show wires, normals, overdraw, difference, or which faces are right"},
          {"H B J", "next hue; 8 or 16 bits a cell; nearest in ratio or difference"}};
}

}  // namespace xnewell
