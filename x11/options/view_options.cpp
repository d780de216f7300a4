#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "x11/options/option_reader.h"

namespace xnewell {

/// The options that say what is shown, and where a window begins.

namespace {

/// The keys of settings, or "" for the word none.
std::string parseControls(const std::string& text) {
  if (text == "none") return "";
  if (text.empty()) refuse("--controls", text, "the keys of settings in view 1, such as Ssn, or none");
  for (const char key : text)
    if (settingOf(key) == nullptr)
      refuse("--controls", text, "the keys of settings in view 1, such as Ssn, or none");
  return text;
}

/// The names of all views of draw, snapshot and the window, each once.
std::string viewNames() {
  std::string all;
  for (const ViewRow& row : kViews)
    if (row.hasSheet()) all += (all.empty() ? "" : ", ") + std::string{row.name};
  all += "; in a window";
  for (const ViewRow& row : kWindowViews)
    if (!row.hasSheet()) all += (all.ends_with("window") ? " " : ", ") + std::string{row.name};
  return all;
}

/// Returns false if no view has that name. checkTogether() checks later whether the command has this view.
bool takeView(Options& o, const std::string& name) {
  const auto* const view = std::ranges::find(kViews, name, &ViewRow::name);
  if (view == kViews.end()) return false;
  o.view = view->id;
  o.window.view = view->key ? view->id : View::Picture;
  o.show = view->key ? View::Picture : view->id;
  return true;
}

/// A row, or a polygon. checkPlaces() knows which of them the command has.
void takeScanline(Options& o, const std::string& text) {
  const std::size_t point = text.find('.');
  const auto isNumber = [](const std::string& s) {
    return !s.empty() && s.size() < 10 && std::ranges::all_of(s, [](char c) { return c >= '0' && c <= '9'; });
  };
  if (!isNumber(text.substr(0, point)) || (point != std::string::npos && !isNumber(text.substr(point + 1))))
    refuse("--scanline", text, "a row or a face, such as 59, or a part of a face, such as 59.2");
  o.window.polygon = text;
  if (const int row = std::stoi(text); point == std::string::npos && row < kMaxPicture)
    o.window.scanline = row;
}

}  // namespace

void addView(Reader& r, Options& o) {
  r.text("--view", "what to show: " + viewNames(), std::string{rowOf(o.view).name},
         [&](const std::string& s) {
           if (!takeView(o, s)) refuse("--view", s, viewNames());
         })
      .proposes(kViews)
      .only({"view", "draw", "snapshot"});
  r.number("--step", o.window.step, 0, 1'000'000'000,
           "the step of the depth sort, or the stage of --view viewing, that the window begins with; lesson: "
           "the lesson's step, from 1")
      .only({"--view depthsort", "--view viewing", "--view scanline", "lesson"});
  r.text("--pixel", "the pixel X,Y that the window begins with, in the picture of that view", "its middle",
         [&](const std::string& s) { o.window.pixel = pixelOf("--pixel", s); })
      .only({"--view pixel"});
  r.text("--viewing",
         "explain: what the viewing transformation does to a vertex, FACE.CORNER with corners from 1, or "
         "the number of a vertex, such as 495.1 or 1234; --view viewing begins with it",
         "in the middle of the picture",
         [&](const std::string& s) {
           const bool digits = s.find_first_not_of("0123456789.") == s.npos;
           const bool isOne = s.find('.') == s.rfind('.') && !s.starts_with('.') && !s.ends_with('.');
           if (!digits || !isOne || s.size() > 20)
             refuse("--viewing", s, "FACE.CORNER or the number of a vertex, such as 495.1 or 1234");
           o.window.vertex = s;
         })
      .only({"explain", "--view viewing"})
      .mayLack = true;
  r.text(
       "--controls",
       "the few controls that stand beside a larger picture in view 1, by their keys, such as Ssn; none puts "
       "those of view 1 or 2 away. All keys work all the time",
       "all controls", [&](const std::string& s) { o.window.controls = parseControls(s); })
      .only({"view", "--whole-window"});
  r.text(
       "--scanline",
       "the row of the picture that --view machbands follows, from 0 at its top; --view scanline and "
       "trace: the "
       "polygon that is filled, by its face number, such as 59, or with .2 for the face's second convex part",
       "the middle row, or the row that shows most if nothing shows there; a polygon of about 200 samples",
       [&](const std::string& s) { takeScanline(o, s); })
      .only({"--view machbands", "--view scanline", "trace"});
  r.text("--beside",
         "the settings of B that differ from those of A, such as \"order=none shade=phong\"; same: none of "
         "them",
         "z-sort beside an exact order, Newell's beside any other",
         [&](const std::string& s) { o.window.beside = besideOf(s); })
      .only({"--view sidebyside"});
  r.choice("--difference", kUnlikes, o.window.difference, "what --view sidebyside compares")
      .only({"--view sidebyside"});
}

namespace {

struct ObliqueRow {
  std::string_view name;
  double length;
};
constexpr std::array kObliques{ObliqueRow{"cavalier", 1.0}, ObliqueRow{"cabinet", 0.5}};

Oblique parseOblique(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto* const row = std::ranges::find(kObliques, text.substr(0, colon), &ObliqueRow::name);
  if (row == kObliques.end()) refuse("--oblique", text, "cavalier or cabinet, optionally followed by :ANGLE");
  Oblique oblique{.length = row->length};
  if (colon != std::string::npos)
    oblique.angle = numbers("--oblique", text.substr(colon + 1), 1, "an angle in degrees")[0];
  return oblique;
}

}  // namespace

std::string textOf(const Oblique& oblique) {
  const auto* const row = std::ranges::find(kObliques, oblique.length, &ObliqueRow::length);
  return std::string{row->name} + ':' + textOf(oblique.angle);
}

void addCamera(Reader& r, CameraSettings& camera) {
  r.point("--eye", "where the eye is, x,y,z in the world", "where the whole scene fits",
          [&](glm::dvec3 p) { camera.eye = p; });
  r.point("--look-at", "the point that the eye looks at", "the scene's centre",
          [&](glm::dvec3 p) { camera.lookAt = p; });
  r.point("--up", "the up direction", "z for .bpt, y for .obj, .ply and .off",
          [&](glm::dvec3 p) { camera.up = p; });
  r.text("--fov", "perspective with this vertical field of view, degrees", "30",
         [&](const std::string& text) {
           camera.fov = numbers("--fov", text, 1, "an angle between 0 and 180 degrees")[0];
           if (!(*camera.fov > 0 && *camera.fov < 180))
             refuse("--fov", text, "an angle between 0 and 180 degrees");
         });
  r.text("--parallel", "parallel projection; the picture's height in world units", "",
         [&](const std::string& text) {
           camera.height = numbers("--parallel", text, 1, "a height above 0")[0];
           if (!(*camera.height > 0)) refuse("--parallel", text, "a height above 0");
           camera.parallel = true;
         });
  r.text("--oblique", "oblique projection: cavalier or cabinet, optionally followed by :ANGLE", "angle 45",
         [&](const std::string& text) { camera.oblique = parseOblique(text); })
      .proposes(kObliques);
  r.point("--vrp", "the textbook's view reference point", "the look-at point",
          [&](glm::dvec3 p) { camera.vrp = p; });
  r.point("--vpn", "view plane normal", "from the reference point to the eye",
          [&](glm::dvec3 p) { camera.vpn = p; });
  r.point("--vup", "view up vector", "up", [&](glm::dvec3 p) { camera.vup = p; });
  r.point("--prp", "projection reference point, in viewing coordinates", "the eye",
          [&](glm::dvec3 p) { camera.prp = p; });
  r.text("--view-window",
         "window umin,umax,vmin,vmax on the view plane; it overrides the height of --parallel", "",
         [&](const std::string& text) {
           const auto v = numbers("--view-window", text, 4, "four finite numbers umin,umax,vmin,vmax");
           camera.window = {v[0], v[1], v[2], v[3]};
         });
  const auto plane = [&](const char* name, const char* help, const char* initially,
                         std::optional<double>& n) {
    r.text(name, help, initially,
           [name, &n](const std::string& text) { n = numbers(name, text, 1, "a finite number")[0]; });
  };
  plane("--front", "n of the front clipping plane", "just before the eye", camera.front);
  plane("--back", "n of the back clipping plane", "behind the scene", camera.back);
}

void addEffects(Reader& r, Options& o) {
  const auto cell = [](const std::string& option, const std::string& text) {
    const std::string expected = "a cell, a whole number from 0 to 255";
    const double v = numbers(option, text, 1, expected)[0];
    if (v < 0 || v > 255 || v != std::floor(v)) refuse(option, text, expected);
    return static_cast<int>(v);
  };
  r.text("--cell", "the cell that --view colours inspects", "the middle one of the cells that polygons use",
         [&o, cell](const std::string& s) { o.window.cell = cell("--cell", s); })
      .only({"--view colours"});
  const auto drawn = {std::string_view{"draw"}, std::string_view{"snapshot"}};
  std::string tables;
  for (const TableRow& row : kTables) tables += (tables.empty() ? "" : ", ") + std::string{row.name};
  r.text("--store", "keep the indices that --table picks, but store the colours of this table: " + tables, "",
         [&o, tables](const std::string& s) {
           const auto row = std::ranges::find(kTables, s, &TableRow::name);
           if (row == kTables.end()) refuse("--store", s, "one of " + tables);
           o.effects.stored = row->id;
         })
      .proposes(kTables)
      .only(drawn);
  r.number("--turn", o.effects.hueTurn, -360, 360, "turn the hue of all stored colours by degrees")
      .only(drawn);
  r.number("--gamma", o.effects.gamma, kLeastGamma, kMostGamma,
           "store v^(1/gamma) for v, for a screen that shows v^gamma")
      .only(drawn);
  r.text("--bend", "CELL,VALUE: bend the curve of stored values so that this cell holds VALUE of 255", "",
         [&o, cell](const std::string& s) {
           const std::string expected = "CELL,VALUE with a value from 0 to 255";
           const auto v = numbers("--bend", s, 2, expected);
           if (v[1] < 0 || v[1] > 255) refuse("--bend", s, expected);
           o.effects.bend = CurvePoint{cell("--bend", s.substr(0, s.find(','))), v[1]};
         })
      .only(drawn);
  r.number("--rotate", o.effects.rotate, -255, 255, "move the stored colours up the ramp by this many cells")
      .only(drawn);
  r.text("--lit", "store yellow in this cell, to show which polygons have this shade", "",
         [&o, cell](const std::string& s) { o.effects.lit = cell("--lit", s); })
      .only(drawn);
}

}  // namespace xnewell
