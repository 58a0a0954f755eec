#pragma once

#include "sim/observer/clips_host.h"

#include <string>
#include <string_view>

extern "C" {
#include <clips/clips.h>
}

namespace npsee::observer {

/// Values, facts and messages of CLIPS as values and texts of ours. For clips_host.cpp alone: this header brings CLIPS with it.

/// A number, word or text. Throws std::invalid_argument for anything else (a list, a fact).
RuleValue valueOf(int type, void* value);
void setValue(void* env, dataObject& out, const RuleValue& value);
/// "(contact (id 3) ...)"; slots that hold nothing are left out.
std::string factText(const fact& given);
/// Whole numbers without a point, others so that they read back the same.
std::string numberText(double value);
/// The sentence of a message of CLIPS, without its code and without the echo of the text read so far.
std::string sentence(std::string_view message);

}  // namespace npsee::observer
