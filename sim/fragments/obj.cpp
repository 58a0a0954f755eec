#include "sim/core/text.h"
#include "sim/fragments/polygon.h"
#include "sim/fragments/shells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace npsee {
namespace {

using fragments::Loop;

constexpr std::size_t kMaxFaults = 20, kMaxMaterials = 1000, kMaxCorners = 1000, kMaxPoints = 200'000;
/// Coordinates beyond it are mistakes: 100 km.
constexpr double kMaxCoordinate = 1e5;

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> out;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_not_of(" \t\r", at);
    if (begin == std::string_view::npos) break;
    at = std::min(line.find_first_of(" \t\r", begin), line.size());
    out.push_back(line.substr(begin, at - begin));
  }
  return out;
}

bool number(std::string_view word, double& out) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(out);
}

/// Walks over the lines of a file and keeps what is wrong with them.
class ObjLines {
 public:
  ObjLines(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  /// Calls `take(words)` for each line that says something; stops after some faults.
  template <class Take>
  void read(const Take& take) {
    for (std::size_t at = 0; at < text_.size() && faults.size() < kMaxFaults;) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      std::string_view line = text_.substr(at, end - at);
      at = end + 1;
      ++line_;
      line = line.substr(0, line.find('#'));
      if (const auto words = wordsOf(line); !words.empty()) take(words);
    }
  }
  void wrong(std::string what, std::string remedy = {}) { faults.push_back({.what = std::move(what), .remedy = std::move(remedy), .file = std::string(name_), .line = line_, .pointer = {}}); }

  std::vector<Fault> faults;

 private:
  std::string_view text_, name_;
  int line_ = 0;
};

std::string quoted(std::string_view word) { return '"' + printable(word.substr(0, 60)) + '"'; }

/// Colours by the names of a material library; what else it says is passed over.
std::map<std::string, Colour, std::less<>> coloursOf(std::string_view mtl) {
  std::map<std::string, Colour, std::less<>> out;
  std::string name;
  ObjLines reader(mtl, {});
  reader.read([&](const std::vector<std::string_view>& words) {
    if (words[0] == "newmtl" && words.size() > 1) name = words[1];
    double r = 0.0, g = 0.0, b = 0.0;
    if (words[0] != "Kd" || words.size() < 4 || name.empty() || out.size() >= kMaxMaterials) return;
    if (number(words[1], r) && number(words[2], g) && number(words[3], b)) out[name] = {std::clamp(r, 0.0, 1.0), std::clamp(g, 0.0, 1.0), std::clamp(b, 0.0, 1.0)};
  });
  return out;
}

class ObjReader {
 public:
  ObjReader(std::string_view obj, std::string_view mtl, std::string_view name) : lines_(obj, name), colours_(coloursOf(mtl)) {}

  std::vector<Fault> read(Solid& surface, std::vector<SolidModel::Material>& materials) {
    lines_.read([&](const std::vector<std::string_view>& words) {
      if (words[0] == "v") point(words, surface);
      else if (words[0] == "f") face(words, surface);
      else if (words[0] == "usemtl") material_ = words.size() > 1 ? materialOf(words[1]) : 0;
    });
    if (materials_.empty()) materialOf("");
    materials = std::move(materials_);
    return std::move(lines_.faults);
  }

 private:
  void point(const std::vector<std::string_view>& words, Solid& surface) {
    Vec3 p;
    if (words.size() < 4 || !number(words[1], p.x) || !number(words[2], p.y) || !number(words[3], p.z)) {
      lines_.wrong("a point needs three finite numbers.", "Write it as: v 1.0 0.5 -2.0");
      // It counts as a point all the same: faces that use later ones are not wrong for it.
      p = {};
    }
    if (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) > kMaxCoordinate) lines_.wrong("a point lies further out than " + std::to_string(static_cast<int>(kMaxCoordinate)) + ".", "Coordinates are metres, or become metres by pieces.scale.");
    if (surface.points.size() >= kMaxPoints) return tooMuch("points", kMaxPoints);
    surface.points.push_back(p);
  }

  void face(const std::vector<std::string_view>& words, Solid& surface) {
    if (words.size() > kMaxCorners + 1) return lines_.wrong("a face has " + std::to_string(words.size() - 1) + " corners, above the limit of " + std::to_string(kMaxCorners) + ".");
    Loop loop;
    for (std::size_t i = 1; i < words.size(); ++i) {
      std::uint32_t corner = 0;
      if (!index(words[i], surface.points.size(), corner)) return;
      if (loop.empty() || loop.back() != corner) loop.push_back(corner);
    }
    if (words.size() < 4) return lines_.wrong("a face has " + std::to_string(words.size() - 1) + " corners, but needs at least 3.");
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() < 3) return;  // a sliver, as exporters write now and then
    if (surface.facets.size() + loop.size() - 2 > kMaxModelFacets) return tooMuch("triangles", kMaxModelFacets);
    if (materials_.empty()) material_ = materialOf("");
    fragments::fillLoop(surface.points, loop, material_, surface.facets);
  }

  /// The first number of a corner (v, v/vt, v//vn, v/vt/vn); negative ones count back from the last point.
  bool index(std::string_view word, std::size_t count, std::uint32_t& out) {
    const std::string_view text = word.substr(0, word.find('/'));
    long long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      lines_.wrong("the corner " + quoted(word) + " is not the number of a point.", "Write a face as: f 1 2 3");
      return false;
    }
    const auto points = static_cast<long long>(count);
    const long long at = value > 0 ? value - 1 : points + value;
    if (value == 0 || at < 0 || at >= points) {
      lines_.wrong("the face uses point " + std::to_string(value) + ", but there are " + std::to_string(points) + " points so far, counted from 1.", "Points stand above the faces that use them.");
      return false;
    }
    out = static_cast<std::uint32_t>(at);
    return true;
  }

  std::uint16_t materialOf(std::string_view name) {
    for (std::size_t i = 0; i < materials_.size(); ++i)
      if (materials_[i].name == name) return static_cast<std::uint16_t>(i);
    if (materials_.size() >= kMaxMaterials) {
      tooMuch("materials", kMaxMaterials);
      return 0;
    }
    SolidModel::Material material{std::string(name), FacetPaint::layer, {}};
    if (const auto found = colours_.find(name); found != colours_.end()) {
      material.colour = found->second;
      // Roles, not colours: what they are painted with depends on whose they are.
      if (name != "body" && name != "accent") material.paint = FacetPaint::own;
    }
    materials_.push_back(std::move(material));
    return static_cast<std::uint16_t>(materials_.size() - 1);
  }

  void tooMuch(std::string_view what, std::size_t limit) {
    lines_.wrong("there are more than " + std::to_string(limit) + ' ' + std::string(what) + ".", "Simplify the model.");
    // What follows would only say the same.
    while (lines_.faults.size() < kMaxFaults) lines_.faults.push_back({});
  }

  ObjLines lines_;
  std::map<std::string, Colour, std::less<>> colours_;
  std::vector<SolidModel::Material> materials_;
  std::uint16_t material_ = 0;
};

}  // namespace

Expected<SolidModel> parseSolidModel(std::string_view obj, std::string_view mtl, std::string_view name) {
  const auto refuse = [&](std::string what, std::string remedy) { return fail(ErrorKind::input, Fault{.what = std::move(what), .remedy = std::move(remedy), .file = std::string(name), .line = 0, .pointer = {}}); };
  if (obj.size() > kMaxModelFile) return refuse("the model has " + std::to_string(obj.size()) + " bytes, above the limit of " + std::to_string(kMaxModelFile) + ".", "Simplify it.");
  SolidModel out;
  out.name = name;
  Solid surface;
  std::vector<Fault> faults = ObjReader(obj, mtl, name).read(surface, out.materials);
  std::erase_if(faults, [](const Fault& fault) { return fault.what.empty(); });
  if (!faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  if (surface.facets.empty()) return refuse("the model has no faces.", "Write points as v and faces as f lines.");
  out.shells = fragments::shellsOf(std::move(surface));
  if (out.shells.empty()) return refuse("the model encloses no volume: it is a sheet, or lies in one plane.", "Only what has an inside can come apart.");
  return out;
}

}  // namespace npsee
