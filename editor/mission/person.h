#pragma once

#include "editor/mission/document.h"

#include <string>

namespace npsee::editor {

/// What a person does in a mission: a list of commands by time, from which everything is simulated again identically.

/// The moment at which a command given while `time_s` is shown takes effect: the next tick, so that a simulation that has come
/// exactly this far and one that starts anew with the command treat it alike.
double commandTime(double time_s);

/// The commands with one more. What was recorded later for the same one in command is dropped: who acts anew at a moment of the
/// past rewrites what he did afterwards.
MissionCommands withCommand(const MissionCommands& commands, MissionCommand command);

/// True if a person has taken over `who` at a moment.
bool takenOver(const MissionCommands& commands, const std::string& who, double time_s);
/// Everybody taken over at a moment.
std::vector<std::string> allTaken(const MissionCommands& commands, double time_s);

}  // namespace npsee::editor
