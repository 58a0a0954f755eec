#include "sim/observer/fire_direction.h"

#include "sim/observer/fire_computer.h"

namespace npsee::observer {

struct FireDirection::Data {
  // The computer remembers aimers between requests; that changes no result, so asking is const.
  mutable FireComputer computer;
};

FireDirection::FireDirection(std::unique_ptr<Data> data) : data_(std::move(data)) {}
FireDirection::~FireDirection() = default;
FireDirection::FireDirection(FireDirection&&) noexcept = default;
FireDirection& FireDirection::operator=(FireDirection&&) noexcept = default;

Expected<FireDirection> FireDirection::make(const BatterySetup& battery, const Weapon& weapon, const Terrain& terrain, const Weather& weather, const FdcSetup& fdc) {
  auto ammunition = ammunitionOf(battery, weapon);
  if (!ammunition) return tl::unexpected<Error>(ammunition.error());
  auto data = std::make_unique<Data>(Data{FireComputer(battery, weapon, terrain, weather, fdc, std::move(*ammunition))});
  if (auto ready = data->computer.prepare(); !ready) return tl::unexpected<Error>(ready.error());
  return FireDirection(std::move(data));
}

FireSolution FireDirection::solve(const FireRequest& request) const { return data_->computer.solve(request); }

FlightPath FireDirection::fly(const FireSolution& solution, double along_sigma, double across_sigma, double lay_error_rad) const {
  return data_->computer.fly(solution, along_sigma, across_sigma, lay_error_rad);
}

const std::vector<Charge>& FireDirection::charges() const { return data_->computer.charges(); }
double FireDirection::maxRange() const { return data_->computer.maxRange(); }
std::vector<Fault> FireDirection::warnings() const { return data_->computer.warnings(); }

std::string_view refusalWord(Refusal refusal) {
  switch (refusal) {
    case Refusal::none: return "none";
    case Refusal::out_of_range: return "out_of_range";
    case Refusal::too_close: return "too_close";
    case Refusal::masked: return "masked";
    case Refusal::elevation: return "elevation";
    case Refusal::in_sea: return "in_sea";
    case Refusal::no_convergence: return "no_convergence";
  }
  return "none";
}

}  // namespace npsee::observer
