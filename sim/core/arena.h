#pragma once

#include <cstddef>
#include <memory_resource>
#include <mutex>
#include <vector>

namespace npsee {

/// Memory that is taken piece by piece and given back all at once, in large blocks on huge pages where the system has them: the arcs
/// of many particles are read all over at every frame, and ordinary pages would cost a fault each when they are written and a
/// look-up each when they are read. Allocation is thread-safe.
class Arena final : public std::pmr::memory_resource {
 public:
  /// `expected` bytes are a hint for the first block.
  explicit Arena(std::size_t expected = 0);
  ~Arena() override;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Bytes in use, in whole pages; the unused end of a block is address space only.
  std::size_t bytes() const;

 private:
  struct Block {
    std::byte* memory = nullptr;
    std::size_t size = 0, used = 0;
    std::size_t unit = 0;  ///< page size
  };
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void*, std::size_t, std::size_t) override {}
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
  void addBlock(std::size_t at_least);

  mutable std::mutex mutex_;
  std::vector<Block> blocks_;
  std::size_t next_size_;
};

}  // namespace npsee
