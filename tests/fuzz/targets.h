#pragma once

#include <span>
#include <string_view>

namespace npsee::fuzz {

/// What a target checks must hold for any bytes: a fault is reported, or the value is valid and survives writing and reading. A broken promise
/// aborts, which a fuzzer and a test both see.
using Target = void (*)(std::string_view bytes);

/// A preset file.
void presetFile(std::string_view bytes);
/// Lines of `--set` for presets: a refused line leaves the preset as it was.
void settings(std::string_view bytes);
/// A mission file; its text is written and read again.
void missionFile(std::string_view bytes);
/// Lines of `--set` for missions.
void missionSettings(std::string_view bytes);
/// A weapons.dat.
void weaponsFile(std::string_view bytes);
/// A rules file: what the guard lets pass is loaded.
void rulesFile(std::string_view bytes);
/// A projectile file; what is read flies without NaN.
void projectileFile(std::string_view bytes);
/// A bare table of coefficients.
void aeroTable(std::string_view bytes);
/// A recorded mission.
void recordingFile(std::string_view bytes);
/// Terrain from SRTM tiles.
void terrainHgt(std::string_view bytes);
/// Terrain from pictures; the part up to the first zero byte is the sidecar.
void terrainPng(std::string_view bytes);
/// A script of the editor.
void uiScript(std::string_view bytes);
/// A picture as `npsee compare` reads it.
void comparedPicture(std::string_view bytes);

struct NamedTarget {
  std::string_view name;  ///< of its program (NAME_fuzz) and its folder in tests/fuzz/corpus
  Target run;
  std::string_view seeds;  ///< shipped files to start from: a folder and an ending, "presets .npsee.json"
};
std::span<const NamedTarget> targets();

}  // namespace npsee::fuzz
