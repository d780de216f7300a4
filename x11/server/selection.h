#pragma once

#include <string>

#include "x11/server/display.h"

namespace xnewell {

/// Text that other programs can paste. While we own CLIPBOARD and PRIMARY, the server passes their requests
/// on to us. The text goes when the connection ends.
class Selection {
 public:
  /// Both must outlive this.
  Selection(Display* display, Window window) : display_{display}, window_{window} {}

  /// Owns both selections with this text, in UTF-8. `since` is the time of the key press that asked for it.
  void offer(std::string text, Time since);
  /// Answers a program that asks for the text, as UTF8_STRING or as STRING (Latin-1), or for the list of
  /// these (TARGETS). Anything else is declined. A program that is gone by then is no error.
  void answer(const XSelectionRequestEvent& request) const;

 private:
  Display* display_;
  Window window_;
  std::string text_;
};

}  // namespace xnewell
