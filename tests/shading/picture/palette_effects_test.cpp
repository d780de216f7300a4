#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shading/laboratory/profile.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "tests/support/full_color_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Effects of the palette

Picture made(const char* scene, ColorPlan plan, TableKind kind = TableKind::Corrected, int bits = 16) {
  PictureSettings s;
  s.width = 80, s.height = 60;
  s.colors = plan;
  s.table.kind = kind;
  s.table.bits = bits;
  return makePicture(readScene(scene, 3), s, CellPlan{kind}[Cell::Well]);
}

int largest(const Rgb16& c) { return std::max({c.r, c.g, c.b}); }
int least(const Rgb16& c) { return std::min({c.r, c.g, c.b}); }
int apart(const Rgb16& p, const Rgb16& q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

/// A ramp of one hue whose values never fall, some of them equal.
Palette rising(std::mt19937& rng, const CellRange& ramp) {
  std::vector<int> values;
  for (int k = 0; k < ramp.count; ++k) values.push_back(rng() % 4 ? static_cast<int>(rng() % 65536) : 9000);
  std::ranges::sort(values);
  Palette palette = scattered(7);
  for (int k = 0; k < ramp.count; ++k) {
    const auto v = static_cast<std::uint16_t>(values[k]);
    palette[ramp.first + k] = {v, static_cast<std::uint16_t>(v / 2), 0};
  }
  return palette;
}

// Turns of the ramp add up, a full turn changes nothing, and a turn by k moves colours only within the ramp:
// shade j gets what shade j - k had.
TEST(PaletteEffects, RotationsAreTurnsOfTheRamp) {
  for (const CellRange& ramp : {CellRange{11, 240}, {10, 240}, {11, 7}, {100, 1}})
    for (const int k : {0, 1, 5, -1, -13, 239, 240, 1000}) {
      SCOPED_TRACE(testing::Message() << ramp.count << " by " << k);
      const Palette start = scattered(1);
      Palette palette = start;
      rotate(palette, ramp, k);
      const int n = ramp.count;
      for (int cell = 0; cell < 256; ++cell) {
        const int from = ramp.has(cell) ? ramp.first + (((cell - ramp.first - k) % n) + n) % n : cell;
        ASSERT_EQ(palette[cell], start[from]) << cell;
      }
      EXPECT_EQ(palette == start, k % n == 0);
      rotate(palette, ramp, n - k % n);
      EXPECT_EQ(palette, start);
    }
}

// A turn of the hue by 120 degrees makes the channels change places exactly, and a turn by 360 changes
// nothing. At every angle the largest and the least channel stay, gray stays, and turning back leads back to
// within rounding.
TEST(PaletteEffects, HueTurnsRoundTheHexagon) {
  int moved = 0;
  for (const Rgb16& c : scattered(2)) {
    EXPECT_EQ(hueTurned(c, 120), (Rgb16{c.b, c.r, c.g}));
    EXPECT_EQ(hueTurned(c, -120), (Rgb16{c.g, c.b, c.r}));
    EXPECT_EQ(hueTurned(c, 360), c);
    for (const double degrees : {1.0, 47.5, 180.0, -300.0}) {
      const Rgb16 turned = hueTurned(c, degrees);
      EXPECT_EQ(largest(turned), largest(c));
      EXPECT_EQ(least(turned), least(c));
      EXPECT_LE(apart(hueTurned(turned, -degrees), c), 1);
      moved += turned != c;
    }
    EXPECT_EQ(hueTurned({c.r, c.r, c.r}, 33), (Rgb16{c.r, c.r, c.r}));
  }
  EXPECT_GT(moved, 1000);
  EXPECT_EQ(hueTurned({65535, 0, 0}, 60), (Rgb16{65535, 65535, 0}));  // amber lies between red and green
}

// Gamma is the power, to the last of 16 bits except for rounding. 1 changes no value, black and full
// intensity stay, and order is kept.
TEST(PaletteEffects, GammaIsThePower) {
  for (int v = 0; v < 65536; ++v) {
    const auto u = static_cast<std::uint16_t>(v);
    ASSERT_EQ(gammaCorrected({u, 0, u}, 1.0), (Rgb16{u, 0, u}));
  }
  for (const double gamma : {kLeastGamma, 0.45, 1.8, 2.2, kMostGamma}) {
    SCOPED_TRACE(gamma);
    EXPECT_EQ(gammaCorrected({0, 65535, 0}, gamma), (Rgb16{0, 65535, 0}));
    int before = 0;
    for (int v = 0; v < 65536; v += 17) {
      const int now = gammaCorrected({static_cast<std::uint16_t>(v), 0, 0}, gamma).r;
      ASSERT_NEAR(now, 65535 * std::pow(v / 65535.0, 1 / gamma), 0.5 + 1e-6) << v;
      ASSERT_GE(now, before);
      before = now;
    }
  }
}

// A rising curve that is dragged goes through the point, still rises, keeps its brightest shade and touches
// no other cell. If it is dragged to where it is, nothing changes.
TEST(PaletteEffects, BentCurvesStillRise) {
  std::mt19937 rng{5};
  int bent = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const CellRange ramp{11, 2 + static_cast<int>(rng() % 239)};
    const Palette start = rising(rng, ramp);
    Palette palette = start;
    const CurvePoint point{ramp.first + static_cast<int>(rng() % ramp.count),
                           static_cast<double>(rng() % 256)};
    bend(palette, ramp, point);
    const int end = largest(start[ramp.last()]), asked = static_cast<int>(std::lround(257 * point.value));
    EXPECT_NEAR(largest(palette[point.cell]), std::min(asked, end), 1);
    if (point.cell != ramp.last()) {
      EXPECT_EQ(palette[ramp.last()], start[ramp.last()]);
    }
    for (int cell = 0; cell < 256; ++cell) {
      if (!ramp.has(cell)) {
        ASSERT_EQ(palette[cell], start[cell]) << cell;
      } else if (cell > ramp.first) {
        ASSERT_GE(palette[cell].r, palette[cell - 1].r) << cell;
        ASSERT_GE(palette[cell].g, palette[cell - 1].g) << cell;
      }
    }
    bent += palette != start;
    palette = start;
    bend(palette, ramp, {point.cell, largest(start[point.cell]) / 257.0});
    EXPECT_EQ(palette, start);
  }
  EXPECT_GT(bent, 250);
}

// Effects on the scene's colours leave the tool's sixteen colours alone, in every plan that allows it. No
// effect changes nothing.
TEST(PaletteEffects, LeaveTheToolAlone) {
  const std::array effects{PaletteEffects{.stored = TableKind::Brief},
                           PaletteEffects{.hueTurn = 77},
                           PaletteEffects{.gamma = 2.2},
                           PaletteEffects{.bend = CurvePoint{60, 200}},
                           PaletteEffects{.rotate = 9},
                           PaletteEffects{.lit = 60}};
  for (const auto& [scene, plan] : {std::pair{"teapot", ColorPlan::OneHue}, {"hues", ColorPlan::Hues}}) {
    const Picture picture = made(scene, plan);
    const CellPlan cells{TableKind::Corrected};
    const Palette start = picture.palette(cells);
    EXPECT_EQ(withEffects(start, picture, cells, {}), start);
    for (std::size_t k = 0; k < effects.size(); ++k) {
      SCOPED_TRACE(k);
      const Palette after = withEffects(start, picture, cells, effects[k]);
      EXPECT_NE(after, start);
      EXPECT_EQ(withInterface(after, cells), after);
    }
  }
}

// Lighting a shade stores one cell, and the pixels that change are those that show it.
TEST(PaletteEffects, LightOneCell) {
  const Picture picture = made("teapot", ColorPlan::OneHue);
  const Palette start = picture.palette(CellPlan{TableKind::Corrected});
  for (const int lit : {11, 148, 250}) {
    const Palette after = withEffects(start, picture, CellPlan{TableKind::Corrected}, {.lit = lit});
    for (int cell = 0; cell < 256; ++cell) ASSERT_EQ(after[cell], cell == lit ? kLit : start[cell]);
  }
}

// If another table is stored while indices are held, each cell that both tables fill gets the other one's
// colour. Each cell that only the first fills keeps its own, as XStoreColors leaves it. Storing the same
// table changes nothing.
TEST(PaletteEffects, StoringAnotherTableFillsItsCells) {
  for (const TableRow& indices : kTables)
    for (const TableRow& stored : kTables) {
      SCOPED_TRACE(std::string{indices.name} + ' ' + std::string{stored.name});
      const Picture picture = made("teapot", ColorPlan::OneHue, indices.id);
      const CellPlan plan{indices.id};
      const Palette start = picture.palette(plan);
      const Palette after = withEffects(start, picture, plan, {.stored = stored.id});
      const ColorTable other{{.kind = stored.id}};
      int taken = 0, kept = 0;
      for (int cell = indices.first; cell < indices.first + kMaxShades; ++cell) {
        const int j = cell - stored.first;
        const bool both = j >= 0 && j < kMaxShades;
        ASSERT_EQ(after[cell], both ? other.color(j) : start[cell]) << cell;
        (both ? taken : kept) += 1;
      }
      // The two linear tables begin one cell apart.
      EXPECT_EQ(kept, indices.first != stored.first);
      EXPECT_GE(taken, 239);
      EXPECT_EQ(withInterface(after, plan), after);
      if (indices.id == stored.id) {
        EXPECT_EQ(after, start);
      }
    }
}

// An effect that needs a ramp is refused if there is none, and so is a cell that is not the scene's. Other
// effects work.
TEST(PaletteEffects, RefuseWhatMakesNoSense) {
  const CellPlan cells{TableKind::Corrected};
  const auto complaint = [&](const Picture& picture, const PaletteEffects& effects) -> std::string {
    try {
      static_cast<void>(withEffects(picture.palette(cells), picture, cells, effects));
    } catch (const ViewError& e) {
      return e.what();
    }
    return "";
  };
  for (const ColorPlan plan : {ColorPlan::Cube, ColorPlan::Chosen}) {
    const Picture picture = made("hues", plan);
    for (const PaletteEffects& effects :
         {PaletteEffects{.stored = TableKind::Brief}, PaletteEffects{.bend = CurvePoint{60, 1}},
          PaletteEffects{.rotate = 1}})
      EXPECT_NE(complaint(picture, effects).find("needs a ramp"), std::string::npos);
    EXPECT_EQ(complaint(picture, {.hueTurn = 5, .gamma = 2, .lit = 60}), "");
  }
  const Picture teapot = made("teapot", ColorPlan::OneHue);
  EXPECT_EQ(complaint(teapot, {.lit = 10}), "cell 10 is not one of the scene's: choose one of 11 to 250");
  EXPECT_EQ(complaint(teapot, {.bend = CurvePoint{251, 3}}),
            "cell 251 is in no ramp: choose one of 11 to 250");
}

// A table of 8 bits keeps 8 bits after effects too: each value is 257 times a byte.
TEST(PaletteEffects, EightBitsStayEight) {
  for (const int bits : {8, 16}) {
    const Picture picture = made("teapot", ColorPlan::OneHue, TableKind::Corrected, bits);
    const CellPlan plan{TableKind::Corrected};
    const Palette plain = picture.palette(plan);
    const Palette palette = withEffects(plain, picture, plan, {.gamma = 1.4, .bend = CurvePoint{100, 33.3}});
    int odd = 0;
    for (int cell = 11; cell <= 250; ++cell) odd += palette[cell].r % 257 != 0;
    EXPECT_EQ(odd > 0, bits == 16);
    EXPECT_NE(palette, plain);
  }
}

// On gray screens one hue shows as its intensity, and several hues as their brightness. The tool's cells
// stay.
TEST(PaletteEffects, GraysForGrayScreens) {
  for (const auto& [scene, colors] : {std::pair{"teapot", ColorPlan::OneHue}, {"hues", ColorPlan::Hues}}) {
    const Picture picture = made(scene, colors, TableKind::Linear);
    const CellPlan plan{TableKind::Linear};
    const Palette plain = picture.palette(plan), gray = forGrayScreen(plain, picture);
    for (int cell = 0; cell < 256; ++cell) {
      const Rgb16 c = plain[cell], g = gray[cell];
      if (cell < 11 || cell > 250) {
        EXPECT_EQ(g, c) << cell;
        continue;
      }
      EXPECT_EQ(g.r, g.g);
      EXPECT_EQ(g.g, g.b);
      if (colors == ColorPlan::OneHue)
        EXPECT_EQ(g.r, c.r) << cell;
      else
        EXPECT_NEAR(g.r, 0.30 * c.r + 0.59 * c.g + 0.11 * c.b, 1) << cell;
    }
  }
}

/// ---- Ambient light

constexpr std::uint8_t kGround = 3;

/// A ball, a torus and a card with a texture. `kd` is that of all of them; ks is 0.
Scene solids(const std::string& light, const std::string& kd, bool colored) {
  const std::string first = colored ? R"("color": [1, 0.4, 0.1], )" : "";
  const std::string text = R"({"up": "z", "ambient": 0.47, "lights": [)" + light +
                           R"(], "materials": {"ball": {)" + first + R"("ks": 0, "ka": 0.83, "kd": )" + kd +
                           R"(}, "torus": {"ks": 0, "ka": 0.31, "kd": )" + kd +
                           R"(}, "card": {"ks": 0, "texture": "textures/checks.png", "kd": )" + kd + R"(}},
    "objects": [{"solid": "sphere", "material": "ball"},
      {"solid": "torus", "material": "torus", "move": [0.5, 0.3, 0.8], "rotate": [30, 0, 0]},
      {"polygons": [[[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]]],
       "uv": [[[0, 0], [1, 0], [1, 1], [0, 1]]], "material": "card"}]})";
  return parseSceneFile(text, "solids", XNEWELL_DATA_DIR);
}

constexpr std::string_view kSun = R"({"Ip": 0.5, "towards": [0, -1, 1]})";
constexpr std::string_view kLamp =
    R"({"kind": "point", "Ip": 0.5, "at": [0, 0, 4], "attenuation": "inverse"})";
constexpr std::string_view kSpot =
    R"({"kind": "spot", "Ip": 0.5, "at": [0, 0, 4], "shines": [0, 0, -1], "inner": 5, "outer": 40})";

/// A coefficient that changes no bit of any sum, but asks for all that a light needs.
constexpr const char* kAlmostNothing = "1e-300";

// Where kd = ks = 0 there are no normals, and the picture is the same to the bit as one that computes them.
TEST(AmbientLight, ShowsTheSameWithoutNormals) {
  int pictures = 0;
  for (const std::string_view light : {kSun, kLamp, kSpot})
    for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
      for (const Form form : {Form::Textbook, Form::HalfVector, Form::Tutorial})
        for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Hues, ColorPlan::Chosen})
          for (const TableKind table : {TableKind::Linear, TableKind::Corrected}) {
            SCOPED_TRACE(testing::Message() << light << ' ' << rowOf(method).name << ' ' << int(form) << ' '
                                            << int(plan) << ' ' << int(table));
            PictureSettings s;
            s.width = 90, s.height = 70;
            s.shading = method, s.light.form = form, s.colors = plan, s.table.kind = table;
            const bool colored = plan != ColorPlan::OneHue || pictures % 2 == 0;
            const Picture with =
                PictureCache{solids(std::string{light}, kAlmostNothing, colored)}.make(s, kGround);
            const Picture without = PictureCache{solids(std::string{light}, "0", colored)}.make(s, kGround);
            ASSERT_FALSE(with.shading().points().N.empty());
            ASSERT_TRUE(without.shading().points().N.empty() &&
                        without.shading().vertices().vertices.empty());
            ASSERT_EQ(with.image().pixels, without.image().pixels);
            ASSERT_EQ(with.palette(CellPlan{table}), without.palette(CellPlan{table}));
            ASSERT_EQ(with.cells(), without.cells());
            ASSERT_EQ(with.saturated(), without.saturated());
            const SeenRows rows = with.seen(0, s.height);
            for (int c = 0; c < with.shading().lighting().channels; ++c) {
              const std::vector<double> a = with.intensities(rows, c), b = without.intensities(rows, c);
              for (std::size_t k = 0; k < a.size(); ++k) ASSERT_TRUE(a[k] == b[k] || a[k] != a[k]);
            }
            ++pictures;
          }
  EXPECT_EQ(pictures, 3 * 3 * 3 * 3 * 2);
}

// What shows normals or asks for them shows the same: the view of normals, and the surfaces that a scanline
// crosses.
TEST(AmbientLight, NormalsAreThereForWhoAsks) {
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
    for (const double crease : {180.0, 20.0}) {
      PictureSettings s;
      s.width = 90, s.height = 70;
      s.shading = method, s.crease = crease;
      const Picture with = makePicture(solids(std::string{kSun}, kAlmostNothing, false), s, kGround);
      const Picture without = makePicture(solids(std::string{kSun}, "0", false), s, kGround);
      const SeenRows rows = with.seen(0, s.height);
      ASSERT_EQ(with.normals(rows), without.normals(rows));
      const int row = defaultScanline(with);
      const Scanline a = scanlineOf(with, row, kGround), b = scanlineOf(without, row, kGround);
      ASSERT_GT(a.edges, 0);
      ASSERT_EQ(a.edges, b.edges);
      for (std::size_t k = 0; k < a.profiles.size(); ++k) ASSERT_EQ(a.profiles[k].cells, b.profiles[k].cells);
    }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
