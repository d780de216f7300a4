#include "x11/app/surface.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "x11/app/viewer.h"

namespace xnewell {

Surface::Surface(const Options& options, Scene scene, const Setup& setup, Workbench::Server server,
                 std::function<void()> refresh, std::function<std::string()> png)
    : bench_{std::move(scene), setup,
             [&] {
               server.say = [](const std::string& text) { std::cout << text << std::flush; };
               server.picture = [this, refresh = std::move(refresh), png = std::move(png)] {
                 for (int k = 0; k < 3 && bench_.stale() != Workbench::Stale::Nothing; ++k) refresh();
                 return png();
               };
               return std::move(server);
             }()},
      scale_{options.gave("--scale") ? options.scale : 0} {
  if (!options.answers.empty()) bench_.lessons().keepAnswers(options.answers);
}

void Surface::scale(int usual, int width, int height) {
  if (!bench_.scaleIsChosen())
    bench_.scale(std::min(scale_ > 0 ? scale_ : usual, largestScale(width, height)));
}

void Surface::move(int x, int y) {
  if (dragging_)
    bench_.dragTo(x, y);
  else
    bench_.hover(x, y);
}

void Surface::letGo() {
  if (std::exchange(dragging_, false)) bench_.settle();
}

int Surface::tick() {
  constexpr double kTick = 40;
  if (!bench_.moving()) return -1;
  const double rest = kTick - sinceTick_.ms();
  if (rest > 0) return 1 + static_cast<int>(rest);
  sinceTick_ = {};
  bench_.tick();
  return 0;
}

int runViewer(const Options& options, Scene scene, std::optional<Lesson> lesson,
              const std::function<void()>& shown) {
  return showWindow(
      options, std::move(scene),
      [&](Workbench& bench) {
        bench.begin(options, std::move(lesson));
        if (options.command == Command::View && options.given.empty()) bench.welcome();
      },
      shown);
}

int runLecture(const Options& options, std::vector<Page> pages, const std::function<void()>& shown) {
  Scene scene = pages.front().scene;
  return showWindow(
      options, std::move(scene),
      [&](Workbench& bench) {
        bench.lecture({std::move(pages), options.play});
      },
      shown);
}

}  // namespace xnewell
