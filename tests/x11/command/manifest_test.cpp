#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "tests/support/sha256.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"
#include "tests/x11/support/program_picture.h"

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
constexpr std::string_view kProgram = "xnewell ";

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
/// in their place, or its pixels if it has no colours.
std::string contentOf(const std::string& file) {
  if (!file.ends_with(".png")) return readTextFile(file);
  std::string content = noteInPng(file).value_or("");
  if (const std::optional<IndexedPng> indexed = readIndexedPng(file)) {
    for (const auto& held : indexed->held) content.append(held.begin(), held.end());
    return content.append(indexed->image.pixels.begin(), indexed->image.pixels.end());
  }
  const RgbImage image = readPng(file);
  return content.append(image.rgb.begin(), image.rgb.end());
}

/// The first 16 digits of the SHA-256 of all that the command leaves: its status, what it says, and its
/// files. It leaves out times, places, and the bytes that a list takes, which depend on the size of a
/// pointer. XNEWELL_EMULATOR holds the words of a command that runs programs of another processor.
std::string sumOf(const std::string& command) {
  const TemporaryFolder folder;
  const char* emulator = std::getenv("XNEWELL_EMULATOR");
  std::vector<std::string> line = words(emulator ? emulator : "");
  line.push_back(builtProgram());
  for (const std::string& word : words(command))
    line.push_back(line.back() == "-o" || line.back() == "--ids" ? folder.file(word) : word);
  RunningProgram program{line.front(), {line.begin() + 1, line.end()}, ""};
  const Finished done = program.wait(std::chrono::seconds{600});
  EXPECT_EQ(done.status, 0) << "xnewell " << command << ": " << done.err;
  static const std::regex kOfTheMachine{R"re("ms":\{[^}]*\}|"order_bytes":[0-9]+|: [0-9.]+ ms)re"};
  std::string all = std::regex_replace(done.out + done.err, kOfTheMachine, "");
  all = with(all, folder.path().string(), "");
  for (const char* name : {"1.png", "2.png", "1.svg", "1.pdf", "1.eps"})
    if (fs::exists(folder.file(name))) all += name + contentOf(folder.file(name));
  return sha256(all).substr(0, 16);
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
      made[scene].push_back(sumOf(with(command, "SCENE", scene)));
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

// The sums are those of `sha256sum`.
TEST(Sha256, OfThreeTexts) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace xnewell::THIS_FILE
