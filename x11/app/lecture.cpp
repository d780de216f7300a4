#include "x11/app/lecture.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>

#include "shading/scene/settings.h"
#include "x11/app/workbench.h"
#include "x11/kit/typed_line.h"
#include "x11/lessons/lesson_view.h"
#include "x11/stepper/sort_view.h"
#include "x11/terminal/terminal.h"

namespace xnewell {

std::string Lecture::title() const {
  return std::to_string(at_ + 1) + " of " + std::to_string(pages_.size()) + ": " + now().title;
}

bool Lecture::turn(int pages) {
  const auto to = static_cast<std::ptrdiff_t>(at_) + pages;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(pages_.size())) return false;
  at_ = static_cast<std::size_t>(to);
  wait();
  return true;
}

void Lecture::turnByItself() {
  at_ = (at_ + 1) % pages_.size();
  wait();
}

/// The lecture in the window.

void Workbench::lecture(Lecture lecture) {
  lecture_ = std::move(lecture);
  showPage();
}

void Workbench::showPage() {
  if (before_) switchTo(View::Lesson);  // a view may still have the scene of a lesson
  switchTo(View::Picture);
  const Page& page = lecture_->now();
  begin(workOn(page.scene, page.setup));
  lessons_->forget();
  goTo(page.place);
  if (page.lesson) teach(*page.lesson);
  told_.clear();
  notice_.clear();
  server_.say(lecture_->title() + '\n' + (page.notes.empty() ? "" : page.notes + '\n'));
}

bool Workbench::turnsPage(const Key& key) {
  if (!lecture_) return false;
  lecture_->wait();
  const int pages = turning(key);
  if (pages == 0) return false;
  // Inside a lesson its steps come first.
  if (const Lesson* const lesson = lessons_->lesson();
      view() == View::Lesson && lesson && !lessons_->showsList()) {
    const int step = lessons_->step() + pages;
    if (step >= 0 && step < static_cast<int>(lesson->steps.size())) return false;
  }
  if (lecture_->turn(pages))
    showPage();
  else
    notify(pages > 0 ? "This is the last page of the lecture." : "This is the first page of the lecture.");
  return true;
}

namespace {

Scene read(const Options& options) {
  std::optional<Doing> reading{"reading " + options.scene};
  Scene scene = readScene(options.scene, options.divisions);
  reading.reset();
  for (const std::string& note : scene.mesh.notes) {
    const std::string line =
        oneLine(note);  // it may need memory, so it comes before a part is on the terminal
    std::cerr << "xnewell: note: " << line << '\n';
  }
  return scene;
}

/// Removes from the scene the light and surface values that the command line replaces.
/// @throws UsageError if the rest does not go with the command line: if Ia + the sum of Ip exceeds 1, if no
/// light can be attenuated, or if --fill x11 cannot show the scene's textures
void giveWay(Scene& scene, const Options& options) {
  if (options.fill == Fill::XFillPolygon && !scene.textures.empty())
    throw UsageError{"--fill x11 paints each polygon in one colour, so it cannot show the scene's textures"};
  for (const Setting& setting : settingRows())
    if (!setting.replaces.empty() && options.gave(setting.option) &&
        std::ranges::find(options.keep, setting.replaces) == options.keep.end())
      strip(scene, setting.replaces);

  // What is left of the lights must be able to fade as the user says.
  const Illumination& user = options.picture.light;
  if (options.gave("--attenuation") && user.attenuation != Attenuation::None && !user.lightPosition &&
      !scene.light.placed())
    throw UsageError{
        "--attenuation needs a light at a place: give --light-at x,y,z or a scene with such a light"};

  // A user's Ia must fit the scene's lights, and a user's Ip the scene's Ia.
  const bool besideLights = options.gave("--ia") && !scene.light.lights.empty(),
             besideIa = options.gave("--ip") && scene.light.Ia;
  glm::dvec3 sum = ambientOf(scene.light, user);
  for (const Light& light : scene.light.lights) sum += light.Ip;
  if (scene.light.lights.empty()) sum += user.Ip;
  if ((besideLights || besideIa) && std::max({sum.r, sum.g, sum.b}) > kMostLight)
    throw UsageError{
        std::string{besideLights ? "--ia and the scene's lights" : "--ip and the scene's ambient light"} +
        ": their sum must not exceed 1"};
}

}  // namespace

Scene readyScene(Options& options) {
  Scene scene = read(options);
  if (options.command == Command::Trace)
    scene.settings.order = Order::Newell;  // the trace follows this order
  settle(options, scene.settings);
  giveWay(scene, options);
  options.picture.camera = completed(options.picture.camera, scene.camera);
  if (!options.texture.empty()) {
    wear(scene, readTexture(options.texture));
    scene.origin.texture = options.texture;
  }
  scene.marks.edges = options.edges, scene.marks.edgeColor = options.edgeColor;
  return scene;
}

}  // namespace xnewell
