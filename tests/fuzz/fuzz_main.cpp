// One program for every target: libFuzzer calls this with the bytes; NPSEE_TARGET is the function of targets.h.
#include "tests/fuzz/targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  npsee::fuzz::NPSEE_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
