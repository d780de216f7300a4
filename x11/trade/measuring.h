#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "shading/trade/trade.h"

namespace xnewell {

/// A trade that is measured on a thread of its own, while the window goes on.
class Measuring {
 public:
  /// Starts at once, on the axes of choosableAxes().
  Measuring(Scene scene, const PictureSettings& settings, TradeRequest request);
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;
  /// Stops it and waits for the end of what it is doing, at most one picture.
  ~Measuring();

  struct News {
    Trade trade;
    std::string doing;  ///< "timing short cuts: round 3"
    bool done = false;
    std::string failure;  ///< why it ended without a trade; "" if it did not
  };
  /// What is new since the last call; nothing if that was all.
  [[nodiscard]] std::optional<News> news();

 private:
  [[nodiscard]] Trade measured(const Shared<Scene>& scene, const PictureSettings& settings,
                               const TradeRequest& request);
  void publish(News news);

  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::optional<News> news_;
  std::thread thread_;  // last, so that it finds the others
};

}  // namespace xnewell
