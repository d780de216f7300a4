#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "x11/kit/control.h"
#include "x11/kit/key_table.h"
#include "x11/kit/page.h"
#include "x11/kit/typed_line.h"

namespace xnewell::THIS_FILE {

namespace {

struct Listener : Prompt {
  void ask(Question asked) override { question = std::move(asked); }
  void notify(std::string notice) override { notices.push_back(std::move(notice)); }
  void tell(std::string) override {}
  std::vector<std::string> notices;
  std::optional<Question> question;
};

struct Sheet : Listener {
  Sheet() { draw(); }
  [[nodiscard]] Controls controls() {
    using Kind = Control::Kind;
    const auto into = [](double& value) { return [&value](double v) { value = v; }; };
    const TrackRange wide{1, 1000, 0.01, true, 0};
    Controls all{
        {.kind = Kind::Slider, .key = 's', .label = "share", .value = share, .set = into(share)},
        {.kind = Kind::Slider,
         .key = 'n',
         .label = "count",
         .value = count,
         .range = wide,
         .set = into(count)},
        {.kind = Kind::Slider, .key = 'o', .label = "off", .off = "It is off.", .set = into(never)},
        {.kind = Kind::Choice,
         .key = 'C',
         .label = "choice",
         .value = choice,
         .options = {"one", "two", "three"},
         .set = into(choice)},
        {.kind = Kind::Toggle, .key = 'T', .label = "toggle", .value = on, .words = "on", .set = into(on)}};
    for (int part = 0; part < 3; ++part)
      all.push_back({.kind = Kind::Number,
                     .key = 'v',
                     .part = part,
                     .label = "place",
                     .value = xyz[part],
                     .range = {-9, 9, 0.5},
                     .set = into(xyz[part])});
    all.push_back({.kind = Kind::Own, .key = 't', .label = "turn", .move = [this](int along, int up) {
                     turned += 100 * along + up;
                   }});
    return all;
  }
  void draw() {
    list.forgetPlaces();
    bottom = list.placeColumn(controls(), 20, 30);
    const CellPlan plan;
    Pen pen{Painter{image}, plan};
    list.draw(pen, controls());
  }
  bool press(const Key& key) {
    KeyTable keys;
    list.appendKeys(keys, controls());
    return pressIn(keys, key, *this);
  }
  void type(std::string_view text) {
    for (const char letter : text) (void)press(letter);
  }
  bool grab(int x, int y) { return list.grab(controls(), x, y); }
  void dragTo(int x, int y) { list.dragTo(controls(), x, y); }
  [[nodiscard]] Rect area(char key, int part = 0) const { return list.find({key, part})->area; }

  double share = 0.5, count = 10, never = -1, choice = 0, on = 0;
  std::array<double, 3> xyz{1, 2, 3};
  int turned = 0, bottom = 0;
  IndexImage image{400, 300, 0};
  ControlList list{*this};
};

using namespace page;

Table numbers(int rows, int chosen) {
  Table t{.key = "rows",
          .columns = {{"name", "name"},
                      {.head = "x", .key = "x", .right = true},
                      {.head = "remark", .weight = 1}},
          .chosen = chosen,
          .id = 1};
  for (int k = 0; k < rows; ++k)
    t.rows.push_back({{"row " + std::to_string(k), k},
                      {.data = k / 8.0, .number = k / 8.0},
                      {"a remark that takes some room"}});
  t.foot = {{{.words = "both columns", .span = 2}}};
  return t;
}

/// The lines that a page has in an area, and what had no room.
struct Drawn {
  Drawn(const Page& page, int width, int height) {
    const CellPlan plan{TableKind::Linear};
    Pen pen{Painter{image}, plan};
    pressed = draw(pen, page, {10, 10, width, height}, 16, {}, &leftOut);
  }
  IndexImage image{1000, 800, 0};
  std::vector<std::string> leftOut;
  std::vector<Pressed> pressed;
  /// Whether something is drawn beyond the area.
  [[nodiscard]] bool within(int width, int height) const {
    for (int j = 0; j < image.height; ++j)
      for (int i = 0; i < image.width; ++i)
        if (image.row(j)[i] != 0 && (i < 6 || i >= 14 + width || j < 6 || j >= 14 + height)) return false;
    return true;
  }
};

}  // namespace

// A page of controls, one of each kind, without a window.

// A letter selects a slider; arrows, Shift, Home and End change the selected one and no other.
TEST(ControlList, KeysChangeTheSelectedControl) {
  Sheet page;
  page.type("s");
  EXPECT_TRUE(page.press(NamedKey::Right));
  EXPECT_DOUBLE_EQ(page.share, 0.51);
  EXPECT_TRUE(page.press({NamedKey::Down, 0, true}));
  EXPECT_DOUBLE_EQ(page.share, 0.41);
  EXPECT_TRUE(page.press(NamedKey::End));
  EXPECT_EQ(page.share, 1);
  page.type("n");
  EXPECT_TRUE(page.press(NamedKey::Home));
  EXPECT_EQ(page.count, 1);
  EXPECT_TRUE(page.press(NamedKey::Right));
  EXPECT_EQ(page.count, 2);  // at least one unit of the last decimal
  EXPECT_EQ(page.share, 1);
  page.type("t");
  EXPECT_TRUE(page.press({NamedKey::Left, 0, true}));
  EXPECT_TRUE(page.press(NamedKey::Up));
  EXPECT_EQ(page.turned, -999);
  EXPECT_EQ(page.count, 2);
}

// Tab visits all controls that the arrows change, and comes round; with Shift, the other way.
TEST(ControlList, TabGoesRound) {
  Sheet page;
  std::string visited;
  for (int k = 0; k < 8; ++k) {
    EXPECT_TRUE(page.press(NamedKey::Tab));
    visited += page.list.focus()->key;
  }
  EXPECT_EQ(visited, "snovvvts");
  EXPECT_TRUE(page.press({NamedKey::Tab, 0, true}));
  EXPECT_EQ(page.list.focus()->key, 't');
}

// The letter of several numbers goes through them, and each takes its own value, by the arrows and dragged.
TEST(ControlList, NumbersShareALetter) {
  Sheet page;
  page.type("vv");
  EXPECT_TRUE(page.press(NamedKey::Right));
  EXPECT_EQ(page.xyz, (std::array<double, 3>{1, 2.5, 3}));
  page.type("vv");
  EXPECT_EQ(page.list.focus()->part, 0);
  const Rect box = page.area('v', 0);
  ASSERT_TRUE(page.grab(box.x + 5, box.y + 5));
  page.dragTo(box.x + 8, box.y + 5);
  EXPECT_EQ(page.xyz[0], 2.5);
  page.list.drop();
}

// A control that is off keeps its value, and says why, also to the pointer.
TEST(ControlList, OffSaysWhy) {
  Sheet page;
  page.type("o");
  EXPECT_TRUE(page.press(NamedKey::Up));
  const Rect track = page.list.find({'o'})->track;
  EXPECT_TRUE(page.grab(track.x + 9, track.y));
  EXPECT_FALSE(page.list.dragging());
  EXPECT_EQ(page.notices, (std::vector<std::string>{"It is off.", "It is off."}));
  EXPECT_FALSE(page.question);
  EXPECT_TRUE(page.press({'='}));  // opens a question, so that digits are not keys of the view
  ASSERT_TRUE(page.question);
  EXPECT_EQ(page.question->take("0.5"), "It is off.");
  EXPECT_EQ(page.never, -1);
}

// Without a selected control `=` says what is missing.
TEST(ControlList, TypingNeedsAControl) {
  Sheet page;
  ASSERT_FALSE(page.list.focus());
  EXPECT_TRUE(page.press({'='}));
  EXPECT_FALSE(page.question);
  EXPECT_EQ(page.notices.size(), 1u);
}

// A typed number may have a plus, and blanks around it.
TEST(ControlList, TypedNumbers) {
  EXPECT_EQ(typedNumber(" +0.5 "), 0.5);
  EXPECT_EQ(typedNumber("-2"), -2);
  for (const char* wrong : {"", " ", "+", "+-1", "1 2", "0x1", "1,5", "--1"})
    EXPECT_FALSE(typedNumber(wrong)) << wrong;
}

// The pointer: an option is chosen, the name of a choice takes the next one, a toggle flips, a name selects
// and changes nothing, and a thumb follows to both ends and no further.
TEST(ControlList, ThePointer) {
  Sheet page;
  const std::vector<Rect> options = page.list.find({'C'})->options;
  ASSERT_TRUE(page.grab(options[2].x + 3, options[2].y + 3));
  EXPECT_EQ(page.choice, 2);
  ASSERT_TRUE(page.grab(page.area('C').x + 30, page.area('C').y + 5));
  EXPECT_EQ(page.choice, 0);
  ASSERT_TRUE(page.grab(page.area('T').x + 30, page.area('T').y + 5));
  EXPECT_EQ(page.on, 1);
  ASSERT_TRUE(page.grab(page.area('s').x + 30, page.area('s').y + 5));
  EXPECT_EQ(page.share, 0.5);
  EXPECT_EQ(page.list.focus()->key, 's');
  EXPECT_FALSE(page.list.dragging());
  const Rect track = page.list.find({'s'})->track;
  ASSERT_TRUE(page.grab(track.x + track.width / 4, track.y));
  EXPECT_TRUE(page.list.dragging());
  EXPECT_NEAR(page.share, 0.25, 0.01);
  page.dragTo(track.x + 5000, track.y - 40);
  EXPECT_EQ(page.share, 1);
  page.dragTo(-5000, track.y);
  EXPECT_EQ(page.share, 0);
  page.list.drop();
  EXPECT_FALSE(page.grab(390, 290));
}

// Options that need more lines get them, and the column says where it ends.
TEST(ControlList, LayoutReturnsWhatItTook) {
  Sheet page;
  for (const auto& [id, place] : page.list.places()) EXPECT_LE(place.area.y + place.area.height, page.bottom);
  Control wide = page.controls()[3];
  wide.options = {"a long option", "another long option", "a third long option", "short"};
  const ControlPlace place = placeInRow(wide, 0, 20);
  EXPECT_GT(place.options.back().y, place.options.front().y);
  EXPECT_GE(place.area.y + place.area.height, place.options.back().y + place.options.back().height);
}

// A place on a track and the value there belong together, on linear and logarithmic tracks; a step moves
// every value and stays in the range.
TEST(ControlList, TracksInvert) {
  for (const TrackRange& range : {TrackRange{}, TrackRange{1, 1000, 0.01, true, 0},
                                  TrackRange{-9, 9, 0.5, false, 1}, TrackRange{0.001, 0.5, 0.025, true, 4}}) {
    for (int k = 0; k <= 50; ++k) {
      const double value = valueAt(range, k / 50.0);
      EXPECT_GE(value, range.low);
      EXPECT_LE(value, range.high);
      EXPECT_EQ(valueAt(range, shareOf(range, value)), value);
      for (const int steps : {-1, 1}) {
        const double next = stepped(range, value, steps);
        EXPECT_TRUE(next != value || value == (steps > 0 ? range.high : range.low)) << value;
        EXPECT_GE(next, range.low);
        EXPECT_LE(next, range.high);
      }
    }
  }
}

// The options of a choice stand in one line. Those that do not fit follow in more lines, one height lower,
// from the same place on. The frame of a chosen word touches no other word.
TEST(Control, OptionsTakeTheLinesThatTheyNeed) {
  const std::vector<std::string> words{"one", "two", "three", "four", "five", "six"};  // 22 letters
  for (const auto& [width, lines] :
       {std::pair{400, 1}, {22 * 6 + 5 * 8, 1}, {22 * 6 + 19, 2}, {60, 4}, {1, 6}}) {
    SCOPED_TRACE(width);
    const std::vector<Rect> frames = optionFrames(words, 100, 50, width, 19);
    ASSERT_EQ(frames.size(), words.size());
    EXPECT_EQ(frames.back().y, frames.front().y + (lines - 1) * 19);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const int from = frames[k].x + 6, to = from + textWidth(words[k]);
      EXPECT_EQ(frames[k].width, textWidth(words[k]) + 13);
      EXPECT_TRUE(to <= 100 + width || from == 100);  // a word that is wider than a line has its own
      if (k == 0) continue;
      const bool sameLine = frames[k].y == frames[k - 1].y;
      EXPECT_TRUE(sameLine || frames[k].y == frames[k - 1].y + 19);
      if (sameLine) {
        EXPECT_GT(from, frames[k - 1].x + frames[k - 1].width);
      } else {
        EXPECT_EQ(from, 100);
      }
    }
  }
}

// One table drives a view and is what the view says about its keys.

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

// A page is told once: as text, with its marks taken out, and as JSON with all digits, in the order that it
// asks for.
TEST(Page, IsToldAsTextAndJson) {
  page::Section s{"1 numbers", "an aside"};
  s.add(numbers(2, 0));
  s.add(Fact{"sum", 0.125, "their sum is " + asked(2, "0.1250") + std::string{kTick}});
  s.fact("none", Data{});
  s.fact("list", List{1, 2.5, "a", true, Object{{"k", std::optional<double>{}}}});
  s.say("only words").indent = 2;
  const Page page{.of = "a page", .title = "fine", .sections = {s}, .order = "sum rows"};
  EXPECT_EQ(asText(page),
            "a page: fine\n1 numbers: an aside\n"
            "      name        x  remark\n"
            "      row 0  0.0000  a remark that takes some room\n"
            "      row 1  0.1250  a remark that takes some room\n"
            "      both columns\n"
            "      their sum is 0.1250\n"
            "        only words\n");
  EXPECT_EQ(asJson(page), R"({"sum":0.125,"rows":[{"name":0,"x":0.0},{"name":1,"x":0.125}],"none":null,)"
                          R"("list":[1,2.5,"a",true,{"k":null}]})"
                          "\n");
  EXPECT_EQ(asLines(page, {2})[6], "      their sum is ?");
  EXPECT_EQ(asLines(page, {3})[6], "      their sum is 0.1250");
}

// Of a table that has too little room, the chosen row is always there, with the first one; a line stands for
// the others. Nothing is drawn beyond the area.
TEST(Page, RowsOfALongTable) {
  for (const int rows : {1, 4, 9, 30})
    for (int chosen = 0; chosen < rows; ++chosen)
      for (const int height : {120, 170, 300}) {
        const Drawn drawn{{.sections = {{"t", "", {numbers(rows, chosen)}}}}, 300, height};
        std::set<int> shown;
        for (const Pressed& one : drawn.pressed) shown.insert(one.row);
        EXPECT_TRUE(shown.contains(chosen) && shown.contains(0)) << rows << ' ' << chosen << ' ' << height;
        EXPECT_TRUE(drawn.within(300, height)) << rows << ' ' << chosen << ' ' << height;
      }
}

// The lightest goes first, whatever stands above or below it; where there is room again, it stays.
TEST(Page, TheLightestGoesFirst) {
  page::Section s{"weights"};
  for (int weight = 1; weight <= 9; ++weight) s.say("weight " + std::to_string(weight), weight);
  s.say("never in a window", 0);
  for (int height = 60; height < 220; height += 10) {
    const Drawn drawn{{.sections = {s}}, 200, height};
    EXPECT_TRUE(drawn.within(200, height)) << height;
    EXPECT_FALSE(std::ranges::count(drawn.leftOut, "never in a window"));
    for (std::size_t k = 1; k <= 9; ++k)
      EXPECT_EQ(std::ranges::count(drawn.leftOut, "weight " + std::to_string(k)), k <= drawn.leftOut.size());
  }
}

// A narrow table gives up its remark, then decimals, and keeps its numbers; a finding gives up its last
// lines.
TEST(Page, ANarrowTableKeepsItsNumbers) {
  page::Section s{"t"};
  s.add(numbers(3, -1));
  s.add(
      page::Finding{.bold = "Found.", .why = "Why it is so, in a sentence that takes some lines of a box."});
  for (const int width : {60, 84, 120, 200, 400})
    EXPECT_TRUE(Drawn(Page{.sections = {s}}, width, 400).within(width, 400)) << width;
  EXPECT_NE(Drawn(Page{.sections = {s}}, 200, 400).image, Drawn(Page{.sections = {s}}, 400, 400).image);
}

}  // namespace xnewell::THIS_FILE
