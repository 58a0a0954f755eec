#pragma once

#include <npsee/error.h>

#include <functional>
#include <string>

namespace npsee::observer {

/// Runs `work` in a child process with limits on processor time and memory and without the right to write files, and returns the
/// text it returns. Nothing the work does can harm this process: a crash, a hang or exhaustion become an error of kind input that
/// says which it was ("crashed", ...), beginning with `who`. Other threads of this process go on; the child is a copy of the calling
/// one alone, so the work must start no threads and take no locks another thread may hold.
Expected<std::string> runInChild(const std::string& who, const std::function<std::string()>& work);

}  // namespace npsee::observer
