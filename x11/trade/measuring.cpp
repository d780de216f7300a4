#include "x11/trade/measuring.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "shading/picture/stopwatch.h"

namespace xnewell {

namespace {

constexpr double kBetweenNews = 150;  // ms

}  // namespace

Measuring::Measuring(Scene scene, const PictureSettings& settings, TradeRequest request,
                     std::vector<std::string> without) {
  auto measure = [this, scene = Shared<Scene>{std::move(scene)}, settings, request = std::move(request),
                  without = std::move(without)]() mutable {
    try {
      request.axes = choosableAxes(PictureCache{scene}.make(settings));
      std::erase_if(request.axes, [&](const std::string& axis) {
        return std::ranges::find(without, axis) != without.end();
      });
      if (request.axes.empty()) throw std::runtime_error{"every short cut is chosen already"};
      publish({measured(scene, settings, request), "", true, ""});
    } catch (const std::exception& e) {
      publish({{}, "", true, e.what()});
    }
  };
  try {
    thread_ = std::thread{std::move(measure)};
  } catch (const std::system_error& e) {
    publish({{}, "", true, "the system refuses a thread: " + e.code().message()});
  }
}

Trade Measuring::measured(const Shared<Scene>& scene, const PictureSettings& settings,
                          const TradeRequest& request) {
  const Stopwatch watch;
  double told = -kBetweenNews;
  return tradeOf(scene, settings, request, [&](const std::string& doing, const Trade& known) {
    if (watch.ms() >= told + kBetweenNews) {
      told = watch.ms();
      publish({known, doing, false, ""});
    }
    return !stop_;
  });
}

Measuring::~Measuring() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Measuring::publish(News news) {
  const std::lock_guard lock{mutex_};
  news_ = std::move(news);
}

std::optional<Measuring::News> Measuring::news() {
  const std::lock_guard lock{mutex_};
  return std::exchange(news_, std::nullopt);
}

}  // namespace xnewell
