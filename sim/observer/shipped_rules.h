#pragma once

#include <string_view>

namespace npsee::observer {

/// Texts of assets/rules that are part of the library; generated when the build is configured.
/// templates.clp: the facts the simulator keeps up to date.
std::string_view shippedTemplates();
/// observer.clp: the autonomous forward observer.
std::string_view shippedRules();

}  // namespace npsee::observer
