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

// A run is told in one line a step, and as JSON. What is no run is refused in one line.
TEST_F(CommandTest, JudgeFindsTheFirstFalseStepOfARun) {
  const std::string run = file("run.jsonl");
  const auto write = [&](const std::string& lines) { std::ofstream{run} << lines; };
  const std::string first = "{\"event\": \"run\", \"size\": [800, 600]}\n{\"event\": \"take\", \"P\": 0}\n",
                    last = "{\"event\": \"paint\", \"P\": 0}\n{\"event\": \"paint\", \"P\": 1}\n";
  write(first + R"({"event": "test", "P": 0, "Q": 1, "test": "1", "outcome": "yes"})" + '\n' + last);
  const auto said = runProgram({"judge", "two-cards", "--run", run});
  EXPECT_EQ(said.status, 1);
  EXPECT_TRUE(
      said.out.starts_with("wrong: 4 steps, and this is the first false one\nline 3: test 1 of face 0 (P) "
                           "and face 1 (Q) says yes: do the x-extents not overlap? No: they overlap by "))
      << said.out;
  const auto json = Json::parse(runProgram({"judge", "two-cards", "--run", run, "--json"}).out);
  EXPECT_EQ(json.at("wrong")[0].at("kind"), "answer");
  EXPECT_EQ(json.at("wrong").size(), 1u);  // what is painted too early follows from it
  EXPECT_EQ(json.at("follow"), 1);
  std::filesystem::create_directory(file("class"));
  std::filesystem::copy(run, file("class/one.jsonl"));
  EXPECT_EQ(runProgram({"grade", "two-cards", file("class"), "-o", file("marks.csv")}).status, 0);
  EXPECT_NE(contents(file("marks.csv")).find("one.jsonl,wrong,"), std::string::npos)
      << contents(file("marks.csv"));
  write(first + "{\"event\": \"move\", \"P\": 0, \"Q\": 1}\n" +
        "{\"event\": \"paint\", \"P\": 1}\n{\"event\": \"paint\", \"P\": 0}\n");
  EXPECT_EQ(runProgram({"judge", "two-cards", "--run", run}).out, "right: 4 steps, and none is false\n");
  refused({"judge", "two-cards", "--run", run, "--size", "640x480"}, 2,
          run + " is for a picture of 800 x 600, and --size says 640 x 480: leave --size out");
  refused({"judge", "two-cards", "--run", run, run}, 2, "an order and --run exclude each other");

  const std::string number = "\"P\" is a whole number from 0";
  for (const auto& [line, why] : std::vector<std::pair<std::string, std::string>>{
           {R"({"event": "take", "P": 2})", "no polygon 2: the faces are 0 to 1, and no split made it"},
           {R"({"event": "take", "P": "a"})", number},
           {R"({"event": "take", "P": 99999999999999999999})", number},
           {R"({"event": "take", "P": 1e999})", "a number is too large"},
           {R"({"event": "take"})", "\"P\" is needed: the number of a face, from 0, or of a piece"},
           {R"({"event": "go", "P": 0})",
            "'go' is no event: take, test, move, mark, cut, paint and note are"},
           {R"({"event": "test", "P": 0, "Q": 1, "test": "7", "outcome": "no"})",
            "'7' is no test: plane, 1, 2, 3, 4, 5, 3', 4' and 6 are"},
           {R"({"event": "move", "P": 1, "Q": 1})", "P and Q are the same polygon"},
           {R"({"event": "cut", "P": 0, "Q": 1, "behind": 2, "in_front": 2})",
            "a piece has the number 2, which another polygon has"},
           {R"({"event": "cut", "P": 0, "Q": 1, "behind": 2, "in_front": 3, "P_shade": [1, 2]})",
            "\"P_shade\" is [Nx, Ny, Nz, N.L, cell]"},
           {R"({"event": "take", "P": )" + std::string(300, '['),
            "lists and objects are nested more than 100 deep"},
           {std::string("\x00\xff\x13", 3), R"(not a JSON object such as {"event": "take", "P": 3})"}}) {
    write(first + line + '\n');
    refused({"judge", "two-cards", "--run", run}, 2, run + ":3: " + why);
  }
  write("");
  refused({"judge", "two-cards", "--run", run}, 2, run + ": no line is a step of a run");
}

// An order with pieces is right in the picture whose size it says, and wrong in another. A size beside it may
// only be the same. The page of a class says where an order was judged.
TEST_F(CommandTest, OrdersSayTheSizeOfTheirPicture) {
  std::filesystem::create_directory(file("class"));
  const std::string order = file("class/cut.jsonl");
  // Card 1, and card 0 in two halves.
  const std::string steps = R"({"face": 1}
{"face": 0, "piece": [[33, 92], [160, 92], [160, 162], [33, 162]]}
{"face": 0, "piece": [[160, 92], [287, 92], [287, 162], [160, 162]]}
)";
  std::ofstream{order} << "{\"size\": [320, 240]}\n" << steps;
  const auto sized = runProgram({"judge", "two-cards", order});
  EXPECT_EQ(sized.out, "right: 3 steps, and every sample shows the nearest face\n");
  EXPECT_EQ(runProgram({"judge", "two-cards", order, "--size", "320x240"}).status, 0);
  refused({"judge", "two-cards", order, "--size", "640x480"}, 2,
          order + " is for a picture of 320 x 240, and --size says 640 x 480: leave --size out");
  std::ofstream{file("class/bare.jsonl")} << steps;
  EXPECT_EQ(runProgram({"judge", "two-cards", file("class/bare.jsonl")}).status, 1);
  EXPECT_EQ(runProgram({"judge", "two-cards", file("class/bare.jsonl"), "--size", "320x240"}).status, 0);
  const auto end =
      runProgram({"grade", "two-cards", file("class"), "-o", file("marks.csv"), "--page", file("page.html")});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.out.substr(0, end.out.find('\n')), "2 files: 1 right, 1 wrong");
  for (const char* const name : {"marks.csv", "page.html"}) {
    const std::string text = contents(file(name));
    const std::size_t said = text.find("every sample shows the nearest face; judged at 320 x 240");
    EXPECT_NE(said, std::string::npos) << text;
    EXPECT_EQ(text.find("judged at", said + 60), std::string::npos) << text;
  }
}

// A class is marked in one run: the rows, the page and the summary.
TEST_F(CommandTest, GradeMarksAFolder) {
  std::filesystem::create_directory(file("class"));
  ASSERT_EQ(runProgram({"draw", "bench", "--size", "160x120", "-o", file("class/a.png")}).status, 0);
  ASSERT_EQ(
      runProgram({"draw", "bench", "--size", "160x120", "--mistake", "Ia-twice", "-o", file("class/b.png")})
          .status,
      0);
  std::ofstream{file("class/c.png")} << "no picture";
  // The lesson asks at step 3, and d holds there.
  std::ofstream{file("class/d.json")}
      << R"({"answers": [{"lesson": "cycles", "step": 3, "tries": ["d"], "right": "a"}]})";
  std::ofstream{file("class/e.json")}
      << R"({"answers": [{"lesson": "cycles", "step": 1, "tries": ["d"], "right": "d"}]})";
  const auto end =
      runProgram({"grade", "bench", file("class"), "-o", file("marks.csv"), "--page", file("page.html")});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.err, "");
  EXPECT_EQ(end.out,
            "5 files: 2 unreadable, 1 answers, 1 mistake, 1 right\nmistakes: 1 Ia-twice\n"
            "answers: 1 of 1 right at the first try\n");
  const std::string csv = contents(file("marks.csv"));
  EXPECT_NE(csv.find("\nb.png,mistake,Ia-twice,ka Ia,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nd.json,answers,,,,,,,1 of 1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("step 1 of 'cycles' asks nothing"), std::string::npos) << csv;
  EXPECT_NE(contents(file("page.html")).find("data:image/png;base64,"), std::string::npos);
  refused({"grade", "bench", file("class")}, 2, "grade needs -o MARKS.csv");
  std::filesystem::create_directory(file("empty"));
  std::ofstream{file("empty/readme.txt")} << "hello";
  refused({"grade", "bench", file("empty"), "-o", file("new.csv")}, 2,
          "grade: no picture, order (.jsonl) or answers (.json) is in " + file("empty"));
  refused({"grade", "bench", file("none"), "-o", file("new.csv")}, 1,
          file("none") + ": No such file or directory");
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

// Questions come as text with solutions and as a file for Moodle.
TEST_F(CommandTest, QuestionsAreWritten) {
  const auto end =
      runProgram({"questions", "cycle", "--count", "30", "--seed", "4", "--gift", file("q.gift")});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_NE(end.out.find("\n30. "), std::string::npos);
  EXPECT_NE(end.out.find("\nSolutions\n"), std::string::npos);
  EXPECT_TRUE(contents(file("q.gift")).starts_with("// questions in Moodle's GIFT format\n"));
  EXPECT_EQ(runProgram({"questions", "cycle", "--count", "30", "--seed", "4"}).out, end.out);
  refused({"questions"}, 2, "questions needs a scene, such as teapot");
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
