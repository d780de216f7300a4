#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

/// A cube that reflects the ambient light as it is: all of it has the intensity Ia.
Scene evenCube(bool textured) {
  Mesh mesh = cube();
  mesh.materials = {{.name = "", .ka = 1, .kd = 0, .ks = 0}};
  std::ranges::fill(mesh.material, 0);
  if (textured) {
    mesh.materials[0].texture = 0;
    mesh.uv = {{0.5, 0.5}};
    mesh.uvOfCorner.assign(mesh.corners.size(), 0);
  }
  Scene scene = makeScene("even", mesh, UpAxis::Z);
  if (textured) {
    Texture white{.width = 1, .height = 1, .channel = {}, .gray = {255}};
    white.channel.fill({255});
    scene.textures = {white};
  }
  return scene;
}

/// The rule, said once more: the nearest of the intensities that the shades stand for, half way the brighter.
int cellByTheRule(const ColorTable& table, double I) {
  if (table.settings().kind != TableKind::Corrected)
    return static_cast<int>(table.first() + 0.5 + (table.shades() - 1) * I);
  const long double x = I;
  int shade = 0;
  for (; shade + 1 < table.shades(); ++shade) {
    const long double below = table.level(shade), above = table.level(shade + 1);
    if (table.settings().pick == Pick::Log ? x * x < below * above : x - below < above - x) break;
  }
  return table.first() + shade;
}

/// Intensities close to where one cell ends and the next begins: by 2^-14 of a cell where single precision
/// rounds the value, and for `corrected` as close as single precision and the steps of a value allow.
std::vector<double> closeToEnds(const ColorTable& table) {
  std::vector<double> I{0.0, 1.0};
  for (int j = 0; j + 1 < table.shades(); ++j) {
    const double end = table.picked(j).to;
    const double apart = table.settings().kind != TableKind::Corrected ? 0x1p-14 / (table.shades() - 1)
                                                                       : 0x1p-22 * end + 0x1p-31;
    I.insert(I.end(), {end - apart, end + apart});
  }
  return I;
}

}  // namespace

// Every filler gives the same cell to the same intensity: flat shading, whose cells XFillPolygon takes too,
// Gouraud shading over triangles and by rows, Phong shading, textures and environment maps.
TEST(CellRule, IsOneForEveryFiller) {
  struct Filler {
    const char* name;
    Shading shading;
    Polygons polygons;
    bool textured;
  };
  for (const Filler& filler : {Filler{"flat", Shading::Flat, {}, false},
                               {"Gouraud", Shading::Gouraud, Polygons::Triangles, false},
                               {"Gouraud by rows", Shading::Gouraud, Polygons::Rows, false},
                               {"Phong", Shading::Phong, {}, false},
                               {"environment", Shading::Environment, {}, false},
                               {"flat, textured", Shading::Flat, {}, true},
                               {"Gouraud, textured", Shading::Gouraud, {}, true},
                               {"Phong, textured", Shading::Phong, {}, true}})
    for (const TableSettings& of : {TableSettings{.kind = TableKind::Brief},
                                    {.kind = TableKind::Linear},
                                    {.kind = TableKind::Corrected},
                                    {.kind = TableKind::Corrected, .I0 = 1e-6}})
      for (const int shades : {2, 61, 240}) {
        if (kSanitized && shades != 61) continue;
        SCOPED_TRACE(std::string{filler.name} + ' ' +
                     std::string{kTables[static_cast<std::size_t>(of.kind)].name} + ' ' +
                     std::to_string(shades) + ' ' + std::to_string(of.I0));
        PictureCache pictures{evenCube(filler.textured)};
        PictureSettings s;
        s.width = 32, s.height = 24;
        s.shading = filler.shading, s.polygons = filler.polygons;
        s.order = Order::ZMean;
        s.table = of;
        s.table.shades = shades;
        const ColorTable table{s.table};
        int samples = 0;
        for (const double I : closeToEnds(table)) {
          s.light.Ia = I, s.light.Ip = 0;
          const Picture picture = pictures.make(s, 0);
          for (const std::uint8_t cell : picture.image().pixels) {
            if (cell == 0) continue;
            ASSERT_EQ(cell, cellByTheRule(table, I)) << I;
            ++samples;
          }
          for (const std::uint8_t cell : picture.cells()) ASSERT_EQ(cell, cellByTheRule(table, I)) << I;
        }
        EXPECT_GT(samples, 100 * shades);
      }
}

// Next to each threshold of a table, and on it, TableCells finds what the rule says, whatever number stands
// for the intensity. Only so close to the threshold as color_table.h bounds its error may it find the other.
TEST(CellRule, TableCellsAreExact) {
  int checked = 0;
  for (const double I0 : {1e-300, 1e-40, 1e-6, 1e-3, 0.02, 0.3, 0.999})
    for (const int shades : {2, 64, 240})
      for (const PickRow& pick : kPicks) {
        SCOPED_TRACE(std::to_string(I0) + ' ' + std::to_string(shades) + ' ' + std::string{pick.name});
        const ColorTable table{{.kind = TableKind::Corrected, .shades = shades, .I0 = I0, .pick = pick.id}};
        const TableCells cells{table};
        const auto expectCell = [&](double I, int cell) {
          ++checked;
          if (cell == cellByTheRule(table, I)) return;
          const double end = table.picked(std::min(cell, cellByTheRule(table, I)) - table.first()).to;
          EXPECT_LE(std::abs(I - end), (5 * shades + 9) * 0x1p-53 * end) << I << ' ' << cell;
        };
        const auto floats = [&](float I) { return cells.cells(Lanes<float, 4>{I, I, I, I})[2]; };
        for (const double I : {0.0, 1.0, 2.0}) {
          EXPECT_EQ(cells.cell(I), cellByTheRule(table, I));
          EXPECT_EQ(floats(static_cast<float>(I)), cellByTheRule(table, I));
        }
        EXPECT_EQ(floats(NAN), table.first());
        EXPECT_EQ(cells.cell(NAN), table.first());
        for (int j = 0; j + 1 < shades; ++j) {
          const double end = table.picked(j).to;
          for (double I : {std::nextafter(end, 0.0), end, std::nextafter(end, 2.0)})
            expectCell(I, cells.cell(I));
          const auto near = static_cast<float>(end);
          for (float I : {std::nextafter(near, 0.0F), near, std::nextafter(near, 2.0F)})
            expectCell(I, floats(I));
          const auto steps = static_cast<std::uint32_t>((0.5 + 255 * end) * 0x1p24);
          for (const std::uint32_t v : {steps - 1, steps, steps + 1, steps + 2})
            expectCell(std::max(0.0, (v * 0x1p-24 - 0.5) / 255), cells.bySteps()(v));
        }
      }
  EXPECT_GT(checked, 40'000);
}

}  // namespace xnewell::THIS_FILE
