#pragma once

namespace npsee::test {

/// Root of the source tree. A variable in one file, not a macro in all, so that compiled tests do not depend on where the tree lies and a
/// compiler cache serves every copy of it.
extern const char source_directory[];

}  // namespace npsee::test

#define NPSEE_SOURCE_DIR ::npsee::test::source_directory
