#include "x11/kit/key_table.h"

#include <gtest/gtest.h>

namespace xnewell::THIS_FILE {

// One table drives a view and is what the view says about its keys.

namespace {

struct Listener : Prompt {
  void ask(Question) override { ++questions; }
  void notify(std::string notice) override { notices.push_back(std::move(notice)); }
  void tell(std::string) override {}
  int questions = 0;
  std::vector<std::string> notices;
};

}  // namespace

// A key does what its row says, with the Shift that was pressed. A row that is off says why, and a key
// without a row is not taken.
TEST(KeyTable, ActsOrSaysWhyNot) {
  int by = 0;
  const KeyTable table{
      {{NamedKey::Left, NamedKey::Right},
       "move",
       "move it",
       [&](const Key& key) { by += (key.name == NamedKey::Left ? -1 : 1) * (key.shift ? 10 : 1); }},
      {{'k'}, "", "keep it", [&](const Key&) { by = 1000; }, "There is nothing to keep."},
      {.keys = {'w'}, .act = [&](const Key&) { by = 1000; }, .waits = true}};
  Listener user;
  EXPECT_TRUE(pressIn(table, NamedKey::Right, user));
  EXPECT_TRUE(pressIn(table, {NamedKey::Left, 0, true}, user));
  EXPECT_EQ(by, -9);
  EXPECT_TRUE(user.notices.empty());
  EXPECT_TRUE(pressIn(table, 'k', user));
  EXPECT_TRUE(pressIn(table, 'w', user));
  EXPECT_EQ(by, -9);
  EXPECT_EQ(user.notices, std::vector<std::string>{"There is nothing to keep."});
  EXPECT_FALSE(pressIn(table, 'K', user));
  EXPECT_FALSE(pressIn(table, NamedKey::Up, user));
}

// A key that is taken keeps its meaning when more rows come, unless it is idle; what is left of the new rows
// is added.
TEST(KeyTable, TheFirstMeaningWins) {
  KeyTable table{{{'a'}, "one", "one"}};
  append(table, {{{'a', 'b'}, "two", "two"}, {{'a'}, "three", "three"}, {.does = "four", .gesture = "drag"}});
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(rowOf(table, 'a')->does, "one");
  EXPECT_EQ(rowOf(table, 'b')->does, "two");
  EXPECT_EQ(table.back().gesture, "drag");
  KeyTable idle{{.keys = {'a'}, .does = "idle", .idle = true}};
  append(idle, {{{'a'}, "two", "two"}});
  EXPECT_EQ(rowOf(idle, 'a')->does, "two");
}

// The last line and the list of all keys are written from the rows. Neighbours with the same words are one
// entry, and four arrows are "arrows".
TEST(KeyTable, SaysWhatItDoes) {
  const KeyTable table{{{NamedKey::Left}, "step", "a step"},
                       {{NamedKey::Right}, "step", "a step"},
                       {{NamedKey::Up}, "", "a step"},
                       {{NamedKey::Down}, "", "a step"},
                       {{'g', NamedKey::PageUp}, "", "go"},
                       {.legend = "turn", .does = "turn it", .gesture = "drag"},
                       {{'+'}, "zoom", "nearer", {}, {}, "wheel"},
                       {{'j'}, "step", "a long step"}};
  EXPECT_EQ(legendOf(table),
            (std::vector<Legend>{
                {{NamedKey::Left, NamedKey::Right, 'j'}, "step"}, {{}, "turn", "drag"}, {{'+'}, "zoom"}}));
  EXPECT_EQ(helpOf(table), (std::vector<HelpLine>{{"arrows", "a step"},
                                                  {"g PgUp", "go"},
                                                  {"drag", "turn it"},
                                                  {"+, wheel", "nearer"},
                                                  {"j", "a long step"}}));
}

}  // namespace xnewell::THIS_FILE
