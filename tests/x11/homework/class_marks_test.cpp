#include "x11/homework/class_marks.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/temporary_folder.h"
#include "x11/homework/hand_ins.h"
#include "x11/homework/marks_formats.h"

namespace xnewell::THIS_FILE {

namespace {

struct Class {
  Scene scene = readScene("bench-n3");
  PictureSettings settings;
  TemporaryFolder folder;

  Class() {
    settings = scene.settings;
    settings.camera = scene.camera, settings.width = 160, settings.height = 120;
  }
  void draw(const std::string& name, Mistake mistake) {
    PictureSettings s = settings;
    s.light.mistake = mistake;
    const CellPlan plan;
    const Picture picture = makePicture(scene, s, plan[Cell::Well]);
    writePng(folder.file(name), picture.image(), picture.palette(plan));
  }
  [[nodiscard]] std::vector<MarkedFile> marked(Marker& marker) const {
    std::vector<MarkedFile> rows;
    for (const HandIn& one : handInsOf(folder.path().string()).files)
      rows.push_back(marker.mark(folder.path().string(), one.path));
    return rows;
  }
};
std::string csvOf(const std::vector<MarkedFile>& rows) {
  return rowOf(MarksFormat::Csv).text({"", {}, rows});
}

}  // namespace

// Each file has a row, broken ones too; the summary counts verdicts and mistakes.
TEST(ClassMarks, HaveARowForEachFile) {
  Class one;
  one.draw("anna.png", Mistake::None);
  one.draw("bert.png", Mistake::NoAmbient);
  one.draw("carl.png", Mistake::NoAmbient);
  one.folder.write("dora.png", "\x89PNG, but not really");
  one.folder.write("=emil,\"x\".ppm", "P6 99999 99999 255\n");
  writePng(one.folder.file("gina.png"), IndexImage{5000, 4000, 7}, Palette{});
  one.folder.write("fred.jsonl", "{\"face\": 0}\n");
  one.folder.write(".hidden", "");
  one.folder.write("readme.txt", "nobody handed this in");
  std::filesystem::create_directory(one.folder.file("hans.png"));
  std::filesystem::create_symlink("nowhere", one.folder.file("ida.png"));
  ASSERT_EQ(mkfifo(one.folder.file("jana.jsonl").c_str(), 0600), 0);
  Marker marker{one.scene, one.settings, {}, true};
  const std::vector<MarkedFile> rows = one.marked(marker);
  ASSERT_EQ(rows.size(), 10u);
  EXPECT_EQ(rows[0].verdict, "unreadable");
  EXPECT_EQ(rows[1].verdict, "right");
  EXPECT_EQ(rows[2].mistakes, "Ia-forgotten");
  // A right picture's difference is black, one without its ambient term is darker everywhere.
  for (const int k : {1, 2}) {
    ASSERT_EQ(rows[k].pictures.size(), 3u);
    one.folder.write("shown", rows[k].pictures[2].png);
    const RgbImage apart = readPng(one.folder.file("shown"));
    EXPECT_EQ(std::ranges::count(apart.rgb, 0) == std::ssize(apart.rgb), k == 1);
  }
  EXPECT_EQ(rows[3].terms, "ka Ia");
  EXPECT_EQ(rows[4].words.substr(0, 10), "unreadable");
  EXPECT_EQ(rows[5].mistakes, "missing");
  EXPECT_EQ(rows[6].words, "unreadable: diagnose takes pictures of up to 4096 x 4096 pixels");
  EXPECT_EQ(rows[7].words, "unreadable: hans.png: Is a directory");
  EXPECT_EQ(rows[8].words, "unreadable: ida.png: No such file or directory");
  EXPECT_EQ(rows[9].words, "unreadable: jana.jsonl: not a regular file");

  const std::string csv = csvOf(rows);
  EXPECT_TRUE(csv.starts_with("file,verdict,mistakes,term,explained,informative,pixel,face,answers,words\n"));
  EXPECT_NE(csv.find("\n\"'=emil,\"\"x\"\".ppm\",unreadable,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nbert.png,mistake,Ia-forgotten,ka Ia,"), std::string::npos) << csv;
  EXPECT_EQ(std::ranges::count(csv, '\n'), 11);
  const std::string summary = summaryOf({"", {}, rows});
  EXPECT_TRUE(summary.starts_with("10 files: 6 unreadable, 2 mistake, 1 right, 1 wrong\n")) << summary;
  EXPECT_NE(summary.find("mistakes: 2 Ia-forgotten, 1 missing\n"), std::string::npos) << summary;
}

// A class of mistakes is named, and so is the line of a file that cannot be read.
TEST(ClassMarks, NameWhatTheyTell) {
  Class one;
  one.draw("anna.png", Mistake::ReversedV);
  one.folder.write("bert.jsonl", "{\"face\": 0}\nface 1\n");
  one.folder.write("carl.jsonl", "{\"face\": 0, \"piece\": [[nan, 1], [2, 3], [4, 5]]}\n");
  Marker marker{one.scene, one.settings, {}, false};
  one.folder.write("dora.jsonl", "{\"face\": 0}\n");
  const std::string folder = one.folder.path().string();
  EXPECT_EQ(marker.mark(folder, "anna.png").words,
            "wrong: one of 2 answers that look alike here: V-sign, R-sign");
  EXPECT_TRUE(
      marker.mark(folder, "bert.jsonl").words.starts_with("unreadable: bert.jsonl:2: not a JSON object"));
  const std::string dora = marker.mark(folder, "dora.jsonl").words;
  EXPECT_NE(dora.find(" missing that should show ("), std::string::npos) << dora;
  EXPECT_NE(dora.find(", and 55 that nobody would see ("), std::string::npos) << dora;
  EXPECT_EQ(marker.mark(folder, "carl.jsonl").words,
            "unreadable: carl.jsonl:1: JSON has no nan: places are numbers");
}

// Kept answers are counted by the program's own lessons, whatever the file calls right; of a lesson that the
// program does not have, the file is believed. Hostile files have a row with one line.
TEST(ClassMarks, CountKeptAnswers) {
  Class one;
  const auto answers = [](const std::string& list) { return "{\"answers\": [" + list + "]}"; };
  const std::string cycles = R"({"lesson": "cycles", "step": 3, "tries": ["b", "d"], "right": "b"})",
                    other = R"({"lesson": "mine", "step": 1, "tries": ["c"], "right": "c"})";
  one.folder.write("a.json", answers(cycles + "," + other));
  one.folder.write("b.json", answers(cycles + "," + cycles));
  one.folder.write("c.json", answers(R"({"lesson": "cycles", "step": 1, "tries": ["a"], "right": "a"})"));
  one.folder.write("d.json", std::string(100'000, '['));
  one.folder.write("e.json", std::string((1 << 20) + 1, ' '));
  one.folder.write("f.json",
                   answers(R"({"lesson": "=x\u0000\n", "step": 1e99, "tries": ["a"], "right": "a"})"));
  one.folder.write("g.json", answers(""));
  const RightAnswer right = [](const std::string& lesson, int step) -> std::optional<int> {
    if (lesson != "cycles") return std::nullopt;
    return step == 3 ? 3 : -1;
  };
  Marker marker{one.scene, one.settings, {}, false, right};
  const std::vector<MarkedFile> rows = one.marked(marker);
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[0].words, "1 of 2 right at the first try, in 2 lessons");
  EXPECT_EQ(rows[1].words, "unreadable: b.json: step 3 of 'cycles' is answered twice");
  EXPECT_EQ(rows[2].words, "unreadable: c.json: step 1 of 'cycles' asks nothing");
  EXPECT_EQ(rows[4].words, "unreadable: e.json: longer than 1 MB");
  for (const int k : {3, 5}) EXPECT_TRUE(rows[k].words.starts_with("unreadable:")) << rows[k].words;
  EXPECT_EQ(rows[6].words, "0 of 0 right at the first try, in no lessons");
  const std::string csv = csvOf(rows);
  EXPECT_NE(csv.find("\na.json,answers,,,,,,,1 of 2,\"1 of 2 right"), std::string::npos) << csv;
  EXPECT_EQ(std::ranges::count(csv, '\n'), 8);
  EXPECT_TRUE(summaryOf({"", {}, rows}).ends_with("answers: 1 of 2 right at the first try\n"))
      << summaryOf({"", {}, rows});
}

// Two files have two names, in any language and encoding.
TEST(ClassMarks, KeepNamesApart) {
  const std::vector<MarkedFile> rows{{.file = "\u00c9mile.ppm"}, {.file = "\u00d6mile.ppm"},
                                     {.file = "\xc9mile.ppm"},   {.file = "\xd6mile.ppm"},
                                     {.file = "\x1bmile.ppm"},   {.file = "\nmile.ppm"}};
  const std::string csv = csvOf(rows), page = rowOf(MarksFormat::Html).text({"", {}, rows});
  for (const char* begin : {"\u00c9", "\u00d6", "\\xc9", "\\xd6", "\\x1b", "\\n"}) {
    EXPECT_NE(csv.find('\n' + std::string{begin} + "mile.ppm,"), std::string::npos) << begin;
    EXPECT_NE(page.find("<td>" + std::string{begin} + "mile.ppm</td>"), std::string::npos) << begin;
  }
}

}  // namespace xnewell::THIS_FILE
