#pragma once

#include <string_view>

namespace npsee::world {

/// Texts of assets/ that are part of the library; generated when the build is configured.
/// assets/weapons.dat, the thesis's appendix B.A.
std::string_view shippedWeapons();
/// assets/rules/forwardobserver.clp, the thesis's appendix B.C.
std::string_view shippedFacts();

}  // namespace npsee::world
