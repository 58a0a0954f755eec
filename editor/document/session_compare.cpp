// Comparing and variations: presets beside the edited one.

#include "editor/document/session.h"
#include "editor/document/vary.h"

#include <utility>

namespace npsee::editor {

void Session::updateCompared() {
  compare.update(shownTime(), scripted());
  // Another preset may have been opened that is too large for nine.
  if (explosion_ != nullptr && explosion_->particleCount() > Variations::kMostParticles) variations.open = false;
  if (!variations.open) return;
  // Variations are those of the preset as it is now and of the amount chosen now.
  const std::pair now{document.revision(), design.amount};
  if (now != varied_) gatherVariations();
  variations.update(shownTime(), scripted());
}

void Session::compareWith(std::shared_ptr<const Preset> preset, std::string name) {
  compare.preset = std::move(preset);
  compare.name = std::move(name);
  compare.taken = nullptr;
  compare.flipped = false;
  if (compare.mode == Compare::Mode::off) compare.mode = Compare::Mode::split;
}

void Session::keepForComparing() {
  compareWith(document.snapshot(), "kept state");
  notices.note = "The state now is kept as A.";
}

void Session::compareWithUndo(std::size_t back) {
  const auto states = document.history().undoSteps();
  if (back == 0 || back > states) return;
  compareWith(document.history().undoState(back).content, "before " + document.history().undoLabels()[states - back]);
}

void Session::compareWithFile(const std::filesystem::path& path) {
  auto preset = loadPreset(path);
  if (!preset) {
    notices.error = preset.error().text();
    return;
  }
  std::string name = preset->title.empty() ? path.filename().string() : preset->title;
  compareWith(std::make_shared<const Preset>(std::move(*preset)), std::move(name));
}

void Session::swapCompared() {
  if (compare.preset == nullptr) return;
  const auto before = document.snapshot();
  const auto other = compare.preset;
  if (took(document.edit("Swap A and B", {}, [&](Preset& preset) { preset = *other; }))) {
    // Swapped to and fro, without an edit between, the same two names come back.
    const bool back = compare.taken != nullptr && *compare.taken == *before;
    std::string name = back ? compare.taken_name : document.name() + ", before the swap";
    compare.taken_name = std::exchange(compare.name, std::move(name));
    compare.taken = other;
    compare.preset = before;
  }
}

void Session::showVariations() {
  if (explosion_ != nullptr && explosion_->particleCount() > Variations::kMostParticles) {
    notices.error = "Nine variations of " + std::to_string(explosion_->particleCount()) + " particles are too much at once.\n  Lower counts or densities to " + std::to_string(Variations::kMostParticles) + " particles first, or randomise (D).";
    return;
  }
  variations.open = true;
  design.draws += Variations::kCount;
  gatherVariations();
}

void Session::gatherVariations() {
  varied_ = {document.revision(), design.amount};
  for (std::size_t i = 0; i < Variations::kCount; ++i) {
    if (i == Variations::kMiddle) variations.presets[i] = document.snapshot();
    else variations.presets[i] = std::make_shared<const Preset>(varied(document.preset(), {design.amount, design.draws + i, -1, {}, &design.locked}));
  }
}

void Session::adoptVariation(std::size_t index) {
  if (!variations.open || index >= Variations::kCount || variations.presets[index] == nullptr) return;
  const auto chosen = variations.presets[index];
  design.draws += Variations::kCount;
  if (took(document.edit("Adopt variation", {}, [&](Preset& preset) { preset = *chosen; }))) notices.note = "Variation " + std::to_string(index + 1) + " is the preset now; undo takes it back.";
}

}  // namespace npsee::editor
