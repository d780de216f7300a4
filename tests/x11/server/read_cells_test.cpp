#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "shading/color/palette.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/program_picture.h"
#include "tests/x11/support/x_server.h"

namespace xnewell::THIS_FILE {

// PNG files hold the picture's cells: the same numbers and colours, whether drawn or read back from a server.

namespace {

/// A palette PNG as it is stored: the cell numbers row by row, and what the cells hold.
struct StoredPng {
  int width = 0, height = 0;
  std::vector<std::uint8_t> cells, palette;  ///< palette: 768 bytes; empty where the file has none
};
StoredPng storedPng(const std::string& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input{std::fopen(file.c_str(), "rb"), &std::fclose};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, input.get());
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  StoredPng stored{static_cast<int>(png_get_image_width(png, info)),
                   static_cast<int>(png_get_image_height(png, info)),
                   {},
                   {}};
  if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) {
    for (int j = 0; j < stored.height; ++j) {
      const png_bytep row = png_get_rows(png, info)[j];
      stored.cells.insert(stored.cells.end(), row, row + stored.width);
    }
    png_colorp colors = nullptr;
    int count = 0;
    png_get_PLTE(png, info, &colors, &count);
    for (int c = 0; c < count; ++c)
      stored.palette.insert(stored.palette.end(), {colors[c].red, colors[c].green, colors[c].blue});
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return stored;
}

std::string made(const TemporaryFolder& folder, const std::string& name, const std::string& line,
                 const std::string& display = "") {
  const Finished done = runProgram(words(line) + Strings{"-o", folder.file(name)}, display);
  EXPECT_EQ(done.status, 0) << line << ": " << done.err;
  return folder.file(name);
}

const std::array kEffects{
    "--rotate 30", "--rotate -100",  "--lit 148",     "--gamma 2.2",
    "--turn 120",  "--bend 100,200", "--store brief", "--store corrected --gamma 0.5 --lit 20"};

}  // namespace

// A snapshot writes the same file as `draw`, byte for byte, with a real colormap or an emulated one. A
// picture of 240 shades needs all 256 cells, although many shades look the same at 8 bits. Views and effects
// are the same too.
TEST(ReadCells, SnapshotsAreTheFilesThatAreDrawn) {
  const XServer eight = XServer::xvfb(8), deep = XServer::xvfb(24);
  const TemporaryFolder folder;
  for (const std::string line :
       {"teapot --divisions 4", "teapot --divisions 3 --table corrected --bits 8 --shade gouraud",
        "teapot --divisions 3 --table brief --size 99x77 --lit 60 --rotate 20", "hues --size 200x150",
        "hues --colors cube --size 200x150", "teapot --divisions 4 --table corrected --view colours",
        "hues --colors chosen --view colours --size 1024x768 --gamma 1.8"}) {
    SCOPED_TRACE(line);
    const std::string drawn = contents(made(folder, "drawn.png", "draw " + line));
    EXPECT_EQ(drawn[25], 3);  // IHDR: colour type, by palette
    EXPECT_EQ(contents(made(folder, "8.png", "snapshot --visual PseudoColor8 " + line, eight.name())), drawn);
    EXPECT_EQ(contents(made(folder, "24.png", "snapshot --visual TrueColor24 " + line, deep.name())), drawn);
  }
}

// What the server filled is read back as cells too. On a real colormap, shades that look the same are told
// apart: inside the outlines each sample has the cell that our own filler gives it. Decoded, the file is the
// picture that the other server shows.
TEST(ReadCells, TellEqualColorsApart) {
  const XServer eight = XServer::xvfb(8), deep = XServer::xvfb(24);
  const TemporaryFolder folder;
  const std::string line = "teapot --divisions 8 --table corrected --bits 8 --ia 0.02 --ip 0.15";
  const std::string filled = made(folder, "x.png", "snapshot --fill x11 " + line, eight.name());
  const StoredPng ours = storedPng(made(folder, "d.png", "draw " + line)), served = storedPng(filled);
  ASSERT_EQ(served.cells.size(), ours.cells.size());
  EXPECT_EQ(served.palette, ours.palette);
  const auto color = [&](std::uint8_t cell) { return ours.palette[3 * cell]; };
  int painted = 0, same = 0, twins = 0;
  for (std::size_t k = 0; k < ours.cells.size(); ++k) {
    const std::uint8_t cell = ours.cells[k];
    if (cell < 11) continue;
    ++painted;
    same += served.cells[k] == cell;
    twins += cell > 11 && color(cell) == color(cell - 1);
  }
  EXPECT_GT(painted, 30'000);
  EXPECT_GT(same, painted * 9 / 10);
  EXPECT_LT(same, painted);        // outlines have the cells of the server
  EXPECT_GT(twins, painted / 20);  // here the first cell of that colour would be wrong
  EXPECT_EQ(readPng(made(folder, "y.png", "snapshot --fill x11 " + line, deep.name())), readPng(filled));
}

// An effect changes the palette of the file but no cell number, and leaves the tool's sixteen colours alone.
TEST(ReadCells, EffectsChangeNoCell) {
  const TemporaryFolder folder;
  const std::string line = "draw teapot --divisions 3 --size 160x120 --shade gouraud --table ";
  for (const std::string table : {"linear", "corrected"}) {
    const StoredPng plain = storedPng(made(folder, "plain.png", line + table));
    for (const std::string effect : kEffects) {
      SCOPED_TRACE(table + ' ' + effect);
      const StoredPng changed = storedPng(made(folder, "changed.png", line + table + ' ' + effect));
      EXPECT_EQ(changed.cells, plain.cells);
      if (table != "linear" || effect != "--store brief") {  // these hold the same in the same cells
        EXPECT_NE(changed.palette, plain.palette);
      }
      for (int role = 0; role < kCells; ++role) {
        const int cell = CellPlan{}[static_cast<Cell>(role)];
        EXPECT_TRUE(
            std::equal(&plain.palette[3 * cell], &plain.palette[3 * cell] + 3, &changed.palette[3 * cell]));
      }
    }
  }
}

// A command that makes no sense is refused in one line, and nothing is written.
TEST(ReadCells, EffectsAreRefusedWhereTheyMakeNoSense) {
  const TemporaryFolder folder;
  const std::string file = folder.file("no.png");
  const auto refused = [&](const std::string& line) {
    const Finished done = runProgram(words(line) + Strings{"-o", file});
    EXPECT_EQ(done.status, 2) << line;
    return done.err;
  };
  EXPECT_EQ(refused("draw hues --colors cube --rotate 3"),
            "xnewell: rotating needs a ramp: the cells of this picture hold single colours\n");
  EXPECT_EQ(refused("draw teapot --lit 8"),
            "xnewell: cell 8 is not one of the scene's: choose one of 11 to 250\n");
  EXPECT_EQ(refused("draw teapot --view normals --gamma 2"),
            "xnewell: --gamma works only with --view picture and colours\n");
  EXPECT_EQ(refused("draw teapot --cell 3"), "xnewell: --cell works only with --view colours\n");
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace xnewell::THIS_FILE
