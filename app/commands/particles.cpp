#include "app/commands/command.h"

#include <npsee/explosion.h>
#include <npsee/parameters.h>

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <thread>

namespace npsee::commands {
namespace {

struct Options {
  PresetChoice preset;
  std::string time;
  std::string format = "csv";
  std::string output;
};

constexpr std::array kColumns{"layer", "index", "alive", "age_s", "x_m", "y_m", "z_m", "vx_mps", "vy_mps", "vz_mps", "size_m", "r", "g", "b", "a", "bounces"};

/// Bytes of text written at a time.
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

int dump(const Options& options) {
  const auto time = parseQuantity(options.time, Unit::second);
  if (!time) return report({ErrorKind::usage, {{.what = "--time " + options.time + ": " + time.error().faults.front().what, .remedy = "For example --time 0.5 or --time 500ms.", .file = {}, .line = 0, .pointer = {}}}});
  const auto preset = loadChosen(options.preset);
  if (!preset) return report(preset.error());
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const auto explosion = Explosion::compile(*preset, std::nullopt, nullptr, {.threads = threads});
  if (!explosion) return report(explosion.error());

  ExactFrame frame;
  (*explosion)->at(*time, frame, kVelocity | kLook | kBounces | kAge, threads);
  // Written piece by piece, so that millions of particles need no second copy as text.
  const bool csv = options.format == "csv";
  std::string text;
  if (csv) {
    for (const char* column : kColumns) text += (text.empty() ? "" : ",") + std::string(column);
    text += '\n';
  } else {
    text = "[";
  }
  bool first = true;
  for (const LayerSpan& layer : (*explosion)->layers())
    for (std::size_t i = 0; i < layer.count; ++i) {
      if (csv) appendCsv(text, layer, frame, i);
      else appendJson(text, layer, frame, i, first);
      if (text.size() < kPiece) continue;
      if (const int code = writeResult(text); code != 0) return code;
      text.clear();
    }
  return writeResult(csv ? text : text + "\n]\n");
}

}  // namespace

void addParticles(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("particles", "Print the state of every particle at a time, at full precision, for checks and other tools");
  addPresetOptions(*command, options->preset);
  command->add_option("--time", options->time, "Time after the burst in seconds (\"0.5\", \"500ms\")")->required()->type_name("T");
  command->add_option("--format", options->format, "csv or json")->check(CLI::IsMember({"csv", "json"}))->type_name("FORMAT");
  command->footer("Columns: layer,index,alive,age_s,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,size_m,r,g,b,a,bounces\n"
                  "A particle that is not alive stands where it was born or died, with size and a of 0.\n"
                  "Examples:\n  npsee particles presets/classic_1993.npsee.json --time 0.5\n"
                  "  npsee particles presets/classic_1993.npsee.json --time 2 --seed 7 --set fragments.restitution=0.8 --format json");
  command->callback([options, &outcome] { outcome.exit_code = dump(*options); });
}

}  // namespace npsee::commands
