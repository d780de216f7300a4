#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <sstream>

#include "shading/laboratory/errors.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "x11/command/commands.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell::THIS_FILE {

// What the commands say, against other ways to find it. Single lines that they say are in tests/stories.

namespace {

constexpr std::array kSorts{"farthest", "nearest", "mean"};  ///< by one z of each face

/// The longest part of `text` that stands as it is in HTML, with no placeholder in it.
std::string longestPlain(const std::string& text) {
  std::string longest;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("{<>&\"'", at), text.size());
    if (end - at > longest.size()) longest = text.substr(at, end - at);
    at = end < text.size() && text[end] == '{' ? text.find('}', end) + 1 : end + 1;
  }
  return longest;
}

using TraceCommand = CommandTest;

std::vector<Json> linesOf(const Strings& words) {
  const Finished end = runProgram(Strings{"trace"} + words);
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.err, "");
  std::vector<Json> lines;
  std::istringstream in{end.out};
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// What the numbers of a test's line say by themselves.
std::string decided(const Json& line) {
  const Json& n = line["numbers"];
  const std::string test = line["test"];
  const auto apart = [](const Json& p, const Json& q) { return p[1] <= q[0] || q[1] <= p[0] ? "yes" : "no"; };
  const auto only = [](const Json& corners, const char* where, const char* notThere) {
    return corners[notThere] == 0 && corners[where] > 0 ? "yes" : "no";
  };
  if (test == "1") return apart(n["P_x"], n["Q_x"]);
  if (test == "2") return apart(n["P_y"], n["Q_y"]);
  if (test == "3") return only(n["P_from_plane_of_Q"], "behind", "in_front");
  if (test == "4") return only(n["Q_from_plane_of_P"], "in_front", "behind");
  if (test == "5") return n["separating_edge"].is_null() ? "no" : "yes";
  if (test == "3'") return only(n["Q_from_plane_of_P"], "behind", "in_front");
  if (test == "4'") return only(n["P_from_plane_of_Q"], "in_front", "behind");
  if (test == "plane") return "yes";
  if (n["contact"]) return line["outcome"];
  return n["P_nearer"] == 0 ? "P first" : n["Q_nearer"] == 0 ? "Q first" : "crossing";
}

/// The number of files in the folder for each word that follows a file's number.
std::map<std::string, int> framesIn(const std::string& folder) {
  std::map<std::string, int> words;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.size() > 9 && name[4] == '-' && name.ends_with(".png")) << name;
    ++words[name.substr(5, name.size() - 9)];
  }
  return words;
}

}  // namespace

// Ctrl-C at any moment of long work ends a command with status 130, or it had just ended. What it was to
// write is as it was; a chart has what is known, or it is said that there is none. A second interrupt ends
// the program at once.
TEST_F(CommandTest, InterruptsLeaveNothingHalfDone) {
  struct Row {
    Strings words;
    std::string output;
    bool chart = false;
  };
  std::filesystem::create_directory(file("class"));
  ASSERT_EQ(runProgram({"draw", "bench", "--size", "320x240", "-o", file("class/0.png")}).status, 0);
  for (int k = 1; k < 400; ++k)
    std::filesystem::copy_file(file("class/0.png"), file("class/" + std::to_string(k) + ".png"));
  const std::string large = kSanitized ? "400x300" : "1600x1200";
  for (const Row& row : {Row{{"draw", "teapot", "--size", "3000x3000", "--ids", file("ids.png")}, "big.png"},
                         Row{{"draw", "teapot", "--size", large, "--errors"}, "errors.png"},
                         Row{{"grade", "bench", file("class")}, "marks.csv"},
                         Row{{"trade", kSanitized ? "cubes" : "teapot", "--size", "400x300", "--axes",
                              "shade,order", "--budget", "600"},
                             "trade.png",
                             true},
                         Row{{"extremes", "cycle", "--size", "1200x900"}, "extremes.png", true}}) {
    SCOPED_TRACE(row.words[0]);
    const Strings words = row.words + Strings{"-o", write(row.output, "before")};
    int interrupted = 0;
    bool some = false;
    for (int ms = row.chart ? 1000 : 20; !some && ms <= (row.chart ? 32'000 : 640); ms *= 2) {
      std::filesystem::remove(file("ids.png"));
      RunningProgram child{words};
      std::this_thread::sleep_for(std::chrono::milliseconds{ms});
      child.signal(SIGINT);
      const Finished end = child.wait();
      some = contents(file(row.output)) != "before";
      interrupted += end.status == 130;
      if (some && !row.output.ends_with(".csv")) {
        EXPECT_GT(readPng(file(row.output)).height, 50);
      }
      EXPECT_EQ(std::filesystem::exists(file("ids.png")), some && row.output == "big.png");
      if (!row.chart) {
        // The signal may come behind the last file, and before the report.
        EXPECT_TRUE(end.status == 130 || (some && end.status == 0)) << end.err;
        if (!some || row.output == "big.png") {
          EXPECT_EQ(end.out, "");
        } else if (end.status == 0) {
          EXPECT_NE(end.out, "");
        }
        continue;
      }
      ASSERT_EQ(end.status, 130) << end.err;
      if (row.words[0] == "trade") {
        EXPECT_EQ(end.err.find("no chart was written: nothing was timed") == end.err.npos, some) << end.err;
        EXPECT_EQ(end.out.find("Nothing was timed") == end.out.npos, some) << end.out;
      } else if (end.out.starts_with("Stopped: ")) {  // on a busy machine it may not have begun
        EXPECT_EQ(end.out.find("light falls to"), end.out.npos);
        some = end.out.find("scaled up by (powers of two)") != end.out.npos;
      }
    }
    EXPECT_TRUE(some || !row.chart);
    EXPECT_GT(interrupted, 0);
  }
  RunningProgram twice{{"extremes", "cycle", "--size", "1200x900"}};
  std::this_thread::sleep_for(std::chrono::milliseconds{500});
  for (int k = 0; k < 2; ++k) twice.signal(SIGINT);
  EXPECT_EQ(twice.wait().status, 130);
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

// A row has its command, and the command has the errors of the row. They may differ by roundings: the
// trade holds the camera still while divisions change, and the command places it anew.
TEST_F(CommandTest, EachRowOfATradeCanBeRepeated) {
  const auto told =
      runProgram(Strings{"trade", XNEWELL_DATA_DIR "/../tests/data/dome.bpt", "--size", "60x45", "--budget",
                         "60", "--json", "--axes", kSanitized ? "shade,order" : "shade,divisions"});
  ASSERT_EQ(told.status, 0) << told.err;
  const auto trade = Json::parse(told.out);
  auto rows = trade.at("rows");
  ASSERT_GT(rows.size(), 5u);
  for (const auto& one : trade.at("combinations"))
    if (one.at("front").get<bool>()) rows.push_back(one);
  for (std::size_t k = 0; k < rows.size(); k += kSanitized ? 6 : 2) {
    const auto& row = rows[k];
    const std::string command = row.at("command");
    SCOPED_TRACE(command);
    const auto drawn = runProgram(commandWords(command, file("picture.png")));
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    auto errors = Json::parse(drawn.out).at("errors");
    EXPECT_EQ(errors.at("reference_divisions"), trade.at("reference").at("divisions"));
    errors.erase("reference_divisions");
    const Json ofCommand = errors.flatten(), ofTrade = Json(row.at("errors")).flatten();
    ASSERT_EQ(ofCommand.size(), ofTrade.size());
    for (const auto& [key, value] : ofTrade.items()) {
      if (value.is_number_float())
        EXPECT_NEAR(ofCommand.at(key).get<double>(), value.get<double>(),
                    1e-9 * std::abs(value.get<double>()))
            << key;
      else
        EXPECT_EQ(ofCommand.at(key), value) << key;
    }
  }
}

// The picture that is named for two mistakes tells them apart: the program itself, which shares no code with
// the evaluator that chose the pixel, draws there what is promised.
TEST_F(CommandTest, DiagnoseNamesAScene) {
  for (const auto& [a, b] :
       {std::pair{"RV-abs", "RV-unclamped"}, {"NL-abs", "NL-unclamped"}, {"ks-in-the-power", "right"}}) {
    SCOPED_TRACE(a);
    const auto end = runProgram({"diagnose", "--scene-for", std::string{a} + "," + b, "--json"});
    EXPECT_EQ(end.status, 0) << end.err;
    const auto json = Json::parse(end.out);
    EXPECT_EQ(json.at("told_apart"), true);
    EXPECT_GT(json.at("shades_apart"), 2);
    const auto shown = [&](const std::string& mistake) {
      Strings words{"draw", json.at("scene"), "--size", "640x480", "-o", file("a.png")};
      words = words + Strings{"--shade", json.at("shade"), "--table", json.at("table")};
      if (mistake != "right") words = words + Strings{"--mistake", mistake};
      EXPECT_EQ(runProgram(words).status, 0);
      return int{readPng(file("a.png")).pixel(json.at("pixel").at(0), json.at("pixel").at(1))[0]};
    };
    EXPECT_NEAR(shown(a), json.at("first_shows").at("value"), 1.5);
    EXPECT_NEAR(shown(b), json.at("second_shows").at("value"), 1.5);
    EXPECT_NEAR(shown("right"), json.at("right_shows").at("value"), 1.5);
  }
}

// A sort by one z of each face is right on no scene of the exercises but the one that asks for it.
TEST_F(CommandTest, JudgeTellsSortsByZApart) {
  for (const std::string scene : {"leaning-card", "leaning-cards", "bench", "teapot"}) {
    Scene read = readScene(scene);
    PictureSettings s = read.settings;
    s.width = kPictureSize.x, s.height = kPictureSize.y, s.order = Order::Unsorted;
    s.camera = completed({}, read.camera);
    const Picture picture = makePicture(std::move(read), s, std::uint8_t{0});
    const SnappedScene& snapped = picture.snapped();
    for (std::size_t sort = 0; sort < kSorts.size(); ++sort) {
      std::vector<std::pair<double, int>> order;
      for (const SnappedFace& face : snapped.faces) {
        double far = 1e9, near = -1e9, sum = 0;
        for (int k = face.first; k < face.first + face.count; ++k) {
          const double z = snapped.vertices[static_cast<std::size_t>(k)].z;
          far = std::min(far, z), near = std::max(near, z), sum += z;
        }
        order.emplace_back(std::array{far, near, sum / face.count}[sort], face.number);
      }
      std::ranges::sort(order);
      std::ofstream out{file("order.jsonl")};
      for (const auto& [z, f] : order) out << "{\"face\": " << f << "}\n";
      out.close();
      const Finished judged = runProgram({"judge", scene, file("order.jsonl")});
      EXPECT_EQ(judged.status, scene == "leaning-card" && sort == 0 ? 0 : 1)
          << scene << ", " << kSorts[sort] << ": " << judged.out;
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

// `--worksheet` writes one HTML file without any X server: a picture for each step, each question with all
// its answers and room to write, and the right letter of each only after the last step.
TEST_F(CommandTest, AWorksheetAsksAndSolves) {
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    const std::string sheet = file("sheet.html");
    const Finished end = runProgram({"lesson", entry.name, "--worksheet", sheet});
    ASSERT_EQ(end.status, 0) << end.err;
    const std::string html = contents(sheet);
    const auto count = [&](const std::string& what) {
      std::size_t n = 0;
      for (std::size_t at = html.find(what); at != std::string::npos; at = html.find(what, at + 1)) ++n;
      return n;
    };
    const Lesson lesson = readLesson(entry.file);
    const std::size_t questions =
        std::ranges::count_if(lesson.steps, [](const auto& s) { return s.question.has_value(); });
    EXPECT_EQ(count("src=\"data:image/png;base64,iVBORw0KGgo"), lesson.steps.size());
    EXPECT_EQ(count("class=\"room\""), questions);
    EXPECT_EQ(count("<code>xnewell lesson " + entry.name + " --step "),
              std::ranges::count_if(lesson.steps, [](const auto& s) { return !s.controls.empty(); }));
    const std::size_t solutions = html.find("<h2>Solutions</h2>");
    for (const LessonStep& step : lesson.steps) {
      if (!step.question) continue;
      const auto right = std::ranges::find(step.question->answers, true, &LessonAnswer::holds);
      const std::string letter{static_cast<char>('a' + (right - step.question->answers.begin()))};
      EXPECT_NE(html.find("<li>" + letter + ": ", solutions), std::string::npos);
    }
    for (const LessonStep& step : lesson.steps)  // an explanation stands among the solutions only
      for (const auto& answer : step.question ? step.question->answers : std::vector<LessonAnswer>{})
        if (const std::string words = longestPlain(answer.says); words.size() > 20) {
          EXPECT_GE(html.find(words), solutions) << words;
        }
    for (const std::string name : {"section", "ol", "p", "html", "li", "h2"})
      EXPECT_EQ(count('<' + name + '>') + count('<' + name + ' '), count("</" + name + '>')) << name;
    EXPECT_EQ(html.find('{'), html.find("{ font"));  // no placeholder is left, only the style
    EXPECT_EQ(html.find('{', html.find("</style>")), std::string::npos);
  }
}

// Every line is JSON. Steps are counted without a gap. All tests of a step failed but the last, which settled
// the pair. The numbers of each test give the same decision. The summary counts what was told.
TEST_F(TraceCommand, LinesTellTheRun) {
  std::map<std::string, int> settled;
  for (const Strings& words : {Strings{"cycle"}, Strings{"penetrate"}, Strings{"nested-cycles"},
                               Strings{"decals"}, Strings{"crossing-sheets"}, Strings{"room", "--quick"},
                               Strings{"nested-cycles", "--quick"}, Strings{"cycle", "--size", "64x64"}}) {
    SCOPED_TRACE(words[0]);
    const bool quick = std::ranges::find(words, "--quick") != words.end();
    const std::vector<Json> lines = linesOf(words);
    ASSERT_GT(lines.size(), 2u);
    EXPECT_EQ(lines.front()["event"], "run");
    EXPECT_EQ(lines.front()["scene"], words[0]);
    EXPECT_EQ(lines.front()["run"], quick ? "quick" : "textbook");
    const Json& summary = lines.back();
    EXPECT_EQ(summary["event"], "summary");

    std::map<std::string, int> events;
    int step = 0, pairs = 0;
    bool open = false;  // a test failed, so the next line goes on with the same pair
    for (const Json& line : std::span{lines}.subspan(1, lines.size() - 2)) {
      const std::string event = line["event"];
      ASSERT_EQ(line["step"], open ? step : step + 1) << line;
      step = line["step"];
      if (open) {
        ASSERT_EQ(event, "test") << line;
      }
      ASSERT_FALSE(line["P"].empty());
      ASSERT_TRUE(line["says"].get<std::string>().ends_with('.'));
      ++events[event];
      open = event == "test" && line["outcome"] == "no";
      if (event != "test") continue;
      EXPECT_EQ(line["outcome"], decided(line)) << line;
      EXPECT_EQ(line.contains("verdict"), !open) << line;
      if (open) continue;
      ++pairs;
      ++settled[line["test"]];
      const std::string test = line["test"], verdict = line["verdict"];
      if (test.size() == 1 && test != "6") {
        EXPECT_EQ(verdict, "P first");
      }
      if (test.size() == 2) {
        EXPECT_EQ(verdict, "Q first");
      }
      if (test == "plane") {
        EXPECT_EQ(verdict == "P first", line["numbers"]["P_place"] < line["numbers"]["Q_place"]);
      }
    }
    EXPECT_FALSE(open);
    EXPECT_EQ(lines.front()["steps"], step);
    EXPECT_EQ(summary["pairs"], pairs);
    EXPECT_EQ(summary["fragments"], events["paint"]);
    EXPECT_EQ(summary["moves"], events["move"]);
    EXPECT_EQ(summary["cycles"], events["cycle"]);
    EXPECT_EQ(summary["cuts"], events["cut"]);
    if (words[0] == "cycle") {
      EXPECT_GE(events["cycle"], 1);
      EXPECT_GE(events["cut"], 1);
    }
    if (words[0] == "penetrate") {
      EXPECT_GE(events["cut"], 1);
    }
  }
  for (const TestRow& row : kTestRows) EXPECT_GT(settled[std::string{row.name}], 0) << row.name;
}

// --frames writes a picture for each step of the chosen kind and one for the end. The last one shows what
// `draw` draws.
TEST_F(TraceCommand, FramesOfEachKind) {
  const std::map<std::string, int> all = [] {
    std::map<std::string, int> events;
    std::set<int> told;
    for (const Json& line : linesOf({"nested-cycles"}))
      if (line.contains("step") && told.insert(line["step"].get<int>()).second) ++events[line["event"]];
    return events;
  }();
  for (const auto& row : kEvery) {
    const std::string word{row.name}, folder = file("deep/" + word);
    const Finished end =
        runProgram({"trace", "nested-cycles", "--frames", folder, "--every", word, "--size", "160x120"});
    ASSERT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.out + end.err, "");
    std::map<std::string, int> expected = all;
    if (row.id != Every::Step) expected = {{word, all.at(word)}};
    expected["done"] = 1;
    EXPECT_EQ(framesIn(folder), expected) << word;
  }
  for (const std::string scene : {"cycle", "penetrate", "nested-cycles", "room"}) {
    const Strings options = scene == "room" ? Strings{"--every", "cycle"} : Strings{};
    for (const std::string size : {"64x64", "800x600"}) {
      const std::string folder = file(scene + size);
      ASSERT_EQ(runProgram(Strings{"trace", scene, "--frames", folder, "--size", size} + options).status, 0);
      const Drawn drawn = draw(scene, {"--size", size});
      std::set<std::string> names;
      for (const auto& entry : std::filesystem::directory_iterator{folder})
        names.insert(entry.path().string());
      ASSERT_TRUE(names.rbegin()->ends_with("-done.png"));
      EXPECT_GT(names.size(), 1u);
      const RgbImage last = readPng(*names.rbegin());
      ASSERT_GE(last.width, drawn.picture.width);
      for (int j = 0; j < drawn.picture.height; ++j)
        ASSERT_TRUE(std::equal(drawn.picture.pixel(0, j), drawn.picture.pixel(0, j) + 3 * drawn.picture.width,
                               last.pixel(0, j)))
            << scene << size << ", row " << j;
    }
  }
}

}  // namespace xnewell::THIS_FILE
