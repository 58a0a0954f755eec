#include <npsee/parameters.h>

#include "sim/preset/row.h"

#include <algorithm>

namespace npsee {
namespace {

const std::vector<Parameter>& allRows() {
  static const std::vector<Parameter> rows = [] {
    std::vector<Parameter> out = table::burstRows();
    for (Parameter& parameter : table::layerRows()) out.push_back(std::move(parameter));
    return out;
  }();
  return rows;
}

std::size_t burstRowCount() {
  static const std::size_t count = table::burstRows().size();
  return count;
}

}  // namespace

Value Parameter::get(const Layer& layer) const { return read(&layer); }
Value Parameter::get(const Preset& preset) const { return read(&preset); }
void Parameter::assign(Layer& layer, const Value& value) const { write(&layer, value); }
void Parameter::assign(Preset& preset, const Value& value) const { write(&preset, value); }

std::span<const Parameter> parameters() { return allRows(); }

std::span<const Parameter> parameters(Scope scope) {
  const std::span<const Parameter> all = allRows();
  return scope == Scope::burst ? all.first(burstRowCount()) : all.subspan(burstRowCount());
}

const Parameter* findParameter(Scope scope, std::string_view key) {
  for (const Parameter& parameter : parameters(scope))
    if (parameter.key == key) return &parameter;
  return nullptr;
}

std::string_view withoutEffect(const Parameter& parameter, const Preset& preset, const Layer* layer) {
  static const Layer kNone;
  return parameter.idle == nullptr ? std::string_view() : parameter.idle(preset, layer != nullptr ? *layer : kNone);
}

std::string_view title(Section section) {
  switch (section) {
    case Section::about: return "About";
    case Section::burst: return "Burst";
    case Section::surroundings: return "Surroundings";
    case Section::layer: return "Layer";
    case Section::hierarchy: return "Hierarchy";
    case Section::region: return "Region";
    case Section::launch: return "Launch";
    case Section::time: return "Time";
    case Section::flight: return "Flight";
    case Section::ground: return "Ground";
    case Section::look: return "Look";
    case Section::pieces: return "Pieces";
  }
  return "";
}

std::string_view typeName(ParameterType type) {
  switch (type) {
    case ParameterType::boolean: return "boolean";
    case ParameterType::integer: return "integer";
    case ParameterType::number: return "number";
    case ParameterType::choice: return "choice";
    case ParameterType::text: return "text";
    case ParameterType::vector: return "vector";
    case ParameterType::colour: return "colour";
    case ParameterType::curve: return "curve";
    case ParameterType::gradient: return "gradient";
  }
  return "";
}

// The members' defaults stand in the table only.
Layer::Layer() {
  for (const Parameter& parameter : parameters(Scope::layer)) parameter.write(this, parameter.initial);
}

Preset::Preset() {
  for (const Parameter& parameter : parameters(Scope::burst)) parameter.write(this, parameter.initial);
}

}  // namespace npsee
