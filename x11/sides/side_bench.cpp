#include "x11/sides/side_bench.h"

#include <algorithm>
#include <stdexcept>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// The points identify the scene, since a scene is always opened as a whole.
bool isSame(const Scene& a, const Scene& b) {
  return &a == &b || (a.name == b.name && a.mesh.points == b.mesh.points && a.mesh.corners == b.mesh.corners);
}

/// The order that is worth comparing with that of A: an exact one with an inexact one, and the reverse.
Setup lessonBeside(const Setup& A) {
  Setup B = A;
  B.picture.order = rowOf(A.picture.order).exact ? Order::ZSort : Order::Newell;
  return B;
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

Setup SideBench::beside(const Setup& A) const {
  if (!a_ || !b_) return lessonBeside(A);
  Setup B = *b_;
  const PictureSettings &before = a_->picture, &now = A.picture;
  PictureSettings& b = B.picture;
  b.width = now.width, b.height = now.height;
  b.camera = now.camera;
  B.fill = A.fill;
  (void)keepFillable(B);
  if (!joins_) return B;
  for (const Setting& setting : settingRows())  // B's follows A's where both had the same
    if (setting.field.get(b) == setting.field.get(before)) setting.field.set(b, setting.field.get(now));
  // Each thumb of the bar follows alone; together they stay within it.
  (void)keepWithinOne(b.light, true, false);
  return B;
}

void SideBench::put(const Setup& B) {
  a_ = host_->setup(), b_ = B;
  (void)keepFillable(*b_);
  kind_ = Unlike::Intensity, place_ = 0, joins_ = false;
  picturesB_.reset();  // whatever scene they were of, B stays
  before_.clear();
}

void SideBench::follow(const Setup& A) {
  b_ = beside(A);
  a_ = A;
  joins_ = false;
}

void SideBench::remember(Changed changed, char control, const Setup& A) {
  if (!before_.empty() && before_.back().changed == changed && before_.back().control == control &&
      changed != Changed::Both)
    before_.back().A = A;
  else
    before_.push_back({changed, control, A, *b_});
}

void SideBench::change(char control, const Setup& A, const std::function<void(Setup&)>& edit) {
  Setup next = focus_ == 'A' ? A : *b_;
  edit(next);
  (void)keepFillable(next);
  if (next == (focus_ == 'A' ? A : *b_)) return;
  if (focus_ == 'A') {
    remember(Changed::A, control, next);
    host_->change(control, edit);
  } else {
    remember(Changed::B, control, A);
    b_ = next;
  }
}

void SideBench::swap(const Setup& A) {
  const Setup B = *b_;
  remember(Changed::Both, 'x', B);
  b_ = A;
  host_->change('x', [&](Setup& s) { s = B; });
}

void SideBench::nextPair(const Setup& A) {
  Setup nextA = A, nextB = A;
  const PairRow* row = nullptr;
  do {  // skip a pair that is shown already, in either order
    row = &kPairs[pair_];
    pair_ = (pair_ + 1) % kPairs.size();
    nextA = nextB = A;
    row->set(nextA.picture, nextB.picture);
    (void)keepFillable(nextA), (void)keepFillable(nextB);
  } while ((nextA == A && nextB == *b_) || (nextA == *b_ && nextB == A));
  kind_ = row->shows;
  place_ = 0;
  remember(Changed::Both, 'g', nextA);
  b_ = nextB;
  host_->change('g', [&](Setup& s) { s = nextA; });
  host_->tell("A and B are " + std::string{row->name} +
              "; all else is as in A, the picture of view 1. u undoes this.");
}

bool SideBench::undo(const Setup& A) {
  if (before_.empty()) return false;
  const Before last = before_.back();
  if (last.changed != Changed::B && A != last.A) return false;  // the window has changed A since
  before_.pop_back();
  b_ = last.B;
  return last.changed == Changed::B;
}

bool SideBench::pressArrow(int steps, const Setup& A) {
  if (!slider_) return false;
  const SliderRow* const row = sliderOf(slider_);
  const Setup& of = focus_ == 'A' ? A : *b_;
  if (!row->enabled(of)) {
    host_->notify(noEffect(row->label, *row->setting, std::string{"in "} + focus_) + ".");
    return true;
  }
  change(slider_, A, [&](Setup& s) { step(s, *row, steps); });
  return true;
}

bool SideBench::pressControl(char letter, const Setup& A) {
  if (letter == 'F') {
    host_->notify("Here the program's own scanline code fills both pictures.");
    return true;
  }
  if (const ChoiceRow* const row = choiceOf(letter); row && row->section != Section::Hidden) {
    if (letter == 'P')  // both have one camera
      choose(*host_, *row, row->next(A));
    else
      change(letter, A, [&](Setup& s) { row->set(s, row->next(s)); });
    return true;
  }
  if (const ToggleRow* const row = toggleOf(letter))
    return change(letter, A, [&](Setup& s) { row->flip(s); }), true;
  if (letter == 'H') return change('H', A, nextHue), true;
  if (!sliderOf(letter)) return false;
  slider_ = letter;
  return true;
}

bool SideBench::press(const Key& key, const Setup& setup) {
  follow(setup);
  const int times = key.shift ? 10 : 1;
  switch (key.name) {
    case NamedKey::Space:
      return blinking_ = !blinking_, true;
    case NamedKey::Left:
    case NamedKey::Down:
      return pressArrow(-times, setup);
    case NamedKey::Right:
    case NamedKey::Up:
      return pressArrow(times, setup);
    case NamedKey::Tab:
      return focus_ = focus_ == 'A' ? 'B' : 'A', true;
    case NamedKey::Escape:
      blinking_ = false, slider_ = 0;
      return true;
    case NamedKey::Letter:
      break;
    default:
      return false;
  }
  switch (key.letter) {
    case 'A':
    case 'B':
      return focus_ = key.letter, true;
    case 'x':
      return swap(setup), true;
    case 'g':
      return nextPair(setup), true;
    case 'n':
      place_ = places_.empty() ? 0 : (place_ + 1) % static_cast<int>(places_.size());
      if (places_.empty()) host_->notify("Nothing differs: there is no place to go to.");
      return true;
    case 'f':
      kind_ = kUnlikes[(static_cast<std::size_t>(kind_) + 1) % kUnlikes.size()].id;
      place_ = 0;
      if (kind_ == Unlike::Intensity && noIntensities_) {
        kind_ = Unlike::Color;
        host_->notify("These cells hold single colours, which have no intensity.");
      }
      return true;
    case 'u':
      return undo(setup);
    case 't':
    case 'z':
      slider_ = 0;
      return false;
    default:
      return pressControl(key.letter, setup);
  }
}

bool SideBench::grab(int x, int y) {
  if (at_.captionA.has(x, y)) focus_ = 'A';
  if (at_.captionB.has(x, y)) focus_ = 'B';
  const Rect kinds{at_.difference.x, at_.sections.y + 3, at_.difference.width, 20};
  if (kinds.has(x, y)) (void)press({NamedKey::Letter, 'f'}, host_->setup());
  const Rect pairs{at_.numbers.x, at_.numbers.y + at_.numbers.height - 18, at_.numbers.width, 18};
  if (pairs.has(x, y)) (void)press({NamedKey::Letter, 'g'}, host_->setup());
  if (at_.difference.has(x, y)) (void)press({NamedKey::Letter, 'n'}, host_->setup());
  x_ = x, y_ = y;
  return at_.A.has(x, y) || at_.B.has(x, y);
}

void SideBench::dragTo(int x, int y) {
  if (x == x_ && y == y_) return;
  turn(*host_, host_->setup(), subject_(), -0.5 * (x - x_), 0.5 * (y - y_));
  x_ = x, y_ = y;
}

void SideBench::leave() {
  blinking_ = false, slider_ = 0;
  before_.clear();
}

bool SideBench::late(const Setup&) const { return told() != drawn_; }

Picture SideBench::makeB(const Desk& desk) {
  if (!picturesB_ || !isSame(picturesB_->scene(), desk.picture.scene())) {
    if (picturesB_) b_ = lessonBeside(desk.setup), before_.clear();
    picturesB_.emplace(desk.picture);
    measuredA_ = measuredB_ = {};
    placed_.reset();
  }
  const PictureSettings& A = desk.picture.settings();
  coarse_ = desk.coarse || (desk.dragging && slow_);
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
  const auto make = [&] { return picturesB_->make(sized(*b_), desk.plan[Cell::Well]); };
  const Picture B = [&] {
    try {
      return make();
    } catch (const std::runtime_error& e) {  // a view that shows nothing, or too large a BSP tree
      host_->notify("B cannot be drawn with these settings: " + std::string{e.what()});
      b_ = drawn_ && drawn_->b ? drawn_->b : desk.setup;
      return make();
    }
  }();
  slow_ = desk.dragging && (coarse_ || B.times().total() > kFluid);
  return B;
}

void SideBench::measure(Measured& side, const Measured& other, const Picture& picture) {
  if (side.of == picture.settings()) return;
  if (other.of == picture.settings()) {  // A and B were swapped
    side = other;
    return;
  }
  side = {picture.settings(), numbersOf(picture, truth_.of(picture)),
          timeOf(picture.scene(), picture.settings())};
}

void SideBench::draw(IndexImage& image, const Desk& desk) {
  follow(desk.setup);
  at_ = layoutOfSides(desk.layout.body);
  const Picture pictureB = makeB(desk);
  if (!desk.dragging) {
    const Measured before = measuredA_;
    measure(measuredA_, measuredB_, desk.picture);
    measure(measuredB_, before, pictureB);
  }

  const PictureSettings &ofA = desk.picture.settings(), &ofB = pictureB.settings();
  const auto own = [&](const Picture& picture, TableKind kind) {
    const Palette palette = picture.palette(CellPlan{kind});
    return desk.gray ? forGrayScreen(palette, picture) : palette;
  };
  const Palette ownA = own(desk.picture, ofA.table.kind), ownB = own(pictureB, ofB.table.kind);
  const ColoredPicture A{desk.picture, ownA}, B{pictureB, ownB};
  noIntensities_ = !hasIntensities(pictureB, desk.picture);
  if (kind_ == Unlike::Intensity && noIntensities_) kind_ = Unlike::Color;
  const Unlikeness unlike = unlikeness(kind_, A, B);
  const std::pair<Unlike, std::pair<PictureSettings, PictureSettings>> placed{kind_, {ofA, ofB}};
  if (desk.dragging) {
    places_.clear(), placed_.reset();
  } else if (placed_ != placed) {
    places_ = placesOf(unlike, at_.frameWidth, at_.frameHeight);
    placed_ = placed;
  }
  if (place_ >= static_cast<int>(places_.size())) place_ = 0;
  const std::optional<DifferingPlace> place = places_.empty() ? std::nullopt : std::optional{places_[place_]};
  const OnePalette one = onePalette(A, B, desk.plan, desk.palette, most_());
  colors_ = {one.palette, std::nullopt};
  if (one.shared) {
    const std::string rule = std::to_string(one.colors) + " colours, what A and B show";
    colors_.words = SceneCellWords{.cells = {desk.picture.table().first(), one.colors},
                                   .rule = rule,
                                   .shortRule = rule,
                                   .what = "colours"};
  }

  const PictureSettings &askedA = desk.setup.picture, &askedB = b_->picture;
  std::string pairs;
  for (const PairRow& row : kPairs) pairs += (pairs.empty() ? "" : ", ") + std::string{row.name};
  if (textWidth(pairs) + 21 > at_.numbers.width) pairs = "next pair: " + std::string{kPairs[pair_].name};
  Painter{image}.fillRect(desk.layout.body, desk.plan[Cell::Paper]);
  const bool known = measuredA_.of == ofA && measuredB_.of == ofB;
  drawSidesPage(image, at_,
                {.A = one.A,
                 .B = one.B,
                 .unlike = unlike,
                 .ofA = {phrasesOf(askedA, askedB), measuredA_.numbers, measuredA_.time},
                 .ofB = {phrasesOf(askedB, askedA), measuredB_.numbers, measuredB_.time},
                 .finding = known ? findingOf(desk.picture, pictureB, measuredA_.numbers, measuredB_.numbers,
                                              unlike, place)
                                  : Finding{},
                 .known = known,
                 .place = place,
                 .number = place_,
                 .places = static_cast<int>(places_.size()),
                 .focus = focus_,
                 .blinking = blinking_,
                 .colors = one.shared ? "Both in one palette of " + std::to_string(one.colors) +
                                            " colours, " + (one.exact ? "all exact." : "each the nearest.")
                                      : "",
                 .pairs = pairs},
                desk.plan);
  use_ = cellUse(one.A);
  const CellUse second = cellUse(one.B);
  for (std::size_t k = 0; k < use_.samples.size(); ++k) use_.samples[k] += second.samples[k];
  status_ = sidesStatus(askedA, askedB);
  if (slider_) {
    const SliderRow* const row = sliderOf(slider_);
    const Setup& of = focus_ == 'A' ? desk.setup : *b_;
    aside_ =
        "arrows: " + std::string{row->label} + " of " + focus_ + ", " + fixed(row->get(of), row->decimals);
  } else {
    aside_ = known                    ? "the numbers are of these pictures"
             : coarse_ || desk.coarse ? "coarse while dragging; numbers follow"
                                      : "numbers follow";
  }
  drawn_ = told();
}

std::vector<Legend> SideBench::legend() const {
  return {
      {{"A", "B"}, "focus"}, {{"x"}, "swap"},      {{"Space"}, "blink in place"},    {{"f"}, "difference of"},
      {{"n"}, "next place"}, {{"g"}, "next pair"}, {{"S", "N", "O", "T"}, "change"}, {{"t"}, "turn both"},
      {{"z"}, "zoom both"}};
}

std::vector<HelpLine> SideBench::help() const {
  return {{"A B", "which one the letters below change; Tab is the other, or a click"},
          {"S N O K T H L V", "shading, normals, order, backs, table, hue, L, V: the next"},
          {"i p a d s c 0", "Ia, Ip, ka, kd, ks, shades, I0: then < >, Shift by ten"},
          {"g", "a pair worth comparing: z-sort | Newell, flat | Gouraud, ..."},
          {"x", "swap A and B"},
          {"Space", "B in A's place and back: differences jump out"},
          {"f", "compare faces, intensities or colours"},
          {"n", "the next place where they differ"},
          {"t z P", "turn, zoom, projection: of both; or drag a picture"}};
}

}  // namespace xnewell
