#pragma once

#include "sim/c/guard.h"

#include <npsee/recording.h>

#include <cstddef>

namespace npsee::c {

/// What missions and recordings tell alike; the functions of npsee/c.h say how.
npsee_status event(const Recording& recording, std::size_t index, char* buffer, std::size_t capacity, std::size_t* length);
npsee_status vehicle(const Recording& recording, std::size_t index, double t_s, npsee_vehicle* out);
npsee_status shell(const Recording& recording, std::size_t index, double t_s, npsee_shell* out);
npsee_status unmet(const Recording& recording, char* buffer, std::size_t capacity, std::size_t* length);

npsee_status refuseIndex(const char* what, std::size_t count);
npsee_status refuseTime();

}  // namespace npsee::c
