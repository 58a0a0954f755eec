#pragma once

#include "app/render/exr_compare.h"
#include "app/render/image_compare.h"

#include <npsee/error.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::commands {

/// Two pictures that belong together; a path is empty where one of them is missing.
struct PicturePair {
  std::string name;  ///< shown to people: the relative path in both folders
  std::filesystem::path before, after;
};

enum class Verdict { same, within, different, sizes, missing, unreadable };
std::string_view verdictName(Verdict verdict);
/// Whether the tolerance is met.
inline bool passes(Verdict verdict) { return verdict == Verdict::same || verdict == Verdict::within; }

struct PairResult {
  PicturePair pair;
  Verdict verdict = Verdict::same;
  render::ImageDifference difference;      ///< where both could be compared
  std::vector<std::string> reasons;        ///< why the verdict is not same or within
  std::optional<Error> error;              ///< where a picture could not be read
  std::vector<render::PassDifference> passes = {};  ///< of OpenEXR pictures
};

/// The pairs of two files, or of all *.png and *.exr below two folders by relative path, in name order. Error kind usage: a file and a
/// folder; kind input: nothing there, or too many files.
Expected<std::vector<PicturePair>> picturePairs(const std::filesystem::path& before, const std::filesystem::path& after);

/// Compares two pictures that are at hand.
PairResult judged(PicturePair pair, const render::DeepImage& before, const render::DeepImage& after, const render::Tolerance& tolerance);

/// Reads and compares a pair, PNG or OpenEXR. A difference picture is written to `picture` if that is not empty; for `only_differing` only where
/// a pixel differs. Error kind output if it cannot be written.
Expected<PairResult> comparePair(const PicturePair& pair, const render::Tolerance& tolerance, const std::filesystem::path& picture, bool only_differing);

/// A number for people: at most `digits` digits after the point.
std::string rounded(double value, int digits);
/// The lines that `npsee compare` prints about a pair.
std::string pairText(const PairResult& result);
nlohmann::ordered_json differenceJson(const render::ImageDifference& difference);
nlohmann::ordered_json pairJson(const PairResult& result);

}  // namespace npsee::commands
