#include "editor/mission/person.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {

double commandTime(double time_s) { return (std::floor(time_s / kMissionTick_s + 0.5) + 1.0) * kMissionTick_s; }

MissionCommands withCommand(const MissionCommands& commands, MissionCommand command) {
  MissionCommands out;
  for (const MissionCommand& known : commands)
    if (known.t_s <= command.t_s || known.who != command.who) out.push_back(known);
  // Of two wishes for one tick the later one counts.
  if (command.kind == MissionCommand::Kind::drive)
    std::erase_if(out, [&](const MissionCommand& known) { return known.kind == command.kind && known.who == command.who && known.t_s == command.t_s; });
  const auto place = std::ranges::upper_bound(out, command.t_s, {}, &MissionCommand::t_s);
  out.insert(place, std::move(command));
  return out;
}

bool takenOver(const MissionCommands& commands, const std::string& who, double time_s) {
  bool taken = false;
  for (const MissionCommand& command : commands) {
    if (command.t_s > time_s || command.who != who) continue;
    if (command.kind == MissionCommand::Kind::take) taken = true;
    if (command.kind == MissionCommand::Kind::release) taken = false;
  }
  return taken;
}

std::vector<std::string> allTaken(const MissionCommands& commands, double time_s) {
  std::vector<std::string> out;
  for (const MissionCommand& command : commands)
    if (command.kind == MissionCommand::Kind::take && takenOver(commands, command.who, time_s) && std::ranges::find(out, command.who) == out.end()) out.push_back(command.who);
  return out;
}

}  // namespace npsee::editor
