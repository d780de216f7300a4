#include "x11/app/long_work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/watched_viewer.h"

#include <X11/keysym.h>

namespace xnewell {

namespace {

constexpr Rect kSeen{0, 0, 1024, 724};  ///< the window of 1024 x 768 but for its status line

/// Triangles through each other, whose exact order takes some seconds.
std::string crossing() {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> any{-1.0, 1.0};
  std::ostringstream text;
  const int triangles = kSanitized ? 150 : 270;
  for (int corner = 0; corner < 3 * triangles; ++corner) {
    const double x = any(random), y = any(random), z = any(random);
    text << "v " << x << ' ' << y << ' ' << z << '\n';
  }
  for (int corner = 1; corner < 3 * triangles; corner += 3)
    text << "f " << corner << ' ' << corner + 1 << ' ' << corner + 2 << '\n';
  return text.str();
}

/// Whether the box is there, of any of the first seconds.
class BoxWatch {
 public:
  bool operator()(const WatchedWindow& window) const {
    return std::ranges::find(boxes_, window.shown(at_)) != boxes_.end();
  }

 private:
  static constexpr int kSeconds = 120;

  static std::vector<RgbImage> boxes() {
    const CellPlan plan;
    const Palette palette = withInterface({}, plan);
    std::vector<RgbImage> all;
    for (int seconds = 1; seconds <= kSeconds; ++seconds) {
      IndexImage window{1024, 768, plan[Cell::Paper]};
      drawBusyBox(window, plan, seconds, true);
      RgbImage& box = all.emplace_back(at_.width, at_.height);
      std::size_t k = 0;
      for (int j = at_.y; j < at_.y + at_.height; ++j)
        for (int i = at_.x; i < at_.x + at_.width; ++i) {
          const Rgb16 c = palette[window.row(j)[i]];
          for (const int value : {c.r, c.g, c.b}) box.rgb[k++] = static_cast<std::uint8_t>(value >> 8);
        }
    }
    return all;
  }

  static inline const Rect at_ = busyBox(1024, 768);
  std::vector<RgbImage> boxes_ = boxes();
};

}  // namespace

TEST(DoPatiently, SaysNothingOfWorkThatIsSoonDone) {
  int said = 0;
  std::thread::id where;
  doPatiently([&] { where = std::this_thread::get_id(); }, [&](int) { ++said; });
  EXPECT_EQ(said, 0);
  EXPECT_NE(where, std::thread::id{});
  EXPECT_NE(where, std::this_thread::get_id());
}

TEST(DoPatiently, TellsTheSeconds) {
  std::vector<int> said;
  bool done = false;
  const std::thread::id here = std::this_thread::get_id();
  doPatiently(
      [&] {
        std::this_thread::sleep_for(2 * kPatience + std::chrono::milliseconds{50});
        done = true;
      },
      [&](int seconds) {
        said.push_back(seconds);
        EXPECT_EQ(std::this_thread::get_id(), here);
      });
  EXPECT_TRUE(done);
  ASSERT_FALSE(said.empty());
  EXPECT_GE(said.front(), 1);
  EXPECT_TRUE(std::ranges::is_sorted(said));
}

TEST(DoPatiently, PassesOnWhatIsThrown) {
  EXPECT_THROW(doPatiently([] { throw std::runtime_error{"work"}; }, [](int) {}), std::runtime_error);
  bool done = false;
  EXPECT_THROW(doPatiently(
                   [&] {
                     std::this_thread::sleep_for(kPatience + std::chrono::milliseconds{300});
                     done = true;
                   },
                   [](int) { throw std::logic_error{"meanwhile"}; }),
               std::logic_error);
  EXPECT_TRUE(done);
}

class LongWorkAt : public testing::TestWithParam<int> {
 protected:
  XServer server = XServer::xvfb(GetParam(), 1280, 1024);
  TemporaryFolder folder;
  std::string scene = folder.write("crossing.obj", crossing());
  BoxWatch showsBox;
};
INSTANTIATE_TEST_SUITE_P(Depths, LongWorkAt, testing::Values(8, 24), testing::PrintToStringParamName());

// A window is there before its picture, and says so; the picture follows, and nothing of the box stays. Later
// pictures that take long are told over the one that is there. Closing meanwhile does not wait.
TEST_P(LongWorkAt, IsTold) {
  const RgbImage picture = freshWindow(server, scene);
  RunningProgram program{words("view " + scene), server.name()};
  {
    const WatchedWindow early = WatchedWindow::early(server);
    EXPECT_TRUE(early.isDrawing()) << early.title();
    EXPECT_TRUE(comesTrue([&] { return showsBox(early); }));
  }
  const WatchedWindow window{server};
  EXPECT_EQ(window.title(), "xnewell: " + scene);
  EXPECT_TRUE(window.comesToShow(picture, kSeen));

  window.type("t");
  window.press(XK_Right);
  EXPECT_TRUE(comesTrue([&] { return window.isDrawing(); }));
  EXPECT_TRUE(comesTrue([&] { return showsBox(window); }));
  EXPECT_TRUE(comesTrue([&] { return !window.isDrawing(); }));
  EXPECT_TRUE(window.comesToDiffer(picture, kSeen));

  window.press(XK_Right);
  EXPECT_TRUE(comesTrue([&] { return window.isDrawing(); }));
  window.askToClose();
  EXPECT_TRUE(window.goes());
  EXPECT_EQ(program.wait().status, 0);
}

// q ends it as soon, and so does whoever destroys the window, with a word.
TEST_P(LongWorkAt, EndsAtOnce) {
  {
    RunningProgram program{words("view " + scene), server.name()};
    const WatchedWindow window = WatchedWindow::early(server);
    window.type("q");
    EXPECT_TRUE(window.goes());
    EXPECT_EQ(program.wait().status, 0);
  }
  RunningProgram program{words("view " + scene), server.name()};
  const WatchedWindow window = WatchedWindow::early(server);
  XDestroyWindow(window.display(), window.id());
  XSync(window.display(), 0);
  const Finished end = program.wait();
  EXPECT_EQ(end.status, 1);
  EXPECT_NE(end.err.find("xnewell: the window was destroyed by another program"), std::string::npos)
      << end.err;
}

// But not where what was changed would be lost: that is said as ever.
TEST_P(LongWorkAt, LosesNothing) {
  RunningProgram program{words("view " + scene), server.name()};
  const WatchedWindow window{server};
  window.type("w");
  window.type(folder.file("kept.json"));
  window.press(XK_Return);
  ASSERT_TRUE(comesTrue([&] { return std::filesystem::exists(folder.file("kept.json")); }));
  window.type("t");
  window.press(XK_Right);
  EXPECT_TRUE(comesTrue([&] { return window.isDrawing(); }));
  window.askToClose();
  EXPECT_TRUE(comesTrue([&] { return !window.isDrawing(); }));
  EXPECT_TRUE(program.running());
  window.askToClose();
  EXPECT_TRUE(window.goes());
  EXPECT_EQ(program.wait().status, 0);
}

}  // namespace xnewell
