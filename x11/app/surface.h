#pragma once

#include <functional>
#include <string>

#include "shading/picture/shared.h"
#include "x11/app/workbench.h"
#include "x11/options/options.h"

namespace xnewell {

/// What a window does with its workbench, whether an X server shows it (viewer.h) or a page of a browser
/// (x11/browser): the pointer, the clock, the scale.
class Surface {
 public:
  /// What the two do in their own ways. `refresh` brings the window up to date; `png` is what it shows then.
  Surface(const Options& options, Scene scene, const Setup& setup, Workbench::Server server,
          std::function<void()> refresh, std::function<std::string()> png);

  [[nodiscard]] Workbench& bench() { return bench_; }

  /// Takes the scale that an option or the user has chosen, else the usual one, as far as the window has
  /// room.
  void scale(int usual, int width, int height);

  void press(int x, int y) { dragging_ = bench_.grab(x, y); }
  void move(int x, int y);
  void letGo();
  [[nodiscard]] bool dragging() const { return dragging_; }

  /// A moving view moves at most once in 40 ms: it does so now, or this says in how many milliseconds. -1 if
  /// nothing moves.
  [[nodiscard]] int tick();

 private:
  Workbench bench_;
  int scale_;  ///< that an option says; 0 for none
  bool dragging_ = false;
  Stopwatch sinceTick_;
};

}  // namespace xnewell
