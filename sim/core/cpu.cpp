#include "sim/core/cpu.h"

namespace npsee {

bool hasAvx2() {
#if defined(__x86_64__)
  static const bool has = [] {
    // Needed where static objects of another file ask before main().
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") != 0;
  }();
  return has;
#else
  return false;
#endif
}

}  // namespace npsee
