#include "x11/options/setup_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/units.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/parsed_options.h"
#include "x11/options/shell_words.h"

namespace xnewell::THIS_FILE {

namespace {

/// What the scene asks for, in its units, at a small size.
PictureSettings setupOf(const Scene& scene) {
  PictureSettings settings = scene.settings;
  settings.inPixels = false;
  settings.camera = scene.camera;
  settings.width = 64, settings.height = 48;
  return settings;
}

/// The file that `draw` writes of this set-up, with this note; "" if it has no picture.
std::string fileOf(const Scene& scene, const PictureSettings& settings, const std::string& note) {
  try {
    const CellPlan plan{settings.table.kind};
    const Picture picture = makePicture(scene, settings, plan[Cell::Well]);
    return encodePng(picture.image(), picture.palette(plan), note);
  } catch (const std::exception&) {
    return "";
  }
}

Value randomValue(const Setting& setting, std::mt19937& rng) {
  const auto number = [&] {
    const double low = std::max(setting.range.low, -4.0), high = std::min(setting.range.high, 4.0);
    return std::uniform_real_distribution{low, high}(rng);
  };
  for (;;) {
    Value value = number();
    if (setting.field.kind == ValueKind::Triple) value = glm::dvec3{number(), number(), number()};
    if (setting.field.kind == ValueKind::Whole) value = setting.range.low + static_cast<double>(rng() % 200);
    if (setting.field.kind == ValueKind::Flag) value = static_cast<double>(rng() % 2);
    if (setting.field.kind == ValueKind::Choice)
      value = static_cast<double>(rng() % setting.field.choices.size());
    if (setting.key == "table.hue") value = glm::dvec3{1.0, std::abs(number()) / 4, 0.5};
    if (setting.key == "table.shades") value = 30.0 + static_cast<double>(rng() % 200);
    if (allows(setting, value)) return value;
  }
}

/// A random camera, or the scene's own turned, or another projection.
CameraSettings randomCamera(const Scene& scene, const PictureSettings& settings, std::mt19937& rng) {
  const Camera placed = placeCamera(scene, settings.camera, 4.0 / 3);
  CameraSettings camera = settings.camera;
  switch (rng() % 6) {
    case 0:
      return moved(camera, placed, scene, 20.0, -7.5, 1.3);
    case 1:  // as the key P does
      camera.parallel = !camera.parallel && !camera.oblique;
      camera.oblique.reset(), camera.height.reset();
      return camera;
    case 2:
      camera = {}, camera.oblique = Oblique{0.5, 30};
      return completed(camera, settings.camera);
    case 3:
      camera = {}, camera.vpn = glm::dvec3{0.3, -1, 0.4}, camera.front = 0.25;
      return completed(camera, settings.camera);
    case 4:
      camera = {}, camera.parallel = true, camera.height = 1.7, camera.vup = glm::dvec3{0.1, 0.2, 1};
      return completed(camera, settings.camera);
    default:
      return camera;
  }
}

/// A picture that carries a note.
std::string picture(const TemporaryFolder& folder, const std::string& note,
                    const std::string& name = "a.png") {
  return folder.write(name, encodePng(IndexImage{3, 2, 7}, Palette{}, note));
}

}  // namespace

using SetupCommandTest = CommandTest;

// The command draws the set-up again, byte for byte: for any settings that may be chosen in a window, any
// camera, scenes with lights, materials and textures of their own, and set-ups from a file.
TEST_F(SetupCommandTest, DrawsTheSameFile) {
  const std::string setup = write("setup.json", R"({"scene": "lamp", "without": ["kd"],
    "camera": {"parallel": true}, "shading": {"method": "gouraud", "kd": 0.5, "dither": true,
    "constant_v": true, "attenuation": "inverse"}})");
  const std::string worn =
      write("worn.json", R"({"scene": "teapot", "divisions": 3, "texture": ")" XNEWELL_DATA_DIR
                         R"(/textures/checks.png", "shading": {"method": "phong", "light_at": [4, -5, 6]}})");
  const std::string far = write("far.obj", "v 0 0 0\nv 3e9 0 0\nv 0 3e9 1e9\nf 1 2 3\n");
  const std::string half =
      write("half.json", R"({"materials": {"m": {"ka": 0.5, "kd": 0.6, "ks": 0.7, "n": 9}},
    "objects": [{"solid": "sphere", "material": "m"}, {"solid": "cube", "move": [1.5, 0, 0]}]})");
  std::mt19937 rng{11};
  int drawn = 0, kept = 0, lit = 0;
  for (const std::string& name :
       {setup, worn, far, half, std::string{"teapot"}, std::string{"colored-lights"},
        std::string{"textured-cube"}, std::string{"spotlight"}, std::string{"hues"}})
    for (int trial = 0; trial < (kSanitized ? 4 : 16); ++trial) {
      Scene scene = readScene(name, 4);
      PictureSettings settings = setupOf(scene);
      std::vector<Override> overrides;
      for (const Setting& setting : settingRows()) {
        if (setting.key == "fill" || rng() % 4 != 0) continue;
        if (setting.key == "Ia" && !scene.light.lights.empty()) continue;  // their sum must not exceed 1
        overrides.push_back({&setting, randomValue(setting, rng)});
        if (!setting.replaces.empty() && rng() % 2) strip(scene, setting.replaces);
      }
      if (!applyOverrides(settings, overrides)) continue;
      if (scene.light.lights.empty() && scene.light.Ia && largest(*scene.light.Ia) + settings.light.Ip > 1)
        continue;
      settings.camera = randomCamera(scene, settings, rng);
      const std::string command = SetupCommand{scene}.of(settings);
      // The file carries the command, unless that rests on a second file.
      const std::string expected = fileOf(scene, settings, scene.origin.texture.empty() ? command : "");
      if (expected.empty()) continue;
      SCOPED_TRACE(command);
      const Finished end = runProgram(commandWords(command, file("out.png")));
      ASSERT_EQ(end.status, 0) << end.err;
      ASSERT_TRUE(contents(file("out.png")) == expected);
      ++drawn;
      kept += command.find(" --keep ") != std::string::npos;
      lit += command.find(" --light") != std::string::npos;
    }
  EXPECT_GT(drawn, kSanitized ? 15 : 60);
  EXPECT_GT(kept, kSanitized ? -1 : 0);  // few trials may have none
  EXPECT_GT(lit, kSanitized ? 1 : 10);
}

// Only what differs from what the scene asks for is said. What a scene's file sets and the set-up does not is
// ended by name.
TEST_F(SetupCommandTest, SaysWhatDiffers) {
  const auto said = [](const std::string& name, auto&& change) {
    Scene scene = readScene(name);
    PictureSettings settings = setupOf(scene);
    change(scene, settings);
    const std::string all = SetupCommand{scene}.of(settings);
    const std::string first = "xnewell draw ", last = " -o picture.png";
    EXPECT_TRUE(all.starts_with(first) && all.ends_with(last)) << all;
    return all.substr(first.size(), all.size() - first.size() - last.size());
  };
  const auto nothing = [](Scene&, PictureSettings&) {};
  for (const std::string name : {"teapot", "lamp", "spotlight"})
    EXPECT_EQ(said(name, nothing), name + " --size 64x48");
  EXPECT_EQ(said("teapot", [](Scene&, PictureSettings& s) { s.shading = Shading::Phong, s.light.n = 7; }),
            "teapot --size 64x48 --shade phong --n 7");
  EXPECT_EQ(said("lamp", [](Scene&, PictureSettings& s) { s.light.attenuation = Attenuation::Inverse; }),
            "lamp --size 64x48 --attenuation inverse");
  EXPECT_EQ(said("teapot",
                 [](Scene&, PictureSettings& s) {
                   s.camera.eye = glm::dvec3{-1, 0.1, 3}, s.camera.fov = 20;
                 }),
            "teapot --size 64x48 --eye=-1,0.1,3 --fov 20");
  EXPECT_EQ(said("teapot",
                 [](Scene& scene, PictureSettings&) {
                   scene.marks.edges = ModelEdges::All, scene.marks.edgeColor = glm::dvec3{255, 8, 0} / 255.0;
                 }),
            "teapot --size 64x48 --edges all --edge-color '#ff0800'");
  const std::string dithered = write("it's.json", R"({"objects": [{"solid": "cube"}],
    "shading": {"dither": true, "light_at": [1, 2, 3]}})");
  std::string quotedName;
  for (const char c : dithered) quotedName += c == '\'' ? "'\\''" : std::string{c};
  EXPECT_EQ(
      said(dithered, [](Scene&, PictureSettings& s) { s.dither = false, s.light.lightPosition.reset(); }),
      "'" + quotedName + "' --size 64x48 --dither=false --light" +
          (defaultLight(UpAxis::Y).x < 0 ? "=" : " ") +
          textOf(*settingOf("--light"), defaultLight(UpAxis::Y)));
}

// Only a server fills with XFillPolygon.
TEST_F(SetupCommandTest, IsASnapshotWhereTheServerFills) {
  const Scene scene = readScene("cycle");
  EXPECT_EQ(SetupCommand{scene}.of(setupOf(scene), 0, Fill::XFillPolygon),
            "xnewell snapshot cycle --size 64x48 --fill x11 -o picture.png");
}

// The options that a picture carries are as if the user gave them, and what the user gives replaces them.
TEST(CarriedSetup, TheUserHasTheLastWord) {
  const TemporaryFolder folder;
  const std::string file =
      picture(folder,
              "xnewell draw cubes --size 720x480 --shade phong --light-at 1,2,3 --eye=-1,2,3 --fov 40 --view "
              "machbands --scanline 7 -o picture.png");
  const Options as = parsed({"draw", file, "-o", "no.png"});
  EXPECT_EQ(as.scene, "cubes");
  EXPECT_EQ(as.carrier, file);
  EXPECT_EQ(as.size, (glm::ivec2{720, 480}));
  EXPECT_EQ(as.picture.shading, Shading::Phong);
  EXPECT_EQ(as.picture.light.lightPosition, (glm::dvec3{1, 2, 3}));
  EXPECT_EQ(as.picture.camera.eye, (glm::dvec3{-1, 2, 3}));
  EXPECT_EQ(as.view, View::MachBands);
  EXPECT_EQ(as.window.scanline, 7);

  const Options other = parsed({"draw", file, "-o", "no.png", "--size", "80x60", "--shade", "flat", "--light",
                                "0,0,1", "--eye", "9,9,9", "--view", "picture"});
  EXPECT_EQ(other.size, (glm::ivec2{80, 60}));
  EXPECT_EQ(other.picture.shading, Shading::Flat);
  EXPECT_EQ(other.picture.light.lightPosition, std::nullopt);
  EXPECT_EQ(other.picture.light.light, (glm::dvec3{0, 0, 1}));
  EXPECT_EQ(other.picture.camera.eye, (glm::dvec3{9, 9, 9}));
  EXPECT_EQ(other.picture.camera.fov, 40);
  EXPECT_EQ(other.view, View::Picture);
  EXPECT_EQ(other.window.scanline, std::nullopt);
}

// Each command takes from a picture what it can use. The window has its own size, unless the picture shows
// the window.
TEST(CarriedSetup, EachCommandTakesWhatItCanUse) {
  const TemporaryFolder folder;
  const std::string drawn = picture(folder,
                                    "xnewell draw teapot --size 768x560 --view colours --cell 40 --gamma 2 "
                                    "--order zmean -o picture.png"),
                    window =
                        picture(folder,
                                "xnewell snapshot teapot --size 1700x1300 --whole-window --view depthsort "
                                "--scale 2 --step 40 --controls none -o picture.png",
                                "b.png"),
                    filled = picture(folder, "xnewell snapshot teapot --shade flat --fill x11 -o picture.png",
                                     "c.png");
  const Options shown = parsed({drawn});
  EXPECT_EQ(shown.command, Command::View);
  EXPECT_EQ(shown.size, std::nullopt);
  EXPECT_EQ(shown.window.view, View::Colors);
  EXPECT_EQ(shown.window.cell, std::nullopt);
  EXPECT_EQ(shown.picture.order, Order::ZMean);
  const Options again = parsed({"snapshot", drawn, "-o", "no.png"});
  EXPECT_EQ(again.size, (glm::ivec2{768, 560}));
  EXPECT_EQ(again.window.cell, 40);
  EXPECT_EQ(parsed({filled}).fill, Fill::XFillPolygon);
  EXPECT_EQ(parsed({"draw", filled, "-o", "no.png"}).fill, Fill::Scanline);
  EXPECT_EQ(parsed({"trace", drawn}).picture.order, Order::Newell);
  EXPECT_EQ(parsed({"explain", drawn, "767,559"}).size, (glm::ivec2{768, 560}));
  EXPECT_EQ(parsed({"extremes", drawn}).size, std::nullopt);

  const Options opened = parsed({window});
  EXPECT_EQ(opened.size, (glm::ivec2{1700, 1300}));
  EXPECT_EQ(opened.scale, 2);
  EXPECT_EQ(opened.window.view, View::DepthSort);
  EXPECT_EQ(opened.window.step, 40);
  EXPECT_EQ(opened.window.controls, "");
  EXPECT_EQ(parsed({window, "--view", "colours"}).window.step, 0);
  EXPECT_FALSE(opened.wholeWindow);
  EXPECT_TRUE(parsed({"snapshot", window, "-o", "no.png"}).wholeWindow);
  EXPECT_EQ(parsed({"draw", window, "-o", "no.png"}).size, std::nullopt);
  EXPECT_EQ(parsed({"snapshot", drawn, "-o", "no.png", "--whole-window"}).size, std::nullopt);
}

// A picture of a lesson opens the lesson, and only a window can show one.
TEST(CarriedSetup, APictureOfALessonOpensIt) {
  const TemporaryFolder folder;
  const std::string own = folder.write("my own.json", ""),
                    file = picture(folder, lessonNote("cycles", {1700, 1300}, 2, 3)),
                    ofOwn = picture(folder, lessonNote("my own.json", {900, 700}, 1, 2), "b.png"),
                    ofNone = picture(folder, lessonNote("no.json", {900, 700}, 1, 2), "c.png");
  const Options opened = parsed({file});
  EXPECT_EQ(opened.command, Command::Lesson);
  EXPECT_EQ(opened.scene, "cycles");
  EXPECT_EQ(opened.window.step, 3);
  EXPECT_EQ(opened.size, (glm::ivec2{1700, 1300}));
  EXPECT_EQ(opened.scale, 2);
  EXPECT_EQ(parsed({file, "--step", "1"}).window.step, 1);
  EXPECT_EQ(parsed({ofOwn}).scene, own);
  EXPECT_EQ(complaintAll({"draw", file, "-o", "no.png"}),
            file + ": it shows a lesson, which opens in a window: xnewell " + file);
  EXPECT_EQ(complaintAll({file, "--shade", "flat"}),
            file + ": --shade does not work with lesson: the lesson decides how its steps are drawn");
  EXPECT_EQ(complaintAll({"draw", ofNone, "-o", "no.png"}),
            ofNone + ": the scene of the set-up that it carries, no.json, is not there");
}

// A scene's file is found from the picture's folder, beside the picture although its folder has changed, and
// also if its name needs quotes.
TEST(CarriedSetup, FindsTheScenesFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  const auto scene = [&](const std::string& name) {
    return parsed({"draw", picture(folder, "xnewell draw " + name + " -o picture.png"), "-o", "no.png"})
        .scene;
  };
  const std::string below = folder.write("sub/it.obj", ""), quoted = folder.write("it's one.obj", "");
  EXPECT_EQ(scene("sub/it.obj"), below);
  EXPECT_EQ(scene(below), below);
  EXPECT_EQ(scene("'it'\\''s one.obj'"), quoted);
  const std::string odd = "it's\n\t\x1b[2J\\\xc3\xa9.obj";
  EXPECT_EQ(scene(xnewell::quoted(odd)), folder.write(odd, ""));
  const std::string beside = folder.write("it.obj", "");
  EXPECT_EQ(scene("sub/it.obj"), below);
  EXPECT_EQ(scene("elsewhere/it.obj"), beside);
}

}  // namespace xnewell::THIS_FILE
