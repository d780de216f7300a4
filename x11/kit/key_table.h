#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// A key as the window sees it: a Latin-1 letter, or a key with a name.
enum class NamedKey {
  Letter,
  Left,
  Right,
  Up,
  Down,
  Home,
  End,
  PageUp,
  PageDown,
  Tab,
  Space,
  Return,
  Backspace,
  Escape,
  F11
};
struct Key {
  NamedKey name = NamedKey::Letter;
  char letter = 0;
  bool shift = false;

  constexpr Key() = default;
  constexpr Key(NamedKey n, char l = 0, bool s = false) : name{n}, letter{l}, shift{s} {}
  constexpr Key(char l) : letter{l} {}
  bool operator==(const Key&) const = default;

  /// True if both are the same key. Shift does not count: a letter has it already, and with a named key it
  /// only means "ten times as far".
  [[nodiscard]] constexpr bool isSameKeyAs(const Key& other) const {
    return name == other.name && (name != NamedKey::Letter || letter == other.letter);
  }
};

/// What is written on the key: "a", "PgUp"; an arrow is "<", ">", "^" or "v", which a key cap draws as a
/// triangle.
[[nodiscard]] std::string capOf(const Key& key);
/// The key whose cap has this written on it, or an arrow with this name; nothing if no key has.
[[nodiscard]] std::optional<Key> keyOfCap(std::string_view cap);
/// The key in a sentence: "a", "PgUp", "left".
[[nodiscard]] std::string nameOf(const Key& key);

/// A question whose answer the user types on a line under the body. Return accepts the answer, Esc cancels.
struct Question {
  std::string asks;                      ///< "go to step"
  std::string text = {};                 ///< the text at first
  bool fresh = true;                     ///< true if the first letter typed replaces the text
  std::vector<std::string> offers = {};  ///< the texts that Up and Down put on the line
  /// Takes the text. Returns "", or a sentence that says what is wrong; then the user can correct the text.
  std::function<std::string(const std::string&)> take;
  std::function<void()> dropped = {};  ///< called if the line is closed without an answer
  bool cells = false;                  ///< a click on the strip answers `cell 178`
  bool ofPicture = false;              ///< the line closes when another picture is shown
};

/// Where a view talks to the user.
class Prompt {
 public:
  virtual ~Prompt() = default;
  virtual void ask(Question question) = 0;
  /// Shows a warning, one sentence, in the status line until the next key or click.
  virtual void notify(std::string notice) = 0;
  /// Shows plain news there until the next key.
  virtual void tell(std::string news) = 0;
};

/// The keys of a view are rows of one table. The view is driven by this table, and the last line of the
/// window, the list of all keys and the manual are written from it. So a key and what is said about it cannot
/// differ.

/// Some keys that do one thing.
struct KeyRow {
  std::vector<Key> keys = {};  ///< none: a gesture of the pointer, which the list of all keys names
  std::string legend = {};     ///< a word or two for the last line; "": the row is not there
  std::string does = {};       ///< for the list of all keys; rows in a row that do the same share a line
  std::function<void(const Key&)> act = {};  ///< gets the key that was pressed, with its Shift
  std::string off = {};                      ///< why the keys do nothing now, a sentence; "": they act
  std::string gesture = {};                  ///< "drag, wheel": what the pointer does to the same end
  bool waits = false;  ///< they act on what the next drawing shows, so they do nothing before it
  bool idle = false;   ///< there is nothing for them to do now: they go on to what all views have
};
using KeyTable = std::vector<KeyRow>;

/// The row of a key; null if the table has none.
[[nodiscard]] const KeyRow* rowOf(const KeyTable& table, const Key& key);

/// Does what the key's row says, or notifies the user why it does nothing now. A row that waits does nothing.
/// Returns false if the table has no such key.
bool pressIn(const KeyTable& table, const Key& key, Prompt& prompt);

/// Appends the rows of `more`. A key that `table` has already keeps its meaning: it is left out of the new
/// rows, and so are rows that have no key left.
void append(KeyTable& table, KeyTable more);

/// An entry of the window's last line: key caps or a gesture of the pointer, and what they do.
struct Legend {
  std::vector<Key> keys;
  std::string does, gesture = {};
  bool operator==(const Legend&) const = default;
};
/// The entries of the last line, in the table's order. Rows with the same words share an entry.
[[nodiscard]] std::vector<Legend> legendOf(const KeyTable& table);

/// A line in the list of all keys.
struct HelpLine {
  std::string keys, does;
  bool operator==(const HelpLine&) const = default;
};
/// The list of all keys, in the table's order. Neighbours with the same words share a line, and so do the
/// four arrows: "arrows".
[[nodiscard]] std::vector<HelpLine> helpOf(const KeyTable& table);

}  // namespace xnewell
