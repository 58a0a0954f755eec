#include "app/commands/build_id.h"

#include "sim/core/files.h"
#include "sim/core/sha256.h"

#include <cstdint>
#include <cstring>
#include <string_view>

#include <elf.h>
#include <link.h>

namespace npsee::commands {
namespace {

std::string hexOf(const unsigned char* bytes, std::size_t count) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) {
    out += "0123456789abcdef"[bytes[i] >> 4];
    out += "0123456789abcdef"[bytes[i] & 15];
  }
  return out;
}

/// The build's identifier among the notes of a segment; empty if it is not there.
std::string idInNotes(const unsigned char* at, std::size_t size) {
  const auto padded = [](std::size_t n) { return (n + 3) & ~std::size_t{3}; };
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, at, sizeof note);
    const std::size_t name = padded(note.n_namesz), whole = sizeof note + name + padded(note.n_descsz);
    if (whole > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(at + sizeof note, ELF_NOTE_GNU, 4) == 0) return hexOf(at + sizeof note + name, note.n_descsz);
    at += whole;
    size -= whole;
  }
  return {};
}

/// Called for the program first, then for its libraries.
int findId(dl_phdr_info* object, std::size_t, void* out) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    std::string& id = *static_cast<std::string*>(out);
    id = idInNotes(reinterpret_cast<const unsigned char*>(object->dlpi_addr + segment.p_vaddr), segment.p_memsz);
    if (!id.empty()) break;
  }
  return 1;
}

/// Digits that are kept: enough to tell builds, and few enough for the comment of a video.
constexpr std::size_t kBuildDigits = 32;

std::string findBuildId() {
  std::string id;
  ::dl_iterate_phdr(findId, &id);
  if (!id.empty()) return id.substr(0, kBuildDigits);
  const auto program = readTextFile("/proc/self/exe", std::size_t{1} << 30);
  return program ? sha256(*program).substr(0, kBuildDigits) : std::string("unknown");
}

}  // namespace

const std::string& buildId() {
  static const std::string id = findBuildId();
  return id;
}

}  // namespace npsee::commands
