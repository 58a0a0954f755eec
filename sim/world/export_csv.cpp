#include "sim/world/export_samples.h"

#include <npsee/units.h>

#include <cmath>

namespace npsee {
namespace {

using world::rounded;
using world::Sample;

/// A value that holds a comma, a quote or a line end stands in quotes (RFC 4180). One that a spreadsheet would take for a formula
/// gets an apostrophe in front: names come from files of strangers.
std::string cell(std::string_view text) {
  std::string out(text);
  if (!out.empty() && std::string_view("=+-@\t\r").find(out[0]) != std::string_view::npos) out.insert(out.begin(), '\'');
  if (out.find_first_of(",\"\r\n") == std::string::npos) return out;
  std::string quoted = "\"";
  for (const char c : out) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string_view stateOf(const VehicleRecord& vehicle, double t) {
  const DamageStep* damage = vehicle.damageAt(t);
  if (!damage) return "whole";
  return damage->hull >= 1.0 ? "destroyed" : "damaged";
}

/// kind,id,name,side of a sample, and its state.
std::pair<std::string, std::string> words(const Recording& r, const Sample& s) {
  const auto i = static_cast<std::size_t>(s.index);
  const auto side = [](Side value) { return std::string(world::sideWord(value)); };
  switch (s.kind) {
    case Sample::Kind::vehicle: return {"vehicle," + cell(r.vehicles[i].id) + ',' + cell(r.vehicles[i].type.name) + ',' + side(r.vehicles[i].type.side), std::string(stateOf(r.vehicles[i], s.t_s))};
    case Sample::Kind::gun: return {"gun," + cell(r.guns[i].id) + ",gun,friendly", "whole"};
    default: break;
  }
  const ShellRecord& shell = r.shells[i];
  const std::string what = s.kind == Sample::Kind::shell ? "shell," : "burst,";
  return {what + std::to_string(shell.number) + ',' + cell("weapon " + std::to_string(shell.weapon)) + ',' + side(world::sideOf(r, shell)), s.kind == Sample::Kind::burst ? "burst" : s.first ? "fired" : "flying"};
}

}  // namespace

Expected<std::string> csvText(const Recording& recording, const ExportSetup& setup) {
  const auto samples = world::samplesOf(recording, setup);
  if (!samples) return tl::unexpected<Error>(samples.error());
  std::string out = "t_s,kind,id,name,side,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,heading_deg,state\n";
  for (const Sample& s : *samples) {
    const auto [name, state] = words(recording, s);
    const double turns = s.heading_rad / kTwoPi;
    out += rounded(s.t_s, 4) + ',' + name;
    for (const double value : {s.position_m.x, s.position_m.y, s.position_m.z, s.velocity_mps.x, s.velocity_mps.y, s.velocity_mps.z}) out += ',' + rounded(value, 3);
    out += ',';
    if (s.kind == Sample::Kind::vehicle || s.kind == Sample::Kind::gun) out += rounded(360.0 * (turns - std::floor(turns)), 2);
    out += ',' + state + '\n';
  }
  return out;
}

}  // namespace npsee
