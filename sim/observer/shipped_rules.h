#pragma once

#include <string_view>

namespace npsee::observer {

/// Texts of assets/rules that are part of the library; generated when the build is configured.
/// templates.clp: the facts the simulator keeps up to date.
std::string_view shippedTemplates();
/// observer.clp, adjustment.clp, effect.clp: the autonomous forward observer, in the order they are loaded.
std::string_view shippedObserver();
std::string_view shippedAdjustment();
std::string_view shippedEffect();

}  // namespace npsee::observer
