#include "tests/x11/support/random_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "shading/scene/settings.h"
#include "tests/x11/support/changed_numbers.h"
#include "x11/views/views.h"

namespace xnewell {

namespace {

class Maker {
 public:
  Maker(std::string folder, std::mt19937& rng) : folder_{std::move(folder)}, rng_{rng} {}

  RandomWords make(const std::string& scene, bool server) {
    const int what = below(100, rng_);
    if (what < 40)
      picture("draw", scene);
    else if (what < 50 && server)
      picture("snapshot", scene);
    else if (what < 60)
      view(server && oneIn(3) ? "snapshot" : "draw", scene);
    else if (what < 66)
      explain(scene);
    else if (what < 75)
      trace(scene);
    else if (what < 90)
      extremes(scene);
    else
      trade(scene);
    return std::move(made_);
  }

 private:
  bool oneIn(int n) { return below(n, rng_) == 0; }
  void add(const std::vector<std::string>& words) {
    made_.words.insert(made_.words.end(), words.begin(), words.end());
  }
  void writes(const std::string& option, const std::string& name) {
    add({option, folder_ + "/" + name});
    made_.writes.push_back(name);
  }

  /// A size of at most so many pixels a side.
  void size(int most) {
    const auto side = [&] { return std::to_string(1 + below(oneIn(4) ? 8 : most, rng_)); };
    const std::string width = side();
    add({"--size", width + "x" + side()});
  }
  std::string number(double low, double high) {
    if (oneIn(6)) return oddNumber(rng_);
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%.6g", std::uniform_real_distribution{low, high}(rng_));
    return text.data();
  }
  std::string numbers(int count, double low, double high) {
    std::string all;
    for (int k = 0; k < count; ++k) all += (k > 0 ? "," : "") + number(low, high);
    return all;
  }

  void setting() {
    const std::vector<Setting>& rows = settingRows();
    const Setting& row = rows[rng_() % rows.size()];
    // One option twice is refused, and so is the server's filler in most commands.
    if (row.option.empty() || row.option == "--fill" ||
        std::ranges::find(made_.words, row.option) != made_.words.end())
      return;
    add({std::string{row.option}});
    const double low = std::max(row.range.low, -10.0), high = std::min(row.range.high, 250.0);
    switch (row.field.kind) {
      case ValueKind::Flag:
        break;
      case ValueKind::Choice:
        add({std::string{row.field.choices[rng_() % row.field.choices.size()].name}});
        break;
      case ValueKind::Number:
        add({number(low, high)});
        break;
      case ValueKind::Whole:
        add({oneIn(8) ? oddNumber(rng_)
                      : std::to_string(std::lround(low + (high - low) * below(1000, rng_) / 999))});
        break;
      case ValueKind::Triple:
        add({numbers(3, std::max(low, -3.0), std::min(high, 3.0))});
        break;
    }
  }
  void camera() {
    switch (below(8, rng_)) {
      case 0:
        return add({"--eye", numbers(3, -8, 8)});
      case 1:
        return add(
            {"--eye", numbers(3, -3, 3), "--look-at", numbers(3, -2, 2), "--fov", number(0.001, 179.999)});
      case 2:
        return add({"--fov", number(1e-9, 180)});
      case 3:
        return add({"--parallel", number(0, 12), "--up", numbers(3, -1, 1)});
      case 4:
        return add({"--parallel", number(0, 12), "--oblique", "cavalier:" + number(0, 360)});
      case 5:
        return add({"--vrp", numbers(3, -2, 2), "--vpn", numbers(3, -1, 1), "--vup", numbers(3, -1, 1),
                    "--prp", numbers(3, -9, 9)});
      case 6:
        return add({"--view-window", numbers(4, -4, 4)});
      default:
        return add({"--front", number(-9, 9), "--back", number(-30, 0)});
    }
  }
  void options(int most) {
    for (int k = below(most + 1, rng_); k > 0; --k) setting();
    if (oneIn(3)) camera();
    if (oneIn(4)) add({"--divisions", std::to_string(1 + below(12, rng_))});
    if (oneIn(12)) add({"--max-fragments", std::to_string(1 + below(3000, rng_))});
  }

  void picture(const std::string& command, const std::string& scene) {
    add({command, scene});
    writes("-o", "picture.png");
    if (oneIn(2)) writes("--ids", "ids.png");
    size(60);
    const int told = below(8, rng_);
    if (told < 3) add({"--stats"});
    if (told >= 3 && told < 7) add({"--errors"});
    made_.printsJson = told < 7;
    if (command == "draw" && oneIn(10))
      add({"--accuracy", oneIn(2) ? "0.05" : number(0, 1), "--budget", "1"});
    options(4);
  }
  void view(const std::string& command, const std::string& scene) {
    add({command, scene});
    writes("-o", "view.png");
    std::size_t any = 0;
    while (any == 0 || !kViews[any].hasSheet()) any = rng_() % kViews.size();
    const ViewRow& row = kViews[any];
    add({"--view", std::string{row.name}, "--size",
         std::to_string(row.least.x) + "x" + std::to_string(row.least.y)});
    if (row.id == View::MachBands && oneIn(2)) add({"--scanline", std::to_string(below(300, rng_))});
    if (row.id == View::Colors && oneIn(2)) add({"--cell", std::to_string(below(256, rng_))});
    options(2);
  }
  void trace(const std::string& scene) {
    add({"trace", scene});
    const bool frames = oneIn(5);
    if (frames) add({"--frames", folder_ + "/" + kFrames});
    if (frames && oneIn(4))
      add({"--whole-window", "--size", "800x600"});
    else
      size(60);
    if (!frames && oneIn(2)) add({"--quick"});
    made_.printsLines = !frames;
    options(2);
  }
  void explain(const std::string& scene) {
    add({"explain", scene, std::to_string(below(60, rng_)) + "," + std::to_string(below(60, rng_))});
    add({"--size", "60x60"});
    made_.printsJson = oneIn(2);
    if (made_.printsJson) add({"--json"});
    options(3);
  }
  void extremes(const std::string& scene) {
    add({"extremes", scene});
    if (oneIn(2)) writes("-o", "chart.png");
    made_.printsJson = oneIn(2);
    if (made_.printsJson) add({"--json"});
    size(16);
    options(2);
  }
  void trade(const std::string& scene) {
    add({"trade", scene, "--budget", "1"});
    if (oneIn(2)) writes("-o", "chart.png");
    made_.printsJson = oneIn(2);
    if (made_.printsJson) add({"--json"});
    if (oneIn(2)) add({"--axes", oneIn(2) ? "shade,order" : "divisions"});
    size(32);
    options(2);
  }

  std::string folder_;
  std::mt19937& rng_;
  RandomWords made_;
};

}  // namespace

RandomWords randomWords(const std::string& scene, const std::string& folder, bool server, std::mt19937& rng) {
  return Maker{folder, rng}.make(scene, server);
}

RandomWords wordsForLesson(const std::string& lesson, const std::string& folder) {
  return {.words = {"lesson", lesson, "--size", "800x600", "--frames", folder + "/" + kFrames}};
}

}  // namespace xnewell
