#pragma once

#include <npsee/error.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace npsee::fuzz {

inline void require(bool holds, const char* promise, const std::string& detail = {}) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n%s\n", promise, printable(detail).c_str());
  std::abort();
}

inline void requireFaults(const Error& error) {
  require(!error.faults.empty(), "an error names a fault");
  for (const Fault& fault : error.faults) require(!fault.what.empty() && !fault.text().empty(), "a fault says what");
}

}  // namespace npsee::fuzz
