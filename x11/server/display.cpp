#include "x11/server/display.h"

#include <X11/Xutil.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "geometry/files/parse_error.h"

namespace xnewell {

namespace {

ErrorTrap* innermost = nullptr;
int strays = 0;
Window ours = 0;
int standardError = STDERR_FILENO;  ///< the stream for our own messages

void tell(const std::string& what) { dprintf(standardError, "xnewell: %s\n", visible(what).c_str()); }

/// The name of a request, such as "X_PutImage"; for an extension's request "MIT-SHM.3", or "request 130.3" if
/// we must not ask the server for the extension's name.
std::string requestName(Display* display, int major, int minor, bool mayAsk) {
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

std::string describe(Display* display, const XErrorEvent& error, bool mayAsk) {
  std::array<char, 256> text{};
  XGetErrorText(display, error.error_code, text.data(), text.size());
  return requestName(display, error.request_code, error.minor_code, mayAsk) + ": " + text.data();
}

bool allIsDone = false;
std::string lostMessage;

/// It may be called in a signal handler.
[[noreturn]] void endLost(int /*signal*/ = 0) {
  if (write(standardError, lostMessage.data(), lostMessage.size()) < 0) _exit(1);  // nobody reads it
  _exit(1);
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Opens a display. `said` gets what the libraries write to standard error meanwhile: a server that refuses
/// us gives a reason, and libxcb reports it nowhere else.
OwnedDisplay open(const std::string& name, std::string& said) {
  const std::unique_ptr<std::FILE, FileCloser> aside{std::tmpfile()};
  const int copy = aside ? dup(STDERR_FILENO) : -1;
  if (copy < 0) return OwnedDisplay{XOpenDisplay(name.c_str())};
  dup2(fileno(aside.get()), STDERR_FILENO);
  standardError = copy;
  OwnedDisplay display{XOpenDisplay(name.c_str())};
  standardError = dup2(copy, STDERR_FILENO);
  close(copy);
  std::rewind(aside.get());
  for (int c; (c = std::fgetc(aside.get())) != EOF;) said += static_cast<char>(c);
  while (!said.empty() && said.back() == '\n') said.pop_back();
  return display;
}

/// Xlib calls this when a connection has ended. It must not return.
int onServerGone(Display* display) {
  std::fflush(stdout);
  if (allIsDone) std::_Exit(0);
  const std::string name = DisplayString(display);
  lostMessage = "xnewell: lost the connection to the X server of display '" + name + "'\n";
  // A connection may end while it is opened, perhaps to see here whether the server still runs.
  if (standardError != STDERR_FILENO) endLost();
  constexpr unsigned kPatience = 2;  // seconds
  std::signal(SIGALRM, endLost);
  alarm(kPatience);
  std::string said;
  if (!open(name, said)) endLost();
  tell("the X server of display '" + name +
       "' still runs, but has ended our connection, as xkill makes it do");
  std::_Exit(1);
}

}  // namespace

/// Xlib calls this while it reads the server's answers. It must not make requests and must not throw.
int onError(Display* display, XErrorEvent* error) {
  for (ErrorTrap* trap = innermost; trap != nullptr; trap = trap->outer_) {
    if (trap->display_ != display || error->serial < trap->from_) continue;
    if (!trap->first_) trap->first_ = *error;
    return 0;
  }
  if (ours != 0 && error->resourceid == ours &&
      (error->error_code == BadWindow || error->error_code == BadDrawable))
    return 0;
  if (++strays <= kToldErrors) tell(describe(display, *error, /*mayAsk=*/false));
  return 0;
}

OwnedDisplay openDisplay(const std::string& name) {
  std::signal(SIGPIPE, SIG_IGN);  // onServerGone() handles a broken connection
  XSetErrorHandler(onError);
  XSetIOErrorHandler(onServerGone);
  const std::string used = XDisplayName(name.empty() ? nullptr : name.c_str());
  if (used.empty())
    throw X11Error("DISPLAY is not set: start an X server, or name one, for example DISPLAY=:0");
  std::string said;
  OwnedDisplay display = open(used, said);
  if (!display) throw X11Error("cannot open display '" + used + "'" + (said.empty() ? "" : ": " + said));
  if (!said.empty()) tell(said);
  return display;
}

int strayErrors() { return strays; }

void tellsItsEnd(Window window) { ours = window; }

void nothingMoreIsNeeded() { allIsDone = true; }

void ImageDestroyer::operator()(XImage* image) const { XDestroyImage(image); }

ErrorTrap::ErrorTrap(Display* display)
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

}  // namespace xnewell
