#include "x11/pixel/pixel_view.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"

namespace xnewell {

namespace {

/// What three letters are for; they share a line in the list of all keys.
const char* const kTurns = "with the arrows: turn the scene, zoom, turn the ball of N, L, V and R";

}  // namespace

PixelFrame frameOf(const Layout& at) {
  const Rect& body = at.body;
  const int left = at.compact ? 250 : std::max(404, body.width * 2 / 5), gap = at.compact ? 26 : 32;
  const int controls = at.compact ? 52 : 80, least = at.compact ? 120 : 210;
  PixelFrame frame;
  frame.picture = framed({body.x, body.y, left, std::min(left * 2 / 3, body.height - gap - controls - least)},
                         at.frame.width);
  const int top = frame.picture.y + frame.picture.height + gap;
  frame.below = {body.x, top, left,
                 std::max(least, std::min(left * 11 / 20, body.y + body.height - top - controls)) + 14};
  frame.column = {body.x + left + kMargin, body.y, body.width - left - kMargin, body.height};
  frame.controls = top + frame.below.height + (at.compact ? 6 : 16);
  return frame;
}

void PixelView::choose(double x, double y) {
  x_ = std::clamp(x, 0.0, 1.0), y_ = std::clamp(y, 0.0, 1.0);
  chosen_.reset();
  quiz_.startAgain();
  found_.reset(), now_.reset();
  late_ = true;
}

void PixelView::choose(glm::ivec2 pixel) {
  choose(0.5, 0.5);
  asked_ = pixel;
}

void PixelView::goTo(int column, int row) {
  choose((std::clamp(column, 0, width_ - 1) + 0.5) / width_,
         (std::clamp(row, 0, height_ - 1) + 0.5) / height_);
}

void PixelView::move(int columns, int rows) {
  goTo(static_cast<int>(x_ * width_) + columns, static_cast<int>(y_ * height_) + rows);
}

void PixelView::walk(int steps) {
  if (painted_ == 0) return host_.notify("No polygon is at this sample.");
  const int to = chosen_.value_or(shown_) + steps;
  if (to < 0 || to >= painted_)
    return host_.notify(to < 0 ? "This is the first polygon at this sample."
                               : "This is the last polygon at this sample.");
  chosen_ = to;
  late_ = true;
}

Controls PixelView::controls() {
  Controls all = settingControls(host_.setup(), host_.defaults(), change(), subject_().scene);
  std::erase_if(all,
                [](const Control& control) { return control.key == 'W'; });  // this view shows what is shaded
  for (Control& control : all)
    if (control.key == 'E') control.legend = control.label;
  for (Control& control : cameraControls(host_.setup(), subject_(), change())) {
    control.drag = {};
    control.is = kTurns;
    all.push_back(std::move(control));
  }
  // The picture: a press or a drag takes the pixel along.
  all.push_back({.kind = Control::Kind::Own, .drag = [this](int x, int y, int, int) {
                   choose((x - picture_.x + 0.5) / picture_.width, (y - picture_.y + 0.5) / picture_.height);
                 }});
  addParts(all);
  return all;
}

void PixelView::turnBall(double around, double down) {
  ball_.around += around;
  ball_.down = std::clamp(ball_.down + down, -90.0, 90.0);
  late_ = true;
}

/// The parts of the page that the pointer can press: the ball, the pixels around, and the history.
void PixelView::addParts(Controls& all) {
  all.push_back({.kind = Control::Kind::Own,
                 .key = 'b',
                 .label = "ball",
                 .is = kTurns,
                 .move = [this](int along, int up) { turnBall(5.0 * along, 5.0 * up); },
                 .drag = [this](int, int, int dx, int dy) { turnBall(dx, dy); }});
  all.push_back({.kind = Control::Kind::Own, .part = 1, .drag = [this](int x, int y, int dx, int dy) {
                   const int side = around_.width / (2 * kAround + 1);
                   if (side > 0 && dx == 0 && dy == 0)
                     move((x - around_.x) / side - kAround, (y - around_.y) / side - kAround);
                 }});
  all.push_back({.kind = Control::Kind::Own, .part = 2, .drag = [this](int x, int y, int, int) {
                   for (const page::Pressed& one : pressed_)
                     if (one.id == kPressHistory && one.area.has(x, y)) chosen_ = one.row, late_ = true;
                 }});
}

KeyTable PixelView::ownKeys() {
  KeyTable table;
  const auto moves = [this](int columns, int rows) {
    return [this, columns, rows](const Key& key) {
      const int times = key.shift ? 10 : 1;
      move(times * columns, times * rows);
    };
  };
  if (const Controls all = controls(); !list_.focused(all)) {
    const std::string does = "move to a neighbour; Shift: ten pixels; or click in the picture";
    table = {{{NamedKey::Left}, "pixel", does, moves(-1, 0)},
             {{NamedKey::Right}, "pixel", does, moves(1, 0)},
             {{NamedKey::Up}, "pixel", does, moves(0, -1)},
             {{NamedKey::Down}, "pixel", does, moves(0, 1)}};
  }
  const auto add = [&](Key key, std::string legend, std::string does, std::function<void()> act) {
    table.push_back(
        {{key}, std::move(legend), std::move(does), [act = std::move(act)](const Key&) { act(); }});
  };
  add('g', "go to", "go to a pixel by its column and row", [this] {
    host_.ask({.asks = "go to the pixel x,y", .take = [this](const std::string& text) -> std::string {
                 const std::size_t comma = text.find(',');
                 const auto x = wholeNumber(text.substr(0, comma));
                 const auto y =
                     comma == std::string::npos ? std::nullopt : wholeNumber(text.substr(comma + 1));
                 if (!x || !y || *x < 0 || *y < 0 || *x >= width_ || *y >= height_)
                   return "Type a column and a row, 0,0 to " + std::to_string(width_ - 1) + "," +
                          std::to_string(height_ - 1) + ".";
                 goTo(*x, *y);
                 return {};
               }});
  });
  const std::string polygon = "the polygon that was painted before, after: explain it";
  add(NamedKey::PageUp, "polygon", polygon, [this] { walk(-1); });
  add(NamedKey::PageDown, "polygon", polygon, [this] { walk(1); });
  add('h', "", polygon, [this] {  // before, also in a lecture, which has the other two
    if (painted_ < 2) return walk(-1);
    chosen_ = (chosen_.value_or(shown_) + painted_ - 1) % painted_;
    late_ = true;
  });
  add('y', "predict", "predict a number: it is hidden until you type it",
      [this] { quiz_.ask("No number of this pixel can be predicted."); });
  table.back().waits = late(host_.setup());
  const auto next = [&](char key, const char* legend, int& which, const int& count, const char* none) {
    table.push_back({{key},
                     *none == 0 ? legend : "",
                     "the next vertex of Gouraud shading; the next channel",
                     [this, &which, &count](const Key&) {
                       which = (which + 1) % std::max(1, count);
                       late_ = true;
                     },
                     none});
  };
  next('j', "vertex", vertex_, vertices_,
       vertices_ > 0 ? "" : "Only Gouraud shading evaluates the light at vertices.");
  next('x', "channel", channel_, channels_, channels_ > 1 ? "" : "The picture has one channel.");
  add('k', "keep", "keep this pixel's numbers, to compare with what comes; or no longer", [this] {
    kept_ = kept_ ? std::nullopt : now_;
    late_ = true;
    if (kept_ && quiz_.isHiding())
      host_.tell("Kept. k forgets it.");
    else if (kept_)
      host_.tell("Kept: I " + kept_->I + ", cell " + std::to_string(kept_->cell) + ". k forgets it.");
  });
  add(NamedKey::Return, "the stepper", "step through the depth sort",
      [this] { host_.switchTo(View::DepthSort); });
  add(NamedKey::Escape, "", "show what predict hides; give the arrows back to the pixel", [this] {
    quiz_.showAll();
    list_.setFocus(std::nullopt);
  });
  table.back().idle = !quiz_.isHiding() && !list_.focus();
  append(table, zoomKeys(host_.setup(), subject_(), change()));
  return table;
}

void PixelView::draw(Painter paint, const DrawContext& context) {
  const PixelFrame at = frameOf(context.layout);
  picture_ = at.picture;
  const IndexImage& image = context.picture.image();
  width_ = image.width, height_ = image.height;
  if (const std::optional<glm::ivec2> asked = std::exchange(asked_, std::nullopt)) {
    goTo(asked->x, asked->y);
  }
  const int i = pixel().x, j = pixel().y;
  const bool changed = setup_ && *setup_ != context.setup && !context.dragging;
  if (changed) chosen_.reset(), quiz_.startAgain();
  setup_ = context.setup;
  late_ = false;
  const auto shared = std::make_shared<const PixelStory>(context.picture, i, j);
  const PixelStory& story = *shared;
  painted_ = static_cast<int>(story.history.painted.size()), shown_ = story.history.shown;
  if (chosen_ && *chosen_ >= painted_) chosen_.reset();
  const int chosen = chosen_.value_or(std::max(0, shown_));
  cell_ = story.cell();
  now_.reset();
  vertices_ = 0, channels_ = 1;
  if (painted_ > 0) {
    const Explanation& e = story.explained[static_cast<std::size_t>(chosen)];
    if (e.method == Shading::Gouraud) vertices_ = static_cast<int>(e.vertices.size());
    channels_ = e.channels;
  }
  if (const Explanation* const shown = story.shown())
    now_ = PixelBefore{intensityWords(story, *shown), story.cell()};
  if (!found_) found_ = now_;
  vertex_ = vertices_ > 0 ? vertex_ % vertices_ : 0, channel_ %= channels_;
  const PixelChoice choice{.chosen = chosen,
                           .vertex = vertex_,
                           .channel = channel_,
                           .before = kept_            ? kept_
                                     : found_ != now_ ? found_
                                                      : std::nullopt,
                           .ball = ball_,
                           .palette = &context.palette,
                           .shownBits = context.shownBits};
  const page::Page page = page::ofPixel(shared, choice);
  quiz_.setQuestions(page.questions);

  paint.fit(image, at.picture);
  const Rect mark{at.picture.x + i * at.picture.width / width_ - 7,
                  at.picture.y + j * at.picture.height / height_ - 7, 15, 15};
  Painter inside = paint.within(at.picture);
  inside.frame({mark.x - 1, mark.y - 1, mark.width + 2, mark.height + 2}, context.plan[Cell::Black]);
  inside.frame(mark, context.plan[Cell::White]);
  Pen pen{paint, context.plan};
  if (painted_ > 0) {
    const Explanation& e = story.explained[static_cast<std::size_t>(chosen)];
    const glm::dvec2 place =
        vertices_ > 0 ? e.vertices[static_cast<std::size_t>(vertex_)].at : glm::dvec2{i + 0.5, j + 0.5};
    const int which = vertices_ > 0 ? e.vertices[static_cast<std::size_t>(vertex_)].equation : 0;
    if (which >= 0 && which < std::ssize(e.equations))
      drawVectors(pen, picture_,
                  {picture_.x + static_cast<int>(place.x * picture_.width / width_),
                   picture_.y + static_cast<int>(place.y * picture_.height / height_)},
                  story, e.equations[static_cast<std::size_t>(which)]);
  }
  const int pitch = page::pitchOf(context.layout.body);
  pressed_ = page::draw(pen, page, at.column, pitch, quiz_.hiding());
  for (const page::Pressed& one :
       page::draw(pen, page::besidePixel(shared, choice), at.below, pitch, quiz_.hiding()))
    pressed_.push_back(one);
  const Controls all = controls();
  list_.forgetPlaces();
  const RowStyle narrow{.width = at.below.width, .track = at.below.width - 84 - 60};
  int y = at.controls;
  for (const char key : {'s', 'n'}) y = list_.placeRow(all, key, at.below.x, y, narrow);
  list_.place({}, {.area = at.picture, .grip = at.picture, .bare = true});
  for (const page::Pressed& one : pressed_) {
    if (one.id == kPressAround) around_ = one.area;
    const bool ball = one.id == kPressBall;
    list_.place(ball ? ControlId{'b'} : ControlId{0, one.id == kPressAround ? 1 : 2},
                {.area = one.area, .grip = one.area, .bare = true, .passive = !ball});
  }
  list_.draw(pen, all);
  status_ = "pixel " + std::to_string(i) + ", " + std::to_string(j) + " of " + sizeText(width_, height_) +
            ": " +
            (shown_ < 0
                 ? std::string{"ground"}
                 : "face " + faceName(context.picture,
                                      story.history.painted[static_cast<std::size_t>(shown_)].fragment.face));
  words_ = quiz_.isHiding() ? std::vector<std::string>{} : page::asLines(page);
  words_.insert(words_.begin(), status_);
}

}  // namespace xnewell
