#include "app/commands/particle_formats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace npsee::commands {
namespace {

static_assert(std::endian::native == std::endian::little, "the PLY files are written in the machine's own order");

constexpr std::array kColumns{"layer", "index", "alive", "age_s", "x_m", "y_m", "z_m", "vx_mps", "vy_mps", "vz_mps", "size_m", "r", "g", "b", "a", "bounces"};

/// Bytes handed over at a time.
constexpr std::size_t kPiece = 1 << 20;

/// Shortest text that reads back as the same double.
void append(std::string& out, double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

/// The numbers of one row in column order, after layer, index and alive.
std::array<double, 12> numbersOf(const ExactFrame& f, std::size_t i) {
  return {f.age[i], f.x[i], f.y[i], f.z[i], f.vx[i], f.vy[i], f.vz[i], f.size[i], f.r[i], f.g[i], f.b[i], f.a[i]};
}

void appendCsv(std::string& out, const LayerSpan& layer, const ExactFrame& f, std::size_t i) {
  const std::size_t at = layer.first + i;
  out += layer.name + ',' + std::to_string(i) + ',' + (f.alive[at] ? '1' : '0');
  for (const double number : numbersOf(f, at)) {
    out += ',';
    append(out, number);
  }
  out += ',' + std::to_string(f.bounces[at]) + '\n';
}

void appendJson(std::string& out, const LayerSpan& layer, const ExactFrame& f, std::size_t i, bool& first) {
  const std::size_t at = layer.first + i;
  out += first ? "\n" : ",\n";
  first = false;
  out += "{\"layer\":\"" + layer.name + "\",\"index\":" + std::to_string(i) + ",\"alive\":" + (f.alive[at] ? '1' : '0');
  const auto numbers = numbersOf(f, at);
  for (std::size_t column = 0; column < numbers.size(); ++column) {
    out += ",\"" + std::string(kColumns[column + 3]) + "\":";
    append(out, numbers[column]);
  }
  out += ",\"bounces\":" + std::to_string(f.bounces[at]) + '}';
}

/// A comment of a PLY header ends with its line.
std::string oneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

std::string plyHeader(const ParticleDump& dump) {
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment npsee " NPSEE_VERSION "\ncomment title " + oneLine(dump.title) + "\ncomment seed " + std::to_string(dump.seed) + "\ncomment time_s ";
  append(out, dump.frame.time_s);
  out += "\ncomment axes x east, y up, z south; metres, seconds\n";
  for (std::size_t i = 0; i < dump.layers.size(); ++i) out += "comment layer " + std::to_string(i) + ' ' + dump.layers[i].name + '\n';
  out += "element vertex " + std::to_string(std::count(dump.frame.alive.begin(), dump.frame.alive.begin() + static_cast<std::ptrdiff_t>(dump.frame.count), 1)) + '\n';
  for (const char* name : {"x", "y", "z", "vx", "vy", "vz", "size", "age", "qx", "qy", "qz", "qw"}) out += std::string("property float ") + name + '\n';
  for (const char* name : {"red", "green", "blue", "alpha", "bounces"}) out += std::string("property uchar ") + name + '\n';
  return out + "property ushort layer\nproperty int id\nend_header\n";
}

template <class T>
void appendBytes(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

void appendPly(std::string& out, std::size_t layer, const ExactFrame& f, std::size_t at) {
  if (f.alive[at] == 0) return;
  for (const double value : {f.x[at], f.y[at], f.z[at], f.vx[at], f.vy[at], f.vz[at], f.size[at], f.age[at], f.qx[at], f.qy[at], f.qz[at], f.qw[at]}) appendBytes(out, static_cast<float>(value));
  for (const double value : {f.r[at], f.g[at], f.b[at], f.a[at]}) appendBytes(out, static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
  appendBytes(out, f.bounces[at]);
  appendBytes(out, static_cast<std::uint16_t>(layer));
  appendBytes(out, static_cast<std::int32_t>(at));
}

}  // namespace

std::string endingOf(ParticleFormat format) { return format == ParticleFormat::csv ? ".csv" : format == ParticleFormat::json ? ".json" : ".ply"; }

std::string particleColumns() {
  std::string out;
  for (const char* column : kColumns) out += (out.empty() ? "" : ",") + std::string(column);
  return out;
}

bool writeParticles(ParticleFormat format, const ParticleDump& dump, const TextSink& sink) {
  std::string text = format == ParticleFormat::csv ? particleColumns() + '\n' : format == ParticleFormat::json ? "[" : plyHeader(dump);
  bool first = true;
  for (std::size_t k = 0; k < dump.layers.size(); ++k)
    for (std::size_t i = 0; i < dump.layers[k].count; ++i) {
      const LayerSpan& layer = dump.layers[k];
      if (format == ParticleFormat::csv) appendCsv(text, layer, dump.frame, i);
      else if (format == ParticleFormat::json) appendJson(text, layer, dump.frame, i, first);
      else appendPly(text, k, dump.frame, layer.first + i);
      if (text.size() < kPiece) continue;
      if (!sink(text)) return false;
      text.clear();
    }
  if (format == ParticleFormat::json) text += "\n]\n";
  return sink(text);
}

}  // namespace npsee::commands
