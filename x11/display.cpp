#include "x11/display.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace {

ErrorTrap* innermost = nullptr;
int strays = 0;

/// "X_PutImage"; for an extension's request "MIT-SHM.3", or "request 130.3" where we may not ask the server.
std::string requestName(::Display* display, int major, int minor, bool mayAsk) {
  const std::string number = std::to_string(major);
  std::array<char, 128> text{};
  XGetErrorDatabaseText(display, "XRequest", number.c_str(), "", text.data(), text.size());
  if (text[0] != '\0') return text.data();
  std::string extension = "request " + number;
  int count = 0;
  char** names = mayAsk ? XListExtensions(display, &count) : nullptr;
  for (int i = 0; i < count; ++i) {
    int opcode = 0, event = 0, error = 0;
    if (XQueryExtension(display, names[i], &opcode, &event, &error) && opcode == major) extension = names[i];
  }
  if (names != nullptr) XFreeExtensionList(names);
  return extension + "." + std::to_string(minor);
}

std::string describe(::Display* display, const XErrorEvent& error, bool mayAsk) {
  std::array<char, 256> text{};
  XGetErrorText(display, error.error_code, text.data(), text.size());
  return requestName(display, error.request_code, error.minor_code, mayAsk) + ": " + text.data();
}

int onServerGone(::Display* display) {
  std::fflush(stdout);
  std::fprintf(stderr, "xnewell: the X server of display '%s' has gone\n", DisplayString(display));
  std::_Exit(1);
}

}  // namespace

/// Called by Xlib while it reads the server's answers: must not make requests, must not throw.
int onError(::Display* display, XErrorEvent* error) {
  for (ErrorTrap* trap = innermost; trap != nullptr; trap = trap->outer_) {
    if (trap->display_ != display || error->serial < trap->from_) continue;
    if (!trap->first_) trap->first_ = *error;
    return 0;
  }
  ++strays;
  std::fprintf(stderr, "xnewell: %s\n", describe(display, *error, /*mayAsk=*/false).c_str());
  return 0;
}

OwnedDisplay openDisplay(const std::string& name) {
  XSetErrorHandler(onError);
  XSetIOErrorHandler(onServerGone);
  const std::string used = XDisplayName(name.empty() ? nullptr : name.c_str());
  if (used.empty()) throw X11Error("no DISPLAY is set: start an X server, or name one, as in DISPLAY=:0");
  OwnedDisplay display{XOpenDisplay(used.c_str())};
  if (!display) throw X11Error("cannot open display '" + used + "'");
  return display;
}

int strayErrors() { return strays; }

ErrorTrap::ErrorTrap(::Display* display)
    : display_{display}, outer_{innermost}, from_{NextRequest(display)}, synced_{from_} {
  innermost = this;
}

ErrorTrap::~ErrorTrap() {
  sync();
  innermost = outer_;
}

void ErrorTrap::sync() {
  if (NextRequest(display_) == synced_) return;
  XSync(display_, 0);
  synced_ = NextRequest(display_);
}

void ErrorTrap::check() {
  sync();
  if (!first_) return;
  const XErrorEvent error = *std::exchange(first_, std::nullopt);
  throw X11Error(describe(display_, error, /*mayAsk=*/true));
}
