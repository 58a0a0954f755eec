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
  # Likewise sizes near 2^63 in strings that it inlines (GCC bugs 105651, 105329), and empty std::optional (GCC bug 80635). Builds with
  # less inlining keep these warnings.
  target_compile_options(npsee_options INTERFACE
    "$<$<CONFIG:Release>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds;-Wno-maybe-uninitialized>")
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

# npsee_keep_loaded(TARGET): what a program needs for AddressSanitizer to name the libraries that leak (keep_loaded.cpp says why).
function(npsee_keep_loaded target)
  if(NPSEE_SANITIZE MATCHES "address")
    target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests/sanitizers/keep_loaded.cpp")
  endif()
endfunction()

if(NPSEE_FUZZ)
  # Coverage for every target; the fuzz targets themselves link libFuzzer's main.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

find_program(NPSEE_CCACHE ccache)
set(NPSEE_PRECOMPILE ON)
if(NPSEE_CCACHE AND NOT DEFINED ENV{CCACHE_DISABLE})
  set(NPSEE_PRECOMPILE OFF)
  set(CMAKE_C_COMPILER_LAUNCHER "${NPSEE_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${NPSEE_CCACHE}")
endif()

# npsee_precompile(TARGET HEADER... | REUSE_FROM OTHER): precompiled headers, where there is no ccache, which would hardly find
# anything again with them. CCACHE_DISABLE=1 when configuring counts as no ccache. Only for headers that cost a second and more:
# each source pays for reading the whole of them. Sources include what they use all the same; builds with ccache see to that.
function(npsee_precompile target)
  if(NOT NPSEE_PRECOMPILE)
    return()
  elseif(ARGV1 STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# npsee_together(TARGET GROUP SOURCE...): compiles some sources of a target as one. Most of a compiler's time goes into headers and
# the templates each source instantiates for itself, so that a dozen small files together cost what three cost alone. Groups are
# written out, and a new file is in none: no file changes what another one is compiled with. Names in unnamed namespaces of one
# group must differ. Call it where the target is made.
#
# CMake's own UNITY_BUILD would do the same with absolute paths inside, and so spoil a compiler cache that serves several trees.
option(NPSEE_TOGETHER "Compile groups of sources together (OFF: each by itself, for tools that want that)" ON)
function(npsee_together target group)
  if(NOT NPSEE_TOGETHER)
    return()
  endif()
  set(text "// Generated; npsee_together in cmake/NpseeOptions.cmake says why.\n")
  foreach(source IN LISTS ARGN)
    file(REAL_PATH "${source}" path)
    file(RELATIVE_PATH path "${PROJECT_SOURCE_DIR}" "${path}")
    string(APPEND text "#include \"${path}\"\n")
  endforeach()
  set(together "${CMAKE_CURRENT_BINARY_DIR}/together/${target}_${group}.cpp")
  file(CONFIGURE OUTPUT "${together}" CONTENT "${text}" @ONLY)
  target_sources(${target} PRIVATE "${together}")
  set_source_files_properties(${ARGN} PROPERTIES HEADER_FILE_ONLY ON)
endfunction()
