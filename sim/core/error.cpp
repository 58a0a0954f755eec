#include <npsee/error.h>

namespace npsee {

std::string printable(std::string_view text) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    // UTF-8 text passes. C0 controls and DEL could move a terminal's cursor or worse, and so could C1, which is 0xC2 and 0x80 to 0x9f: without
    // the first byte the second is no character.
    if (byte < 0x20 || byte == 0x7f || (byte == 0xc2 && next >= 0x80 && next < 0xa0)) {
      out += "\\x";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      out += c;
    }
  }
  return out;
}

std::string Fault::text() const {
  std::string out;
  if (!file.empty()) {
    out += printable(file);
    if (line > 0) out += ':' + std::to_string(line);
    out += ": ";
  }
  if (!pointer.empty()) out += printable(pointer) + ": ";
  out += printable(what);
  if (!remedy.empty()) out += "\n  " + printable(remedy);
  return out;
}

std::string Error::text() const {
  std::string out;
  for (const Fault& fault : faults) {
    if (!out.empty()) out += '\n';
    out += fault.text();
  }
  return out;
}

tl::unexpected<Error> fail(ErrorKind kind, std::string what, std::string remedy) {
  return fail(kind, Fault{.what = std::move(what), .remedy = std::move(remedy), .file = {}, .line = 0, .pointer = {}});
}

tl::unexpected<Error> fail(ErrorKind kind, Fault fault) {
  return tl::unexpected<Error>(Error{kind, {std::move(fault)}});
}

int exitCode(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage: return 2;
    case ErrorKind::input: return 3;
    case ErrorKind::graphics: return 4;
    case ErrorKind::output: return 5;
  }
  return 2;
}

}  // namespace npsee
