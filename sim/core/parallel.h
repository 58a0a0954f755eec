#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace npsee {

/// Calls `work(i)` for i in [0, count) on up to `threads` threads, this one included; returns when all are done. Which thread does
/// which i is open, so `work` must write only what belongs to i. The first exception is thrown on.
template <class Work>
void parallelFor(int threads, std::size_t count, const Work& work) {
  const std::size_t helpers = threads > 1 && count > 1 ? std::min<std::size_t>(static_cast<std::size_t>(threads), count) - 1 : 0;
  if (helpers == 0) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto loop = [&] {
    try {
      for (std::size_t i; (i = next.fetch_add(1)) < count;) work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> pool;
    for (std::size_t i = 0; i < helpers; ++i) pool.emplace_back(loop);
    loop();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace npsee
