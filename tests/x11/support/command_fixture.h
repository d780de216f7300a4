#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "shading/color/png.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"

namespace xnewell {

/// Shared by the tests of the program as a user meets it.

using Strings = std::vector<std::string>;
using Json = nlohmann::json;

inline Strings operator+(Strings a, const Strings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::string contents(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

inline const std::string kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The names in a folder, sorted; none if there is no folder.
inline Strings filesIn(const std::string& folder) {
  Strings names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator{folder, none})
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

/// A folder that holds an old picture, and the state of its files.
class CommandTest : public testing::Test {
 protected:
  CommandTest() { write("old.png", "before"); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream{folder_.file(name), std::ios::binary} << text;
    return folder_.file(name);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

  /// Every file in the folder with its bytes.
  [[nodiscard]] std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator{folder_.file(".")})
      all[entry.path().filename().string()] = entry.is_regular_file() ? contents(entry.path().string()) : "";
    return all;
  }

  struct Drawn {
    Json stats;
    std::string png;
    RgbImage picture, ids;
  };
  /// Draws a picture, at 160x120 unless the options say otherwise, and checks everything that is promised of
  /// a success.
  [[nodiscard]] Drawn draw(const std::string& scene, Strings options = {}) const {
    if (std::ranges::find(options, "--size") == options.end())
      options = options + Strings{"--size", "160x120"};
    const Finished end = runProgram(
        Strings{"draw", scene, "-o", file("out.png"), "--ids", file("ids.png"), "--stats", "--bare"} +
        options);
    EXPECT_EQ(end.status, 0) << end.err;
    for (std::size_t from = 0; from < end.err.size(); from = end.err.find('\n', from) + 1)
      EXPECT_EQ(end.err.compare(from, 15, "xnewell: note: "), 0) << end.err;
    if (end.status != 0) return {};
    EXPECT_EQ(end.out.find('\n'), end.out.size() - 1);
    return {Json::parse(end.out), contents(file("out.png")), readPng(file("out.png")),
            readPng(file("ids.png"))};
  }

 private:
  TemporaryFolder folder_;
};

inline int idAt(const RgbImage& ids, int i, int j) {
  const std::uint8_t* p = &ids.rgb[3 * (std::size_t(j) * ids.width + i)];
  return p[0] << 16 | p[1] << 8 | p[2];
}

/// The words of a printed command, after the program's name. No word of these tests needs quotes.
inline Strings commandWords(const std::string& command, const std::string& picture) {
  Strings words;
  std::istringstream in{command};
  for (std::string word; in >> word;) words.push_back(word == "picture.png" ? picture : word);
  words.erase(words.begin());
  return words;
}

/// A double with all its digits.
inline std::string number(double v) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.17g", v);
  return text.data();
}

}  // namespace xnewell
