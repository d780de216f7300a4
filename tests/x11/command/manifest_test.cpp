#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "tests/support/sha256.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"
#include "tests/x11/support/program_picture.h"
#include "x11/app/workbench.h"

namespace xnewell::THIS_FILE {

namespace {

namespace fs = std::filesystem;

/// tests/data/manifest.txt: remarks, commands for a scene named SCENE, and a row for each scene with the sum
/// of what each command leaves.
struct Manifest {
  std::string head;                   ///< the lines of remarks and commands, as they are
  std::vector<std::string> commands;  ///< without `xnewell`
  std::map<std::string, std::vector<std::string>> rows;
};

const std::string kManifest = XNEWELL_TESTS_DATA_DIR "/manifest.txt";
const std::string kTexts = XNEWELL_TESTS_DATA_DIR "/texts.txt";
constexpr std::string_view kProgram = "xnewell ";
/// Options whose value is a file or a folder that the command makes.
constexpr std::array<std::string_view, 4> kBeforeFiles{"-o", "--ids", "--frames", "--worksheet"};

Manifest readManifest() {
  Manifest manifest;
  std::istringstream lines{readTextFile(kManifest)};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kProgram)) manifest.commands.push_back(line.substr(kProgram.size()));
    if (line.starts_with(kProgram) || line.starts_with("#") || line.empty())
      manifest.head += line + "\n";
    else if (const std::vector<std::string> row = words(line); !row.empty())
      manifest.rows[row[0]] = {row.begin() + 1, row.end()};
  }
  return manifest;
}

std::string with(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
    text.replace(at, word.size(), by);
  return text;
}

/// A file's bytes. A PNG's compressed bytes differ by version of zlib, so its note, indices and colours stand
/// in their place, or its pixels if it has no colours; a PNG in a page is left out.
std::string contentOf(const std::string& file) {
  if (file.ends_with(".html")) {
    std::string page = readTextFile(file);
    for (std::size_t at = 0; (at = page.find(";base64,", at)) != std::string::npos; ++at)
      page.erase(at, page.find('"', at) - at);
    return page;
  }
  if (!file.ends_with(".png")) return readTextFile(file);
  std::string content = noteInPng(file).value_or("");
  if (const std::optional<IndexedPng> indexed = readIndexedPng(file)) {
    for (const auto& held : indexed->held) content.append(held.begin(), held.end());
    return content.append(indexed->image.pixels.begin(), indexed->image.pixels.end());
  }
  const RgbImage image = readPng(file);
  return content.append(image.rgb.begin(), image.rgb.end());
}

/// Without times, and the bytes that a list takes, which depend on the size of a pointer.
std::string withoutMachine(const std::string& text) {
  static const std::regex kOfTheMachine{
      R"re("ms":\{[^}]*\}|"order_bytes":[0-9]+|: [0-9.]+ ms|time, ms[^\n]*)re"};
  return std::regex_replace(text, kOfTheMachine, "");
}

/// Brings everything up to date.
void finish(Workbench& bench) {
  for (int k = 0; k < 3 && bench.stale() != Workbench::Stale::Nothing; ++k) bench.update();
}

/// "window SCENE WxH KEYS": the window, without a server, after these keys; > is the right arrow. Writes it
/// as 1.png, without its status, which may have times, and returns its words. "words": without a picture.
std::string windowAfter(const std::vector<std::string>& command, const TemporaryFolder& folder) {
  const std::string& size = command.at(2);
  Workbench bench{readScene(command.at(1), 3), {}, {}};
  bench.resize(std::stoi(size), std::stoi(size.substr(size.find('x') + 1)));
  finish(bench);
  for (const char letter : command.at(3)) {
    bench.press(letter == '>' ? Key{NamedKey::Right} : Key{letter});
    finish(bench);
  }
  std::string said;
  for (const std::string& line : bench.bench().report()) said += line + '\n';
  said = withoutMachine(said);
  if (command[0] == "words") return said;
  IndexImage image = bench.image();
  std::fill(image.row(bench.layout().status.y * bench.layout().unit), &image.pixels.back() + 1,
            bench.ground());
  writeFile(folder.file("1.png"), encodePng(image, bench.palette()));
  return said;
}

/// What the command says: its status, unless it is 0, and its output, without places. Its files are in the
/// folder. XNEWELL_EMULATOR holds the words of a command that runs programs of another processor. Commands
/// between semicolons share the folder.
std::string textOf(const std::string& commands, const TemporaryFolder& folder) {
  if (const std::vector<std::string> line = words(commands); line[0] == "window" || line[0] == "words")
    return windowAfter(line, folder);
  const std::size_t semicolon = std::min(commands.find(" ; "), commands.size());
  const char* emulator = std::getenv("XNEWELL_EMULATOR");
  std::vector<std::string> line = words(emulator ? emulator : "");
  line.push_back(builtProgram());
  for (const std::string& word : words(commands.substr(0, semicolon)))
    line.push_back(std::ranges::find(kBeforeFiles, line.back()) != kBeforeFiles.end() ||
                           fs::exists(folder.file(word))
                       ? folder.file(word)
                       : with(word, "DATA", XNEWELL_TESTS_DATA_DIR));
  RunningProgram program{line.front(), {line.begin() + 1, line.end()}, ""};
  const Finished done = program.wait(std::chrono::seconds{600});
  EXPECT_LE(done.status, 1) << "xnewell " << commands << ": " << done.err;  // 1: what is handed in is wrong
  std::string all = withoutMachine(done.out + done.err);
  all = with(with(all, folder.path().string(), ""), XNEWELL_TESTS_DATA_DIR, "DATA");
  if (done.status != 0) all += "status " + std::to_string(done.status) + '\n';
  return semicolon < commands.size() ? all + textOf(commands.substr(semicolon + 3), folder) : all;
}

/// All files of the folder, with their names.
std::string filesIn(const TemporaryFolder& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder.path()})
    if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), folder.path()));
  std::string all;
  for (const std::string& name : names) all += name + contentOf(folder.file(name));
  return all;
}

/// The first 16 digits of the SHA-256.
std::string sumOf(const std::string& content) { return sha256(content).substr(0, 16); }
/// That of all that the command leaves.
std::string sumOfAll(const std::string& command) {
  const TemporaryFolder folder;
  const std::string text = textOf(command, folder);
  return sumOf(text + filesIn(folder));
}

/// Each of the words between bars, in the place of "(one|another)".
std::vector<std::string> expanded(const std::string& pattern) {
  const std::size_t from = pattern.find('('), to = pattern.find(')');
  if (from == std::string::npos) return {pattern};
  std::vector<std::string> all;
  std::istringstream choices{pattern.substr(from + 1, to - from - 1) + '|'};
  for (std::string choice; std::getline(choices, choice, '|');)
    for (std::string& one : expanded(pattern.substr(0, from) + choice + pattern.substr(to + 1)))
      all.push_back(std::move(one));
  return all;
}

/// The built-in scene, and all scenes of data/scenes.
std::vector<std::string> allScenes() {
  std::vector<std::string> scenes{"teapot"};
  for (const fs::directory_entry& entry : fs::directory_iterator{XNEWELL_DATA_DIR "/scenes"})
    scenes.push_back(entry.path().stem());
  std::ranges::sort(scenes);
  return scenes;
}

}  // namespace

// Each command leaves the bytes that the manifest says, of every scene and on every machine. With
// XNEWELL_NEW_MANIFEST=1 it writes the sums into the manifest instead.
TEST(Manifest, HasTheBytesOfEveryScene) {
  const Manifest kept = readManifest();
  ASSERT_FALSE(kept.commands.empty()) << kManifest;
  std::map<std::string, std::vector<std::string>> made;
  for (const std::string& scene : allScenes())
    for (const std::string& command : kept.commands)
      made[scene].push_back(sumOfAll(with(command, "SCENE", scene)));
  if (std::getenv("XNEWELL_NEW_MANIFEST")) {
    std::ofstream file{kManifest};
    file << kept.head;
    for (const auto& [scene, sums] : made) {
      file << scene;
      for (const std::string& sum : sums) file << ' ' << sum;
      file << '\n';
    }
    return;
  }
  std::string others;
  for (const auto& [scene, sums] : made) {
    const auto row = kept.rows.find(scene);
    for (std::size_t k = 0; k < sums.size(); ++k)
      if (row == kept.rows.end() || k >= row->second.size() || row->second[k] != sums[k])
        others += "xnewell " + with(kept.commands[k], "SCENE", scene) + "\n";
  }
  EXPECT_EQ(others, "") << "These commands leave other bytes than tests/data/manifest.txt says.";
  EXPECT_EQ(made.size(), kept.rows.size()) << "A row of tests/data/manifest.txt is of no scene.";
}

// Each text and each page of the window is as tests/data/texts.txt says: its lines of commands, then a line
// for each command with the sum of its text, that of its files, and itself. With XNEWELL_LEFT_IN=FOLDER it
// also writes what each leaves there, for `diff -r`.
TEST(Manifest, HasTheTextsAndPages) {
  const char* const leftIn = std::getenv("XNEWELL_LEFT_IN");
  std::vector<std::string> kept;
  std::string head, made, others;
  std::istringstream lines{readTextFile(kTexts)};
  for (std::string line; std::getline(lines, line);) {
    kept.push_back(line);
    if (line.empty() || line.starts_with('#') || line.starts_with(' ')) head += line + '\n';
    if (!line.starts_with(' ')) continue;
    for (const std::string& command : expanded(line.substr(2))) {
      const TemporaryFolder folder;
      const std::string text = textOf(command, folder);
      made += sumOf(text) + ' ' + sumOf(filesIn(folder)) + ' ' + command + '\n';
      if (!leftIn) continue;
      fs::create_directories(fs::path{leftIn});
      const fs::path left = fs::path{leftIn} / with(command, "/", ":");
      fs::copy(folder.path(), left, fs::copy_options::recursive);
      std::ofstream{left / "text"} << text;
    }
  }
  if (std::getenv("XNEWELL_NEW_MANIFEST")) {
    std::ofstream{kTexts} << head << made;
    return;
  }
  std::istringstream all{made};
  for (std::string line; std::getline(all, line);)
    if (std::ranges::find(kept, line) == kept.end()) others += line + '\n';
  EXPECT_EQ(others, "") << "tests/data/texts.txt has other sums for these.";
  EXPECT_EQ(head.size() + made.size(), readTextFile(kTexts).size()) << "It has a line of no command.";
}

// The sums are those of `sha256sum`.
TEST(Sha256, OfThreeTexts) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace xnewell::THIS_FILE
