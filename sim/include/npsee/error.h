#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// What a failure means to the caller; the command line turns it into an exit code.
enum class ErrorKind {
  usage,     ///< the request itself is wrong (exit 2)
  input,     ///< an input is unreadable or invalid (exit 3)
  graphics,  ///< no usable GL (exit 4)
  output,    ///< a result could not be written (exit 5)
};

/// One fault: what is wrong, where, and how to mend it.
struct Fault {
  std::string what;     ///< full sentence, e.g. "speed_mean is 5000 m/s, above the limit of 3000 m/s."
  std::string remedy;   ///< full sentence, may be empty
  std::string file;     ///< file name, may be empty
  int line = 0;         ///< 1-based line in `file`, 0 = unknown
  std::string pointer;  ///< JSON pointer (RFC 6901) of the value, may be empty

  /// "file:line: /pointer what\n  remedy", leaving out what is unknown.
  std::string text() const;
};

/// Every fault found, never only the first.
struct Error {
  ErrorKind kind = ErrorKind::input;
  std::vector<Fault> faults;

  /// The faults, one or two lines each, without a final newline.
  std::string text() const;
};

template <class T>
using Expected = tl::expected<T, Error>;

/// An error of one fault, ready to be returned from a function of type Expected<T>.
tl::unexpected<Error> fail(ErrorKind kind, std::string what, std::string remedy = {});
tl::unexpected<Error> fail(ErrorKind kind, Fault fault);

/// Exit code of the command line for an error: 2 usage, 3 input, 4 graphics, 5 output.
int exitCode(ErrorKind kind);

/// `text` with control characters shown as `\xNN`, so that a hostile name cannot drive a terminal.
std::string printable(std::string_view text);

}  // namespace npsee
