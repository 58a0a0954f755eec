#pragma once

#include <cstddef>

namespace npsee {

/// True if the process may still map so many bytes. Whoever cannot end in good order without memory asks first; that others take it
/// meanwhile is possible, so `bytes` is many times what is needed.
bool hasRoom(std::size_t bytes) noexcept;

/// Memory that is held for the moment when there is none left; one for the process.
class MemoryReserve {
 public:
  /// Holds it unless it is held already. Throws std::bad_alloc where there is too little for it.
  static void hold();
  /// Gives it back, for what must go on to its end; false if it has been given back before.
  static bool release() noexcept;
};

}  // namespace npsee
