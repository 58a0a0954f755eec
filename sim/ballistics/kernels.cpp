#include "sim/ballistics/kernels.h"

namespace npsee::ballistics {

#if defined(NPSEE_AVX2_KERNEL)
const Kernels& avx2Kernels();
#endif

const Kernels& bestKernels() {
#if defined(NPSEE_AVX2_KERNEL)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return avx2Kernels();
#endif
  return baselineKernels();
}

}  // namespace npsee::ballistics
