#include "x11/command/costs.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "shading/laboratory/without.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/required.h"
#include "shading/trade/timing.h"

namespace xnewell {

namespace {

/// One channel and one ramp are the least that a picture can have.
bool isRequired(const Required& item) {
  return std::visit([](auto what) { return what > decltype(what){0}; }, item.what) &&
         !(item.name == "channels" && std::get<std::int64_t>(item.what) == 1) &&
         !(item.name == "ramps" && std::get<std::int64_t>(item.what) == 1);
}

/// Makes the picture as if it were the first.
double timeToMake(Shared<Scene> scene, const PictureSettings& settings, std::uint8_t ground) {
  PictureCache pictures{std::move(scene)};
  const double start = processorMs();
  (void)pictures.make(settings, ground);
  return std::max(processorMs() - start, 1e-6);
}

}  // namespace

std::vector<std::pair<std::string, double>> costsOf(const Picture& picture) {
  const std::vector<Required> required = requiredBy(picture);
  std::vector<Timed> ways;
  std::vector<const CostRow*> rows;
  // A scene is changed anew each time: several large ones might not fit into memory.
  const auto add = [&](void (*without)(Scene&, PictureSettings&)) {
    ways.push_back([&picture, without] {
      Scene scene = picture.scene();
      PictureSettings settings = picture.settings();
      if (without != nullptr) without(scene, settings);
      return timeToMake(std::move(scene), settings, picture.ground());
    });
  };
  add(nullptr);
  for (const CostRow& row : costRows()) {
    if (!isRequired(*std::ranges::find(required, row.name, &Required::name))) continue;
    rows.push_back(&row);
    if (row.alone != nullptr)
      ways.push_back([&picture, &row] { return std::max(row.alone(picture, processorMs), 1e-6); });
    else
      add(row.without);
  }

  const Timings timings = timeAll(ways, {.seconds = 2, .leastRounds = 3});
  std::vector<std::pair<std::string, double>> costs;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Timing& way = timings.of[k + 1];
    const double saved = way.tie ? 0.0 : timings.of[0].ms * (1.0 - way.ratio);
    costs.emplace_back(rows[k]->name, rows[k]->alone != nullptr ? way.ms : saved);
  }
  return costs;
}

}  // namespace xnewell
