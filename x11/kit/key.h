#pragma once

#include <optional>
#include <string>
#include <string_view>

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

}  // namespace xnewell
