// The kernels' whole code; compiled once per instruction set by kernel_*.cpp, everything in an unnamed namespace.

#include "sim/ballistics/kernels.h"
#include "sim/core/elementary.h"

namespace npsee::ballistics {
namespace {

using namespace lanes;

#include "sim/ballistics/atmosphere.inl"

#include "sim/ballistics/forces.inl"

#include "sim/ballistics/dormand_prince.inl"

void flyMany(const Setup& setup, const ShotConstants* shots, Progress* progress, std::size_t count) {
  // Eight lanes hide the long chains of dependent operations; a handful of shots would leave half of them idle.
  if (count >= 24) flyFlock<Eight>(setup, shots, progress, count, nullptr);
  else flyFlock<Doubles>(setup, shots, progress, count, nullptr);
}

void flyOne(const Setup& setup, const ShotConstants& shot, Progress& progress, Recorder* recorder) { flyFlock<double>(setup, &shot, &progress, 1, recorder); }

constexpr Kernels kKernels{flyMany, flyOne};

}  // namespace
}  // namespace npsee::ballistics
