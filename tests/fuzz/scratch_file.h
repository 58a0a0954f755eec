#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace npsee::fuzz {

/// The bytes as a file, for what is read by path; removed at the end.
class ScratchFile {
 public:
  ScratchFile(const std::string& ending, std::string_view bytes) : path_(std::filesystem::temp_directory_path() / ("npsee_fuzz_" + std::to_string(::getpid()) + ending)) {
    std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace npsee::fuzz
