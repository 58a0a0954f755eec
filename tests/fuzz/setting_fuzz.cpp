// libFuzzer target: bytes as lines of `--set`.
#include "tests/fuzz/targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  npsee::fuzz::settings({reinterpret_cast<const char*>(data), size});
  return 0;
}
