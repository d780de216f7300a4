#include <chrono>
#include <thread>

#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// One point of the teapot is very far away, so that all others coincide on the screen. The errors are
// measured, in seconds.
TEST_F(CommandTest, ErrorsOfATeapotWithOnePointFarAway) {
  std::string teapot = contents(std::string{XNEWELL_DATA_DIR} + "/teapot.bpt");
  const std::string one = "\n0 -1.425 0\n";  // in the middle of the bottom
  ASSERT_NE(teapot.rfind(one), std::string::npos);
  teapot.replace(teapot.rfind(one), one.size(), "\n-1e30 -1.425 0\n");
  const auto start = std::chrono::steady_clock::now();
  const Finished end = runProgram({"draw", write("far.bpt", teapot), "-o", file("a.png"), "--size", "60x40",
                                   "--errors", "--shade", "flat"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds{60});
  EXPECT_TRUE(Json::parse(end.out).at("errors").contains("intensity"));
}

// An interrupt while the errors are measured leaves no picture behind: it is written when they are known.
TEST_F(CommandTest, AnInterruptedMeasurementLeavesNothing) {
  const Strings words{
      "draw", "teapot", "-o", file("a.png"), "--size", kSanitized ? "400x300" : "1600x1200", "--errors"};
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(runProgram(words).status, 0);
  const auto whole = std::chrono::steady_clock::now() - start;
  for (const double share : {0.3, 0.5, 0.7}) {
    std::filesystem::remove(file("a.png"));
    RunningProgram child{words};
    std::this_thread::sleep_for(whole * share);
    child.signal(SIGINT);
    const Finished end = child.wait();
    // An interrupt that comes while the file is written waits until it is whole.
    if (std::filesystem::exists(file("a.png")))
      EXPECT_GT(readPng(file("a.png")).width, 0);
    else
      EXPECT_EQ(end.status, 130);
    EXPECT_EQ(end.out.empty(), end.status == 130) << end.status;
  }
}

// --stats counts doubtful samples only where an order may have any. The number is that of a whole check: for
// scenes whose faces touch, for exact orders and others.
TEST_F(CommandTest, StatsCountWhatIsDoubtful) {
  int doubtful = 0, contacts = 0, none = 0;
  for (const char* scene : {"teapot", "room", "shingles", "sheets", "decals"})
    for (const char* order : {"newell", "bsp", "zsort", "oracle", "zbuffer16"}) {
      const Json stats = draw(scene, {"--order", order, "--size", "97x71"}).stats;
      PictureCache pictures{readScene(scene)};
      PictureSettings settings = pictures.scene().settings;
      settings.camera = pictures.scene().camera;
      settings.width = 97, settings.height = 71;
      settings.order = std::ranges::find(kOrders, order, &OrderRow::name)->id;
      const int whole = exactnessOf(pictures.make(settings, 8)).doubtful;
      EXPECT_EQ(stats.at("doubtful"), whole) << scene << ' ' << order;
      doubtful += whole;
      contacts += stats.at("contacts").get<int>();
      none += stats.at("contacts") == 0;
    }
  EXPECT_GT(doubtful, 0);
  EXPECT_GT(contacts, 0);
  EXPECT_GT(none, 10);
}

}  // namespace xnewell::THIS_FILE
