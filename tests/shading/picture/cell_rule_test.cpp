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

/// The rule, said once more. Linear tables: the nearest shade. `corrected`: the shade for the middle of those
/// intensities that have the same sixteen bits, of which the first and the last two are not used.
int cellByTheRule(const ColorTable& table, double I) {
  if (table.settings().kind != TableKind::Corrected)
    return static_cast<int>(table.first() + 0.5 + (table.shades() - 1) * I);
  return table.cell((std::clamp(std::floor(65536 * I), 1.0, 65533.0) + 0.5) / 65536);
}

/// Intensities close to where one cell ends and the next begins: by 2^-14 of a cell where single precision
/// rounds the value, and where sixteen bits are looked up as close as single precision can be. There, too,
/// those at which the index would be another if it were a share of 65,535.
std::vector<double> closeToEnds(const ColorTable& table) {
  std::vector<double> I{0.0, 1.0};
  for (int j = 0; j + 1 < table.shades(); ++j) {
    const double end = table.picked(j).to;
    if (table.settings().kind != TableKind::Corrected) {
      const double apart = 0x1p-14 / (table.shades() - 1);
      I.insert(I.end(), {end - apart, end + apart});
    } else {
      const double k = std::ceil(65536 * end - 0.5);
      I.insert(I.end(), {k / 65536, k / 65536 - 0x1p-24, (k + 0.5) / 65536});
    }
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
    for (const TableRow& row : kTables)
      for (const int shades : {2, 61, 240}) {
        if (kSanitized && shades != 61) continue;
        SCOPED_TRACE(std::string{filler.name} + ' ' + std::string{row.name} + ' ' + std::to_string(shades));
        PictureCache pictures{evenCube(filler.textured)};
        PictureSettings s;
        s.width = 32, s.height = 24;
        s.shading = filler.shading, s.polygons = filler.polygons;
        s.order = Order::ZMean;
        s.table = {.kind = row.id, .shades = shades};
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

// The table by sixteen bits is the colour table's own choice at the middle of each step.
TEST(CellRule, TablesHoldTheCellsOfTheMiddles) {
  for (const TableRow& row : kTables)
    for (const double I0 : {1e-6, 0.02, 0.5})
      for (const int shades : {2, 64, 240})
        for (const PickRow& pick : kPicks) {
          const ColorTable table{{.kind = row.id, .shades = shades, .I0 = I0, .pick = pick.id}};
          const std::vector<std::uint8_t> cells = cellsBy16Bits(table);
          ASSERT_EQ(cells.size(), 65536u);
          for (int k = 0; k < 65536; ++k) ASSERT_EQ(cells[k], table.cell((k + 0.5) / 65536)) << k;
        }
}

}  // namespace xnewell::THIS_FILE
