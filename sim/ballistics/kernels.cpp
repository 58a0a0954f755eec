#include "sim/ballistics/kernels.h"

#include "sim/core/cpu.h"

namespace npsee::ballistics {

#if defined(NPSEE_AVX2_KERNEL)
const Kernels& avx2Kernels();
#endif

const Kernels& bestKernels() {
#if defined(NPSEE_AVX2_KERNEL)
  if (hasAvx2()) return avx2Kernels();
#endif
  return baselineKernels();
}

}  // namespace npsee::ballistics
