#include "app/gl/machine.h"

namespace npsee::gl {

std::string processorClass() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  // Makers differ in the approximate reciprocals that Mesa's generated code may use.
  const std::string maker = __builtin_cpu_is("intel") ? "intel" : __builtin_cpu_is("amd") ? "amd" : "other";
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  const bool v2 = __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
  return maker + (v4 ? " x86-64-v4" : v3 ? " x86-64-v3" : v2 ? " x86-64-v2" : " x86-64");
#else
  return "other";
#endif
}

}  // namespace npsee::gl
