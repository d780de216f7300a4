#include "x11/app/long_work.h"

#include <future>

namespace xnewell {

void doPatiently(const std::function<void()>& work, const std::function<void(int seconds)>& meanwhile) {
  using namespace std::chrono;
  constexpr milliseconds kTick{100};
  const auto start = steady_clock::now();
  std::future<void> done = std::async(std::launch::async, work);
  for (milliseconds wait = kPatience; done.wait_for(wait) != std::future_status::ready; wait = kTick)
    meanwhile(static_cast<int>(duration_cast<seconds>(steady_clock::now() - start).count()));
  done.get();
}

}  // namespace xnewell
