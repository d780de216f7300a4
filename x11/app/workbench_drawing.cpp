#include <algorithm>
#include <stdexcept>
#include <utility>

#include "shading/scene/divide_anew.h"
#include "x11/app/workbench.h"
#include "x11/window/moot.h"

namespace xnewell {

// Decides when the window is stale, and draws it. workbench.cpp handles keys and the pointer.

namespace {

/// Settings for a quick picture that still shows where everything is.
PictureSettings coarse(PictureSettings settings) {
  settings.shading = settings.shading == Shading::Full ? Shading::Full : Shading::Flat;
  settings.order = Order::ZSort;
  settings.adapt = 0;
  settings.dither = false;
  return settings;
}

}  // namespace

Workbench::Indices Workbench::indices() const {
  Setup painted = this->painted();
  painted.picture = withoutColors(painted.picture);
  std::array<std::string, 3> typing;
  if (question_) typing = {question_->asks, question_->text, complaint_};
  return {view(), width_, height_, layout_.unit, painted, notice_, told_, typing, help_, dragging_};
}

Workbench::Stale Workbench::stale() const {
  if (!shown_ || indices() != shown_->indices) return Stale::Everything;
  if (colors() != shown_->colors) return bench().colors() ? Stale::Everything : Stale::Colors;
  return bench().late(work_.setup) ? Stale::Everything : Stale::Nothing;
}

PictureSettings Workbench::sized() const {
  const Rect at = bench().picture(layout_) * layout_.unit;
  PictureSettings settings = painted().picture;
  settings.width = std::min(at.width, width_);
  settings.height = std::min(at.height, height_);
  settings.inPixels = serverFills();
  return settings;
}

/// The palette without effects.
Palette Workbench::plainPalette() const {
  const Palette palette = picture().palette(plan(), server_.unneeded);
  return server_.gray ? forGrayScreen(palette, picture()) : palette;
}

void Workbench::makePalette(const PaletteEffects& effects) {
  palette_ = withEffects(plainPalette(), picture(), plan(), effects);
}

/// Divides the scene's patches as often as the setup says. If it does not say, they get the divisions that
/// they were read with.
void Workbench::divide() {
  const Scene& scene = this->scene();
  const int wanted = work_.setup.divisions > 0 ? work_.setup.divisions : work_.divisions;
  if (scene.divisions == 0 || scene.divisions == wanted) return;
  work_.pictures = PictureCache{dividedAnew(scene, wanted)};
}

void Workbench::drawFrame(bool dragging) {
  const PictureSettings wanted = sized();
  Bench& view = bench();
  const bool whole = view.wantsImage();
  const bool quick = dragging && slow_ && whole && !serverFills() && coarse(wanted) != wanted;
  divide();
  const CellPlan cells = plan();
  const Picture picture = work_.pictures.make(quick ? coarse(wanted) : wanted,
                                              whole ? std::optional{cells[Cell::Well]} : std::nullopt);
  const auto isShown = [&](const Picture& shown) {
    return shown.settings() == picture.settings() && &shown.scene() == &picture.scene();
  };
  const bool fresh = !whole || !shown_ || !shown_->image || !isShown(*shown_->image);
  slow_ = dragging && (quick || picture.times().total() > kFluid);
  dragging_ = dragging;

  const PaletteEffects effects = view.stored(work_.setup);
  makePalette(effects);
  image_.width = width_, image_.height = height_;
  image_.pixels.assign(static_cast<std::size_t>(width_) * height_, cells[Cell::Paper]);
  const Painter paint{image_, layout_.unit};
  const Palette plain = plainPalette();
  const CellUse use = whole ? cellUse(picture.image(), view.countsPolygons() ? picture.faceImage()
                                                                             : std::vector<std::uint32_t>{})
                            : CellUse{};
  view.draw(paint, {.picture = picture,
                    .plan = cells,
                    .palette = plain,
                    .use = use,
                    .setup = work_.setup,
                    .layout = layout_,
                    .fresh = fresh,
                    .dragging = dragging,
                    .coarse = quick,
                    .gray = server_.gray});
  const OwnColors* const own = view.colors();
  if (own) palette_ = own->palette;
  panel_ = {.title = titleOf(picture.scene()),
            .visual = server_.visual(),
            .view = this->view(),
            .words = own && own->words ? *own->words : wordsOf(picture, effects),
            .use = view.use() ? *view.use() : use,
            .inspected = view.inspected(),
            .status = view.status(),
            .aside = view.aside(),
            .notice = notice_,
            .told = told_,
            .legend = legendOf(keys()),
            .help = help_ ? helpOf(keys()) : std::vector<HelpLine>{}};
  if (question_)
    panel_.typed = Typed{question_->asks, question_->text, complaint_, !question_->offers.empty()};
  drawPanel(paint, layout_, panel_, cells);
  shown_ = {indices(), {work_.setup, effects}, whole ? std::optional{picture} : std::nullopt};
}

void Workbench::update(bool dragging) {
  switch (stale()) {
    case Stale::Nothing:
      return;
    case Stale::Colors: {
      PictureSettings recolored = picture().settings();  // of the last picture, which may be a coarse one
      recolored.table = sized().table;
      work_.pictures.make(recolored);
      shown_->colors = colors();
      return makePalette(shown_->colors.effects);
    }
    case Stale::Everything:
      break;
  }
  try {
    drawFrame(dragging);
  } catch (const std::runtime_error& e) {
    if (!shown_) throw;
    work_.setup = shown_->colors.setup;
    bench().leave();
    bench().enter();
    notify(e.what());
    drawFrame(dragging);
  }
}

}  // namespace xnewell
