#pragma once

#include "sim/core/memory_room.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace npsee {

/// Calls `work(i)` for i in [0, count) on up to `threads` threads, this one included; returns when all are done. Which thread does
/// which i is open, so `work` must write only what belongs to i. The first exception is thrown on. Where the system gives fewer threads, or no room
/// beside them, fewer do the same work.
template <class Work>
void parallelFor(int threads, std::size_t count, const Work& work) {
  constexpr std::size_t kRoomForWork = 1u << 30;  // allocators set aside some dozen MiB for each of their threads
  const std::size_t helpers = threads > 1 && count > 1 ? std::min<std::size_t>(static_cast<std::size_t>(threads), count) - 1 : 0;
  if (helpers == 0) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<std::size_t> allowed{helpers};
  const auto loop = [&](std::size_t ordinal) {
    try {
      for (std::size_t i; ordinal <= allowed && (i = next.fetch_add(1)) < count;) work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> pool;
    pool.reserve(helpers);
    // What is used up here, memory or a number of threads, others need too: half of these go home.
    const auto enough = [&] { allowed = pool.size() / 2; };
    try {
      for (std::size_t ordinal = 1; ordinal <= helpers && allowed == helpers; ++ordinal)
        if (hasRoom(kRoomForWork)) pool.emplace_back(loop, ordinal);
        else enough();
    } catch (const std::system_error&) {
      enough();
    }
    loop(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace npsee
