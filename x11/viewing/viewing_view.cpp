#include "x11/viewing/viewing_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "x11/drawing/wording.h"
#include "x11/viewing/view_controls.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

constexpr double kLeastZoom = 0.2, kMostZoom = 30.0;
const char* const kOutside = "with the arrows: turn the view from outside, zoom it";
constexpr int kHandleParts = 10;  // the parts of key 0 from here on are the handles
constexpr int kHandleReach = 6;   // units from a handle's middle that still hit it

ControlId controlOf(ViewHandle handle) { return {0, kHandleParts + static_cast<int>(handle)}; }

}  // namespace

ViewingLayout layoutOfViewing(const Layout& at) {
  ViewingLayout layout;
  const Rect& body = at.body;
  const int left = at.controls.x - kMargin - body.x;
  layout.narrow = left < 600;
  layout.pitch = at.low ? 13 : at.compact ? 14 : 16;
  layout.rowPitch = at.low ? 17 : at.compact ? 18 : 22;
  layout.column = {at.controls.x, body.y, kControls, body.height};
  constexpr int kGap = 16, kStages = static_cast<int>(kViewStages.size());
  const int width = (left - (kStages - 1) * kGap) / kStages;
  const int height = std::min(width * 3 / 4, body.height / 9), name = at.low ? 14 : 18;
  const int table = 17 * layout.pitch / 2 + 16, gap = at.low ? 6 : 14;
  layout.outside = {body.x, body.y, left, body.height - table - gap - height - name - gap};
  const int y = layout.outside.y + layout.outside.height + gap;
  for (int k = 0; k < kStages; ++k)
    layout.small[static_cast<std::size_t>(k)] = {body.x + k * (width + kGap), y, width, height};
  layout.table = {body.x, y + height + name + gap - (at.low ? 4 : 6), left, table};
  return layout;
}

void ViewingView::begin(int stage, const std::string& vertex) {
  choose(std::max(0, stage - 1));
  asked_ = vertex;
  vertex_.reset();
}

const Camera& ViewingView::camera() {
  const Subject subject = subject_();
  const CameraSettings& settings = host_.setup().picture.camera;
  if (!placed_ || placed_->scene != &subject.scene || placed_->settings != settings ||
      placed_->aspect != subject.aspect) {
    try {
      placed_ = Placed{&subject.scene, settings, subject.aspect, cameraOf(host_.setup(), subject)};
    } catch (const ViewError&) {  // the next picture says so, and brings back what was
      if (!placed_) placed_ = Placed{&subject.scene, settings, subject.aspect, Camera{}};
    }
  }
  return placed_->camera;
}

void ViewingView::choose(int stage) {
  stage_ = static_cast<ViewStage>(std::clamp(stage, 0, static_cast<int>(kViewStages.size()) - 1));
  late_ = true;
}

void ViewingView::turn(double around, double down) {
  if (stage_ == ViewStage::Snapped)
    return host_.notify("The grid is seen straight on: choose another stage to turn the view.");
  turn_.around = std::remainder(turn_.around + around, 360.0);
  turn_.down = std::clamp(turn_.down + down, -90.0, 110.0);
  late_ = true;
}

bool ViewingView::zoom(double factor) {
  turn_.zoom = std::clamp(turn_.zoom * factor, kLeastZoom, kMostZoom);
  late_ = true;
  return true;
}

Controls ViewingView::controls() {
  const Oblique lean = leanOf(camera().view);
  if (camera().view.projection == Projection::Parallel && lean.length > 1e-9) angle_ = lean.angle;
  Controls all;
  all.push_back({.kind = Kind::Own,
                 .key = 's',
                 .label = "stage",
                 .is = "choose a stage with the arrows; or click it",
                 .legend = "stage",
                 .words = std::string{rowOf(stage_).name},
                 .move = [this](int along, int up) { choose(static_cast<int>(stage_) + along + up); }});
  for (Control& control : viewControls(subject_(), camera(), angle_, change(), host_))
    all.push_back(std::move(control));
  Control matrix{.kind = Kind::Choice,
                 .key = 'M',
                 .label = "matrix",
                 .is = "which matrix is shown",
                 .legend = "matrix",
                 .value = static_cast<double>(matrix_),
                 .set = [this](double option) {
                   matrix_ = static_cast<ShownMatrix>(static_cast<int>(option));
                   late_ = true;
                 }};
  for (const std::string_view name : kShownMatrices) matrix.options.emplace_back(name);
  all.push_back(std::move(matrix));
  addParts(all);
  addHandles(all);
  return all;
}

/// What the arrows or the pointer turn or choose.
void ViewingView::addParts(Controls& all) {
  all.push_back({.kind = Kind::Own,
                 .key = 't',
                 .label = "turn",
                 .is = kOutside,
                 .legend = "turn",
                 .move = [this](int along, int up) { turn(3.0 * along, 3.0 * up); },
                 .drag = [this](int, int, int dx, int dy) { turn(-0.5 * dx, 0.5 * dy); }});
  all.push_back({.kind = Kind::Own,
                 .key = 'z',
                 .label = "zoom",
                 .is = kOutside,
                 .legend = "zoom",
                 .move = [this](int along, int up) { (void)zoom(std::pow(1.05, along + up)); }});
  const auto chooses = [this](const std::array<Rect, kViewStages.size()>& places) {
    return [this, &places](int x, int y, int, int) {
      for (std::size_t k = 0; k < places.size(); ++k)
        if (places[k].has(x, y)) choose(static_cast<int>(k));
    };
  };
  all.push_back({.kind = Kind::Own, .part = 1, .drag = chooses(small_)});
  all.push_back({.kind = Kind::Own, .part = 2, .drag = chooses(rows_)});
}

void ViewingView::addHandles(Controls& all) {
  for (const ViewHandleRow& row : kViewHandles)
    all.push_back({.kind = Kind::Own,
                   .part = controlOf(row.id).part,
                   .label = "handle",
                   .is = std::string{row.is},
                   .drag = [this, id = row.id](int x, int y, int, int) {
                     dragHandle(id, {x, y});
                   }});
}

void ViewingView::dragHandle(ViewHandle handle, const glm::ivec2& pointer) {
  const Controls all = controls();
  if (!drag_ || drag_->id() != handle) {
    const auto at = std::ranges::find(handles_, handle, &HandleAt::id);
    if (at == handles_.end() || !image_) return;
    drag_.emplace(*at, image_->camera(), all, pointer, unit_);
    list_.setFocus(rowOf(handle).number);
  }
  drag_->to(pointer, all, host_);
}

std::string ViewingView::nameOf(ViewHandle handle, const Controls& all) {
  const ViewHandleRow& row = rowOf(handle);
  const auto first = std::ranges::find(all, row.number, &Control::id);
  std::string name = row.numbers == 1 ? first->label : first->name();
  for (int k = 0; k < row.numbers; ++k) name += ' ' + textOf(first[k].range, first[k].value);
  return name;
}

KeyTable ViewingView::ownKeys() {
  KeyTable table;
  if (const Controls all = controls(); !list_.focused(all)) {
    const std::string does = "the stage before, the next";
    table = {
        {{NamedKey::Left}, "stage", does, [this](const Key&) { choose(static_cast<int>(stage_) - 1); }},
        {{NamedKey::Right}, "stage", does, [this](const Key&) { choose(static_cast<int>(stage_) + 1); }}};
  }
  table.push_back({.legend = "square: its number; else turn",
                   .does =
                       "a square of the view from outside: change its number, in stages 1 to 3; elsewhere: "
                       "turn that view",
                   .gesture = "drag"});
  table.push_back({.does = "choose a vertex", .gesture = "click"});
  table.push_back({{'g'}, "vertex", "go to a vertex: FACE.CORNER, or its number", [this](const Key&) {
                     host_.ask({.asks = "vertex FACE.CORNER, or its number",
                                .text = vertex(),
                                .take = [this](const std::string& text) -> std::string {
                                  const Mesh& mesh = subject_().scene.mesh;
                                  const std::optional<FaceCorner> found = cornerOf(mesh, text);
                                  if (!found)
                                    return "There is no such vertex: faces are 0 to " +
                                           grouped(mesh.faceCount() - 1) + ", vertices 0 to " +
                                           grouped(static_cast<std::int64_t>(mesh.points.size()) - 1) +
                                           ", corners count from 1.";
                                  vertex_ = found, late_ = true;
                                  return {};
                                }});
                   }});
  table.push_back({{NamedKey::Escape}, "", "give the arrows back to the stages", [this](const Key&) {
                     list_.setFocus(std::nullopt);
                   }});
  table.back().idle = !list_.focus();
  return table;
}

bool ViewingView::grab(int x, int y) {
  const bool drags = WindowView::grab(x, y);
  clicked_.reset();
  if (drags && !drag_ && outside_.has(x, y)) clicked_ = {x, y};
  return drags;
}

void ViewingView::dragTo(int x, int y) {
  constexpr int kStill = 2;  // units that a hand may tremble in a click
  if (clicked_ && std::abs(x - clicked_->x) <= kStill && std::abs(y - clicked_->y) <= kStill) return;
  clicked_.reset();
  WindowView::dragTo(x, y);
}

void ViewingView::drop() {
  WindowView::drop();
  if (drag_) drag_.reset(), late_ = true;  // the drawing fits the volume again
  if (const auto at = std::exchange(clicked_, std::nullopt)) pick(at->x, at->y);
}

void ViewingView::leave() {
  WindowView::leave();
  drag_.reset();
}

void ViewingView::pick(int x, int y) {
  if (!image_ || !story_) return host_.notify("Choose another stage to click a vertex, or press g.");
  const glm::dvec2 place{(x - outside_.x + 0.5) * unit_, (y - outside_.y + 0.5) * unit_};
  const int face = image_->faceAt(static_cast<int>(place.x), static_cast<int>(place.y));
  if (face < 0) return host_.notify("No face is here: click one near a corner.");
  const Mesh& mesh = subject_().scene.mesh;
  double least = std::numeric_limits<double>::infinity();
  const std::span<const int> corners = mesh.face(face);
  for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
    const glm::dvec4 p = story_->stages.at(stage_, mesh.points[corners[k]]);
    if (!(p.w > 0.0)) continue;
    const double away = glm::length(glm::dvec2{image_->camera()(glm::dvec3{p} / p.w)} - place);
    if (away < least) least = away, vertex_ = FaceCorner{face, k};
  }
  late_ = true;
}

int ViewingView::placeControls(const Controls& all, const ViewingLayout& at) {
  list_.forgetPlaces();
  const RowStyle style{.width = at.column.width, .pitch = at.rowPitch};
  int y = at.column.y + (at.narrow ? 24 : 33);
  for (const char key : {'P', 'O', 'a', 'v', 'n', 'y', 'p', 'o', 'f', 'b', 'M'})
    y = list_.placeRow(all, key, at.column.x, y, style);
  for (const HandleAt& handle : handles_) {
    const int left = outside_.x + static_cast<int>(std::lround(handle.at.x / unit_));
    const int top = outside_.y + static_cast<int>(std::lround(handle.at.y / unit_));
    const Rect area = intersection(
        {left - kHandleReach, top - kHandleReach, 2 * kHandleReach + 1, 2 * kHandleReach + 1}, outside_);
    list_.place(controlOf(handle.id),
                {.area = area, .grip = area, .bare = true, .passive = true, .above = true});
  }
  list_.place({'t'}, {.area = outside_, .grip = outside_, .bare = true, .passive = true});
  for (const Rect& area : small_)
    list_.place({0, 1}, {.area = area, .grip = area, .bare = true, .passive = true});
  for (const Rect& area : rows_)
    list_.place({0, 2}, {.area = area, .grip = area, .bare = true, .passive = true});
  return y - at.rowPitch + 10;
}

void ViewingView::draw(Painter paint, const DrawContext& context) {
  late_ = false;
  const ViewingLayout at = layoutOfViewing(context.layout);
  unit_ = context.layout.unit;
  const Picture& picture = context.picture;
  const Mesh& mesh = picture.scene().mesh;
  if (std::exchange(faces_, mesh.faceCount()) != mesh.faceCount()) vertex_.reset();
  if (!vertex_ && !asked_.empty()) {
    vertex_ = cornerOf(mesh, asked_);
    if (!vertex_) host_.tell("The scene has no vertex " + asked_ + ".");
    asked_.clear();
  }
  if (vertex_ && (vertex_->face >= mesh.faceCount() ||
                  vertex_->corner >= static_cast<int>(mesh.face(vertex_->face).size())))
    vertex_.reset();
  if (!vertex_) vertex_ = middleCorner(picture);
  story_ = std::make_shared<const ViewingStory>(picture, *vertex_);
  if (!lit_ || lit_->picture.settings() != picture.settings() || &lit_->picture.scene() != &picture.scene() ||
      lit_->palette != context.palette)
    lit_.emplace(
        Lit{picture, context.palette, LitParts{picture, context.palette}, StagePoints{mesh, story_->stages}}),
        ++made_;

  outside_ = at.outside, small_ = at.small;
  Pen pen{paint, context.plan};
  OutsideView view{.picture = picture,
                   .lit = lit_->parts,
                   .story = *story_,
                   .points = lit_->points,
                   .images = images_,
                   .made = made_,
                   .stage = stage_,
                   .turn = turn_,
                   .handles = true};
  const Controls all = controls();
  for (const ViewHandleRow& row : kViewHandles)
    if (const Look look = list_.look(controlOf(row.id)); drag_ ? drag_->id() == row.id : look.hovered)
      view.handle = row.id, view.handleName = nameOf(row.id, all);
  if (drag_) view.held = &drag_->camera();
  image_ = drawStage(pen, outside_, view);
  handles_.clear();
  if (image_)
    handles_ = handlesAt(*story_, picture.camera().view, stage_, *image_, lengthUnit(picture.scene()), unit_);
  pen.paint.text(outside_.x + 8, outside_.y + 17,
                 beginningOf(stageTitle(*story_, stage_), outside_.width - 16), pen(Cell::WellText));
  const bool empty = picture.snapped().faces.empty();
  const std::string lengths = lengthsText(picture.scene());
  int last = outside_.y + outside_.height - 24;
  for (const std::string_view line : {empty ? kNothingShows : "", std::string_view{lengths}})
    if (!line.empty())
      pen.paint.text(outside_.x + 8, std::exchange(last, last - 16), line, pen(Cell::WellText));
  for (const ViewStageRow& row : kViewStages) {
    const Rect& small = small_[static_cast<std::size_t>(row.id)];
    OutsideView one = view;
    one.stage = row.id, one.turn.zoom = 1.0;
    drawSmallStage(pen, small, one);
    const std::string name = (at.narrow ? "" : std::to_string(static_cast<int>(row.id) + 1) + ' ') +
                             std::string{rowOf(row.id).name};
    const int x = small.x + (small.width - textWidth(name)) / 2, y = small.y + small.height + 13;
    if (row.id == stage_) {
      for (const int k : {1, 2})
        pen.paint.frame({small.x - k, small.y - k, small.width + 2 * k, small.height + 2 * k},
                        pen(Cell::Ink));
      pen.bold(x, y, name);
    } else {
      pen.ink(x, y, name);
    }
  }
  const page::OfViewing of{story_, picture};
  const page::Page stages = page::stagesOf(of, stage_), light = page::matrixAndLight(of, stage_, matrix_);
  for (const page::Pressed& row : page::draw(pen, stages, at.table, at.pitch))
    rows_[static_cast<std::size_t>(row.row)] = row.area;
  pen.caps(at.column.x, at.column.y + 10, "view");
  const int top = placeControls(all, at);
  (void)page::draw(pen, light, {at.column.x, top, at.column.width, at.column.y + at.column.height - top},
                   at.pitch);
  list_.draw(pen, all);

  cell_ = story_->world().cell;
  words_ = {stageTitle(*story_, stage_)};
  for (const page::Page* one : {&stages, &light})
    for (std::string& line : page::asLines(*one)) words_.push_back(std::move(line));
  const Control* const pointed = list_.hovered(all) ? list_.hovered(all) : list_.focused(all);
  status_ = pointed && !pointed->is.empty() ? pointed->is
            : empty                         ? std::string{kNothingShows}
                                            : findingOf(*story_, stage_).bold;
  aside_ = "vertex " + textOf(*vertex_) + " of " + partOf(picture.scene(), *vertex_);
}

}  // namespace xnewell
