#pragma once

#include <npsee/c.h>
#include <npsee/error.h>
#include <npsee/vec3.h>

#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <string_view>

namespace npsee::c {

/// Keeps the reason of a failure for npsee_last_error and passes the status on. Never throws: a text too long for the memory is left out.
npsee_status refuse(npsee_status status, std::string_view reason) noexcept;
npsee_status refuse(const Error& error) noexcept;

/// "FUNCTION: WHAT is null."
npsee_status refuseNull(const char* function, const char* what) noexcept;

/// "FUNCTION: WHAT"
npsee_status refuseException(const char* function, const char* what) noexcept;

/// Runs the body of an interface function; whatever it throws ends here.
template <class Work>
npsee_status guarded(const char* function, const Work& work) noexcept {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return refuse(NPSEE_MEMORY, "the memory does not suffice.");
  } catch (const std::exception& error) {
    return refuseException(function, error.what());
  } catch (...) {
    return refuseException(function, "an exception of an unknown kind.");
  }
}

/// Copies a text with its zero into the caller's buffer, as npsee_preset_text() describes it.
npsee_status copyText(std::string_view text, char* buffer, std::size_t capacity, std::size_t* length) noexcept;

/// Puts a new handle of type `Handle` into `*out`, or keeps the reason why there is none.
template <class Handle, class Value>
npsee_status handOver(Expected<Value>&& made, Handle** out) {
  if (!made) return refuse(made.error());
  *out = new Handle{std::move(*made)};
  return NPSEE_OK;
}

/// A settled call: what a function that only applies something says of its result.
inline npsee_status settle(const Expected<void>& done) { return done ? NPSEE_OK : refuse(done.error()); }

inline std::string orEmpty(const char* text) { return text == nullptr ? std::string() : std::string(text); }

/// Three numbers into a caller's array; nothing into null.
inline void put(const Vec3& vector, double* numbers) {
  if (numbers == nullptr) return;
  numbers[0] = vector.x;
  numbers[1] = vector.y;
  numbers[2] = vector.z;
}

}  // namespace npsee::c

/// Leaves the function with a usage error if a pointer is null. A macro, for the names in the message.
#define NPSEE_NEEDS(pointer) \
  if ((pointer) == nullptr) return npsee::c::refuseNull(__func__, #pointer)

/// The same for a pointer to a new handle, which is null until there is one: before all else that can fail.
#define NPSEE_MAKES(handle) \
  NPSEE_NEEDS(handle);      \
  *(handle) = nullptr
