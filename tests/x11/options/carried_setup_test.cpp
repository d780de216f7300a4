#include "x11/options/setup_command.h"

#include <gtest/gtest.h>

#include "geometry/files/parse_error.h"
#include "shading/color/png.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/parsed_options.h"
#include "x11/options/shell_words.h"

namespace xnewell::THIS_FILE {

namespace {

/// A picture that carries a note.
std::string picture(const TemporaryFolder& folder, const std::string& note,
                    const std::string& name = "a.png") {
  return folder.write(name, encodePng(IndexImage{3, 2, 7}, Palette{}, note));
}

std::string complaintAbout(const std::string& picture) {
  try {
    (void)parsed({"draw", picture, "-o", "no.png"});
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

}  // namespace

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
  EXPECT_EQ(complaintAbout(file), file + ": it shows a lesson, which opens in a window: xnewell " + file);
  EXPECT_EQ(complaintAll({file, "--shade", "flat"}),
            file + ": --shade does not work with lesson: the lesson decides how its steps are drawn");
  EXPECT_EQ(complaintAbout(ofNone),
            ofNone + ": the scene of the set-up that it carries, no.json, is not there");
}

// What a picture carries is not trusted: only a command that we could have written is read, and none of its
// options names a file.
TEST(CarriedSetup, RefusesWhatWeDoNotWrite) {
  const TemporaryFolder folder;
  const std::string none = "the set-up that it carries is no command of xnewell";
  const std::string end = " -o picture.png";
  for (const auto& [note, complaint] : {
           std::pair{std::string{}, std::string{"the picture carries no set-up, so it is no scene"}},
           {"hello", none},
           {"rm teapot" + end, none},
           {"xnewell trace teapot" + end, none},
           {"xnewell draw teapot", none},
           {"xnewell draw" + end, none},
           {"xnewell draw --size 3x2" + end, none},
           {"xnewell draw 'teapot" + end, none},
           {"xnewell draw teapot\n" + end, "the set-up that it carries has control characters"},
           {"xnewell draw te\xFFpot" + end, "the set-up that it carries is not UTF-8"},
           {"xnewell draw teapot" + std::string(2000, ' ') + end,
            "the set-up that it carries is longer than 2000 bytes"},
           {"xnewell draw teapot -o b.png" + end, "a picture cannot carry '-o'"},
           {"xnewell draw teapot --ids b.png" + end, "a picture cannot carry '--ids'"},
           {"xnewell draw teapot --texture=b.png" + end, "a picture cannot carry '--texture'"},
           {"xnewell draw teapot cubes" + end, "a picture cannot carry 'cubes'"},
           {"xnewell draw b.png" + end, "the scene of the set-up that it carries is a picture"},
           {"xnewell lesson cycles" + end, none},
           {"xnewell lesson --step 2", none},
           {"xnewell lesson cycles --answers a.json", "a picture cannot carry '--answers'"},
           {"xnewell lesson cycles --shade flat", "a picture cannot carry '--shade'"},
           {"xnewell draw no.obj" + end, "the scene of the set-up that it carries, no.obj, is not there"},
           {"xnewell draw teapot --fov" + end, "--fov needs a value"},
           {"xnewell draw teapot --ia 0.8 --ip 0.8" + end, "--ia and --ip: their sum must not exceed 1"},
       }) {
    const std::string file = picture(folder, note);
    EXPECT_EQ(complaintAbout(file), file + ": " + complaint) << note;
  }
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
