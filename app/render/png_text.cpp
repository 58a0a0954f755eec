#include "app/render/png_text.h"

#include <zlib.h>

#include <algorithm>

namespace npsee::render {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
/// Signature and IHDR chunk.
constexpr std::size_t kHeaderSize = 8 + 25;

std::string bigEndian(std::uint32_t value) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 255u);
  return out;
}

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i) out = out << 8 | static_cast<unsigned char>(bytes[at + i]);
  return out;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace

void insertPngText(std::vector<std::uint8_t>& png, std::string_view keyword, std::string_view text) {
  const std::string body = "tEXt" + std::string(keyword) + '\0' + std::string(text);
  const std::string chunk = bigEndian(static_cast<std::uint32_t>(body.size() - 4)) + body + bigEndian(checksum(body));
  png.insert(png.begin() + static_cast<std::ptrdiff_t>(std::min(kHeaderSize, png.size())), chunk.begin(), chunk.end());
}

std::optional<std::string> textOfWholePng(std::string_view png, std::string_view keyword) {
  if (!png.starts_with(kSignature)) return std::nullopt;
  std::optional<std::string> found;
  for (std::size_t at = kSignature.size(); png.size() - at >= 12;) {
    const std::size_t length = numberAt(png, at);
    if (length > png.size() - at - 12) return std::nullopt;
    const std::string_view body = png.substr(at + 4, length + 4);
    if (numberAt(png, at + 8 + length) != checksum(body)) return std::nullopt;
    at += 12 + length;
    if (body.starts_with("IEND")) return at == png.size() ? found : std::nullopt;
    if (body.starts_with("tEXt") && body.substr(4).starts_with(keyword) && body.size() > 4 + keyword.size() && body[4 + keyword.size()] == '\0') found = body.substr(5 + keyword.size());
  }
  return std::nullopt;
}

}  // namespace npsee::render
