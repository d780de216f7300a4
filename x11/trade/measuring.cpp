#include "x11/trade/measuring.h"

#include <exception>
#include <utility>

#include "shading/picture/stopwatch.h"

namespace xnewell {

namespace {

constexpr double kBetweenNews = 150;  // ms

}  // namespace

Measuring::Measuring(const Picture& picture, TradeRequest request)
    : thread_{[this, picture, request = std::move(request)] {
        const Stopwatch watch;
        double told = -kBetweenNews;
        try {
          Trade trade = tradeOf(picture.scene(), picture.settings(), request,
                                [&](const std::string& doing, const Trade& known) {
                                  if (watch.ms() >= told + kBetweenNews) {
                                    told = watch.ms();
                                    publish({known, doing, false, ""});
                                  }
                                  return !stop_;
                                });
          publish({std::move(trade), "", true, ""});
        } catch (const std::exception& e) {
          publish({{}, "", true, e.what()});
        }
      }} {}

Measuring::~Measuring() {
  stop_ = true;
  thread_.join();
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
