#include "geometry/files/text_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include "geometry/files/parse_error.h"

namespace xnewell {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void failTooLong(const std::string& name) {
  throw ParseError{name, 0, "longer than " + std::to_string(kMaxTextBytes) + " bytes"};
}

/// The bytes that may end a word: blanks, the end of the line, and a backslash, which may continue the line.
constexpr auto kMayEndWord = [] {
  std::array<bool, 256> table{};
  for (const unsigned char c : {' ', '\t', '\r', '\v', '\f', '\n', '\\'}) table[c] = true;
  return table;
}();

bool mayEndWord(char c) { return kMayEndWord[static_cast<unsigned char>(c)]; }

bool isBlank(char c) { return mayEndWord(c) && c != '\n' && c != '\\'; }

/// The beginning of the next line if a backslash at `p` joins it to this one; otherwise null.
const char* afterContinuation(const char* p, const char* end) {
  if (*p != '\\') return nullptr;
  ++p;
  if (p != end && *p == '\r') ++p;
  return p != end && *p == '\n' ? p + 1 : nullptr;
}

}  // namespace

std::string readTextFile(const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto failErrno = [&] { throw std::system_error{errno, std::generic_category(), name}; };
  const std::unique_ptr<std::FILE, Close> in{std::fopen(file.c_str(), "rb")};
  if (!in) failErrno();

  // The size is only a hint, because a pipe has none. One extra byte lets the first read find the end of the
  // file.
  std::error_code noSize;
  const std::uintmax_t size = std::filesystem::file_size(file, noSize);
  if (!noSize && size > kMaxTextBytes) failTooLong(name);
  std::string text(noSize ? 1 << 16 : static_cast<std::size_t>(size) + 1, '\0');
  std::size_t used = 0;
  while (true) {
    used += std::fread(text.data() + used, 1, text.size() - used, in.get());
    if (used < text.size()) break;
    if (used > kMaxTextBytes) failTooLong(name);
    text.resize(std::min(2 * used, kMaxTextBytes + 1));
  }
  if (std::ferror(in.get())) failErrno();
  text.resize(used);
  return text;
}

Words::Words(std::string_view text, std::string name, int linesBefore)
    : at_{text.data()}, end_{text.data() + text.size()}, name_{std::move(name)}, line_{linesBefore} {
  if (text.size() > kMaxTextBytes) failTooLong(name_);
  if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
}

bool Words::nextLine() {
  if (!std::exchange(begun_, true)) {
    ++line_;
    return at_ != end_;
  }
  while (!next().empty()) {
  }
  if (end_ - at_ <= 1) {  // nothing after the end of the last line
    at_ = end_;
    return false;
  }
  ++at_;
  ++line_;
  return true;
}

std::string_view Words::next() {
  const char* p = at_;  // a local variable, so that it stays in a register
  for (; p != end_; ++p) {
    if (isBlank(*p)) continue;
    const char* const joined = afterContinuation(p, end_);
    if (!joined) break;
    p = joined - 1;
    ++line_;
  }
  if (p != end_ && *p == '#') p = std::find(p, end_, '\n');
  const char* const begin = p;
  while (p != end_ && (!mayEndWord(*p) || (*p == '\\' && !afterContinuation(p, end_)))) ++p;
  at_ = p;
  return {begin, p};
}

std::string_view Words::firstOfNextLine() {
  while (nextLine())
    if (const std::string_view word = next(); !word.empty()) return word;
  return {};
}

void Words::expectEndOfLine() {
  if (const std::string_view word = next(); !word.empty()) fail("unexpected " + inQuotes(word));
}

std::string Words::rest() {
  std::string joined;
  for (std::string_view word = next(); !word.empty(); word = next()) {
    if (!joined.empty()) joined += ' ';
    joined += word;
  }
  return joined;
}

void Words::fail(int line, const std::string& what) const { throw ParseError{name_, line, what}; }

std::string inQuotes(std::string_view word) {
  constexpr std::size_t kShown = 40;
  std::string shown{word.substr(0, kShown)};
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + shown + (word.size() > kShown ? "...'" : "'");
}

}  // namespace xnewell
