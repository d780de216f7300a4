#include "geometry/files/text_file.h"

#include <sys/stat.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <system_error>
#include <utility>

#include "geometry/exact/scale.h"
#include "geometry/files/input_file.h"
#include "geometry/files/parse_error.h"

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

namespace {

/// Removes a leading '+', which std::from_chars does not accept. It keeps the '+' of "+-", so that a second
/// sign is an error.
std::string_view withoutPlus(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  return word;
}

/// The value of an exponent's digits, clamped to +-10^18. No text has enough digits to make up for such an
/// exponent.
long long toExponent(std::string_view digits) {
  constexpr long long kFar = 1'000'000'000'000'000'000;
  digits = withoutPlus(digits);
  long long exponent = 0;
  const std::errc error = std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec;
  if (error == std::errc::result_out_of_range) return digits.starts_with('-') ? -kFar : kFar;
  return std::clamp(exponent, -kFar, kFar);
}

/// What the text of a well-formed number says besides its value.
struct Spelling {
  long long decimals = 0;  ///< trailing zeros included; not clamped
  int zeros = 0;           ///< at the end of the mantissa
  int digits = 0;          ///< of the mantissa, from the first that is not 0
  bool integer = true;     ///< there is no point and no exponent
};
Spelling spellingOf(std::string_view number) {
  std::size_t end = 0, point = number.npos, first = 0;  // the first digit that is not 0
  for (; end < number.size() && number[end] != 'e' && number[end] != 'E'; ++end)
    if (number[end] == '.') point = end;
  while (first < end && number[first] <= '0') ++first;
  Spelling s;
  while (s.zeros < static_cast<int>(end) && number[end - 1 - s.zeros] == '0') ++s.zeros;
  s.digits = static_cast<int>(end - first) - (first < end && point != number.npos && point > first);
  s.integer = point == number.npos && end == number.size();
  if (point != number.npos) s.decimals = static_cast<long long>(end - point) - 1;
  if (end < number.size()) s.decimals -= toExponent(number.substr(end + 1));
  return s;
}

int clampedDecimals(const Spelling& s) {
  return static_cast<int>(std::clamp<long long>(s.decimals, -kMaxDecimals, kMaxDecimals));
}

/// Half a unit of the last decimal: 5 10^-(d + 1) for d decimals.
double halfUnit(int d) {
  static const std::array<double, 2 * kMaxDecimals + 1> kHalfUnits = [] {
    std::array<double, 2 * kMaxDecimals + 1> units{};
    for (int k = -kMaxDecimals; k <= kMaxDecimals; ++k)
      units[kMaxDecimals + k] = k < 0 ? 0.5 * power(10.0, -k) : 0.5 / power(10.0, k);
    return units;
  }();
  return kHalfUnits[kMaxDecimals + d];
}

/// As RoundingOfNumbers reads it.
Spelling meant(std::string_view number, double value) {
  constexpr int kDigits = std::numeric_limits<double>::digits10, kZeros = 3;
  Spelling spelling = spellingOf(number);
  if (spelling.digits <= kDigits || spelling.zeros > 0) return spelling;
  std::array<char, 32> text;
  spelling = spellingOf({text.data(), std::to_chars(text.begin(), text.end(), value).ptr});
  const char* const end =
      std::to_chars(text.begin(), text.end(), value, std::chars_format::general, kDigits).ptr;
  double rounded = 0.0;
  std::from_chars(text.begin(), end, rounded);
  const Spelling fewer = spellingOf({text.data(), end});
  const bool isNear = std::abs(rounded - value) <= std::numeric_limits<double>::epsilon() * std::abs(value);
  return isNear && fewer.decimals + kZeros <= spelling.decimals ? fewer : spelling;
}

}  // namespace

double toNumber(const Words& words, std::string_view word, bool mayBe) {
  if (mayBe && word.find('#') != word.npos) return NAN;  // -1.#IND of an old writer
  const std::string_view number = withoutPlus(word);
  const char* const end = number.data() + number.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) words.fail("malformed number " + inQuotes(word));
  if (error == std::errc::result_out_of_range) {
    // It is so for both too large and too small numbers, and the value is unchanged (LWG 3081).
    const Spelling spelling = spellingOf(number);
    if (spelling.digits > spelling.decimals) words.fail("number " + inQuotes(word) + " is too large");
    return number.starts_with('-') ? -0.0 : 0.0;
  }
  if (!mayBe && !std::isfinite(value)) words.fail("number " + inQuotes(word) + " is not finite");
  return value;
}

int decimals(std::string_view number) { return clampedDecimals(spellingOf(number)); }

void RoundingOfNumbers::add(std::string_view number, double value) {
  if (value == 0.0) return;
  const Spelling spelling = meant(number, value);
  if (spelling.integer) {
    integers_ = true;
    return;
  }
  const int d = clampedDecimals(spelling);
  ++count_[kMaxDecimals + d];
  ++all_;
  const double half = halfUnit(d), size = std::abs(value);
  const auto single = static_cast<float>(value);
  if (std::abs(single - value) <= half) ++single_;
  if (std::isfinite(single) && size * 0x1p-26 > half) ++finer_;
  used_ = std::max(used_, d - spelling.zeros);
}

std::string RoundingOfNumbers::doubtful() const {
  constexpr int kFewest = 24, kZeros = 3;
  if (all_ < kFewest) return "";
  const double written = -std::log10(2.0 * rounding());
  std::string holds;
  if (single_ == all_ && 10LL * finer_ >= 9LL * all_)
    holds = "are numbers of single precision";
  else if (used_ >= kZeros && written >= used_ + kZeros - 0.5)
    holds = "have no more than " + std::to_string(used_) + " that are not 0";
  if (holds.empty()) return "";
  return "the coordinates are written with " + std::to_string(std::lround(written)) + " decimals but " +
         holds + ": written with fewer, faces that were made in one plane would count as one plane";
}

double RoundingOfNumbers::rounding() const {
  int d = 0;
  if (all_ > 0) {
    d = -kMaxDecimals;
    for (int fit = count_[0]; 10LL * fit < 9LL * all_; fit += count_[kMaxDecimals + d]) ++d;
  }
  if (integers_) d = std::max(d, 0);
  return halfUnit(d);
}

}  // namespace xnewell
