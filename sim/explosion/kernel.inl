// The kernels' whole code; compiled once per instruction set by kernel_*.cpp, everything in an unnamed namespace.

#include "sim/core/elementary.h"
#include "sim/explosion/contact.h"
#include "sim/explosion/kernels.h"

#include <algorithm>
#include <cstring>

namespace npsee::explosion {
namespace {

using namespace lanes;

#include "sim/explosion/find_arcs.inl"

#include "sim/explosion/evaluate.inl"

constexpr Kernels kKernels{evaluate<float>, evaluate<double>, findArcs};

}  // namespace
}  // namespace npsee::explosion
