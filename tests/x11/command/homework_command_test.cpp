#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"
#include "tests/x11/support/command_fixture.h"
#include "x11/options/options.h"

namespace xnewell::THIS_FILE {

// A right order has the status 0. A wrong one has 1, names the pair, and the two polygons alone are a scene
// that draws the mistake again.
TEST_F(CommandTest, JudgeShowsAWrongPair) {
  const auto write = [&](const std::string& order) {
    std::ofstream{file("order.jsonl")} << order;
    return file("order.jsonl");
  };
  // Card 0 slants before card 1: the sort by depth paints 1 first.
  const auto good = runProgram({"judge", "two-cards", write("{\"face\": 1}\n{\"face\": 0}\n")});
  const auto bad =
      runProgram({"judge", "two-cards", write("{\"face\": 0}\n{\"face\": 1}\n"), "-o", file("pair.json")});
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.out, "right: 2 steps, and every sample shows the nearest face\n");
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(bad.out.starts_with("wrong: face 1 ")) << bad.out;
  EXPECT_NE(bad.out.find("test 3 tells") == std::string::npos,
            bad.out.find("test 4 tells") == std::string::npos)
      << bad.out;
  const auto json = Json::parse(runProgram({"judge", "two-cards", file("order.jsonl"), "--json"}).out);
  EXPECT_EQ(json.at("verdict"), "wrong");
  const auto drawn =
      runProgram({"draw", file("pair.json"), "-o", file("pair.png"), "--ids", file("ids.png")});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  const RgbImage ids = readPng(file("ids.png"));
  const auto& pixel = json.at("first").at("pixel");
  EXPECT_EQ(ids.pixel(pixel[0].get<int>(), pixel[1].get<int>())[2], 2);  // the second polygon hides the first
}

// An interrupt leaves the marks that were there.
TEST_F(CommandTest, GradeCanBeInterrupted) {
  std::filesystem::create_directory(file("class"));
  ASSERT_EQ(runProgram({"draw", "bench", "--size", "320x240", "-o", file("class/0.png")}).status, 0);
  for (int k = 1; k < 400; ++k)
    std::filesystem::copy_file(file("class/0.png"), file("class/" + std::to_string(k) + ".png"));
  std::ofstream{file("marks.csv")} << "old";
  RunningProgram child{{"grade", "bench", file("class"), "-o", file("marks.csv")}};
  std::this_thread::sleep_for(std::chrono::milliseconds{300});
  child.signal(SIGINT);
  const Finished end = child.wait();
  EXPECT_EQ(end.status, 130);
  EXPECT_EQ(contents(file("marks.csv")), "old");
}

namespace {

struct OneZ {
  std::string name;
  double (*of)(double far, double near, double mean);
};
const std::array kSorts{OneZ{"farthest", [](double far, double, double) { return far; }},
                        OneZ{"nearest", [](double, double near, double) { return near; }},
                        OneZ{"mean", [](double, double, double mean) { return mean; }}};

}  // namespace

// A sort by one z of each face is right on no scene of the exercises but the one that asks for it.
TEST_F(CommandTest, JudgeTellsSortsByZApart) {
  for (const std::string scene : {"leaning-card", "leaning-cards", "bench", "teapot"}) {
    Scene read = readScene(scene);
    PictureSettings s = read.settings;
    s.width = kPictureSize.x, s.height = kPictureSize.y, s.order = Order::Unsorted;
    s.camera = completed({}, read.camera);
    const Picture picture = makePicture(std::move(read), s, std::uint8_t{0});
    const SnappedScene& snapped = picture.snapped();
    for (const OneZ& sort : kSorts) {
      std::vector<std::pair<double, int>> order;
      for (const SnappedFace& face : snapped.faces) {
        double far = 1e9, near = -1e9, sum = 0;
        for (int k = face.first; k < face.first + face.count; ++k) {
          const double z = snapped.vertices[static_cast<std::size_t>(k)].z;
          far = std::min(far, z), near = std::max(near, z), sum += z;
        }
        order.emplace_back(sort.of(far, near, sum / face.count), face.number);
      }
      std::ranges::sort(order);
      std::ofstream out{file("order.jsonl")};
      for (const auto& [z, f] : order) out << "{\"face\": " << f << "}\n";
      out.close();
      const Finished judged = runProgram({"judge", scene, file("order.jsonl")});
      EXPECT_EQ(judged.status, scene == "leaning-card" && sort.name == "farthest" ? 0 : 1)
          << scene << ", " << sort.name << ": " << judged.out;
    }
  }
}

// A picture of a sort by z may have only right shades. Below the verdict stands at how many samples it
// differs.
TEST_F(CommandTest, DiagnoseCountsWhatASortByZShows) {
  for (const std::string scene : {"bench", "teapot"})
    for (const std::string order : {"newell", "zsort", "zmean"}) {
      const std::string drawn = file(order + ".png");
      ASSERT_EQ(runProgram({"draw", scene, "--order", order, "-o", drawn, "--bare"}).status, 0);
      const RgbImage exact = readPng(file("newell.png")), picture = readPng(drawn);
      int differ = 0;
      for (std::size_t k = 0; k < exact.rgb.size(); k += 3)
        differ += !std::equal(&exact.rgb[k], &exact.rgb[k] + 3, &picture.rgb[k]);
      const Finished said = runProgram({"diagnose", scene, drawn});
      EXPECT_EQ(said.status, 0);
      std::string count =
          said.out.starts_with("right\n  at ") ? said.out.substr(11, said.out.find(" of ") - 11) : "0";
      std::erase(count, ',');
      EXPECT_LE(std::stoi(count), differ) << scene << ' ' << order << said.out;
      EXPECT_GE(std::stoi(count), differ / 3) << scene << ' ' << order << said.out;
      EXPECT_EQ(differ > 0, order != "newell");
    }
}

}  // namespace xnewell::THIS_FILE
