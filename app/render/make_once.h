#pragma once

#include <npsee/error.h>

#include <optional>
#include <utility>

namespace npsee::render {

/// Makes a pass when a picture first needs it: start-up time counts, and most pictures need few. Arguments go to its create().
template <class Pass, class... Arguments>
Expected<void> makeOnce(std::optional<Pass>& pass, Arguments... arguments) {
  if (pass) return {};
  auto made = Pass::create(arguments...);
  if (!made) return tl::unexpected<Error>(made.error());
  pass = std::move(*made);
  return {};
}

}  // namespace npsee::render
