#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "x11/kit/key.h"
#include "x11/kit/prompt.h"

namespace xnewell {

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
