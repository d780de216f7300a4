#include "x11/kit/key_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace xnewell {

namespace {

struct CapRow {
  NamedKey key;
  std::string_view cap, word;  ///< on a key cap; in a sentence
};
constexpr std::array kCaps{
    CapRow{NamedKey::Left, "<", "left"},
    CapRow{NamedKey::Right, ">", "right"},
    CapRow{NamedKey::Up, "^", "up"},
    CapRow{NamedKey::Down, "v", "down"},
    CapRow{NamedKey::Home, "Home", "Home"},
    CapRow{NamedKey::End, "End", "End"},
    CapRow{NamedKey::PageUp, "PgUp", "PgUp"},
    CapRow{NamedKey::PageDown, "PgDn", "PgDn"},
    CapRow{NamedKey::Tab, "Tab", "Tab"},
    CapRow{NamedKey::Space, "Space", "Space"},
    CapRow{NamedKey::Return, "Return", "Return"},
    CapRow{NamedKey::Backspace, "Backspace", "Backspace"},
    CapRow{NamedKey::Escape, "Esc", "Esc"},
    CapRow{NamedKey::F11, "F11", "F11"},
};

bool hasKey(const KeyRow& row, const Key& key) {
  return std::ranges::any_of(row.keys, [&](const Key& one) { return one.isSameKeyAs(key); });
}

/// The keys of a line, each once: "up down", "a d s".
std::string wordsOf(const std::vector<Key>& keys) {
  const auto isThere = [&](NamedKey arrow) {
    return std::ranges::find(keys, arrow, &Key::name) != keys.end();
  };
  const bool arrows =
      isThere(NamedKey::Left) && isThere(NamedKey::Right) && isThere(NamedKey::Up) && isThere(NamedKey::Down);
  std::string words = arrows ? "arrows" : "";
  for (const Key& key : keys) {
    const bool isArrow = key.name >= NamedKey::Left && key.name <= NamedKey::Down;
    if (arrows && isArrow) continue;
    words += (words.empty() ? "" : " ") + nameOf(key);
  }
  return words;
}

}  // namespace

std::string capOf(const Key& key) {
  const auto* const row = std::ranges::find(kCaps, key.name, &CapRow::key);
  return row == kCaps.end() ? std::string{key.letter} : std::string{row->cap};
}

std::optional<Key> keyOfCap(std::string_view cap) {
  if (cap.size() == 1) return Key{cap[0]};
  const auto* const row =
      std::ranges::find_if(kCaps, [&](const CapRow& r) { return cap == r.cap || cap == r.word; });
  return row == kCaps.end() ? std::nullopt : std::optional{Key{row->key}};
}

std::string nameOf(const Key& key) {
  const auto* const row = std::ranges::find(kCaps, key.name, &CapRow::key);
  return row == kCaps.end() ? std::string{key.letter} : std::string{row->word};
}

const KeyRow* rowOf(const KeyTable& table, const Key& key) {
  const auto row = std::ranges::find_if(table, [&](const KeyRow& one) { return hasKey(one, key); });
  return row == table.end() ? nullptr : &*row;
}

bool pressIn(const KeyTable& table, const Key& key, Prompt& prompt) {
  const KeyRow* const row = rowOf(table, key);
  if (!row || row->idle) return false;
  if (row->waits) return true;
  if (!row->off.empty())
    prompt.notify(row->off);
  else
    row->act(key);
  return true;
}

void append(KeyTable& table, KeyTable more) {
  for (KeyRow& row : more) {
    const bool gesture = row.keys.empty();
    std::erase_if(row.keys, [&](const Key& key) {
      const KeyRow* const before = rowOf(table, key);
      return before != nullptr && !before->idle;
    });
    for (KeyRow& before : table)
      if (before.idle) std::erase_if(before.keys, [&](const Key& key) { return hasKey(row, key); });
    std::erase_if(table, [](const KeyRow& before) { return before.idle && before.keys.empty(); });
    if (gesture || !row.keys.empty()) table.push_back(std::move(row));
  }
}

std::vector<Legend> legendOf(const KeyTable& table) {
  std::vector<Legend> all;
  for (const KeyRow& row : table) {
    if (row.legend.empty()) continue;
    auto entry = std::ranges::find(all, row.legend, &Legend::does);
    if (entry == all.end()) entry = all.insert(entry, {{}, row.legend});
    entry->keys.insert(entry->keys.end(), row.keys.begin(), row.keys.end());
    if (row.keys.empty()) entry->gesture = row.gesture;
  }
  return all;
}

std::vector<HelpLine> helpOf(const KeyTable& table) {
  std::vector<HelpLine> all;
  for (auto row = table.begin(); row != table.end();) {
    const std::string does = row->does;
    std::vector<Key> keys;
    std::string gesture;
    for (; row != table.end() && row->does == does; ++row) {
      keys.insert(keys.end(), row->keys.begin(), row->keys.end());
      if (!row->gesture.empty()) gesture = row->gesture;
    }
    if (does.empty()) continue;
    const std::string words = wordsOf(keys);
    all.push_back({words + (words.empty() || gesture.empty() ? "" : ", ") + gesture, does});
  }
  return all;
}

}  // namespace xnewell
