# Flags shared by every target of ours. Results must have equal bits on every machine, so contraction
# into fused multiply-add is off everywhere and nothing is tuned to the build machine.
add_library(npsee_options INTERFACE)
target_compile_options(npsee_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror
  -ffp-contract=off -fno-math-errno)
# Vector types of our own kernels cross no library boundary; compilers note that they would be passed otherwise with AVX.
target_compile_options(npsee_options INTERFACE -Wno-psabi)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overlaps in `"text" + std::string` that cannot be (GCC bug 105651).
  target_compile_options(npsee_options INTERFACE -Wno-restrict)
endif()
target_compile_features(npsee_options INTERFACE cxx_std_20)

if(NPSEE_SANITIZE)
  add_compile_options(-fsanitize=${NPSEE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${NPSEE_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The instrumented code makes GCC see uninitialised uses that are none, e.g. inside std::regex.
    target_compile_options(npsee_options INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

if(NPSEE_FUZZ)
  # Coverage for every target; the fuzz targets themselves link libFuzzer's main.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

find_program(NPSEE_CCACHE ccache)
if(NPSEE_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER "${NPSEE_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${NPSEE_CCACHE}")
endif()
