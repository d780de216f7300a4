#include <array>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"
#include "shading/figure/make_figure.h"
#include "shading/figure/write_figure.h"
#include "x11/app/lecture.h"
#include "x11/app/workbench.h"
#include "x11/kit/typed_line.h"
#include "x11/options/setup_command.h"

namespace xnewell {

namespace {

/// The beginning of a file's name: letters, digits, dots and lines between them.
std::string stemOf(const std::string& name) {
  std::string stem;
  for (const unsigned char c : std::filesystem::path{name}.stem().string())
    if (std::isalnum(c) != 0 || c == '.' || c == '_')
      stem += static_cast<char>(c);
    else if (!stem.empty() && stem.back() != '-')
      stem += '-';
  while (stem.ends_with('-')) stem.pop_back();
  return stem.empty() ? "scene" : stem;
}

/// Writes a new PNG file into the working directory: STEM.png, or STEM-2.png ... if there is such a file.
/// Returns its name. @throws std::system_error
std::string writeNewPng(const std::string& stem, const std::string& png) {
  namespace fs = std::filesystem;
  std::string file = stem + ".png";
  for (int n = 2; fs::exists(fs::symlink_status(file)); ++n) file = stem + '-' + std::to_string(n) + ".png";
  writeFile(file, png);
  return file;
}

/// What --view calls a view, of which view 1 shows `show`.
std::string_view viewOption(View view, View show) { return rowOf(view == View::Picture ? show : view).name; }

}  // namespace

/// The ways of a set-up out of the window and into it: as a command, to a file, from a file.

void Workbench::copyCommand() {
  PictureSettings settings = work_.setup.picture;
  const PictureSettings shown = sized();
  settings.width = shown.width, settings.height = shown.height;
  try {
    // The picture of view 1 alone, unless the drawer beside it belongs to what is shown.
    const bool alone = view() == View::Picture && layout_.drawer == Drawer::Whole;
    const std::string whole = alone ? "" : pictureNote();
    std::string text;
    for (const std::string& line : bench().report()) text += "# " + visible(line) + '\n';
    const std::optional<std::string> own = bench().command();
    server_.copy(text + (own ? *own
                         : !whole.empty()
                             ? whole
                             : SetupCommand{scene()}.of(settings, work_.setup.divisions, work_.setup.fill)));
    tell("Finding, table and command are on standard output, and other programs can paste them.");
  } catch (const std::exception& e) {  // its file may have gone
    notify(oneLine(e.what()));
  }
}

std::string Workbench::pictureName() const {
  if (view() == View::Lesson && lessons_->lesson() && !lessons_->showsList())
    return stemOf(lessons_->lesson()->title) + "-step-" + std::to_string(lessons_->step() + 1);
  return stemOf(scene().name) + '-' + std::string{viewOption(view(), work_.setup.show)};
}

std::string Workbench::pictureNote() const {
  if (view() == View::Lesson) {
    const Lesson* const lesson = lessons_->showsList() ? nullptr : lessons_->lesson();
    return lesson && !lesson->source.empty()
               ? lessonNote(lesson->source, {width_, height_}, layout_.unit, lessons_->step() + 1)
               : "";
  }
  PictureSettings settings = work_.setup.picture;
  const PictureSettings shown = sized();
  settings.width = shown.width, settings.height = shown.height;
  Drawing drawing{.size = glm::ivec2{width_, height_}, .wholeWindow = true};
  drawing.options.emplace_back("--view", viewOption(view(), work_.setup.show));
  if (layout_.unit != 1) drawing.options.emplace_back("--scale", std::to_string(layout_.unit));
  std::ranges::copy(optionsOf(place()), std::back_inserter(drawing.options));
  return noteOf(scene(), settings, work_.setup.divisions, work_.setup.fill, drawing);
}

void Workbench::writePicture() {
  try {
    const std::string png = server_.picture();
    if (png.empty()) return notify("There is no window to take a picture of.");
    const std::string file = writeNewPng(pictureName(), png);
    const std::string figure = writeFigure(std::filesystem::path{file}.replace_extension(".svg").string());
    tell(file + (figure.empty() ? " is written." : " and " + figure + " are written.") +
         (pictureNote().empty() ? "" : " \"xnewell " + file + "\" opens it again."));
  } catch (const std::exception& e) {
    notify(oneLine(e.what()));
  }
}

std::string Workbench::writeFigure(const std::string& file) {
  constexpr int kMostFaces = 20'000;  // with more the window would stand still for seconds
  const bool shows =
      view() == View::DepthSort || (view() == View::Picture && work_.setup.show == View::Picture);
  PictureSettings settings = sized();
  const OrderRow& order = rowOf(settings.order);
  if (!shows || order.bySample || settings.order == Order::Bsp || scene().mesh.faceCount() > kMostFaces ||
      std::filesystem::exists(file))
    return "";
  VectorFigure figure;
  try {
    figure = FigureStages{scene(), settings, kFigureTolerance}.figure();
  } catch (const TooManyPieces&) {
    return "";
  }
  const Drawing drawing{.size = glm::ivec2{settings.width, settings.height}};
  figure.note = noteOf(scene(), settings, work_.setup.divisions, work_.setup.fill, drawing);
  writeFile(file, svgOf(figure));
  return file;
}

void Workbench::askToSave() {
  const std::string stem = stemOf(scene().name);
  ask(fileQuestion(
      "save the set-up as", work_.file.empty() ? stem + "-set-up.json" : work_.file,
      [](const std::string& file) {
        return file.ends_with(".json") ? "" : "A scene file's name ends in .json.";
      },
      [this](const std::string& file) {
        work_.save(file);
        told_ = "Saved. \"xnewell " + file + "\" shows " +
                (view() == View::Picture ? "it" : "the picture of view 1") + " again.";
      }));
}

void Workbench::askToOpen() {
  ask({.asks = "open a scene: a file, or a built-in name",
       .text = work_.file,
       .offers = namesOf(builtInScenes()),
       .take = [this, warned = std::string{}](const std::string& name) mutable -> std::string {
         if (name.empty()) return "Type a name, or press Esc to cancel.";
         try {
           const std::array arguments{"xnewell", "view", name.c_str()};
           Options options = parseOptions(static_cast<int>(arguments.size()), arguments.data()).value();
           if (options.command != Command::View) return "\"xnewell " + name + "\" shows that lesson.";
           Scene scene = readyScene(options);
           Work work = workOn(std::move(scene), setupOf(options));
           if (name.ends_with(".json")) work.file = name;
           if (!isSaved() && std::exchange(warned, name) != name)
             return "Your changes are not saved. Press Return again to open this and lose them.";
           before_.reset();
           begin(std::move(work));
           if (isPicture(name)) goTo(options.window);
         } catch (const std::exception& e) {
           return oneLine(e.what());
         }
         return {};
       }});
}

}  // namespace xnewell
