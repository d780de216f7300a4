#include "x11/window/picture_bench.h"

#include <algorithm>

#include "geometry/exact/scale.h"
#include "geometry/view/view.h"
#include "shading/laboratory/exactness.h"
#include "x11/drawing/pen.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/cell_facts.h"
#include "x11/window/caption.h"
#include "x11/window/drawer.h"

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
  return (compact ? "A" : "Not exact: " + orderInWords(order) + ", a") + " wrong face at " +
         grouped(e.wrong) + " of " + grouped(e.samples) + " samples of " +
         sizeText(picture.settings().width, picture.settings().height) + ".";
}

/// The intensities in force: Ia and the sum of all Ip, those of the scene where it has its own.
struct InForce {
  double Ia, Ip;
  InForce(const Illumination& user, const SceneLight& own)
      : Ia{largest(own.Ia.value_or(glm::dvec3{user.Ia}))}, Ip{user.Ip} {
    glm::dvec3 sum{0.0};
    for (const Light& light : own.lights) sum += light.Ip;
    if (!own.lights.empty()) Ip = largest(sum);
  }
};

/// A row for each light: "point 0.50", or the three numbers of a colour.
std::vector<std::string> rowsOf(const std::vector<Light>& lights) {
  std::vector<std::string> rows;
  for (const Light& light : lights) {
    const glm::dvec3& I = light.Ip;
    rows.push_back((light.kind == LightKind::Directional
                        ? "far"
                        : std::string{kLights[static_cast<std::size_t>(light.kind)].name}) +
                   ' ' + fixed(I.r, 2));
    if (I.g != I.r || I.b != I.r) rows.back() += ' ' + fixed(I.g, 2) + ' ' + fixed(I.b, 2);
  }
  return rows;
}

/// Words for the colours that the picture of normals or of a term has of its own. They are in the cells from
/// `first` on.
SceneCellWords wordsOfOwnColors(Show show, const CellUse& use, int first) {
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

Controls PictureBench::controls() {
  const Setup& now = host_.setup();
  const Subject subject = subject_();
  Controls all{lightControl(now, subject, change())};
  all.back().drag = [this](int x, int y, int, int) {
    const glm::dvec3 towards = glm::transpose(toView_) * directionOnBall(column_, x, y);
    host_.change('l', [&](Setup& s) { aimLight(s.picture.light, towards, subject_().centre); });
  };
  for (Control& control : settingControls(now, host_.defaults(), change(), subject.scene)) {
    if (control.key == 'p')  // its thumb stands at Ia + Ip
      control.drag = [this](int x, int, int, int) {
        const TrackRange share{};
        const double sum = valueAt(share, double(x - column_.bar.x) / (column_.bar.width - 1));
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
    button.off = ownOfScene(button.key, subject.scene);
    all.push_back(std::move(button));
  }
  return all;
}

bool PictureBench::grab(int x, int y) {
  const bool drags = Bench::grab(x, y);
  clicked_.reset();
  if (drags && at_.picture.has(x, y)) clicked_ = {x, y};
  return drags;
}

void PictureBench::dragTo(int x, int y) {
  constexpr int kStill = 2;  // units that a hand may tremble in a click
  if (clicked_ && std::abs(x - clicked_->x) <= kStill && std::abs(y - clicked_->y) <= kStill) return;
  clicked_.reset();
  Bench::dragTo(x, y);
}

void PictureBench::drop() {
  Bench::drop();
  if (!clicked_) return;
  const glm::ivec2 at = *clicked_;
  clicked_.reset();
  host_.explain((at.x - at_.picture.x + 0.5) / at_.picture.width,
                (at.y - at_.picture.y + 0.5) / at_.picture.height);
}

KeyTable PictureBench::ownKeys() {
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
  table.push_back({{'['}, "Ia = 1", "only ambient light", all('i')});
  table.push_back({{']'}, "Ip = 1", "only the light of the point", all('p')});
  return table;
}

void PictureBench::draw(Painter paint, const Desk& desk) {
  at_ = desk.layout;
  const Show show = at_.roomy ? desk.setup.show : Show::Shaded;
  if (desk.fresh || show != shownAs_) {
    shown_ = xnewell::shownAs(show, desk.picture, desk.palette, desk.plan, truth_, at_.unit);
    shownAs_ = show;
  }
  use_ = cellUse(shown_.image);
  colors_ = {shown_.palette, {}};
  if (rowOf(show).ownColors && desk.picture.colors().plan() != ColorPlan::Cube)
    colors_.words = wordsOfOwnColors(show, use_, desk.picture.colors().table().first());
  paint.place(shown_.image, at_.picture.x, at_.picture.y);
  counts_ = countsOf(desk.picture);
  drawColumn(paint, desk);
  if (!at_.roomy) return;
  findInexactness(desk);
  if (at_.drawer == Drawer::Whole)
    drawCaption(paint, desk);
  else
    drawHeadlines(paint, desk);
}

void PictureBench::findInexactness(const Desk& desk) {
  if (desk.fresh || !counted_)
    inexact_ = desk.dragging ? std::string{} : inexactness(desk.picture, at_.compact);
  counted_ = !desk.dragging;
}

void PictureBench::drawHeadlines(Painter paint, const Desk& desk) {
  Pen pen{paint, desk.plan};
  const auto large = [&](const Rect& line, std::string_view text, Cell cell) {
    paint.text(line.x, line.y + 23, beginningOf(std::string{text}, line.width, Voice::Title), desk.plan[cell],
               Voice::Title);
  };
  large(at_.headline, desk.title, Cell::Ink);
  const std::string made = captionOf(desk.setup);
  std::string found = shown_.finding;
  if (found.empty() && !desk.coarse) found = inexact_;
  const Cell cell = shown_.finding.empty() && !found.empty() ? Cell::Alarm : Cell::Ink;
  // Large letters where they fit; else the finding in bold, and below it how the picture was made.
  const std::string& main = found.empty() ? made : found;
  if (textWidth(main, Voice::Title) <= at_.finding.width) return large(at_.finding, main, cell);
  const int y = at_.finding.y + 13;
  pen.bold(at_.finding.x, y, beginningOf(main, at_.finding.width), cell);
  if (found.empty()) return;
  pen.soft(at_.finding.x, y + 16, beginningOf(made, at_.finding.width));
}

void PictureBench::drawColumn(Painter paint, const Desk& desk) {
  const Controls all = controls();
  const Control* const pointed = list_.hovered(all) ? list_.hovered(all) : list_.focused(all);
  aside_ = msText(desk.picture.times().total()) + " ms";
  if (pointed && !pointed->is.empty()) {
    const std::string is =
        (pointed->kind == Control::Kind::Slider ? pointed->label + ": " : "") + pointed->is;
    // What a control is for has the line to itself if it must.
    const int room = desk.layout.width - 2 * Sheet::kMargin - textWidth(is) - 18;
    if (textWidth(counts_ + "   " + aside_) <= room)
      aside_ += "   " + is;
    else if (textWidth(counts_) <= room)
      aside_ = is;
    else
      counts_ = is, aside_.clear();
  }
  list_.forgetPlaces();
  list_.place({'t'}, {.area = at_.picture, .grip = at_.picture, .bare = true, .passive = true});
  Pen pen{paint, desk.plan};
  if (!at_.roomy) return list_.draw(pen, all);

  if (at_.drawer != Drawer::Whole) {
    drawDrawer(pen, at_, all, desk.few, list_);
    return list_.draw(pen, all);
  }
  const Subject subject = subject_();
  const Illumination& light = desk.setup.picture.light;
  const bool ramp = !rowOf(desk.setup.show).ownColors && desk.picture.colors().plan() == ColorPlan::OneHue;
  toView_ = vrcRotation(desk.picture.camera().view);
  const SceneLight& own = desk.picture.scene().light;
  const InForce inForce{light, own};
  column_ = layoutOfControls(at_, all, desk.setup);
  for (const auto& [id, place] : column_.places) list_.place(id, place);
  drawLightControls(pen, column_,
                    {.setup = desk.setup,
                     .angles = lightAngles(light, subject.scene.up, subject.centre),
                     .lightInView = toView_ * towardsLight(light, subject.centre),
                     .ball = ballCells(desk.picture, desk.plan, ramp),
                     .ownLights = rowsOf(own.lights),
                     .ambient = inForce.Ia,
                     .lights = inForce.Ip,
                     .IaIsOwn = own.Ia.has_value(),
                     .light = list_.look({'l'}),
                     .Ia = list_.look({'i'}),
                     .Ip = list_.look({'p'})});
  list_.draw(pen, all);
}

void PictureBench::drawCaption(Painter paint, const Desk& desk) {
  Pen pen{paint, desk.plan};
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
  const InForce inForce{l, desk.picture.scene().light};
  std::string line = "Ia " + fixed(inForce.Ia, 2) + "  Ip " + fixed(inForce.Ip, 2) + "  ka " +
                     fixed(l.ka, 2) + "  kd " + fixed(l.kd, 2) + "  ks " + fixed(l.ks, 2) + "  n " +
                     std::to_string(l.n);
  if (!at_.compact) {
    if (l.constantL) line += "  L constant";
    if (l.constantV) line += "  V constant";
    line += "; " + std::string{kTables[static_cast<int>(p.table.kind)].name} + " table, " +
            shadesText(desk.picture);
  }
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

}  // namespace xnewell
