#include "sim/explosion/kernel.inl"

namespace npsee::explosion {

const Kernels& baselineKernels() { return kKernels; }

}  // namespace npsee::explosion
