#pragma once

#include <string>

namespace npsee::gl {

/// What of the processor can change the bits of a software-drawn picture: maker and instruction sets, as the levels of the x86-64
/// psABI, e.g. "intel x86-64-v4". Pictures of one driver agree to the last bit within a class.
std::string processorClass();

}  // namespace npsee::gl
