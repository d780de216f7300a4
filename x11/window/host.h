#pragma once

#include <functional>
#include <optional>

#include "shading/trade/configuration.h"
#include "x11/kit/key_table.h"
#include "x11/options/options.h"
#include "x11/window/controls.h"

namespace xnewell {

/// What a view may ask of the window that holds it.
class Host : public Prompt {
 public:
  [[nodiscard]] virtual const Setup& setup() const = 0;
  /// The setup that `reset` restores.
  [[nodiscard]] virtual const Setup& defaults() const = 0;
  /// open() shows another scene with a setup of its own, and undo starts afresh. close() brings back what was
  /// there before the first open().
  virtual void open(Scene scene, const Setup& setup) = 0;
  virtual void close() = 0;
  virtual void switchTo(View view) = 0;
  /// Shows in view 8 why a pixel of the picture has its colour: the one at this share of the picture's width
  /// and height, each in [0, 1).
  virtual void explain(double x, double y) = 0;
  /// Goes to a pixel that shows a wrong face, in view 8.
  virtual void explainWrong() = 0;
  /// Shows a step of the depth sort in view 2.
  virtual void sortFrom(int step) = 0;
  /// Fills a polygon in view 0, by its name ("59.1"); "": one that the view chooses.
  virtual void fill(const std::string& polygon) = 0;
  /// Shows the setup in view 5, beside B.
  virtual void compare(const Setup& B) = 0;
  /// Changes the setup in a way that can be undone. Changes in a row with the same `control` are undone as
  /// one.
  virtual void change(char control, const std::function<void(Setup&)>& edit) = 0;
  /// Takes back the last change.
  virtual void undo() = 0;
  /// Presses a letter, as a button with this letter does.
  virtual void pressLetter(char letter) = 0;
};

}  // namespace xnewell
