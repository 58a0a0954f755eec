// Compiled with -mavx2 where the compiler targets x86-64.
#include "sim/explosion/kernel.inl"

namespace npsee::explosion {

const Kernels& avx2Kernels() { return kKernels; }

}  // namespace npsee::explosion
