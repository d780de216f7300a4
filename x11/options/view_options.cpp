#include <algorithm>
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

bool isView(std::string_view name) { return std::ranges::find(kViews, name, &ViewRow::name) != kViews.end(); }

/// The names of all views of draw, snapshot and the window, each once.
std::string viewNames() {
  std::string all;
  for (const ViewRow& row : kViews) all += (all.empty() ? "" : ", ") + std::string{row.name};
  all += "; in a window";
  for (const WindowViewRow& row : kWindowViews)
    if (!isView(row.option)) all += (all.ends_with("window") ? " " : ", ") + std::string{row.option};
  return all;
}

/// Returns false if no view has that name. checkTogether() checks later whether the command has this view.
bool takeView(Options& o, const std::string& name) {
  o.viewName = name;
  const auto* const view = std::ranges::find(kViews, name, &ViewRow::name);
  const auto* const window = std::ranges::find(kWindowViews, name, &WindowViewRow::option);
  const auto* const show = std::ranges::find(kShows, name, &ShowRow::name);
  o.view = view == kViews.end() ? View::Picture : view->id;
  o.window.view = window == kWindowViews.end() ? WindowView::Picture : window->id;
  o.show = show == kShows.end() ? Show::Shaded : show->id;
  return view != kViews.end() || window != kWindowViews.end();
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
  OptionRow& view = r.text("--view", "what to show: " + viewNames(), o.viewName, [&](const std::string& s) {
    if (!takeView(o, s)) refuse("--view", s, viewNames());
  });
  view.proposes(kViews).only({"view", "draw", "snapshot"});
  for (const WindowViewRow& row : kWindowViews)
    if (!isView(row.option)) view.words.emplace_back(row.option);
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

}  // namespace xnewell
