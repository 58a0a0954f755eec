#include "tests/support/source_directory.h"

namespace npsee::test {

constinit const char source_directory[] = NPSEE_SOURCE_PATH;

}  // namespace npsee::test
