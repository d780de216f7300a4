#include "x11/app/long_work.h"

#include <atomic>
#include <future>

#include "geometry/exact/give_up.h"

namespace xnewell {

void doPatiently(const std::function<void()>& work, const std::function<bool(int seconds)>& meanwhile) {
  using namespace std::chrono;
  constexpr milliseconds kTick{100};
  const auto start = steady_clock::now();
  std::atomic<bool> giveUp = false;
  std::future<void> done = std::async(std::launch::async | std::launch::deferred, [&] {
    const MayGiveUp once{[&] { return giveUp.exchange(false); }};
    work();
  });
  for (milliseconds wait = kPatience; done.wait_for(wait) == std::future_status::timeout; wait = kTick)
    if (meanwhile(static_cast<int>(duration_cast<seconds>(steady_clock::now() - start).count())))
      giveUp = true;
  done.get();
}

}  // namespace xnewell
