#pragma once

#include <random>
#include <string>
#include <vector>

namespace xnewell {

/// A random command line, and what it promises.
struct RandomWords {
  std::vector<std::string> words;
  std::vector<std::string> writes = {};  ///< the files that it writes into its folder, besides frames
  bool printsJson = false;               ///< one JSON value
  bool printsLines = false;              ///< one JSON value a line
};

/// The name of the folder that frames go to, in the folder of all files that are written.
inline constexpr const char* kFrames = "frames";

/// A command for a scene, at a small size, with random options: most values are valid. It writes into the
/// folder only. `server`: also commands that need an X server.
[[nodiscard]] RandomWords randomWords(const std::string& scene, const std::string& folder, bool server,
                                      std::mt19937& rng);
[[nodiscard]] RandomWords wordsForLesson(const std::string& lesson, const std::string& folder);

}  // namespace xnewell
