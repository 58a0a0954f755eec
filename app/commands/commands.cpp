#include "app/commands/command.h"

#include <CLI/CLI.hpp>

namespace npsee::commands {

void addAll(CLI::App& app, Outcome& outcome) {
  addEdit(app, outcome);
  addRender(app, outcome);
  addCompare(app, outcome);
  addParticles(app, outcome);
  addMission(app, outcome);
  addCheck(app, outcome);
  addParams(app, outcome);
  addFly(app, outcome);
  addTable(app, outcome);
  addAim(app, outcome);
  addWeapons(app, outcome);
  addReplay(app, outcome);
  addManual(app, outcome);
}

}  // namespace npsee::commands
