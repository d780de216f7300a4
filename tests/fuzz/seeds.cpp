#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>

#include "shading/color/png.h"
#include "tests/x11/support/corpus_models.h"
#include "tests/x11/support/story_text.h"

namespace xnewell {

namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// Seeds by the name of their fuzzer.
class Seeds {
 public:
  explicit Seeds(fs::path folder) : folder_{std::move(folder)} {}
  void add(const std::string& fuzzer, const std::string& bytes) {
    fs::create_directories(folder_ / fuzzer);
    std::ofstream{folder_ / fuzzer / std::to_string(++count_[fuzzer]), std::ios::binary} << bytes;
  }
  /// By the extension of a file, and `json` for .json files.
  void addFile(const fs::path& file, const std::string& bytes, const std::string& json) {
    const std::string extension = file.extension().string();
    if (extension == ".json") add(json, bytes);
    if (extension == ".png") add("setup", '\0' + bytes);
    for (const std::string kind : {"obj", "mtl", "ply", "off", "bpt"})
      if (extension == "." + kind) add(kind, bytes);
  }

 private:
  fs::path folder_;
  std::map<std::string, int> count_;
};

/// The texts that a story gives to a reader: its lines `: TEXT -> COMPLAINT` below a line `READER TEXT`.
void addTexts(Seeds& seeds, const fs::path& story) {
  std::ifstream in{story};
  std::map<std::string, std::string> names;
  std::string reader, around;
  for (std::string line; std::getline(in, line);) {
    line = withNames(line, names);
    const std::size_t blank = std::min(line.find(' '), line.size()), equals = line.find(" = ");
    const std::string verb = line.substr(0, blank);
    if (verb == "let" && equals != line.npos)
      names['<' + line.substr(4, equals - 4) + '>'] = line.substr(equals + 3);
    for (const std::string kind : {"obj", "mtl", "ply", "off", "bpt", "scene", "lesson"})
      if (verb == kind) reader = kind, around = line.substr(blank + 1);
    if (verb != ":" || reader.empty() || line.rfind(" -> ") == line.npos) continue;
    std::string text = around;
    if (const std::size_t at = text.find('@'); at != text.npos)
      text.replace(at, 1, line.substr(2, std::max<std::size_t>(line.rfind(" -> "), 2) - 2));
    seeds.add(reader, unescaped(text));
  }
}

}  // namespace

/// seeds FOLDER: writes what the fuzzers begin with. These are the project's own files of each format, the
/// models of corpus_models.cpp, the texts that tests/stories give to readers, and random bytes for polygons.
void writeSeeds(const fs::path& folder) {
  Seeds seeds{folder};
  for (const CorpusModel& model : corpusModels()) seeds.addFile(model.name, model.content, "scene");
  for (const auto& entry : fs::directory_iterator{XNEWELL_STORIES}) addTexts(seeds, entry.path());
  for (const fs::path source : {XNEWELL_DATA_DIR, XNEWELL_TESTS_DATA_DIR, XNEWELL_EXAMPLE_DIR})
    for (const auto& entry : fs::recursive_directory_iterator{source}) {
      const fs::path& file = entry.path();
      if (entry.is_directory() || file.parent_path().filename() == "lectures") continue;
      if (file.extension() != ".png") {
        seeds.addFile(file, bytesOf(file), file.parent_path().filename() == "lessons" ? "lesson" : "scene");
      } else if (const auto note = noteInPng(file.string())) {
        seeds.add("setup", '\1' + *note);
      }
    }
  for (const std::string note : {"xnewell draw cubes -o picture.png", "xnewell lesson cycles --step 2"})
    seeds.add("setup", '\1' + note);
  // Long enough for points and faces: from nothing, a fuzzer takes minutes to come to faces that overlap.
  std::mt19937 rng{1972};
  for (int i = 0; i < 100; ++i) {
    std::string polygons(150, '\0');
    for (char& byte : polygons) byte = static_cast<char>(rng());
    seeds.add("polygons", polygons);
  }
}

}  // namespace xnewell

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: seeds FOLDER\n", 2;
  xnewell::writeSeeds(argv[1]);
}
