#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// The longest text that is read, in bytes. Every count in it (lines, vertices, corners of faces) then fits
/// an int.
inline constexpr std::size_t kMaxTextBytes = 2'147'483'647;

/// Returns the whole file, byte for byte.
/// Throws as openInput() does (input_file.h), std::system_error if the file cannot be read, and ParseError if
/// it has more bytes than `most` or begins as UTF-16 does. The name in the message is the path as given.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file, std::size_t most = kMaxTextBytes);

/// Walks over the lines of a text and the words of a line without copying them. Call `nextLine()`, then
/// `next()` until it returns an empty word; nextLine() skips the words that are left.
/// A line ends with LF, CR LF or CR. Words are separated by blanks and tabs. A backslash right before the end
/// of a line counts as a blank and joins the next line. A word that begins with '#' opens a comment up to the
/// end of its line. There a backslash joins nothing, because paths in comments can end in one. A '#' inside a
/// word is part of the word, so that the `1.#INF` of some writers is a malformed number and not a 1. A byte
/// order mark is skipped.
class Words {
 public:
  /// Borrows `text`. Error messages call it `name`. Throws ParseError if it is longer than kMaxTextBytes.
  /// `linesBefore` is the number of lines of the file that stand before the text.
  Words(std::string_view text, std::string name, int linesBefore = 0);

  /// Steps to the next line. Returns false if there is none.
  bool nextLine();
  /// The next word of this line; empty if there is none.
  [[nodiscard]] std::string_view next();
  /// The first word of the next line that has one; empty at the end of the text.
  [[nodiscard]] std::string_view firstOfNextLine();
  /// Throws ParseError if this line has another word.
  void expectEndOfLine();
  /// The remaining words of this line, joined by single blanks, for names that contain blanks.
  [[nodiscard]] std::string rest();

  /// The line of the last word read, counted from 1; after the end, the last line; before the first, the
  /// lines before the text.
  [[nodiscard]] int line() const { return line_; }
  /// Throws ParseError at this line.
  [[noreturn]] void fail(const std::string& what) const { fail(line_, what); }
  [[noreturn]] void fail(int line, const std::string& what) const;

 private:
  const char* at_;
  const char* end_;
  std::string name_;
  int line_;
  bool begun_ = false;
};

/// A word of a file, for use in a message: in quotes, cut to 40 bytes, and visible (visible.h), so that a
/// binary file does no harm to a terminal.
[[nodiscard]] std::string inQuotes(std::string_view word);

/// `did you mean teapot?`: the name that is nearest to the word, if one of three letters of the word may be
/// wrong, left out, added, or has changed its place with the next one. Without such a name, `otherwise`.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string>& names,
                                     std::string otherwise);

/// The file that a name in a text file of `folder` means. Some writers part folders by backslashes, and some
/// name places of their own machine. So the name is tried as it is, then with slashes, then its last part in
/// `folder`. If there is none of these, the result is the second of them.
[[nodiscard]] std::filesystem::path namedFile(const std::filesystem::path& folder, std::string name);

/// The names of what a file has and the program has no use for: `vn`, `vertex.red`. Each is named once.
class LeftOut {
 public:
  void add(std::string_view name);
  /// `the program does not use vn, s, l`; "" if there is nothing. It names the first kNamed and
  /// says whether others follow: a file that is no model may have any number of them.
  [[nodiscard]] std::string sentence() const;
  static constexpr std::size_t kNamed = 12;

 private:
  std::vector<std::string> names_;  ///< in the order of the file
  bool others_ = false;             ///< whether there are names that found no room
};

/// The number that a word stands for: the double nearest to its decimal value, subnormals included. A value
/// nearer to 0 than to any other double is read as 0. The word is decimal, with an optional sign, point and
/// exponent: `-1.25`, `+2`, `1.`, `.5`, `1e3`. The locale has no effect.
/// Throws ParseError with the current line of `words` for anything else, for overflow, and, unless anything
/// `mayBe`, for NaN and infinity: some writers leave them in normals.
[[nodiscard]] double toNumber(const Words& words, std::string_view word, bool mayBe = false);

/// The number of decimals in the text of a well-formed number, trailing zeros included: 3 in `-1.250`, 4 in
/// `1.5e-3`, 1 in `1.25e1`, -3 in `1e3` but 0 in `1000`. The result is clamped to +-kMaxDecimals.
[[nodiscard]] int decimals(std::string_view number);
inline constexpr int kMaxDecimals = 400;  ///< 10^400 is infinite as a double, and its inverse is 0

/// Estimates from their texts how finely the numbers of a file are rounded: half a unit of the last decimal.
/// A writer may drop trailing zeros, so the most decimals count. But if one or two numbers have all the
/// digits of a double and the others have six, the others are not exact. So a tenth of the numbers may have
/// more decimals than the result says. Zeros tell nothing. A plain integer tells only that the unit's digit
/// is given. A program that prints 17 digits writes 0.1 as 0.10000000000000001, and 0.1 + 0.2 as
/// 0.30000000000000004. So the shortest number that is the same double counts, or one that ends three digits
/// before it, if that is a double next to it.
class RoundingOfNumbers {
 public:
  void add(std::string_view number, double value);
  [[nodiscard]] double rounding() const;
  /// A sentence if the numbers are written with more decimals than they hold; otherwise "". They are taken at
  /// their word, so faces that were made in one plane may count as two. It is seen in two cases, if there
  /// are at least 24 numbers: all are numbers of single precision; or all end in three zeros after at least
  /// three decimals. Of other numbers, such as results of arithmetic that loses digits, nothing can be seen.
  [[nodiscard]] std::string doubtful() const;

 private:
  std::array<int, 2 * kMaxDecimals + 1> count_{};
  int all_ = 0;
  int single_ = 0;            ///< numbers of single precision
  int finer_ = 0;             ///< numbers with more decimals than single precision holds at their size
  int used_ = -kMaxDecimals;  ///< the most decimals up to the last digit that is not 0
  bool integers_ = false;
};

}  // namespace xnewell
