// Compiled with -mavx2 where the compiler targets x86-64.
#include "sim/ballistics/kernel.inl"

namespace npsee::ballistics {

const Kernels& avx2Kernels() { return kKernels; }

}  // namespace npsee::ballistics
