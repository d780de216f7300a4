#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "geometry/parse_error.h"

/// What `read()` complains of: the exact text of its ParseError or system_error, "" if it does not.
/// Anything else it throws ends the test.
template <typename Read>
std::string complaint(Read read) {
  try {
    static_cast<void>(read());
  } catch (const ParseError& error) {
    return error.what();
  } catch (const std::system_error& error) {
    return error.what();
  }
  return "";
}

/// A folder of its own for a test's files, removed with it.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "reader-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    std::ofstream{path_ / name, std::ios::binary} << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// `text` with 1 to 4 bytes overwritten, taken out or put in, preferably ones that mean something to a
/// reader.
inline std::string mutated(std::string text, std::mt19937& rng) {
  constexpr std::string_view kTelling = "0123456789+-.eE/#\\ \t\r\nvfgonai\0\xff";
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>{0, n - 1}(rng); };
  for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = below(text.size());
    const char byte = below(8) ? kTelling[below(kTelling.size())] : static_cast<char>(below(256));
    switch (below(3)) {
      case 0:
        text[at] = byte;
        break;
      case 1:
        text.erase(at, 1 + below(3));
        break;
      default:
        text.insert(at, 1, byte);
    }
  }
  return text;
}
