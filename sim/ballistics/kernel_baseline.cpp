#include "sim/ballistics/kernel.inl"

namespace npsee::ballistics {

const Kernels& baselineKernels() { return kKernels; }

void flyAdaptive(const Setup& setup, const ShotConstants& shot, Progress& progress, Recorder* recorder) {
  flyFlock<double>(setup, &shot, &progress, 1, recorder);
}

}  // namespace npsee::ballistics
