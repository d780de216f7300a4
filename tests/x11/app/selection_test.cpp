#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/x11/support/watched_viewer.h"

#include <X11/Xatom.h>

namespace xnewell::THIS_FILE {

namespace {

/// Another program that pastes.
class Paster {
 public:
  explicit Paster(const XServer& server)
      : display_{openDisplay(server.name())},
        window_{display_.get(),
                XCreateSimpleWindow(display_.get(), DefaultRootWindow(display_.get()), 0, 0, 1, 1, 0, 0, 0)} {
  }

  [[nodiscard]] Atom atom(const char* name) const { return XInternAtom(display_.get(), name, 0); }
  [[nodiscard]] bool isOwned(Atom selection) const {
    return XGetSelectionOwner(display_.get(), selection) != 0;
  }
  /// What the owner of the selection answers, with its type; type 0 if it declines.
  struct Answer {
    Atom type = 0;
    std::string bytes;  ///< of format 32: one long each
  };
  [[nodiscard]] Answer paste(Atom selection, Atom target) const {
    Display* d = display_.get();
    const Atom into = atom("XNEWELL_TEST");
    XConvertSelection(d, selection, target, into, window_.get(), CurrentTime);
    XEvent event{};
    if (!comesTrue([&] { return XCheckTypedEvent(d, SelectionNotify, &event) != 0; })) return {};
    if (event.xselection.property == 0) return {};
    Answer answer;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* bytes = nullptr;
    XGetWindowProperty(d, window_.get(), into, 0, 100'000, 1, AnyPropertyType, &answer.type, &format, &count,
                       &left, &bytes);
    answer.bytes.assign(reinterpret_cast<char*>(bytes), count * (format == 32 ? sizeof(long) : 1));
    XFree(bytes);
    return answer;
  }

 private:
  OwnedDisplay display_;
  OwnedWindow window_;
};

}  // namespace

// After C, other programs can paste the command that the program has printed, from both selections, as UTF-8
// and as Latin-1. They can ask which forms there are; any other form is declined.
TEST(SelectionOfTheWindow, HasTheCommand) {
  const XServer server = XServer::xvfb(24, 1280, 1024);
  WatchedViewer viewer{server, "teapot --divisions 4 --ks 0.5"};
  const Paster paster{server};
  const Atom clipboard = paster.atom("CLIPBOARD"), utf8 = paster.atom("UTF8_STRING");
  EXPECT_FALSE(paster.isOwned(clipboard));
  viewer.window.type("SC");
  ASSERT_TRUE(comesTrue([&] { return paster.isOwned(clipboard) && paster.isOwned(XA_PRIMARY); }));
  const std::string command = paster.paste(clipboard, utf8).bytes;
  EXPECT_NE(command.find(" polygons, "), std::string::npos) << command;
  EXPECT_NE(command.find("\nxnewell draw teapot --size "), std::string::npos) << command;
  EXPECT_NE(command.find(" --divisions 4 --shade gouraud --ks 0.5 "), std::string::npos) << command;
  for (const Atom selection : {clipboard, Atom{XA_PRIMARY}}) {
    EXPECT_EQ(paster.paste(selection, utf8).type, utf8);
    EXPECT_EQ(paster.paste(selection, utf8).bytes, command);
    EXPECT_EQ(paster.paste(selection, XA_STRING).type, Atom{XA_STRING});
    EXPECT_EQ(paster.paste(selection, XA_STRING).bytes, command);
    const Paster::Answer targets = paster.paste(selection, paster.atom("TARGETS"));
    EXPECT_EQ(targets.type, Atom{XA_ATOM});
    for (const Atom each : {paster.atom("TARGETS"), utf8, Atom{XA_STRING}})
      EXPECT_NE(targets.bytes.find(std::string{reinterpret_cast<const char*>(&each), sizeof each}),
                std::string::npos);
    EXPECT_EQ(paster.paste(selection, XA_BITMAP).type, 0u);
  }
  viewer.window.type("q");
  const Finished end = viewer.program.wait();
  EXPECT_EQ(end.out, command + '\n');
  EXPECT_EQ(end.err, "");
  EXPECT_EQ(end.status, 0);
}

// In another view than the first, the command makes a picture of the window, and that is what the window
// shows.
TEST(SelectionOfTheWindow, HasTheCommandOfTheView) {
  const XServer server = XServer::xvfb(24, 1280, 1024);
  WatchedViewer viewer{server, "teapot --divisions 4"};
  viewer.window.type("3");
  EXPECT_TRUE(viewer.window.settles());
  const Rect seen = aboveStatus(1024, 768);
  const RgbImage shown = viewer.window.shown(seen);
  viewer.window.type("Cq");
  const std::string printed = viewer.program.wait().out;
  const std::size_t begin = printed.find("\nxnewell snapshot teapot --size 1024x768 --whole-window ");
  ASSERT_NE(begin, std::string::npos) << printed;
  const std::string command = printed.substr(begin + 1);
  const std::string line = command.substr(8, command.find(" -o ") - 8);
  EXPECT_EQ(cropped(pictureOf(line, server.name()), seen), shown);
}

}  // namespace xnewell::THIS_FILE
