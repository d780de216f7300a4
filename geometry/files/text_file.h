#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace xnewell {

/// The longest text that is read, in bytes: whatever is counted in it (lines, vertices, corners of faces)
/// then fits an int.
inline constexpr std::size_t kMaxTextBytes = 2'147'483'647;

/// The whole file, byte for byte, in one go.
/// Throws std::system_error, whose text is `teapot.obj: No such file or directory`, if it cannot be opened or
/// read (a directory cannot), and ParseError if it is longer than kMaxTextBytes. The name in the message
/// is the path as given.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file);

/// Walks over the lines of a text and the words of a line without copying them: `nextLine()`, then
/// `next()` until it is empty; words not asked for are skipped.
/// Words are separated by blanks, tabs and the CR of a CR LF. A backslash right before the end of a line
/// is a blank that joins the next line. A word that begins with '#' opens a comment up to the end of its
/// line, where a backslash joins nothing (paths in comments end in one); a '#' inside a word is part of it,
/// so that the `1.#INF` of some writers is a wrong number and not a 1. A byte order mark is skipped.
class Words {
 public:
  /// `text` is borrowed; `name` is how errors call it. Throws ParseError beyond kMaxTextBytes.
  Words(std::string_view text, std::string name);

  /// Steps to the next line; false when there is none.
  bool nextLine();
  /// The next word of this line, empty when there is none.
  [[nodiscard]] std::string_view next();
  /// The remaining words of this line, joined by single blanks: names may hold some.
  [[nodiscard]] std::string rest();

  /// Of the last word read, from 1; after the last line, that line's. 0 before the first.
  [[nodiscard]] int line() const { return line_; }
  /// Throws ParseError at this line.
  [[noreturn]] void fail(const std::string& what) const { fail(line_, what); }
  [[noreturn]] void fail(int line, const std::string& what) const;

 private:
  const char* at_;
  const char* end_;
  std::string name_;
  int line_ = 0;
};

/// A word of a file for use in a message: in quotes, at most 40 bytes of it, and '?' for every byte that
/// is not printable ASCII, so that a binary file does no harm to a terminal.
[[nodiscard]] std::string inQuotes(std::string_view word);

}  // namespace xnewell
