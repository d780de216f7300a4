#include "x11/sides/side_by_side_view.h"

#include <algorithm>
#include <stdexcept>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// The points identify the scene, since a scene is always opened as a whole.
bool isSame(const Scene& a, const Scene& b) {
  return &a == &b || (a.name == b.name && a.mesh.points == b.mesh.points && a.mesh.corners == b.mesh.corners);
}

/// What is worth comparing with A: the right equation with a mistake, or an exact order with an inexact one,
/// and the reverse.
Setup lessonBeside(const Setup& A) {
  Setup B = A;
  if (std::exchange(B.picture.light.mistake, Mistake::None) != Mistake::None) return B;
  B.picture.order = rowOf(A.picture.order).exact ? Order::ZSort : Order::Newell;
  return B;
}

/// The settings of B that differ from those of A. B is A with these over it.
std::vector<Override> differing(const PictureSettings& B, const PictureSettings& A) {
  std::vector<Override> own;
  for (const Setting& setting : settingRows())
    if (const Value value = setting.field.get(B); value != setting.field.get(A))
      own.push_back({&setting, value});
  return own;
}

/// What every pair rests on: only what the pair is about may be wrong, and there must be light to see it.
void layGround(PictureSettings& s) {
  if (!rowOf(s.order).exact) s.order = Order::Newell;
  if (!rowOf(s.shading).lit) s.shading = Shading::Flat;
}

}  // namespace

const std::array<PairRow, 4> kPairs{{
    {"z-sort | Newell", Unlike::Face,
     [](PictureSettings& A, PictureSettings& B) { A.order = Order::ZSort, B.order = Order::Newell; }},
    {"flat | Gouraud", Unlike::Intensity,
     [](PictureSettings& A, PictureSettings& B) { A.shading = Shading::Flat, B.shading = Shading::Gouraud; }},
    {"Gouraud | Phong", Unlike::Intensity,
     [](PictureSettings& A, PictureSettings& B) {
       A.shading = Shading::Gouraud, B.shading = Shading::Phong;
     }},
    {"linear | corrected", Unlike::Color,
     [](PictureSettings& A, PictureSettings& B) {
       A.table.kind = TableKind::Linear, B.table.kind = TableKind::Corrected;
     }},
}};

Setup SideBySideView::beside(const Setup& A) const {
  if (!a_ || !b_) return lessonBeside(A);
  Setup B = *b_;
  const PictureSettings &before = a_->picture, &now = A.picture;
  PictureSettings& b = B.picture;
  b.width = now.width, b.height = now.height;
  b.camera = now.camera, b.lights = now.lights;
  B.fill = A.fill;
  if (joins_) {
    const std::vector<Override> own = differing(b, before);
    b = now;
    (void)applyOverrides(b, own);
    if (b.light.mistake == now.light.mistake) b.light.mistake = Mistake::None;  // right and wrong
  }
  (void)keepFillable(B);
  return B;
}

std::vector<Override> SideBySideView::ownOfB() const {
  if (!a_ || !b_) return differing(lessonBeside(host_.setup()).picture, host_.setup().picture);
  return differing(b_->picture, a_->picture);
}

void SideBySideView::begin(const std::optional<std::vector<Override>>& own, Unlike kind) {
  Setup B = host_.setup();
  if (own) (void)applyOverrides(B.picture, *own);
  put(B, kind);
  if (!own) a_.reset(), b_.reset();  // the order that is worth comparing when the view is opened
}

void SideBySideView::put(const Setup& B, Unlike kind) {
  a_ = host_.setup(), b_ = B;
  (void)keepFillable(*b_);
  kind_ = kind, place_ = 0, joins_ = false;
  picturesB_.reset();  // whatever scene they were of, B stays
  before_.clear();
}

void SideBySideView::follow(const Setup& A) {
  b_ = beside(A);
  a_ = A;
  joins_ = false;
}

void SideBySideView::remember(Changed changed, char control, const Setup& A) {
  if (!before_.empty() && before_.back().changed == changed && before_.back().control == control &&
      changed != Changed::Both)
    before_.back().A = A;
  else
    before_.push_back({changed, control, A, *b_});
}

void SideBySideView::changeFocused(char control, const std::function<void(Setup&)>& edit) {
  const Setup A = host_.setup();
  Setup next = focus_ == 'A' ? A : *b_;
  edit(next);
  (void)keepFillable(next);
  if (next == (focus_ == 'A' ? A : *b_)) return;
  if (focus_ == 'A') {
    remember(Changed::A, control, next);
    host_.change(control, edit);
  } else {
    remember(Changed::B, control, A);
    b_ = next;
  }
}

void SideBySideView::swap(const Setup& A) {
  const Setup B = *b_;
  remember(Changed::Both, 'x', B);
  b_ = A;
  host_.change('x', [&](Setup& s) { s = B; });
}

void SideBySideView::nextPair(const Setup& A) {
  Setup nextA = A, nextB = A;
  const PairRow* row = nullptr;
  do {  // skip a pair that is shown already, in either order
    row = &kPairs[pair_];
    pair_ = (pair_ + 1) % kPairs.size();
    nextA = A;
    layGround(nextA.picture);
    nextB = nextA;
    row->set(nextA.picture, nextB.picture);
    (void)keepFillable(nextA), (void)keepFillable(nextB);
  } while ((nextA == A && nextB == *b_) || (nextA == *b_ && nextB == A));
  kind_ = row->shows;
  place_ = 0;
  remember(Changed::Both, 'g', nextA);
  b_ = nextB;
  host_.change('g', [&](Setup& s) { s = nextA; });
  PictureSettings ground = A.picture;
  layGround(ground);
  host_.tell("A and B are " + std::string{row->name} +
             (ground == A.picture ? "; all else is as in A, the picture of view 1."
                                  : ", in a right order and lit; all else is as in A.") +
             " u undoes this.");
}

bool SideBySideView::undo(const Setup& A) {
  if (before_.empty()) return false;
  const Before last = before_.back();
  if (last.changed != Changed::B && A != last.A) return false;  // the window has changed A since
  before_.pop_back();
  b_ = last.B;
  return last.changed == Changed::B;
}

void SideBySideView::nextPlace() {
  if (places_.empty()) return host_.notify("Nothing differs: there is no place to go to.");
  place_ = (place_ + 1) % static_cast<int>(places_.size());
}

void SideBySideView::nextKind() {
  kind_ = kUnlikes[(static_cast<std::size_t>(kind_) + 1) % kUnlikes.size()].id;
  place_ = 0;
  if (kind_ != Unlike::Intensity || !noIntensities_) return;
  kind_ = Unlike::Color;
  host_.notify("These cells hold single colours, which have no intensity.");
}

Controls SideBySideView::controls() {
  const Setup& A = host_.setup();
  follow(A);
  Controls all;
  const ChangeSetup focused = [this](char control, const auto& edit) { changeFocused(control, edit); };
  for (Control& control :
       settingControls(focus_ == 'A' ? A : *b_, host_.defaults(), focused, subject_().scene)) {
    const char key = control.key;
    if (key == 'W' || key == 'J' || key == 'B') continue;
    if (key == 'P') control = settingControl('P', A, host_.defaults(), change());  // both have one camera
    if (key == 'F') control.off = "Here the program's own scanline code fills both pictures.";
    if (key == 'S' || key == 'N' || key == 'O' || key == 'T') control.legend = "change";
    all.push_back(std::move(control));
  }
  for (Control& control : cameraControls(A, subject_(), change())) {
    control.legend = control.label + " both";
    all.push_back(std::move(control));
  }
  for (const auto& [key, area] : buttons())
    all.push_back({.kind = Control::Kind::Button, .key = key, .part = 1, .set = [this, key = key](double) {
                     host_.pressLetter(key);
                   }});
  return all;
}

std::vector<std::pair<char, Rect>> SideBySideView::buttons() const {
  const Rect& difference = at_.difference;
  return {{'A', at_.captionA},
          {'B', at_.captionB},
          {'f', {difference.x, at_.sections.y + 3, difference.width, 20}},
          {'g', {at_.numbers.x, at_.numbers.y + at_.numbers.height - 18, at_.numbers.width, 18}},
          {'n', difference}};
}

KeyTable SideBySideView::ownKeys() {
  const auto add = [](KeyTable& table, Key key, const char* legend, const char* does, auto act) {
    table.push_back({{key}, legend, does, [act](const Key&) { act(); }});
  };
  KeyTable table;
  const char* const focus = "which one the letters of settings change; Tab is the other, or a click";
  add(table, 'A', "focus", focus, [this] { focus_ = 'A'; });
  add(table, 'B', "focus", focus, [this] { focus_ = 'B'; });
  add(table, NamedKey::Tab, "", focus, [this] { focus_ = focus_ == 'A' ? 'B' : 'A'; });
  add(table, 'x', "swap", "swap A and B", [this] { swap(host_.setup()); });
  add(table, NamedKey::Space, "blink in place", "B in A's place and back: differences jump out",
      [this] { blinking_ = !blinking_; });
  add(table, 'f', "difference of", "compare faces, intensities or colours", [this] { nextKind(); });
  add(table, 'n', "next place", "the next place where they differ", [this] { nextPlace(); });
  add(table, 'g', "next pair", "a pair worth comparing: z-sort | Newell, flat | Gouraud, ...",
      [this] { nextPair(host_.setup()); });
  add(table, NamedKey::Escape, "", "stop blinking, select nothing", [this] {
    blinking_ = false;
    list_.setFocus(std::nullopt);
  });
  table.back().idle = !blinking_ && !list_.focus();
  add(table, 'u', "undo", "undo, redo", [this] {
    if (!undo(host_.setup())) host_.undo();
  });
  return table;
}

void SideBySideView::leave() {
  blinking_ = false;
  list_.setFocus(std::nullopt);
  before_.clear();
  WindowView::leave();
}

bool SideBySideView::late(const Setup&) const { return told() != drawn_ || list_.late() || owes_; }

CachedGroundTruth& SideBySideView::truthOf(const Picture& picture) {
  const auto model = [](const PictureSettings& s) { return std::pair{s.light, s.lights}; };
  return truths_[model(picture.settings()) == model(host_.setup().picture) ? 0 : 1];
}

Picture SideBySideView::makeB(const DrawContext& context) {
  if (!picturesB_ || !isSame(picturesB_->scene(), context.picture.scene())) {
    if (picturesB_) b_ = lessonBeside(context.setup), before_.clear();
    picturesB_.emplace(context.picture);
    measuredA_ = measuredB_ = {};
    placed_.reset(), announced_.reset();
  }
  const PictureSettings& A = context.picture.settings();
  coarse_ = context.coarse || (context.dragging && slow_);
  const auto sized = [&](const Setup& setup) {
    PictureSettings s = setup.picture;
    s.width = A.width, s.height = A.height;
    s.camera = A.camera;
    s.inPixels = A.inPixels;
    if (coarse_) {  // the workbench makes A coarse in the same way
      if (s.shading != Shading::Full) s.shading = Shading::Flat;
      s.order = Order::ZSort;
      s.adapt = 0;
      s.dither = false;
    }
    return s;
  };
  const auto make = [&] { return picturesB_->make(sized(*b_), context.plan[Cell::Well]); };
  const Picture B = [&] {
    try {
      return make();
    } catch (const std::runtime_error& e) {  // a view that shows nothing, or too large a BSP tree
      host_.notify("B cannot be drawn with these settings: " + std::string{e.what()});
      b_ = drawn_ && drawn_->b ? drawn_->b : context.setup;
      return make();
    }
  }();
  slow_ = context.dragging && (coarse_ || B.times().total() > kFluid);
  return B;
}

void SideBySideView::measure(const Picture& A, const Picture& B) {
  if (measuredA_.of == A.settings() && measuredB_.of == B.settings()) return;
  if (measuredA_.of == B.settings() && measuredB_.of == A.settings())
    return std::swap(measuredA_, measuredB_);
  const std::array<BestTime, 2> times = timesOf(A.scene(), A.settings(), B.settings());
  const auto measured = [&](const Picture& picture, const BestTime& time) {
    return Measured{picture.settings(),
                    comparedWithReference(picture, truthOf(picture).of(picture)).difference, time};
  };
  measuredA_ = measured(A, times[0]), measuredB_ = measured(B, times[1]);
}

void SideBySideView::draw(Painter paint, const DrawContext& context) {
  follow(context.setup);
  at_ = layoutOfSides(context.layout.body);
  const Picture pictureB = makeB(context);
  const PictureSettings &ofA = context.picture.settings(), &ofB = pictureB.settings();
  // The truth may take seconds. So this shows first what is ready, and measures once in the next drawing.
  const bool isQuick = truthOf(context.picture).knows(context.picture) && truthOf(pictureB).knows(pictureB);
  if (!context.dragging && !isQuick && announced_ != std::pair{ofA, ofB})
    announced_ = {ofA, ofB}, owes_ = true;
  else if (!context.dragging && (std::exchange(owes_, false) || isQuick))
    measure(context.picture, pictureB);

  const auto own = [&](const Picture& picture, TableKind kind) {
    const Palette palette = picture.palette(CellPlan{kind});
    return context.gray ? forGrayScreen(palette, picture) : palette;
  };
  const Palette ownA = own(context.picture, ofA.table.kind), ownB = own(pictureB, ofB.table.kind);
  const ColoredPicture A{context.picture, ownA}, B{pictureB, ownB};
  noIntensities_ = !hasIntensities(pictureB, context.picture);
  if (kind_ == Unlike::Intensity && noIntensities_) kind_ = Unlike::Color;
  const Difference unlike = unlikeness(kind_, A, B);
  const std::pair<Unlike, std::pair<PictureSettings, PictureSettings>> placed{kind_, {ofA, ofB}};
  if (context.dragging) {
    places_.clear(), placed_.reset();
  } else if (placed_ != placed) {
    const auto samples = [&](int units) { return units * ofA.width / at_.A.width; };
    places_ = placesOf(unlike, samples(at_.frameWidth), samples(at_.frameHeight));
    placed_ = placed;
  }
  if (place_ >= static_cast<int>(places_.size())) place_ = 0;
  const std::optional<DifferingPlace> place = places_.empty() ? std::nullopt : std::optional{places_[place_]};
  const OnePalette one = onePalette(A, B, context.plan, context.palette, most_());
  colors_ = {one.palette, std::nullopt};
  if (one.shared) {
    const std::string rule = std::to_string(one.colors) + " colours, what A and B show";
    colors_.words = SceneCellWords{.cells = {context.picture.table().first(), one.colors},
                                   .rule = rule,
                                   .shortRule = rule,
                                   .what = "colours"};
  }

  const PictureSettings &askedA = context.setup.picture, &askedB = b_->picture;
  std::string pairs;
  for (const PairRow& row : kPairs) pairs += (pairs.empty() ? "" : ", ") + std::string{row.name};
  if (textWidth(pairs) + 21 > at_.numbers.width) pairs = "next pair: " + std::string{kPairs[pair_].name};
  const auto factsOfSide = [](const Picture& picture, const PictureSettings& asked,
                              const PictureSettings& other, const Measured& measured) {
    return SideFacts{phrasesOf(asked, other), measured.errors,
                     static_cast<std::int64_t>(picture.sorted().fragments.size()),
                     picture.sorted().statistics.splits, measured.time};
  };
  paint.fillRect(context.layout.body, context.plan[Cell::Paper]);
  const bool known = measuredA_.of == ofA && measuredB_.of == ofB;
  words_ = drawSidesPage(
      paint, at_,
      {.A = one.A,
       .B = one.B,
       .unlike = unlike,
       .ofA = factsOfSide(context.picture, askedA, askedB, measuredA_),
       .ofB = factsOfSide(pictureB, askedB, askedA, measuredB_),
       .finding =
           known ? findingOf(context.picture, pictureB, measuredA_.errors, measuredB_.errors, unlike, place)
                 : Finding{},
       .known = known,
       .place = place,
       .number = place_,
       .places = static_cast<int>(places_.size()),
       .focus = focus_,
       .blinking = blinking_,
       .colors = one.shared ? "Both in one palette of " + std::to_string(one.colors) + " colours, " +
                                  (one.exact ? "all exact." : "each the nearest.")
                            : "",
       .pairs = pairs},
      context.plan);
  use_ = cellUse(one.A);
  const CellUse second = cellUse(one.B);
  for (std::size_t k = 0; k < use_.samples.size(); ++k) use_.samples[k] += second.samples[k];
  status_ = sidesStatus(askedA, askedB);
  const Controls all = controls();
  list_.forgetPlaces();
  for (const Rect& picture : {at_.A, at_.B})
    list_.place({'t'}, {.area = picture, .grip = picture, .bare = true, .passive = true});
  for (const auto& [key, area] : buttons()) list_.place({key, 1}, {.area = area, .bare = true});
  Pen pen{paint, context.plan};
  list_.draw(pen, all);
  const Control* const selected = list_.focused(all);
  if (selected && selected->kind == Control::Kind::Slider)
    aside_ = "arrows: " + selected->label + " of " + focus_ + ", " + textOf(selected->range, selected->value);
  else
    aside_ = known                       ? "the numbers are of these pictures"
             : coarse_ || context.coarse ? "coarse while dragging; numbers follow"
             : owes_ || context.dragging ? "numbers follow"
                                         : "not measured";
  drawn_ = told();
}

}  // namespace xnewell
