#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/model_file.h"
#include "x11/options/options.h"

namespace xnewell {

/// The rows of --help. The man page and the completions of the shells are made from them.

inline constexpr std::string_view kAbout = "shading and hidden surfaces through real X11 colormaps";

/// The names of scene files end with one of these. A picture carries its scene's name and its set-up.
inline constexpr auto kSceneFiles = [] {
  constexpr std::array<std::string_view, 5> others{".json", ".png", ".svg", ".pdf", ".eps"};
  std::array<std::string_view, kModelFiles.size() + others.size()> all;
  std::ranges::copy(others, std::ranges::transform(kModelFiles, all.begin(), &ModelFileRow::extension).out);
  return all;
}();

/// What follows an option.
enum class Takes { Nothing, Text, File, Folder };
struct OptionRow {
  std::string name, letter;  ///< "--output", and "-o" or ""; "scene": a word that has no option
  std::string does;          ///< the default at its end in [ ]
  Takes takes = Takes::Nothing;
  std::function<void(const std::string&)> take =
      {};                               ///< reads its text; a flag's is "true", or what follows =
  bool mayLack = false;                 ///< the text may be left out: then it is ""
  std::vector<std::string> words = {};  ///< the words that its text may be, or may begin with; else empty
  /// Where it works: a command, "draw"; another option, "--accuracy", or its value, "--view colours"; or
  /// both, "trace --frames". Empty: with all commands that draw a scene (CommandRow::draws).
  std::vector<std::string_view> places = {};

  [[nodiscard]] bool isOption() const { return name.starts_with("--"); }
  /// The name in messages: "-o", "--size".
  [[nodiscard]] const std::string& shown() const { return letter.empty() ? name : letter; }
  OptionRow& only(std::initializer_list<std::string_view> where) {
    places = where;
    return *this;
  }
  /// Its text may be the name of one of these rows.
  OptionRow& proposes(const auto& rows) {
    for (const auto& row : rows) words.emplace_back(row.name);
    return *this;
  }
};
/// In the order of --help.
[[nodiscard]] std::vector<OptionRow> optionRows();

/// All that the first word may be but a file.
[[nodiscard]] std::vector<std::string> commandsAndScenes();

/// Check what no option can check alone: which options need others, and which exclude each other.
/// @throws UsageError

/// What the command line says by itself. `rows` are those of all options.
void checkUsage(const Options& options, const std::vector<OptionRow>& rows);
/// The same as settle(), without the carrier's name in a complaint.
void settleOver(Options& options, const PictureSettings& scene);

/// Refuses a pixel of a picture that has this size. @throws UsageError
[[noreturn]] void refuseOutside(const glm::ivec2& pixel, const glm::ivec2& size);

}  // namespace xnewell
