#include "x11/app/workbench.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "geometry/exact/give_up.h"
#include "shading/laboratory/errors.h"
#include "x11/app/mistake_game.h"
#include "x11/pixel/pixel_view.h"
#include "x11/scanline/scanline_view.h"
#include "x11/sides/side_by_side_view.h"
#include "x11/sides/sides.h"
#include "x11/stepper/sort_view.h"
#include "x11/trade/trade_view.h"
#include "x11/viewing/viewing_view.h"
#include "x11/views/colors_page.h"
#include "x11/window/colors_view.h"
#include "x11/window/controls.h"
#include "x11/window/layout.h"
#include "x11/window/mach_bands_view.h"
#include "x11/window/picture_view.h"

namespace xnewell {

void Workbench::fit(const Scene& scene, const Setup& setup) {
  mostShades_ = server_.mostShades(planOf(scene, setup.picture) != ColorPlan::OneHue);
}

Work Workbench::workOn(Scene scene, Setup setup) {
  (void)keepFillable(setup);
  fit(scene, setup);
  TableSettings& table = setup.picture.table;
  table.shades = std::min(table.shades, mostShades_);
  return {std::move(scene), setup};
}

Workbench::Workbench(Scene scene, const Setup& setup, Server server)
    : work_{std::move(scene), setup}, server_{std::move(server)} {
  fit(this->scene(), setup);
  const auto own = [this](View view, auto made) {
    auto* const bench = made.get();
    benches_[static_cast<std::size_t>(view)] = std::move(made);
    return bench;
  };
  const auto subject = [this] { return this->subject(); };
  const auto done = [this] {
    std::vector<bool> begun;
    for (const LessonEntry& lesson : lessons_->entries())
      begun.push_back(!lessons_->score(lesson.name).empty());
    return begun;
  };
  picture_ = own(View::Picture, std::make_unique<PictureView>(*this, subject, done, [this] { play(); }));
  stepper_ = own(View::DepthSort, std::make_unique<SortView>(*this));
  colors_ = own(View::Colors, std::make_unique<ColorsView>(*this));
  bands_ = own(View::MachBands, std::make_unique<MachBandsView>(*this, subject));
  sides_ =
      own(View::SideBySide, std::make_unique<SideBySideView>(*this, subject, [this] { return mostShades_; }));
  own(View::Trade, std::make_unique<TradeView>(*this));
  lessons_ = own(View::Lesson, std::make_unique<LessonView>(*this));
  pixel_ = own(View::Pixel, std::make_unique<PixelView>(*this, subject));
  viewing_ = own(View::Viewing, std::make_unique<ViewingView>(*this, subject));
  scanline_ = own(View::Scanline, std::make_unique<ScanlineView>(*this, subject));
}

void Workbench::resize(int width, int height) {
  width_ = width, height_ = height;
  layOut();
}

void Workbench::scale(int unit) {
  unit_ = unit;
  layOut();
}

void Workbench::layOut() {
  const Drawer open = few_.empty() || view_ != View::Picture ? Drawer::Whole : Drawer::Few;
  const bool hasDrawer = benches_[static_cast<std::size_t>(view_)]->hasDrawer();
  layout_ = layoutOf(width_, height_,
                     largest_ || scaleIsChosen_
                         ? std::min(largest_ ? kMostScale : unit_, largestScale(width_, height_))
                         : unit_,
                     !hasDrawer ? Drawer::Whole
                     : shut_    ? Drawer::Shut
                                : open);
  layout_.briefTabs = lecture_ && layout_.roomy && !hasRoomForTitle(layout_, lecture_->title());
}

void Workbench::fillScreen(std::optional<bool> wish) {
  const std::optional<bool> full = server_.fillScreen(wish);
  if (!full) return notify("There is no screen to fill.");
  fillsScreen_ = largest_ = *full;
  layOut();
}

void Workbench::takeNextScale() {
  const int most = largestScale(width_, height_);
  if (most == 1 && layout_.unit == 1) {
    const glm::ivec2 least = 2 * kLeastWindow;
    return notify("Larger letters need a window of " + std::to_string(least.x) + " x " +
                  std::to_string(least.y) + "; F11 fills the screen.");
  }
  const int next = layout_.unit < most ? layout_.unit + 1 : 1;
  largest_ = false, scaleIsChosen_ = true;
  scale(next);
  tell("scale " + std::to_string(next) + " of " + std::to_string(most));
}

void Workbench::welcome() { picture_->welcome(); }

void Workbench::teach(Lesson lesson, int step) {
  switchTo(View::Lesson);
  came_.clear();
  lessons_->start(std::move(lesson));
  if (step > 0) lessons_->goTo(step);
}

void Workbench::begin(const Options& options, std::optional<Lesson> lesson) {
  if (lesson)
    teach(std::move(*lesson), std::max(0, options.window.step - 1));
  else if (options.command == Command::Lesson)
    switchTo(View::Lesson);
  else
    goTo(options.window);
}

void Workbench::begin(Work work) {
  bench().drop();
  for (const auto& one : benches_) one->reset();
  work_ = std::move(work);
  shown_.reset();
}

void Workbench::open(Scene scene, const Setup& setup) {
  Work work = workOn(std::move(scene), setup);
  if (!before_) before_ = std::make_unique<Work>(std::move(work_));
  begin(std::move(work));
}

void Workbench::close() {
  if (!before_) return;
  fit(before_->pictures.scene(), before_->setup);
  begin(std::move(*before_));
  before_.reset();
}

void Workbench::change(char control, const std::function<void(Setup&)>& edit) {
  if (const std::string why = ownOfScene(control, work_.setup, scene()); !why.empty()) return notify(why);
  Setup next = work_.setup;
  edit(next);
  if (const std::string_view why = keepFillable(next); !why.empty()) notify(std::string{why});
  if (next == work_.setup) return;
  work_.change(control, next);
  if (!shown_) return;
  if (const std::string why = whyNoEffect(control, picture(), next); !why.empty()) notify(why);
}

void Workbench::switchTo(View view) {
  constexpr std::size_t kMost = 50;
  if (view_ == view) return;
  came_.push_back(isDrawn() ? place() : WindowPlace{.view = view_});
  if (came_.size() > kMost) came_.erase(came_.begin());
  bench().leave();
  if (view_ == View::Lesson && !before_) came_.clear();  // who left it for good does not go back
  view_ = view;
  layOut();
  bench().enter();
}

void Workbench::visit(View view) {
  if (!layout_.roomy) {
    const glm::ivec2 least = kLeastWindow * layout_.unit;
    return notify("View " + std::string{rowOf(view).key} + ", " + std::string{rowOf(view).title} +
                  ", needs a window of " + std::to_string(least.x) + " x " + std::to_string(least.y) + ".");
  }
  switchTo(view);
  // In view 0 a value runs along a row, unless somebody has chosen a method without one.
  const PictureSettings& now = work_.setup.picture;
  if (view != View::Scanline || before_ || std::exchange(sawScanline_, true) ||
      work_.setup.fill != Fill::Scanline || now.shading != Shading::Flat ||
      now.shading != work_.defaults.picture.shading)
    return;
  change('S', [](Setup& s) { s.picture.shading = Shading::Gouraud; });
  tell("Here the polygon is shaded by Gouraud, so that I runs along the rows. u takes it back.");
}

void Workbench::play() {
  if (!shown_) return;
  try {
    teach(mistakeGame(picture().scene(), sized(), ++games_));
  } catch (const std::invalid_argument& e) {
    notify(e.what());
  }
}

void Workbench::goTo(const WindowPlace& place) {
  few_ = place.controls.value_or("");
  shut_ = place.controls && few_.empty();
  if (place.view == View::Scanline) {
    if (place.polygon) scanline_->choose(*place.polygon);
    if (place.polygon || place.step > 0) scanline_->startAt(place.step);
  } else if (place.view != View::Viewing) {
    if (!place.run.empty()) stepper_->open(place.run, scene());
    stepper_->startAt(place.step);
  }
  if (place.scanline) bands_->choose(*place.scanline);
  if (place.cell) colors_->choose(*place.cell);
  if (place.pixel) pixel_->choose(*place.pixel);
  if (place.view == View::Viewing) viewing_->begin(place.step, place.vertex.value_or(""));
  sides_->begin(place.beside, place.difference);
  switchTo(place.view);
  came_.clear();
  layOut();
}

void Workbench::goBack() {
  std::vector<WindowPlace> before = std::move(came_);
  const WindowPlace to = before.empty() ? WindowPlace{.view = View::Lesson} : before.back();
  if (!before.empty()) before.pop_back();
  switchTo(to.view);
  came_ = std::move(before);
  // Other views stay where they were.
  if (to.view == View::DepthSort) stepper_->startAt(to.step);
  if (to.view == View::Pixel && to.pixel && *to.pixel != pixel_->pixel()) pixel_->choose(*to.pixel);
}

void Workbench::follow(const Pointed& link) {
  const Picture shown = work_.pictures.make(picture().settings(), plan()[Cell::Well]);
  const int width = shown.settings().width;
  const auto explainFirst = [&](const auto& samples, const auto& wanted, const std::string& none) {
    const auto first = std::ranges::find_if(samples, wanted);
    if (first == std::ranges::end(samples)) return notify(none);
    const auto at = static_cast<int>(first - std::ranges::begin(samples));
    explain((at % width + 0.5) / width, (at / width + 0.5) / shown.settings().height);
  };
  switch (link.lead) {
    case Lead::Cut:
      stepper_->startAt(Landmark::Cut);
      return switchTo(View::DepthSort);
    case Lead::Clamped: {
      const std::vector<double> I = shown.intensities(shown.seen(0, shown.settings().height));
      return explainFirst(
          I, [](double one) { return one >= 1.0; },
          "No pixel shows it: what is clamped is at a vertex or a side that is hidden.");
    }
    case Lead::Wrong: {
      Difference wrong;
      wrong.width = width;
      for (const SampleCheck check : checkedSamples(shown))
        wrong.at.push_back(isWrong(check) ? 1.0F : 0.0F), wrong.above += isWrong(check);
      // Where most of them are.
      const int high = shown.settings().height;
      const std::vector<DifferingPlace> places = placesOf(wrong, width / 10, high / 6);
      if (places.empty())
        return notify(view() == View::SideBySide ? "The set-up, side A, shows no wrong face; x swaps the "
                                                   "sides, then this leads to one."
                                                 : "No sample of this picture shows a wrong face.");
      const Rect& frame = places.front().frame;
      for (int k = 0; k < frame.width * frame.height; ++k) {
        const int i = frame.x + k % frame.width, j = frame.y + k / frame.width;
        if (wrong.at[static_cast<std::size_t>(j) * width + i] > 0)
          return explain((i + 0.5) / width, (j + 0.5) / high);
      }
      return;
    }
    case Lead::Cell:
      if (view() != View::Colors) return colors_->choose(link.number), switchTo(View::Colors);
      return explainFirst(
          shown.image().pixels, [&](int cell) { return cell == link.number; },
          "No sample of this picture shows cell " + std::to_string(link.number) + ".");
    case Lead::Right: {
      Setup right = work_.setup;
      right.picture.light.mistake = Mistake::None;
      return compare(right);
    }
    case Lead::None:
      return;
  }
}

WindowPlace Workbench::place() const {
  WindowPlace place{.view = view()};
  if (place.view == View::DepthSort)
    place.run = stepper_->theirs(), place.step = stepper_->view().own ? 0 : stepper_->view().step;
  if (place.view == View::MachBands) place.scanline = bands_->row();
  if (place.view == View::Colors) place.cell = colors_->inspected();
  if (place.view == View::Pixel) place.pixel = pixel_->pixel();
  if (place.view == View::Viewing) place.step = viewing_->stage(), place.vertex = viewing_->vertex();
  if (place.view == View::Scanline) place.polygon = scanline_->polygon(), place.step = scanline_->view().step;
  if (place.view == View::SideBySide) place.beside = sides_->ownOfB(), place.difference = sides_->kind();
  if (layout_.drawer != Drawer::Whole) place.controls = layout_.drawer == Drawer::Few ? few_ : "";
  return place;
}

void Workbench::explain(double x, double y) {
  pixel_->choose(x, y);
  switchTo(View::Pixel);
}

void Workbench::explainWrong() {
  update();  // the picture that was just asked for
  follow({.place = {}, .lead = Lead::Wrong});
}

void Workbench::sortFrom(int step) {
  stepper_->startAt(step);
  switchTo(View::DepthSort);
}

void Workbench::fill(const std::string& polygon) {
  scanline_->choose(polygon);
  switchTo(View::Scanline);
}

void Workbench::compare(const Setup& B) {
  switchTo(View::SideBySide);
  sides_->put(
      B, Unlike::Intensity);  // after the view was entered, because then B follows what was changed elsewhere
}

void Workbench::tick() {
  if (bench().moving()) bench().tick();
  if (lecture_ && lecture_->isDue() && !line_.isOpen()) {
    lecture_->turnByItself();
    showPage();
  }
}

Subject Workbench::subject() const {
  const Rect at = bench().frame(layout_);
  return {scene(), work_.centre, static_cast<double>(at.width) / std::max(1, at.height)};
}

bool Workbench::grab(int x, int y) {
  if (const auto cell = cellInStrip(layout_.strip, x / layout_.unit, y / layout_.unit))
    if (line_.pick(*cell)) return false;
  if (const std::optional<Pointed> at = pressableAt(x / layout_.unit, y / layout_.unit)) {
    if (at->key) {
      press(*at->key);
      bench().release(at->key->letter);
    } else if (at->gesture) {
      notify("This is done with the pointer itself, in the picture.");
    } else {
      notice_.clear(), told_.clear(), pointed_.reset();
      follow(*at);
    }
    return false;
  }
  notice_.clear();
  told_.clear();
  pointed_.reset();
  help_ = false;
  if (lecture_) lecture_->wait();
  line_.cancel();
  x /= layout_.unit, y /= layout_.unit;
  if (const std::optional<View> tab = tabAt(layout_, x, y)) return visit(*tab), false;
  if (!isDrawn()) return false;
  work_.endStep();
  return bench().grab(x, y);
}

std::optional<Pointed> Workbench::pressableAt(int x, int y) {
  if (!isDrawn()) return {};
  std::optional<Pointed> at = pointedAt(writing_, x, y);
  if (!at || (!at->key && !at->gesture && at->lead == Lead::None)) return {};
  const bool inBody = layout_.roomy && y > layout_.views.height && y < layout_.strip.y && !help_;
  if (inBody && bench().list().has(x, y)) return {};
  if (at->lead != Lead::None && (view() == View::Lesson || help_ || line_.isOpen())) return {};
  return at;
}

void Workbench::hover(int x, int y) {
  if (!isDrawn()) return;
  x /= layout_.unit, y /= layout_.unit;
  if (!line_.isOpen()) bench().hover(x, y);
  pointed_ = pressableAt(x, y);
  if (pointed_ || help_) return;
  pointed_ = pointedAt(writing_, x, y);
  if (pointed_ && pointed_->says.empty()) pointed_.reset();
  if (pointed_) pointed_->key.reset(), pointed_->lead = Lead::None;
  // A hint must not hide what the pointer is about to press.
  if (pointed_ && (layout_.low ? layout_.status.has(x, y) : y > layout_.status.y + 20)) pointed_.reset();
}

void Workbench::settle() {
  bench().drop();
  work_.endStep();
  dragging_ = false;
}

void Workbench::wheel(int x, int y, double factor) {
  const bool overPicture = bench().picture(layout_).has(x / layout_.unit, y / layout_.unit);
  if (overPicture && !line_.isOpen()) zoom(factor);
}

void Workbench::zoom(double factor) {
  if (bench().zoom(factor)) return;
  const Controls controls = bench().controls();
  if (std::ranges::find(controls, 'z', &Control::key) == controls.end()) return;
  const auto edit = [this](char control, const auto& change) { this->change(control, change); };
  xnewell::zoom(edit, Setup{work_.setup}, subject(), factor);
}

Workbench::Indices Workbench::indices() const {
  Setup painted = this->painted();
  painted.picture = withoutColors(painted.picture);
  return {view(),   width_,        height_, layout_.unit,   painted, notice_,  told_,
          pointed_, line_.typed(), help_,   layout_.drawer, few_,    dragging_};
}

Workbench::Stale Workbench::stale() const {
  if (!shown_ || indices() != shown_->indices) return Stale::Everything;
  if (colors() != shown_->colors) return bench().colors() ? Stale::Everything : Stale::Colors;
  return bench().late(work_.setup) ? Stale::Everything : Stale::Nothing;
}

PictureSettings Workbench::sized() const {
  const Rect at = bench().frame(layout_) * layout_.unit;
  PictureSettings settings = painted().picture;
  settings.width = std::min(at.width, width_);
  settings.height = std::min(at.height, height_);
  settings.inPixels = serverFills();
  return settings;
}

/// The palette without effects.
Palette Workbench::plainPalette(const Picture& picture) const {
  const Palette palette = picture.palette(plan(), server_.unneeded);
  return server_.gray ? forGrayScreen(palette, picture) : palette;
}

void Workbench::makePalette(const Picture& picture, const PaletteEffects& effects) {
  palette_ = withEffects(plainPalette(picture), picture, plan(), effects);
}

void Workbench::drawFrame(bool dragging) {
  const PictureSettings wanted = sized();
  WindowView& view = bench();
  const bool whole = view.wantsImage();
  const bool quick = dragging && slow_ && whole && !serverFills() && coarse(wanted) != wanted;
  work_.divide();
  const CellPlan cells = plan();
  const Picture picture = work_.pictures.make(quick ? coarse(wanted) : wanted,
                                              whole ? std::optional{cells[Cell::Well]} : std::nullopt);
  const bool isShown = shown_ && shown_->picture.settings() == picture.settings() &&
                       &shown_->picture.scene() == &picture.scene();
  if (!isShown) line_.leavePicture();
  slow_ = dragging && (quick || picture.times().total() > kFluid);
  dragging_ = dragging;

  const PaletteEffects effects = view.stored(work_.setup);
  makePalette(picture, effects);
  image_.width = width_, image_.height = height_;
  image_.pixels.assign(static_cast<std::size_t>(width_) * height_, cells[Cell::Paper]);
  writing_.clear();
  const Painter paint{image_, layout_.unit, &writing_};
  const Palette plain = plainPalette(picture);
  const CellUse use = whole ? cellUse(picture.image(), view.countsPolygons() ? picture.faceImage()
                                                                             : std::vector<std::uint32_t>{})
                            : CellUse{};
  view.draw(paint, {.picture = picture,
                    .plan = cells,
                    .palette = plain,
                    .use = use,
                    .setup = work_.setup,
                    .layout = layout_,
                    .fresh = !whole || !isShown || !shown_->whole || shown_->indices.view != this->view(),
                    .dragging = dragging,
                    .coarse = quick,
                    .gray = server_.gray,
                    .shownBits = server_.shownBits,
                    .title = lecture_ ? lecture_->now().title : titleOf(picture.scene()),
                    .few = few_});
  const OwnColors* const own = view.colors();
  if (own) palette_ = own->palette;
  panel_ = {.title = lecture_ ? lecture_->title() : titleOf(picture.scene()),
            .visual = server_.visual(),
            .view = this->view(),
            .words = own && own->words ? *own->words : wordsOf(picture, effects),
            .use = view.use() ? *view.use() : use,
            .inspected = view.inspected(),
            .selected = view.selectedOutOfSight(),
            .status = view.status(),
            .aside = view.aside(),
            .picture = view.picture(layout_),
            .mistake = this->view() == View::Lesson ? "" : mistakeIn(work_.setup),
            .notice = notice_,
            .told = told_,
            .hint = pointed_ ? pointed_->says : "",
            .typed = line_.typed(),
            .legend = legendOf(keys()),
            .help = help_ ? helpOf(keys()) : std::vector<HelpLine>{}};
  PanelState bands = panel_;
  bands.help.clear();
  drawPanel(paint, layout_, bands, cells);
  // What lies on a control is a part of it.
  Writing free = this->view() == View::Lesson ? Writing{} : writing_;
  std::erase_if(free, [&](const Written& one) {
    return view.list().has(one.place.x + one.place.width / 2, one.place.y + one.place.height / 2);
  });
  drawLinks(paint, free, pointed_, cells);
  if (help_) writing_.clear();
  for (const Rect& list : drawnOverPicture(layout_, panel_))  // the list of keys lies over all
    drawPanel(paint.within(list), layout_, panel_, cells);
  shown_.emplace(indices(), Colors{work_.setup, effects}, picture, whole);
}

void Workbench::update(bool dragging) {
  switch (stale()) {
    case Stale::Nothing:
      return;
    case Stale::Colors: {
      PictureSettings recolored = picture().settings();  // of the last picture, which may be a coarse one
      recolored.table = sized().table;
      shown_->picture = work_.pictures.make(recolored);
      shown_->colors = colors();
      return makePalette(shown_->picture, shown_->colors.effects);
    }
    case Stale::Everything:
      break;
  }
  const auto goBack = [&](const std::string& why) {
    work_.setup = shown_->colors.setup;
    bench().leave();
    bench().enter();
    notify(why);
    drawFrame(dragging);
  };
  try {
    drawFrame(dragging);
  } catch (const std::runtime_error& e) {
    if (!shown_) throw;
    goBack(e.what());
  } catch (const GivenUp&) {
    if (!shown_) throw;
    switchTo(shown_->indices.view);
    goBack("The work was given up. This is the picture before.");
  }
}

}  // namespace xnewell
