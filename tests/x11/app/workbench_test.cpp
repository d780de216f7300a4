#include "x11/app/workbench.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/seeds.h"
#include "tests/x11/support/find_text.h"
#include "tests/x11/support/ready_workbench.h"

namespace xnewell::THIS_FILE {

namespace {

using Stale = Workbench::Stale;

/// All of the window but the status line, which shows milliseconds.
IndexImage withoutStatus(const Workbench& b) {
  IndexImage image = b.image();
  for (int j = b.layout().status.y; b.layout().roomy && j < image.height; ++j)
    std::fill_n(image.row(j), image.width, std::uint8_t{0});
  return image;
}

}  // namespace

// A new hue, and the change between 8 and 16 bits, only change colours: no index of the window changes.
TEST(Workbench, HueAndBitsAreColoursAlone) {
  ReadyWorkbench b;
  const IndexImage before = b.image();
  const Palette palette = b.palette();
  for (const char key : {'H', 'B'}) {
    b.type({&key, 1});
    EXPECT_EQ(b.stale(), Stale::Colors);
    b.update();
    EXPECT_EQ(b.stale(), Stale::Nothing);
    EXPECT_EQ(b.image(), before);
  }
  EXPECT_NE(b.palette(), palette);
}

// A click on a key cap of the last line, or on the words beside it, is that key: fingers have no others.
TEST(Workbench, TheLastLineIsAKeyboard) {
  for (const int unit : {1, 2}) {
    ReadyWorkbench b{{}, 1024 * unit, 768 * unit};
    b.scale(unit);
    b.finish();
    const auto click = [&](const char* words, int right) {
      const std::vector<glm::ivec2> at = findText(b.image(), words, b.plan()[Cell::Soft], unit);
      ASSERT_FALSE(at.empty()) << words;
      EXPECT_FALSE(b.grab(at.back().x + right * unit, at.back().y + 6 * unit));
      b.settle();
      b.finish();
    };
    click("all keys", 20);
    EXPECT_FALSE(b.panel().help.empty());
    click("all keys", -10);  // the cap before the words
    EXPECT_TRUE(b.panel().help.empty());
    b.does({'w'});
    EXPECT_TRUE(b.isAsking());
    click("cancel", 3);
    EXPECT_FALSE(b.isAsking());
  }
}

// Table, shades and I0 change cells and indices. Then the window looks like a fresh start with them.
TEST(Workbench, TableChangesEqualAFreshStart) {
  ReadyWorkbench b;
  b.type("T");  // corrected
  b.update();
  b.type("o");
  b.press({NamedKey::Right, 0, true});
  b.type("c");
  b.press({NamedKey::Left, 0, true});
  EXPECT_EQ(b.stale(), Stale::Everything);
  b.update();
  EXPECT_NE(b.setup().picture.table.I0, 0.02);
  EXPECT_EQ(b.setup().picture.table.shades, 230);

  xnewell::Setup same;
  same.picture.table = b.setup().picture.table;
  ReadyWorkbench fresh{same};
  EXPECT_EQ(b.palette(), fresh.palette());
  const Rect& at = b.layout().picture;
  for (int j = at.y; j < at.y + at.height; ++j)
    ASSERT_TRUE(
        std::equal(b.image().row(j) + at.x, b.image().row(j) + at.x + at.width, fresh.image().row(j) + at.x))
        << j;
}

// Every key of a setting changes what is seen. Undo takes it back exactly, redo brings it again, and reset
// returns to the start.
TEST(Workbench, EveryKeyDoesSomethingAndIsUndone) {
  // With few shades of the corrected table, even a change of the rule that picks a shade can be seen.
  xnewell::Setup setup;
  setup.picture.table.kind = TableKind::Corrected, setup.picture.table.shades = 24;
  ReadyWorkbench b{setup};
  const auto seen = [&] {
    b.finish();
    return std::pair{withoutStatus(b), b.palette()};
  };
  const auto start = seen();
  const auto isUndone = [&](const Key& key, const auto& before) {
    SCOPED_TRACE(nameOf(key));
    b.press(key);
    const auto after = seen();
    EXPECT_NE(after, before);
    b.does('u');
    EXPECT_EQ(seen(), before);
    b.does('U');
    EXPECT_EQ(seen(), after);
    b.does('r');
    EXPECT_EQ(seen(), before);
  };
  for (const char key : std::string{"[]LVSOFPKTHBJ+-"}) isUndone(key, start);
  for (const char focus : std::string{"ipadncoltz"}) {
    SCOPED_TRACE(focus);
    b.does(focus);
    const auto focused = seen();
    EXPECT_NE(focused, start);
    isUndone(NamedKey::Left, focused);
    isUndone({NamedKey::Up, 0, true}, focused);
    if (focus == 'l' || focus == 't' || focus == 'z') continue;
    isUndone(NamedKey::Home, focused);
    isUndone(NamedKey::End, focused);
  }
  b.does('s');
  EXPECT_EQ(seen(), start);
  b.does(NamedKey::Tab);
  EXPECT_NE(seen(), start);
  b.does({NamedKey::Tab, 0, true});
  EXPECT_EQ(seen(), start);
}

// The list of all keys opens with `?` and closes with `?` or Esc. Then the window looks as it did before.
TEST(Workbench, HelpOpensAndCloses) {
  ReadyWorkbench b;
  const IndexImage start = withoutStatus(b);
  for (const Key close : {Key{'?'}, Key{NamedKey::Escape}}) {
    b.does('?');
    EXPECT_NE(withoutStatus(b), start);
    b.does(close);
    EXPECT_EQ(withoutStatus(b), start);
  }
}

// Drags add up: ten drags of 3 pixels turn the scene like one of 30, whether or not a frame is drawn between
// them.
TEST(Workbench, DragsAddUp) {
  ReadyWorkbench one, many;
  one.drag(30, 0);
  const Rect& at = many.layout().picture;
  ASSERT_TRUE(many.grab(at.x, at.y));
  for (int i = 1; i <= 10; ++i) {
    many.dragTo(at.x + 3 * i, at.y);
    if (i % 3 == 0) many.update();
  }
  const glm::dvec3 a = *one.setup().picture.camera.eye, b = *many.setup().picture.camera.eye;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
}

// At sizes from 1 x 1 up, every pixel is drawn. Where there is no room for the controls, the picture fills
// the window.
TEST(Workbench, EverySizeDraws) {
  for (const auto& [w, h] : {std::pair{1, 1},
                             {7, 900},
                             {800, 599},
                             {799, 600},
                             {800, 540},
                             {800, 539},
                             {1023, 767},
                             {1024, 768},
                             {1600, 1200},
                             {2500, 700}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    ReadyWorkbench b{{}, w, h};
    EXPECT_EQ(b.image().width, w);
    EXPECT_EQ(b.image().height, h);
    EXPECT_EQ(b.layout().roomy, w >= 800 && h >= 540);
    const Rect& at = b.layout().picture;
    EXPECT_EQ(intersection(at, {0, 0, w, h}), at);
    const Rect& status = b.layout().status;  // its words end before the margin
    for (int y = status.y + 1; y < status.y + status.height; ++y)
      EXPECT_EQ(std::ranges::count(b.image().row(y) + w - kMargin, b.image().row(y) + w, *b.image().row(y)),
                kMargin);
    b.type("?");
    b.update();
  }
}

// The frame after any keys is the frame of a fresh start with the same setup: nothing is left over from
// before.
TEST(Workbench, NothingLingers) {
  std::mt19937 rng{7};
  constexpr std::string_view kLetters = "ipadsnc0lLVSOFPKTHBJ[]uUr+-=?tz133hmgj";
  ReadyWorkbench b;
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    for (int k = 0; k < 6; ++k) {
      if (rng() % 3)
        b.press({NamedKey::Letter, kLetters[rng() % kLetters.size()]});
      else
        b.press({std::array{NamedKey::Left, NamedKey::Right, NamedKey::Up, NamedKey::Down, NamedKey::Home,
                            NamedKey::End, NamedKey::Tab}[rng() % 7],
                 0, rng() % 2 == 0});
      if (rng() % 2) b.update();
    }
    b.press({NamedKey::Escape});
    b.type("1");
    b.update();
    if (b.bench().list().find({0, 100})) b.press('h');  // the opening page stays until it is put away
    b.type("s");
    b.update();
    ReadyWorkbench fresh{b.setup()};
    fresh.type("s");
    fresh.update();
    EXPECT_EQ(b.palette(), fresh.palette());
    // The marks of the sliders' defaults differ, so only the part left of the controls is compared.
    const IndexImage x = withoutStatus(b), y = withoutStatus(fresh);
    for (int j = 0; j < x.height; ++j)
      ASSERT_TRUE(std::equal(x.row(j), x.row(j) + b.layout().controls.x - 8, y.row(j))) << j;
  }
}

// The camera keys never lead to a view that cannot be drawn. The test takes a thousand steps in each
// direction.
TEST(Workbench, TheCameraSurvivesAnyKeys) {
  ReadyWorkbench b{{}, 300, 200};
  for (const char mode : {'t', 'z'}) {
    b.type({&mode, 1});
    for (const NamedKey key : {NamedKey::Up, NamedKey::Left, NamedKey::Down, NamedKey::Right}) {
      for (int i = 0; i < 300; ++i) b.press({key, 0, true});
      EXPECT_NO_THROW(b.update());
      b.press({NamedKey::Letter, 'P'});
      EXPECT_NO_THROW(b.update());
    }
  }
}

// A z-buffer and the oracle have no polygons for the server to fill. So the choice falls back to the scanline
// filler, and the window says so. A BSP tree has polygons.
TEST(Workbench, OrdersBySampleFillNoPolygons) {
  ReadyWorkbench b;
  b.type("FF");
  EXPECT_EQ(b.setup().fill, Fill::Scanline);
  b.type("F");
  EXPECT_EQ(b.setup().fill, Fill::XFillPolygon);
  b.type("O");
  EXPECT_EQ(b.setup().picture.order, Order::Bsp);
  EXPECT_EQ(b.setup().fill, Fill::XFillPolygon);
  for (const Order order : {Order::ZBuffer16, Order::ZBuffer24, Order::ZBuffer32, Order::Oracle}) {
    b.type("O");
    EXPECT_EQ(b.setup().picture.order, order);
    EXPECT_EQ(b.setup().fill, Fill::Scanline);
  }
  b.type("F");
  EXPECT_EQ(b.setup().fill, Fill::Scanline);
  EXPECT_EQ(b.stale(), Stale::Everything);  // the status line tells why
}

// As soon as the shading interpolates, the server no longer fills, in any view and whichever way the shading
// was chosen.
TEST(Workbench, NoViewLeavesTheServerWhatItCannotFill) {
  for (const std::string_view keys : someOf({"S", "5AS", "5Agg", "5Sx", "5ASux", "5BSx1"}, 2)) {
    SCOPED_TRACE(keys);
    ReadyWorkbench b;
    b.type("FF");
    EXPECT_EQ(b.setup().fill, Fill::Scanline);
    b.type("F");
    b.update();
    ASSERT_TRUE(b.serverFills());
    for (const char key : keys) {
      b.type({&key, 1});
      b.finish();
    }
    b.type("1");
    b.finish();
    EXPECT_EQ(b.serverFills(), !rowOf(b.setup().picture.shading).interpolates);
    if (b.serverFills()) {
      EXPECT_EQ(b.picture().cells().size(), b.picture().snapped().faces.size());
    }
  }
}

// Wrong faces are not counted while the picture is dragged, and are counted afterwards.
TEST(Workbench, CountsWrongFacesWhenSettled) {
  ReadyWorkbench b;
  const IndexImage counted = b.image();
  b.drag(3, 3);
  b.settle();
  b.update();
  b.type("u");
  b.update();
  EXPECT_EQ(b.stale(), Stale::Nothing);  // nothing was left out
  b.drag(3, 3);
  b.update(true);
  b.settle();
  EXPECT_EQ(b.stale(), Stale::Everything);
  b.update();
  EXPECT_EQ(b.stale(), Stale::Nothing);
  b.type("u");
  b.update();
  EXPECT_TRUE(std::equal(counted.row(600), counted.row(663), b.image().row(600)));
}

// C gives what the view says, as comments of a shell, and the command of its set-up: of the picture, or of
// the window with another view. No command opens a lesson at a step, so there it is the picture's.
TEST(Workbench, AnyViewsSetupIsACommand) {
  std::vector<std::string> copied;
  Workbench b{readScene("teapot", 3), {}, {.copy = [&](const std::string& text) { copied.push_back(text); }}};
  b.resize(1024, 768);
  for (const ViewRow& row : kWindowViews) {
    SCOPED_TRACE(row.name);
    b.switchTo(row.id);
    b.update();
    b.change('S', [&](xnewell::Setup& s) { s.picture.shading = Shading::Phong; });
    b.press({NamedKey::Letter, 'C'});
    ASSERT_EQ(copied.size(), 1u);
    const bool picture = row.id == View::Picture || row.id == View::Lesson;
    const std::string begin = picture ? "xnewell draw teapot --size "
                                      : "xnewell snapshot teapot --size 1024x768 --whole-window --view " +
                                            std::string{row.name} + ' ';
    const std::size_t last = copied[0].rfind('\n') + 1;
    EXPECT_EQ(copied[0].find(begin), last) << copied[0];
    for (std::size_t at = 0; at < last; at = copied[0].find('\n', at) + 1)
      ASSERT_EQ(copied[0].substr(at, 2), "# ") << copied[0];
    const std::string_view found = [&] {
      switch (row.id) {
        case View::DepthSort:
          return "# start: nothing is painted\n";
        case View::Colors:
          return " stored levels distinct";
        case View::MachBands:
          return "\n# Bands: ";
        case View::SideBySide:
          return "\n# cuts   ";
        case View::Pixel:
          return " I = ka Ia + ";
        default:
          return "# ";
      }
    }();
    EXPECT_NE(copied[0].find(found), std::string::npos) << copied[0];
    EXPECT_NE(copied[0].find(" --divisions 3 --shade phong -o picture.png"), std::string::npos) << copied[0];
    copied.clear();
  }
}

// No key of the list of all keys runs into the words beside it.
TEST(Workbench, TheListOfAllKeysHasRoomForThem) {
  for (const ViewRow& row : kWindowViews) {
    ReadyWorkbench b;
    b.switchTo(row.id);
    b.finish();
    b.does('?');
    for (const HelpLine& line : helpOf(b.keys()))
      EXPECT_FALSE(findText(b.image(), line.keys + " ", b.plan()[Cell::Ink], 1, Voice::Bold).empty())
          << row.name << ": " << line.keys;
  }
}

}  // namespace xnewell::THIS_FILE
