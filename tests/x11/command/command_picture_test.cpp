#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <set>

#include "geometry/exact/unit.h"
#include "geometry/files/obj.h"
#include "geometry/model/solids.h"
#include "tests/support/seeds.h"
#include "tests/support/triangle_soup.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

/// What the program draws: the face image against an independent decision, the meaning of each option, and
/// extreme scenes and cameras.

namespace {

using DrawnPicture = CommandTest;

/// A polygon in a plane of constant z.
struct Sheet {
  std::vector<glm::dvec2> outline;
  double z;
  bool clockwise;                   ///< seen from +z
  glm::dvec2 low{1e9}, high{-1e9};  ///< the box around the outline
};

/// Stars of 3 to 12 corners, most of them concave, some far larger than the picture, each at its own z, in
/// random order.
std::vector<Sheet> sheets(unsigned seed, int count) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  std::vector<Sheet> all;
  for (int k = 0; k < count; ++k) {
    Sheet sheet{{}, std::remainder(k * 7 + 0.5, count) / count, unit(rng) < 0.5};
    const int corners = 3 + static_cast<int>(unit(rng) * 10);
    const glm::dvec2 centre{3 * unit(rng) - 1.5, 3 * unit(rng) - 1.5};
    const double radius = k % 16 == 0 ? 4000 : 0.7;
    const glm::dvec2 around = k % 16 == 0 ? glm::dvec2{centre.x + radius * 0.5, centre.y} : centre;
    for (int c = 0; c < corners; ++c) {
      const double a = 2 * 3.14159265358979 * c / corners, r = radius * (0.25 + 0.75 * unit(rng));
      const glm::dvec2 p = sheet.outline.emplace_back(around + r * glm::dvec2{std::cos(a), std::sin(a)});
      sheet.low = glm::min(sheet.low, p), sheet.high = glm::max(sheet.high, p);
    }
    if (sheet.clockwise) std::ranges::reverse(sheet.outline);
    all.push_back(sheet);
  }
  return all;
}

std::string objOf(const std::vector<Sheet>& all) {
  std::string text;
  for (const Sheet& s : all) {
    for (const glm::dvec2& p : s.outline)
      text += "v " + number(p.x) + " " + number(p.y) + " " + number(s.z) + "\n";
    text += "f";
    for (int back = static_cast<int>(s.outline.size()); back > 0; --back) text += " -" + std::to_string(back);
    text += "\n";
  }
  return text;
}

enum class Where { In, Out, TooNear };

/// Counts the crossings of a ray. A point within `margin` of an edge is too near.
Where where(const std::vector<glm::dvec2>& outline, glm::dvec2 p, double margin) {
  bool in = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    const glm::dvec2 off = a + t * (b - a) - p;
    if (glm::dot(off, off) < margin * margin) return Where::TooNear;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in ? Where::In : Where::Out;
}

/// The ids of a picture of sheets seen from (0, 0, eye) along -z. `slope` is half the picture's height: at
/// unit distance in perspective, at every distance in a parallel picture.
void expectSheets(const RgbImage& ids, const std::vector<Sheet>& all, double eye, double slope,
                  bool perspective, bool culled) {
  int decided = 0, hidden = 0;
  for (int j = 0; j < ids.height; ++j)
    for (int i = 0; i < ids.width; ++i) {
      int front = -1;
      bool near = false;
      for (int k = 0; k < std::ssize(all) && !near; ++k) {
        if (culled && all[k].clockwise) continue;
        const double half = perspective ? slope * (eye - all[k].z) : slope, pixel = 2 * half / ids.height;
        const glm::dvec2 p{(i + 0.5 - ids.width / 2.0) * pixel, (ids.height / 2.0 - j - 0.5) * pixel};
        const double margin = 1e-3 * pixel;  // vertices move by up to 2^-17 pixel
        if (p.x < all[k].low.x - margin || p.x > all[k].high.x + margin || p.y < all[k].low.y - margin ||
            p.y > all[k].high.y + margin)
          continue;
        const Where w = where(all[k].outline, p, margin);
        near = w == Where::TooNear;
        if (w != Where::In) continue;
        hidden += front >= 0;
        if (front < 0 || all[k].z > all[front].z) front = k;
      }
      if (near) continue;
      ++decided;
      ASSERT_EQ(idAt(ids, i, j), front + 1) << i << ", " << j;
    }
  EXPECT_GT(decided, ids.width * ids.height * 9 / 10);
  EXPECT_GT(hidden, 1000);
}

std::set<int> colorsOf(const RgbImage& image) {
  std::set<int> colors;
  for (const auto& [color, count] : idCounts(image)) colors.insert(color);
  return colors;
}

int covered(const RgbImage& ids) { return ids.width * ids.height - idCounts(ids)[0]; }

}  // namespace

// The face image names the frontmost face at each sample away from edges. This holds in parallel and in
// perspective pictures, with triangulation, clipping and culling.
TEST_F(DrawnPicture, IdsNameTheFaceInFront) {
  const Seeds seeds{4};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Sheet> all = sheets(seed, 48);
    const std::string obj = write("sheets.obj", objOf(all));
    const Strings eye{"--eye", "0,0,9", "--look-at", "0,0,0", "--up", "0,1,0"};
    expectSheets(draw(obj, eye + Strings{"--parallel", "3"}).ids, all, 9, 1.5, false, false);
    expectSheets(draw(obj, eye + Strings{"--fov", "20"}).ids, all, 9, std::tan(3.14159265358979 / 18), true,
                 false);
    const Drawn culled = draw(obj, eye + Strings{"--parallel", "3", "--cull", "back"});
    expectSheets(culled.ids, all, 9, 1.5, false, true);
    EXPECT_GT(culled.stats["culled"], 0);
  }
}

// Face numbers beyond 16 bits use all three channels. The scene has 300 x 300 squares, one for each pixel.
TEST_F(DrawnPicture, IdsHave24Bits) {
  std::string text;
  for (int y = 0; y <= 300; ++y)
    for (int x = 0; x <= 300; ++x) text += "v " + std::to_string(x) + " " + std::to_string(-y) + " 0\n";
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) {
      const int a = 301 * y + x + 1;
      for (const int v : {a + 301, a + 302, a + 1, a})
        text += (v == a + 301 ? "f " : " ") + std::to_string(v);
      text += "\n";
    }
  const Drawn drawn = draw(write("grid.obj", text), {"--size", "300x300", "--eye", "150,-150,9", "--look-at",
                                                     "150,-150,0", "--parallel", "300"});
  for (int j = 0; j < 300; ++j)
    for (int i = 0; i < 300; ++i) ASSERT_EQ(idAt(drawn.ids, i, j), 300 * j + i + 1) << i << ", " << j;
}

// Options of light and table change the picture but not the face image: they only colour the same faces
// differently.
TEST_F(DrawnPicture, LightAndTableRecolour) {
  const Drawn plain = draw("teapot"), corrected = draw("teapot", {"--table", "corrected"});
  const auto recolours = [&](const Drawn& before, const Strings& options) {
    const Drawn after = draw("teapot", options);
    EXPECT_NE(after.picture.rgb, before.picture.rgb) << options.back();
    EXPECT_EQ(after.ids.rgb, before.ids.rgb) << options.back();
    return after;
  };
  for (const Strings& options : std::vector<Strings>{{"--ia", "0.1"},
                                                     {"--ip", "0.3"},
                                                     {"--ka", "0.3"},
                                                     {"--kd", "0.3"},
                                                     {"--ks", "0"},
                                                     {"--n", "1"},
                                                     {"--light", "1,-1,0"},
                                                     {"--light-at", "5,-5,5"},
                                                     {"--constant-v"},
                                                     {"--sided", "one"},
                                                     {"--table", "brief"},
                                                     {"--table", "corrected"}})
    recolours(plain, options);
  recolours(draw("teapot", {"--light-at", "5,-5,5"}), {"--light-at", "5,-5,5", "--constant-l"});
  for (const Strings& more : std::vector<Strings>{{"--i0", "0.2"}, {"--bits", "8"}})
    recolours(corrected, Strings{"--table", "corrected"} + more);
  // The two rules disagree on about 0.2 % of all intensities, so only a large picture shows it.
  const Strings large{"--table", "corrected", "--size", "800x600", "--pick"};
  EXPECT_NE(draw("teapot", large + Strings{"log"}).png, draw("teapot", large + Strings{"search"}).png);

  // There is the ground, and one colour where nothing tells the faces apart; N shades give at most N colours.
  EXPECT_EQ(colorsOf(recolours(plain, {"--shade", "none"}).picture).size(), 2u);
  EXPECT_TRUE(colorsOf(draw("teapot", {"--shade", "none"}).picture).contains(240 << 16));
  EXPECT_EQ(colorsOf(recolours(plain, {"--ia", "1"}).picture).size(), 2u);
  EXPECT_EQ(colorsOf(recolours(plain, {"--shades", "2"}).picture).size(), 3u);
  EXPECT_LE(colorsOf(recolours(plain, {"--shades", "9"}).picture).size(), 10u);
  EXPECT_GT(draw("teapot", {"--ip", "1", "--kd", "1", "--ks", "1", "--n", "0"}).stats["saturated"], 0);
  EXPECT_EQ(draw("teapot", {"--ks", "0"}).stats["saturated"], 0);

  // A green ramp has in green what a red one has in red.
  const RgbImage green = recolours(plain, {"--hue", "0,1,0"}).picture;
  for (std::size_t p = 0; p < green.rgb.size(); p += 3)
    if (idAt(plain.ids, static_cast<int>(p / 3 % 160), static_cast<int>(p / 480)) != 0) {
      ASSERT_EQ(green.rgb[p + 1], plain.picture.rgb[p]);
    }
}

// Options of the camera and of the sort change the faces as they say.
TEST_F(DrawnPicture, CameraOptionsMean) {
  const Drawn plain = draw("teapot");
  for (const Strings& options : std::vector<Strings>{{"--eye", "-1,-9,3"},
                                                     {"--look-at", "1,0,1"},
                                                     {"--up", "1,0,1"},
                                                     {"--fov", "90"},
                                                     {"--parallel", "3"},
                                                     {"--oblique", "cavalier"},
                                                     {"--oblique", "cabinet:30"},
                                                     {"--vrp", "1,0,1"},
                                                     {"--vpn", "0,-1,1"},
                                                     {"--vup", "1,0,1"},
                                                     {"--prp", "1,1,9"},
                                                     {"--view-window", "-1,1,-1,1"},
                                                     {"--front", "0"},
                                                     {"--back", "0"},
                                                     {"--divisions", "3"},
                                                     {"--order", "none"}})
    EXPECT_NE(draw("teapot", options).ids.rgb, plain.ids.rgb) << options[0];
  EXPECT_EQ(draw("teapot", {"--divisions", "3"}).stats["faces"], 32 * 9);
  EXPECT_GT(draw("teapot", {"--cull", "back"}).stats["culled"], 500);
  EXPECT_EQ(draw("teapot", {"--size", "31x17"}).ids.width, 31);

  // A view half as tall shows four times the area; a wider field of view from the same place shows things
  // smaller.
  const int one = covered(draw("teapot", {"--parallel", "20"}).ids),
            four = covered(draw("teapot", {"--parallel", "10"}).ids);
  EXPECT_NEAR(four, 4 * one, 0.1 * four);
  const Strings eye{"--eye", "0,-20,0"};
  EXPECT_GT(covered(draw("teapot", eye + Strings{"--fov", "30"}).ids),
            2 * covered(draw("teapot", eye + Strings{"--fov", "60"}).ids));

  // Of two squares the nearer one shows, from either side; unsorted, the later one in the file shows.
  const std::string squares =
      write("squares.obj",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 2 3 4\nf 5 6 7 8\n");
  const Strings back{"--eye", "0.5,0.5,-9", "--look-at", "0.5,0.5,0", "--parallel", "2"};
  const auto seen = [&](const Strings& options) { return idAt(draw(squares, options).ids, 80, 60); };
  EXPECT_EQ(seen({"--eye", "0.5,0.5,9", "--look-at", "0.5,0.5,0", "--parallel", "2"}), 2);
  for (const char* order : {"zsort", "zmean"}) EXPECT_EQ(seen(back + Strings{"--order", order}), 1);
  EXPECT_EQ(seen(back + Strings{"--order", "none"}), 2);
  EXPECT_EQ(seen(back + Strings{"--cull", "back"}), 0);
  EXPECT_EQ(seen(back + Strings{"--front", "-0.5"}),
            2);  // n runs towards the eye: face 0 at n = 0 is cut away
  EXPECT_EQ(seen(back + Strings{"--front", "0.5", "--back", "-0.5"}), 1);
}

// Awkward scenes are drawn: scenes of any size, far from the origin, single points, faces without area.
TEST_F(DrawnPicture, AwkwardScenes) {
  const auto triangle = [&](const std::string& zero, const std::string& one) {
    return write("t.obj", "v " + zero + " " + zero + " 0\nv " + one + " " + zero + " 0\nv " + zero + " " +
                              one + " 0\nf 1 2 3\n");
  };
  const int area = covered(draw(triangle("0", "1")).ids);
  EXPECT_GT(area, 1000);
  for (const std::string one : {"1e-300", "1e300", "5e-324", "1.7e308", "1e-12"})
    EXPECT_EQ(covered(draw(triangle("0", one)).ids), area) << one;
  // A place far away costs digits: at 1e12 a unit is 8192 rounding steps, at 1e15 only eight.
  EXPECT_NEAR(covered(draw(triangle("1000000000000", "1000000000001")).ids), area, 0.01 * area);
  EXPECT_GT(covered(draw(triangle("1000000000000000", "1000000000000001")).ids), area / 2);

  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Drawn plain = draw(write("t.obj", three + "f 1 2 3\n"));
  EXPECT_EQ(draw(write("t.obj", three + "v 1e300 -1e300 1e300\nv 9 9 9\nf 1 2 3\n")).png, plain.png);
  EXPECT_EQ(draw(write("t.obj", "v 9 9 9\n" + three + "f 2 3 4\n")).png, plain.png);

  for (const std::string points : {"v 0 0 0\nv 0 0 0\nv 0 0 0\n", "v 1 2 3\nv 1 2 3\nv 1 2 3\n"}) {
    const Drawn nothing = draw(write("t.obj", points + "f 1 2 3\nf 1 1 1\n"));
    EXPECT_EQ(covered(nothing.ids), 0);
    EXPECT_EQ(colorsOf(nothing.picture).size(), 1u);
  }
  const Drawn flat = draw(write("t.obj", three + "v 1 1 0\nf 1 1 2\nf 1 2 3\nf 2 2 2\nf 3 2 3\n"));
  EXPECT_EQ(flat.stats["degenerate"], 3);
  EXPECT_EQ(flat.stats["fragments"], 1);
  EXPECT_EQ(idCounts(flat.ids).size(), 2u);
  EXPECT_TRUE(idCounts(flat.ids).contains(2));
}

// An awkward camera gives a picture or a message of one line, but never NaN or a crash.
TEST_F(DrawnPicture, AwkwardCameras) {
  for (const Strings& camera : std::vector<Strings>{{"--eye", "0,0,1"},
                                                    {"--eye", "0.1,0.1,1.5"},
                                                    {"--eye", "1e12,1e12,1e12"},
                                                    {"--eye", "1e300,0,0"},
                                                    {"--eye", "1.7e308,-1.7e308,1.7e308"},
                                                    {"--eye", "1e-300,0,0", "--look-at", "0,0,0"},
                                                    {"--fov", "0.001"},
                                                    {"--fov", "179.9"},
                                                    {"--fov", "1e-300"},
                                                    {"--parallel", "1e-300"},
                                                    {"--parallel", "1e300"},
                                                    {"--eye", "0,0,9", "--look-at", "0,0,0"},
                                                    {"--light-at", "0,0,0"},
                                                    {"--light", "1e-320,0,0"},
                                                    {"--light", "1e308,1e308,1e308"},
                                                    {"--up", "1e308,0,1e308"},
                                                    {"--front", "1e-300", "--back", "-1e-300"},
                                                    {"--size", "1x1"},
                                                    {"--size", "8192x1"},
                                                    {"--size", "1x8192"},
                                                    {"--n", "1000000"},
                                                    {"--n", "0"}}) {
    const Finished end = runProgram(Strings{"draw", "teapot", "-o", file("a.png"), "--stats"} + camera);
    EXPECT_EQ(end.status, 0) << camera[0] << ' ' << camera[1] << ": " << end.err;
    std::filesystem::remove(file("a.png"));
  }
  // Framing keeps the scene the same size for every field of view.
  for (const char* fov : {"0.001", "1", "30"})
    EXPECT_GT(covered(draw("teapot", {"--fov", fov}).ids), 4000) << fov;
  EXPECT_EQ(covered(draw("teapot", {"--eye", "1e12,1e12,1e12"}).ids), 0);
}

// A face of a million corners is one face, and so is a comb of ten thousand needles. (The boxes of all
// needles overlap, which costs n^2 comparisons of boxes.)
TEST_F(DrawnPicture, FacesOfManyCorners) {
  const int kCorners = kSanitized ? 100'000 : 1'000'000;
  std::string disc, corners, comb;
  for (int c = 0; c < kCorners; ++c) {
    const double a = 2 * 3.14159265358979 * c / kCorners;
    disc += "v " + number(std::cos(a)) + " " + number(std::sin(a)) + " 0\n";
  }
  for (int c = 1; c <= kCorners; ++c) corners += " " + std::to_string(c);
  const Strings view{"--eye", "0,0,9", "--look-at", "0,0,0", "--parallel", "4"};
  const RgbImage ids = draw(write("disc.obj", disc + "f" + corners + "\n"), view).ids;
  EXPECT_NEAR(covered(ids), 3.14159265358979 * 30 * 30,
              2 * 3.14159265358979 * 30);  // half a pixel to each side of the rim
  EXPECT_EQ(idCounts(ids).size(), 2u);

  const int kTeeth = kSanitized ? 1'000 : 5'000;
  for (int c = 0; c < kTeeth; ++c)
    comb += "v " + std::to_string(2 * c) + " 1 0\nv " + std::to_string(2 * c + 1) + " 9000 0\n";
  comb += "v 10000 0 0\nv 0 0 0\nf";
  for (int c = 2 * kTeeth + 2; c > 0; --c) comb += " " + std::to_string(c);
  const Drawn drawn = draw(write("comb.obj", comb + "\n"));
  EXPECT_EQ(drawn.stats["faces"], 1);
  EXPECT_EQ(drawn.stats["polygons"], 2 * kTeeth);
  EXPECT_GT(covered(drawn.ids), 1000);
}

}  // namespace xnewell::THIS_FILE
