#include "x11/options/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include "geometry/files/text_file.h"
#include "x11/options/carried_setup.h"
#include "x11/options/exit_status.h"
#include "x11/options/option_reader.h"
#include "x11/options/option_rows.h"
#include "x11/options/options_check.h"
#include "x11/options/read_value.h"
#include "x11/options/shell_words.h"

namespace xnewell {

namespace {

glm::ivec2 parseSize(const std::string& text) {
  const std::string expected = "a size WxH from 1x1 to 8192x8192";
  const std::size_t x = text.find('x');
  if (x == std::string::npos) refuse("--size", text, expected);
  glm::ivec2 size{0};
  const auto part = [&](std::string_view digits, int& v) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), v);
    if (error != std::errc{} || end != digits.data() + digits.size() || v < 1 || v > kMaxPicture)
      refuse("--size", text, expected);
  };
  part(std::string_view{text}.substr(0, x), size.x);
  part(std::string_view{text}.substr(x + 1), size.y);
  return size;
}

AccuracyLimit parseAccuracy(const std::string& text) {
  const std::string expected =
      "a number between 0 and 1, and perhaps a comma and a whole number of samples: 0.03 or 0.03,20";
  const std::size_t comma = text.find(',');
  AccuracyLimit limit{numbers("--accuracy", text.substr(0, comma), 1, expected)[0], {}};
  if (!(limit.rms > 0 && limit.rms < 1)) refuse("--accuracy", text, expected);
  if (comma == std::string::npos) return limit;
  const double wrong = numbers("--accuracy", text.substr(comma + 1), 1, expected)[0];
  if (wrong < 0 || wrong > double{kMaxPicture} * kMaxPicture || wrong != std::floor(wrong))
    refuse("--accuracy", text, expected);
  limit.wrong = static_cast<std::int64_t>(wrong);
  return limit;
}

/// Takes the command off the arguments. CLI11's subcommands would read `draw -- -s.obj` as an option: in a
/// subcommand they parse what follows `--` as options again.
Command takeCommand(std::vector<std::string>& arguments) {
  if (arguments.empty()) return Command::View;
  const std::string first = arguments.front();
  const auto* const row = std::ranges::find(kCommands, first, &CommandRow::name);
  if (row == kCommands.end()) return Command::View;
  arguments.erase(arguments.begin());
  return row->id;
}

/// Says in our words what CLI11 found wrong. Only the `last` argument can lack a value: another one takes
/// what follows it.
[[noreturn]] void complain(const CLI::App& app, const Options& o, const CLI::ParseError& e,
                           const std::string& last) {
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    std::vector<std::string> extra = app.remaining();
    std::erase(extra, "--");
    const bool option = extra.front().starts_with('-');
    const bool meansScene = o.command != Command::Lesson && o.command != Command::Lecture;
    if (!option && meansScene && !isBuiltIn(o.scene) && !std::filesystem::exists(o.scene))
      throw UsageError{inQuotes(o.scene) +
                       ": not a command, a built-in scene or a file; `xnewell --help` lists the commands"};
    throw UsageError{(option ? "unknown option " : "unexpected argument: ") + inQuotes(extra.front())};
  }
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 1 && option->get_items_expected_max() > 0)
      throw UsageError{name + " is given more than once"};
  }
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::ArgumentMismatch))
    if (const CLI::Option* const option = app.get_option_no_throw(last.substr(0, last.find('='))))
      throw UsageError{option->get_name() + " needs a value"};
  throw UsageError{e.what()};
}

/// ".obj, .ply, .off"
std::string kindsOfScenes() {
  std::string all;
  for (const std::string_view kind : kSceneFiles) all += (all.empty() ? "" : ", ") + std::string{kind};
  return all;
}

/// "0 done, 1 ..."
std::string exitStatuses() {
  std::string all;
  for (const StatusRow& row : kStatuses)
    all += (all.empty() ? "" : ", ") + std::to_string(row.id) + " " + std::string{row.means};
  return all;
}

/// CLI11 prints one usage line; this prints one for each command.
class Help : public CLI::Formatter {
  std::string make_usage(const CLI::App*, std::string) const override {
    std::string usage = "\nUsage:\n";
    for (const CommandRow& row : kCommands) {
      usage += "  xnewell " + std::string{row.usage};
      usage +=
          std::string(row.usage.size() < 40 ? 40 - row.usage.size() : 1, ' ') + std::string{row.does} + "\n";
    }
    return usage + "\nSCENE is a file (" + kindsOfScenes() +
           ") or a built-in name (`xnewell scenes`).\n"
           "A .png is a picture that xnewell wrote: it carries its scene's name and all settings.\n"
           "Defaults are in [ ]; a scene file may set others.\n";
  }
};

/// "ambient, lights, ka ..."
std::string strippable() {
  std::string all;
  for (const std::string_view what : kStrippable) all += (all.empty() ? "" : ", ") + std::string{what};
  return all;
}

/// Adds all options, in the order of --help. The reader writes what they say into `o`.
void addOptions(CLI::App& app, Reader& r, Options& o) {
  app.set_help_flag("-h,--help", "print this help");
  app.set_version_flag("--version", "xnewell " XNEWELL_VERSION, "print the version");
  app.add_option_function<std::string>(
         "scene", [&](const std::string& s) { o.scene = s; }, "SCENE [teapot, in a window only]")
      ->type_name("");
  if (o.command == Command::Explain)
    app.add_option_function<std::string>(
           "explained",
           [&](const std::string& s) {
             if (o.scene.find_first_not_of("0123456789,") == o.scene.npos &&
                 o.scene.find(',') != o.scene.npos)
               throw UsageError{"the scene comes first: xnewell explain " + s + ' ' + o.scene};
             o.pixel = pixelOf("X,Y", s);
           },
           "X,Y, a pixel of the picture")
        ->type_name("");
  if (const std::string_view what = rowOf(o.command).takes; !what.empty())
    app.add_option_function<std::string>(
           "handed-in", [&](const std::string& s) { o.handedIn = s; }, std::string{what})
        ->type_name("");
  r.text("-o,--output",
         "the PNG file to write; figure: an SVG, PDF or EPS file, by the end of its name; judge: a scene "
         "file; grade: a CSV file",
         "", [&](const std::string& s) { o.output = s; });
  r.takes("--output", Takes::File);
  r.text("--size",
         "picture or window size WxH, at most 8192x8192; diagnose, judge and grade: that of what is handed "
         "in, if it is not given",
         "800x600, a window 1024x768 times --scale, extremes 160x120",
         [&](const std::string& s) { o.size = parseSize(s); });
  r.number("--scale", o.scale, 1, kMostScale,
           "how many times as large the window's letters, lines and controls are; the picture keeps its own "
           "pixels. For the window, and for pictures of it. Without it, the screen decides for the window",
           "", "; the letters are made of pixels, and a part of a pixel cannot be drawn");
  r.number("--divisions", o.divisions, 1, kMaxDivisions,
           "each Bezier patch becomes N x N polygons, unless the scene file gives the number");
  for (const Setting& row : settingRows()) r.setting(row, o.overrides);
  r.text("--keep",
         "what the scene keeps of its own although options give it, for example ka,n: " + strippable(),
         "nothing", [&](const std::string& s) {
           o.keep = commaWords(s);
           for (const std::string& what : o.keep)
             if (std::ranges::find(kStrippable, what) == kStrippable.end())
               refuse("--keep", s, "names of these, with commas between them: " + strippable());
         });
  r.number("--max-fragments", o.picture.mostPieces, 1, 1'000'000'000,
           "how many pieces the depth sort and the BSP tree make before they give up");
  r.flag("--half-vector", o.halfVector, "the same as --form half-vector");
  r.named("--texture", o.texture, "file", "a PNG for the diffuse colour of all surfaces");
  addCamera(r, o.picture.camera);
  r.named("--visual", o.visual, "visual", "use this visual or fail, for example PseudoColor8 or TrueColor24");
  r.choice("--colormap", kMapOwners, o.colormap,
           "a colormap of its own, or as many cells of the default colormap as are free");
  r.flag("--nearest", o.nearest,
         "show a colour that the server lacks as the nearest one it has, without mixing");
  addView(r, o);
  addEffects(r, o);
  r.named("--ids", o.ids, "file",
          "also write the face image: 8-bit RGB, face number + 1, 0 where there is no face; figure: also "
          "write the "
          "figure in these colours");
  const auto color = [&r](const char* name, auto& of, const char* does, const char* usual) {
    r.text(name, does, usual, [name, &of](const std::string& s) {
      if (s.size() != 7 || s[0] != '#' || s.find_first_not_of("0123456789abcdefABCDEF", 1) != s.npos)
        refuse(name, s, "#rrggbb, a colour by six hexadecimal digits");
      const int rgb = std::stoi(s.substr(1), nullptr, 16);
      of = glm::dvec3{rgb >> 16, rgb >> 8 & 255, rgb & 255} / 255.0;
    });
  };
  color("--paper", o.paper, "figure: the colour behind it, such as #ffffff", "none, so that the page shows");
  r.choice("--edges", kModelEdges, o.edges,
           "the edges of the model's faces as lines, in front or all; hidden ones are dashed");
  color("--edge-color", o.edgeColor, "the colour of the edges, such as #808080", "#000000");
  r.flag("--smooth", o.smooth,
         "figure, PDF: Gouraud shading as triangles with a colour at each corner, which the reader "
         "interpolates; the file is small, and the shades have no borders");
  r.number(
      "--tolerance", o.tolerance, 0, 64,
      "figure: how far colours that change over a face may be off, in steps of 1/255; more makes smaller "
      "files");
  r.flag("--bare", o.bare,
         "the file carries no set-up, so that two files of the same pixels are the same, however they were "
         "drawn");
  r.flag("--stats", o.stats,
         "print counts and times as one JSON object; `saturated` counts intensities above 1 at faces "
         "(flat), at vertices (gouraud), or at pixels each time they are painted (phong, envmap, textures)");
  r.flag("--errors", o.errors,
         "print --stats with the errors of the picture: how far it is from a reference without short cuts, "
         "and where; with figure, how far the areas are from the picture and from that reference");
  r.flag("--costs", o.costs,
         "print --stats with the milliseconds that each required item costs; this makes the picture again, "
         "with and without each, for some seconds");
  r.text(
      "--accuracy",
      "RMS[,WRONG], window, draw, snapshot: measure a trade first, and take the cheapest point of its front "
      "that is off by no more than this intensity (root mean square), and shows a wrong face at no more "
      "samples than WRONG; without WRONG their number does not count. Options that you give stay",
      "", [&](const std::string& s) { o.accuracy = parseAccuracy(s); });
  r.flag(
      "--json", o.json,
      "explain, trade, extremes, diagnose, judge: print all numbers as one JSON object instead of the text");
  r.text("--axes", "trade: only these short cuts, named as their options: shade,order,divisions",
         "all that have an effect", [&](const std::string& s) {
           o.trade.axes = commaWords(s);
           if (o.trade.axes.empty()) refuse("--axes", s, "names of options, with commas between them");
         });
  r.text("--without", "trade: values to leave out, for example order=none,shade=depth", "",
         [&](const std::string& s) { o.trade.without = commaWords(s); });
  r.number("--budget", o.trade.seconds, 1, 3600,
           "about how many seconds of the processor's time to measure, at most",
           "trade " + textOf(TradeRequest{}.seconds) + ", --accuracy " + textOf(kAccuracySeconds));
  r.named("--run", o.run, "file",
          "judge: the steps of a depth sort, as xnewell_run.h or trace writes them, in place of an order");
  r.flag("--whole-window", o.wholeWindow,
         "snapshot: the window with all its controls; trace --frames: with the stepper at each step");
  r.flag("--quick", o.quick,
         "trace: follow the accelerated run; the steps of the textbook's run grow with the square of the "
         "polygons");
  r.named(
      "--frames", o.frames, "folder",
      "trace: write numbered pictures into this folder instead of lines; it must not hold any frames yet");
  r.choice("--every", kEvery, o.every, "trace: the steps that --frames draws");
  r.named("--answers", o.answers, "file",
          "lesson, lecture: keep what is answered in this JSON file, beside what it has");
  r.named("--worksheet", o.worksheet, "file",
          "lesson: write an HTML file to print, with pictures, questions, room to write, and solutions at "
          "the end");
  r.text("--scene-for",
         "A,B, diagnose: name the scene, the settings and the pixel that tell these two mistakes apart best, "
         "in place of a picture",
         "", [&](const std::string& s) {
           if (s.empty()) refuse("--scene-for", s, "two mistakes, such as RV-abs,RV-unclamped");
           o.sceneFor = s;
         });
  r.named("--page", o.page, "file", "grade: also write an HTML file with the pictures in it");
  r.number("--count", o.questions, 1, 10'000, "questions: how many");
  r.number("--seed", o.seed, 0, 1'000'000'000, "questions: another number gives other questions");
  r.named("--gift", o.gift, "file", "questions: also write a file that Moodle imports, in its GIFT format");
  r.number(
      "--play", o.play, 0.5, 3600,
      "lecture: seconds without a key or click until a page turns by itself; after the last comes the first",
      "pages wait for a key");
  addPlaces(r);
}

}  // namespace

std::vector<OptionRow> Reader::rows() const {
  std::vector<OptionRow> rows;
  for (const CLI::Option* option : app_.get_options()) {
    if (option->get_lnames().empty()) continue;  // SCENE
    OptionRow row{.name = option->get_name(), .letter = {}, .does = option->get_description()};
    if (!option->get_snames().empty()) row.letter = "-" + option->get_snames().front();
    if (option->get_items_expected_max() > 0) row.takes = Takes::Text;
    if (const auto what = takes_.find(row.name); what != takes_.end()) row.takes = what->second;
    if (const auto words = words_.find(row.name); words != words_.end()) row.words = words->second;
    if (const auto places = places_.find(row.name); places != places_.end()) row.places = places->second;
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<OptionRow> optionRows() {
  CLI::App app;
  Options options;
  Reader reader{app};
  addOptions(app, reader, options);
  return reader.rows();
}

namespace {

/// Reads arguments into `o`, over what is there. Returns false if it printed --help or --version.
bool parse(std::vector<std::string> arguments, Options& o) {
  CLI::App app{"xnewell: " + std::string{kAbout}};
  app.formatter(std::make_shared<Help>());
  app.footer("In the window, `?` shows all keys.\nExit status: " + exitStatuses() + ".");
  Reader reader{app};
  addOptions(app, reader, o);
  const std::string last = arguments.empty() ? "" : arguments.back();
  try {
    std::ranges::reverse(arguments);  // CLI11 takes them in reverse order
    app.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return false;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    return false;
  } catch (const CLI::ParseError& e) {
    complain(app, o, e, last);
  }
  for (const CLI::Option* option : app.parse_order()) {
    o.given.push_back(option->get_name());
    o.values.push_back(option->get_items_expected_max() == 0 ? "" : option->results().back());
  }
  o.stats = o.stats || o.errors || o.costs;
  return true;
}

/// The set-up that a picture carries, and over it what the user `said` in these arguments.
Options withCarried(Options o, const Options& said, const CarriedSetup& carried,
                    const std::vector<std::string>& arguments) {
  (void)parse(argumentsFor(said, carried), o);
  o.carried = o.given;
  const CameraSettings camera = std::exchange(o.picture.camera, {});
  (void)parse(arguments, o);
  o.picture.camera = completed(o.picture.camera, camera);
  o.scene = carried.scene;
  return o;
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  Options o;
  const std::size_t words = arguments.size();
  o.command = takeCommand(arguments);
  o.commandMeant = !arguments.empty() && arguments.size() == words && !arguments.front().starts_with('-');

  Options said = o;
  if (!parse(arguments, said)) return std::nullopt;
  if (!rowOf(o.command).draws || !isPicture(said.scene)) {
    checkUsage(said, optionRows());
    return said;
  }
  const std::string carrier = said.scene;
  const CarriedSetup carried = readCarriedSetup(carrier);
  try {
    if (carried.lesson && o.command != Command::View)
      throw UsageError{"it shows a lesson, which opens in a window: xnewell " + quoted(carrier)};
    if (carried.lesson) {
      o.command = said.command = Command::Lesson;
      o.commandMeant = false;
    }
    o = withCarried(std::move(o), said, carried, arguments);
    o.carrier = carrier;
    checkUsage(o, optionRows());
  } catch (const UsageError& e) {
    throw UsageError{carrier + ": " + e.what()};
  }
  return o;
}

}  // namespace xnewell
