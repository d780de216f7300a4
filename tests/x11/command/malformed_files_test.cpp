#include "tests/x11/support/malformed_files.h"

#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// Each malformed file is refused in one line with the file and what is wrong, with the place where there is
// one, and the status of the table. Nothing is written. Sizes that a file only promises take neither time nor
// memory.
TEST_F(CommandTest, MalformedFilesAreRefused) {
  for (const Malformed& row : malformedFiles()) {
    const std::string wrong = write(row.name, row.content);
    SCOPED_TRACE(row.content.substr(0, 300));
    const bool library = row.name.ends_with(".mtl"), lesson = row.name == "l.json";
    const std::string scene =
        library ? write("of_mtl.obj", "mtllib " + row.name + "\nusemtl m\n" + kTriangleObj) : wrong;
    refused(lesson ? Strings{"lesson", wrong, "--frames", file("frames")}
                   : Strings{"draw", scene, "-o", file("new.png")},
            row.status, wrong + row.message);
  }
}

// Lists in lists without end are refused wherever JSON is read, with the line. A class with such files is
// marked all the same.
TEST_F(CommandTest, DeepNestingIsRefused) {
  constexpr int kDeep = 60'000;
  const std::string open(kDeep, '['), lists = "{\"objects\":\n" + open;
  std::filesystem::create_directory(file("class"));
  ASSERT_EQ(runProgram({"draw", "bench", "--size", "160x120", "-o", file("class/a.png")}).status, 0);
  int k = 0;
  for (const std::string& text : {lists, lists + std::string(kDeep, ']') + "}"}) {
    const std::string deep = write("deep.json", text),
                      said = deep + ":2: lists and objects are nested more than 100 deep";
    refused({"draw", deep, "-o", file("new.png")}, 2, said);
    refused({"lesson", deep, "--frames", file("frames")}, 2, said);
    refused({"lecture", deep}, 2, said);
    std::ofstream{file("class/" + std::to_string(++k) + ".json")} << text;
    std::string line = text;
    line.erase(line.find('\n'), 1);
    std::ofstream{file("class/" + std::to_string(k) + ".jsonl")} << line;
    const std::string order = write("order.jsonl", "\n" + line);
    refused({"judge", "bench", order}, 2, order + ":2: lists and objects are nested more than 100 deep");
  }
  const auto marks = runProgram({"grade", "bench", file("class"), "-o", file("marks.csv")});
  EXPECT_EQ(marks.status, 0) << marks.err;
  EXPECT_TRUE(marks.out.starts_with("5 files: 4 unreadable, 1 right\n")) << marks.out;
}

}  // namespace xnewell::THIS_FILE
