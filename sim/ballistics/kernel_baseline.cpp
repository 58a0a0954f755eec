#include "sim/ballistics/kernel.inl"

namespace npsee::ballistics {

const Kernels& baselineKernels() { return kKernels; }

}  // namespace npsee::ballistics
