#include "sim/core/arena.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace npsee {
namespace {

constexpr std::size_t kHugePage = 2u << 20;
constexpr std::size_t kSmallest = 16u << 10;
constexpr std::size_t kLargest = 32u << 20;

std::size_t roundedUp(std::size_t size, std::size_t unit) { return (size + unit - 1) / unit * unit; }

}  // namespace

Arena::Arena(std::size_t expected) : next_size_(std::clamp(expected, kSmallest, kLargest)) {}

Arena::~Arena() {
  for (const Block& block : blocks_) std::free(block.memory);
}

std::size_t Arena::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t sum = 0;
  for (const Block& block : blocks_) sum += roundedUp(block.used, block.unit);
  return sum;
}

void Arena::addBlock(std::size_t at_least) {
  std::size_t size = std::max(at_least, next_size_);
  const bool huge = size >= kHugePage / 2;
  const std::size_t unit = huge ? kHugePage : 4096;
  size = roundedUp(size, unit);
  auto* memory = static_cast<std::byte*>(std::aligned_alloc(unit, size));
  if (memory == nullptr) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
  // Only a wish: without huge pages everything works, a little slower.
  if (huge) ::madvise(memory, size, MADV_HUGEPAGE);
#endif
  blocks_.push_back({memory, size, 0, unit});
  // What the first block could not hold is a remainder; a quarter of it at a time keeps the waste small.
  next_size_ = std::clamp(size / 4, kSmallest, kLargest);
}

void* Arena::do_allocate(std::size_t bytes, std::size_t alignment) {
  const std::lock_guard lock(mutex_);
  if (!blocks_.empty()) {
    Block& block = blocks_.back();
    const std::size_t at = roundedUp(block.used, alignment);
    if (at + bytes <= block.size) {
      block.used = at + bytes;
      return block.memory + at;
    }
  }
  addBlock(bytes + alignment);
  blocks_.back().used = bytes;
  return blocks_.back().memory;
}

}  // namespace npsee
