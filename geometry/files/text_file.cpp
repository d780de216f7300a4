#include "geometry/files/text_file.h"

#include <sys/stat.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "geometry/files/input_file.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/visible.h"

namespace xnewell {

namespace {

[[noreturn]] void failTooLong(const std::string& name, std::size_t most = kMaxTextBytes) {
  constexpr std::size_t kMega = 1 << 20;
  throw ParseError{name, 0,
                   "longer than " + (most % kMega == 0 ? std::to_string(most / kMega) + " MB"
                                                       : std::to_string(most) + " bytes")};
}

/// The bytes that may end a word: blanks, the end of the line, and a backslash, which may continue the line.
constexpr auto kMayEndWord = [] {
  std::array<bool, 256> table{};
  for (const unsigned char c : {' ', '\t', '\r', '\v', '\f', '\n', '\\'}) table[c] = true;
  return table;
}();

bool mayEndWord(char c) { return kMayEndWord[static_cast<unsigned char>(c)]; }

/// True for LF, and for a CR that no LF follows.
bool endsLine(const char* p, const char* end) {
  return *p == '\n' || (*p == '\r' && (p + 1 == end || p[1] != '\n'));
}

bool isBlank(const char* p, const char* end) { return mayEndWord(*p) && *p != '\\' && !endsLine(p, end); }

/// The beginning of the next line if a backslash at `p` joins it to this one; otherwise null.
const char* afterContinuation(const char* p, const char* end) {
  if (*p != '\\') return nullptr;
  ++p;
  if (end - p > 1 && *p == '\r' && !endsLine(p, end)) ++p;
  return p != end && endsLine(p, end) ? p + 1 : nullptr;
}

}  // namespace

std::string readTextFile(const std::filesystem::path& file, std::size_t most) {
  const std::string name = file.string();
  const InputFile in = openInput(name);
  // The size is only a hint: another program may write the file, and the files of /proc have none. One extra
  // byte lets the first read find the end of the file.
  struct ::stat status {};
  ::fstat(::fileno(in.get()), &status);
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > most) failTooLong(name, most);
  std::string text(size + 1, '\0');
  std::size_t used = 0;
  while (true) {
    used += std::fread(text.data() + used, 1, text.size() - used, in.get());
    if (used < text.size()) break;
    if (used > most) failTooLong(name, most);
    text.resize(std::min(2 * used, most + 1));
  }
  if (std::ferror(in.get())) throw std::system_error{errno, std::generic_category(), name};
  text.resize(used);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw ParseError{name, 0, "a text in UTF-16; save it as UTF-8"};
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
    if (isBlank(p, end_)) continue;
    const char* const joined = afterContinuation(p, end_);
    if (!joined) break;
    p = joined - 1;
    ++line_;
  }
  if (p != end_ && *p == '#')
    while (p != end_ && !endsLine(p, end_)) ++p;
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
  const std::string_view begin = beginOf(word, kShown);
  return "'" + visible(begin) + (begin.size() < word.size() ? "...'" : "'");
}

namespace {

/// How many letters are wrong, left out, added, or exchanged with the next one (optimal string alignment).
std::size_t lettersApart(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string didYouMean(std::string_view word, const std::vector<std::string>& names, std::string otherwise) {
  constexpr std::size_t kLongest = 40;  // no name is as long
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& name : names)
    if (const std::size_t apart = word.size() > kLongest ? least : lettersApart(word, name); apart < least)
      least = apart, otherwise = "did you mean " + name + "?";
  return otherwise;
}

std::filesystem::path namedFile(const std::filesystem::path& folder, std::string name) {
  const auto there = [](const std::filesystem::path& file) {
    std::error_code missing;
    return std::filesystem::is_regular_file(file, missing);
  };
  const std::filesystem::path written = folder / name;
  std::ranges::replace(name, '\\', '/');
  const std::filesystem::path file = folder / name, beside = folder / file.filename();
  if (there(written)) return written;
  return there(file) || !there(beside) ? file : beside;
}

void LeftOut::add(std::string_view name) {
  if (!names_.empty() && names_.back() == name) return;  // most often a run of the same
  if (std::ranges::find(names_, name) != names_.end()) return;
  if (names_.size() < kNamed)
    names_.emplace_back(name);
  else
    others_ = true;
}

std::string LeftOut::sentence() const {
  if (names_.empty()) return "";
  std::string all = "the program does not use ";
  for (const std::string& name : names_) {
    if (&name != names_.data()) all += ", ";
    const std::string quoted = inQuotes(name);  // with unprintable bytes replaced
    all += quoted.ends_with("...'") ? quoted : quoted.substr(1, quoted.size() - 2);
  }
  return others_ ? all + " and others" : all;
}

}  // namespace xnewell
