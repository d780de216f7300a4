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
