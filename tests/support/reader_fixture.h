#pragma once

#include <gtest/gtest.h>

#include <concepts>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "geometry/files/parse_error.h"
#include "tests/support/temporary_folder.h"

namespace xnewell {

/// The error of `read()`: the exact text of its ParseError or system_error, or "" if there is none. Any other
/// exception ends the test.
template <std::invocable Read>
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

/// `text` with 1 to 4 bytes overwritten, removed or inserted, preferably bytes that mean something to a
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

/// How many of `count` texts are read: `whole` cut off at each byte, then with a few wrong bytes. The others
/// are complained of with the file's name.
template <std::invocable<const std::string&> Read>
int survivors(const std::string& whole, int count, const std::string& name, Read read) {
  std::mt19937 rng{7};
  int readable = 0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const std::string text = i <= std::ssize(whole) ? whole.substr(0, i) : mutated(whole, rng);
    const std::string what = complaint([&] {
      read(text);
      return ++readable;
    });
    EXPECT_TRUE(what.empty() || what.starts_with(name + ':')) << what;
  }
  return readable;
}

}  // namespace xnewell
