#include "sim/core/memory_room.h"

#include <mutex>
#include <new>

#include <sys/mman.h>

namespace npsee {
namespace {

constexpr std::size_t kReserve = 16u << 20;

// Straight from the system: an allocator keeps what is given back to it, each thread's part for that thread.
// Room alone (MAP_NORESERVE) may be more than a small machine's memory.
void* mapped(std::size_t bytes, int reserve) noexcept {
  void* const at = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | reserve, -1, 0);
  return at == MAP_FAILED ? nullptr : at;
}

std::mutex mutex;
void* held = nullptr;

}  // namespace

bool hasRoom(std::size_t bytes) noexcept {
  void* const at = mapped(bytes, MAP_NORESERVE);
  if (at != nullptr) ::munmap(at, bytes);
  return at != nullptr;
}

void MemoryReserve::hold() {
  const std::lock_guard lock(mutex);
  if (held == nullptr) held = mapped(kReserve, 0);
  if (held == nullptr) throw std::bad_alloc();
}

bool MemoryReserve::release() noexcept {
  const std::lock_guard lock(mutex);
  if (held == nullptr) return false;
  ::munmap(held, kReserve);
  held = nullptr;
  return true;
}

}  // namespace npsee
