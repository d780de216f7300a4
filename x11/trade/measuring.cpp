#include "x11/trade/measuring.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "shading/picture/stopwatch.h"

namespace xnewell {

namespace {

constexpr double kBetweenNews = 150;  // ms
constexpr double kAtOnce = 3;         // seconds

}  // namespace

Measuring::Measuring(Scene scene, const PictureSettings& settings, TradeRequest request) {
  const auto measure = [this, scene = Shared<Scene>{std::move(scene)}, settings](TradeRequest asked) {
    try {
      asked.axes = choosableAxes(PictureCache{scene}.make(settings));
      publish({measured(scene, settings, asked), "", true, ""});
    } catch (const std::exception& e) {
      publish({{}, "", true, e.what()});
    }
  };
  try {
    thread_ = std::thread{measure, request};
  } catch (const std::system_error&) {  // there is no other thread, and the window stands still meanwhile
    request.seconds = std::min(request.seconds, kAtOnce);
    measure(std::move(request));
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
