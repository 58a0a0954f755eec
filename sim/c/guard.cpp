#include "sim/c/guard.h"

#include <cstring>

namespace npsee::c {
namespace {

/// The text of a thread's last failure; where the memory did not suffice for it, `fallback` says so.
struct LastError {
  std::string text;
  const char* fallback = nullptr;
};

LastError& lastError() {
  thread_local LastError last;
  return last;
}

}  // namespace

npsee_status refuse(npsee_status status, std::string_view reason) noexcept {
  LastError& last = lastError();
  try {
    last.text = reason;
    last.fallback = nullptr;
  } catch (...) {
    last.fallback = "the memory does not suffice, not even for the message.";
  }
  return status;
}

npsee_status refuse(const Error& error) noexcept {
  try {
    const npsee_status status = error.kind == ErrorKind::usage ? NPSEE_USAGE : error.kind == ErrorKind::output ? NPSEE_OUTPUT : NPSEE_INPUT;
    return refuse(status, error.text());
  } catch (...) {
    return refuse(NPSEE_MEMORY, "the memory does not suffice.");
  }
}

npsee_status refuseNull(const char* function, const char* what) noexcept {
  try {
    return refuse(NPSEE_USAGE, std::string(function) + ": " + what + " is null.");
  } catch (...) {
    return refuse(NPSEE_MEMORY, "the memory does not suffice.");
  }
}

npsee_status refuseException(const char* function, const char* what) noexcept {
  try {
    return refuse(NPSEE_INTERNAL, std::string(function) + ": " + what);
  } catch (...) {
    return refuse(NPSEE_INTERNAL, function);
  }
}

npsee_status copyText(std::string_view text, char* buffer, std::size_t capacity, std::size_t* length) noexcept {
  if (length != nullptr) *length = text.size();
  if (buffer == nullptr && capacity == 0) return NPSEE_OK;
  if (buffer == nullptr) return refuse(NPSEE_USAGE, "the buffer is null, but its capacity is not 0.");
  if (capacity <= text.size()) return refuse(NPSEE_USAGE, "the buffer is too short for the text; ask for its length first and give a byte more for the zero.");
  std::memcpy(buffer, text.data(), text.size());
  buffer[text.size()] = '\0';
  return NPSEE_OK;
}

}  // namespace npsee::c

extern "C" {

const char* npsee_version(void) { return NPSEE_VERSION; }

unsigned npsee_abi(void) { return NPSEE_ABI; }

const char* npsee_last_error(void) {
  const auto& last = npsee::c::lastError();
  return last.fallback != nullptr ? last.fallback : last.text.c_str();
}

}
