#include "x11/server/selection.h"

#include <X11/Xatom.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "shading/color/font.h"

namespace xnewell {

void Selection::offer(std::string text, Time since) {
  text_ = std::move(text);
  for (const Atom selection : {XInternAtom(display_, "CLIPBOARD", 0), Atom{XA_PRIMARY}})
    XSetSelectionOwner(display_, selection, window_, since);
}

void Selection::answer(const XSelectionRequestEvent& request) const {
  const Atom utf8 = XInternAtom(display_, "UTF8_STRING", 0), targets = XInternAtom(display_, "TARGETS", 0);
  const Atom property = request.property != 0 ? request.property : request.target;  // 0: an old program
  const ErrorTrap gone{display_};
  const auto put = [&](Atom type, int bits, const void* data, std::size_t count) {
    XChangeProperty(display_, request.requestor, property, type, bits, PropModeReplace,
                    static_cast<const unsigned char*>(data), static_cast<int>(count));
  };
  XEvent reply{};
  reply.xselection = {.type = SelectionNotify,
                      .serial = 0,
                      .send_event = 1,
                      .display = display_,
                      .requestor = request.requestor,
                      .selection = request.selection,
                      .target = request.target,
                      .property = property,
                      .time = request.time};
  if (request.target == targets) {
    const std::array<Atom, 3> all{targets, utf8, XA_STRING};
    put(XA_ATOM, 32, all.data(), all.size());
  } else if (request.target == utf8) {
    put(utf8, 8, text_.data(), text_.size());
  } else if (request.target == XA_STRING) {
    std::string text;
    for (std::size_t at = 0; at <= text_.size();) {  // line by line: STRING has new lines, the font none
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      text += latin1(std::string_view{text_}.substr(at, end - at));
      if (end < text_.size()) text += '\n';
      at = end + 1;
    }
    put(XA_STRING, 8, text.data(), text.size());
  } else {
    reply.xselection.property = 0;
  }
  XSendEvent(display_, request.requestor, 0, NoEventMask, &reply);
}

}  // namespace xnewell
