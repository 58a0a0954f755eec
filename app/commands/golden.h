#pragma once

#include "app/commands/compare_pairs.h"
#include "app/commands/render_work.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace npsee::commands {

/// The machine that drew a golden, kept in NAME.json beside NAME.png.
struct GoldenRecord {
  std::string driver;     ///< Context::description
  std::string processor;  ///< gl::processorClass
  friend bool operator==(const GoldenRecord&, const GoldenRecord&) = default;
};

/// How a new picture compares with its golden. The pictures (encoded PNG) are kept for the report where they are worth showing and
/// there is room.
struct GoldenResult {
  PairResult pair;
  bool updated = false;
  bool same_machine = false;
  std::vector<std::uint8_t> before, after, difference;
};

/// Judges new pictures by a folder of goldens. `judge` may be called from several threads for different items.
class GoldenCheck {
 public:
  struct Settings {
    std::filesystem::path folder;
    GoldenRecord machine;         ///< this one
    render::Tolerance tolerance;  ///< exact(): by machine
    bool update = false;
    bool keep_pictures = false;   ///< for a report
  };
  GoldenCheck(Settings settings, const std::vector<WorkItem>& items);

  /// Compares, and writes the golden where that is wanted and needed. Error kind output if it cannot be written.
  Expected<void> judge(std::size_t index, const render::Image& image);

  const std::vector<GoldenResult>& results() const { return results_; }
  const Settings& settings() const { return settings_; }

 private:
  GoldenResult compared(const WorkItem& item, const render::Image& image) const;
  Expected<void> update(const WorkItem& item, const render::Image& image) const;
  void keepPictures(GoldenResult& result, const WorkItem& item, const render::Image& image);

  Settings settings_;
  const std::vector<WorkItem>& items_;
  std::vector<GoldenResult> results_;
  std::atomic<std::size_t> kept_bytes_ = 0;
};

/// Allowed where a golden was drawn by another driver or class of processor: 0.01 % of the pixels by more than 2 levels.
render::Tolerance toleranceElsewhere();

struct GoldenCounts {
  std::size_t same = 0, within = 0, failed = 0, updated = 0;
};
GoldenCounts countsOf(const std::vector<GoldenResult>& results);

/// The lines for people: what differs, and a summary.
std::string goldenText(const GoldenCheck& check);

/// One HTML page with the pictures inside, and JUnit XML.
std::string goldenPage(const GoldenCheck& check);
std::string goldenJunit(const GoldenCheck& check);

}  // namespace npsee::commands
