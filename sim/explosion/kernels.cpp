#include "sim/explosion/kernels.h"

#include "sim/core/cpu.h"

namespace npsee::explosion {

#if defined(NPSEE_AVX2_KERNEL)
const Kernels& avx2Kernels();
#endif

const Kernels& bestKernels() {
#if defined(NPSEE_AVX2_KERNEL)
  if (hasAvx2()) return avx2Kernels();
#endif
  return baselineKernels();
}

}  // namespace npsee::explosion
