#include "sim/core/text.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace npsee {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, change});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::optional<std::string_view> best;
  // Longer words than any key of ours are not worth a quadratic comparison.
  if (word.empty() || word.size() > 128) return best;
  std::size_t least = std::max<std::size_t>(2, (word.size() + 1) / 2) + 1;
  for (const std::string_view candidate : candidates) {
    // Every letter of difference in length is an edit: most candidates are out before they are compared.
    if (word.size() >= candidate.size() + least) continue;
    std::size_t distance = editDistance(word, candidate);
    // "speed" should find "speed_mean" although five letters are missing.
    if (candidate.size() > word.size() && word.size() >= 3 && candidate.find(word) != std::string_view::npos)
      distance = std::min<std::size_t>(distance, 2);
    // ... and so should "spede".
    if (candidate.size() > word.size() && word.size() >= 4) distance = std::min(distance, editDistance(word, candidate.substr(0, word.size())) + 1);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string listed(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " and " : ", ";
    out += words[i];
  }
  return out;
}

bool validUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
    const unsigned first = byte(i), second = byte(i + 1);
    std::size_t length = 1;
    // Table 3-7 of the Unicode standard: the second byte's range depends on the first.
    if (first >= 0xf0 && first <= 0xf4 && second >= (first == 0xf0 ? 0x90u : 0x80u) && second <= (first == 0xf4 ? 0x8fu : 0xbfu)) length = 4;
    else if (first >= 0xe0 && first <= 0xef && second >= (first == 0xe0 ? 0xa0u : 0x80u) && second <= (first == 0xed ? 0x9fu : 0xbfu)) length = 3;
    else if (first >= 0xc2 && first <= 0xdf && second >= 0x80 && second <= 0xbf) length = 2;
    else if (first >= 0x80) return false;
    for (std::size_t k = 2; k < length; ++k)
      if (byte(i + k) < 0x80 || byte(i + k) > 0xbf) return false;
    i += length;
  }
  return true;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::string withDecimals(double value, int decimals) {
  char text[400];  // the largest number has 309 digits before the point
  return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, std::clamp(decimals, 0, 60)).ptr);
}

}  // namespace npsee
