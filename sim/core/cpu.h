#pragma once

namespace npsee {

/// Whether this processor and its system run AVX2 code; false on others than x86-64. Asked at run time, so that one program uses what
/// each machine has.
bool hasAvx2();

}  // namespace npsee
