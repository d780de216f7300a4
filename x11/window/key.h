#pragma once

namespace xnewell {

/// A key as the workbench sees it: a Latin-1 letter, or a key with a name.
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
  Escape
};
struct Key {
  NamedKey name = NamedKey::Letter;
  char letter = 0;
  bool shift = false;
};

}  // namespace xnewell
