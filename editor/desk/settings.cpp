#include "editor/desk/settings.h"

#include "sim/core/files.h"
#include "sim/core/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <system_error>
#include <variant>

namespace npsee::editor {
namespace {

using Json = nlohmann::ordered_json;

/// One row of the settings: reading, writing and checking are driven by the table.
struct Row {
  const char* key;
  std::variant<bool Settings::*, double Settings::*, std::string Settings::*, std::vector<std::string> Settings::*> member;
  double min = 0.0, max = 0.0;  ///< of numbers
};

constexpr std::array kRows{
    Row{"light_theme", &Settings::light},
    Row{"left_panels", &Settings::show_left},
    Row{"right_panels", &Settings::show_right},
    Row{"left_width", &Settings::left_width, 100, 2000},
    Row{"right_width", &Settings::right_width, 100, 2000},
    Row{"template_height", &Settings::template_height, 100, 4000},
    Row{"mission_left_width", &Settings::mission_left_width, 100, 2000},
    Row{"mission_right_width", &Settings::mission_right_width, 100, 2000},
    Row{"plan_height", &Settings::plan_height, 90, 4000},
    Row{"log_height", &Settings::log_height, 90, 4000},
    Row{"window_width", &Settings::window_width, 0, 32000},
    Row{"window_height", &Settings::window_height, 0, 32000},
    Row{"tour_done", &Settings::tour_done},
    Row{"show_extent", &Settings::show_extent},
    Row{"show_grid", &Settings::show_grid},
    Row{"background", &Settings::background},
    Row{"quality", &Settings::quality},
    Row{"exposure_stops", &Settings::exposure_stops, -4, 4},
    Row{"favourites", &Settings::favourites},
    Row{"recent", &Settings::recent},
    Row{"bookmarks", &Settings::bookmarks},
};
constexpr std::size_t kMaxList = 1000;

/// Takes a value over; empty, or what is wrong with it.
std::string take(const Row& row, const Json& value, Settings& into) {
  const auto wrong = [&](const char* wanted) { return std::string(row.key) + " is " + shownJson(value) + ", but must be " + wanted + "."; };
  if (const auto* flag = std::get_if<bool Settings::*>(&row.member)) {
    if (!value.is_boolean()) return wrong("true or false");
    into.**flag = value.get<bool>();
  } else if (const auto* number = std::get_if<double Settings::*>(&row.member)) {
    const double read = value.is_number() ? value.get<double>() : row.min - 1.0;
    if (!(read >= row.min && read <= row.max)) return wrong(("a number from " + std::to_string(static_cast<int>(row.min)) + " to " + std::to_string(static_cast<int>(row.max))).c_str());
    into.**number = read;
  } else if (const auto* text = std::get_if<std::string Settings::*>(&row.member)) {
    if (!value.is_string()) return wrong("a text");
    into.**text = value.get<std::string>();
  } else {
    const auto list = std::get<std::vector<std::string> Settings::*>(row.member);
    if (!value.is_array() || value.size() > kMaxList || !std::ranges::all_of(value, [](const Json& entry) { return entry.is_string(); })) return wrong("a list of texts");
    into.*list = value.get<std::vector<std::string>>();
  }
  return {};
}

}  // namespace

std::string settingsText(const Settings& settings) {
  Json json{{"npsee_settings", 1}};
  for (const Row& row : kRows) std::visit([&](auto member) { json[row.key] = settings.*member; }, row.member);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Expected<ReadSettings> parseSettings(std::string_view text, std::string_view file) {
  const auto json = JsonText::parse(text, file);
  if (!json) return tl::unexpected<Error>(json.error());
  if (!json->root().is_object()) return tl::unexpected<Error>(Error{ErrorKind::input, {json->fault("", "is no object with settings.")}});
  ReadSettings out;
  for (const Row& row : kRows) {
    const auto found = json->root().find(row.key);
    if (found == json->root().end()) continue;
    if (std::string wrong = take(row, *found, out.settings); !wrong.empty()) out.faults.push_back(json->fault("/" + std::string(row.key), std::move(wrong)));
  }
  return out;
}

Settings changedSettings(Settings held, const Settings& before, const Settings& now) {
  // Of the files each counts by itself.
  const auto has = [](const std::vector<std::string>& list, const std::string& file) { return std::ranges::find(list, file) != list.end(); };
  std::vector<std::string> favourites = held.favourites, recent = now.recent;
  std::erase_if(favourites, [&](const std::string& file) { return has(before.favourites, file) && !has(now.favourites, file); });
  for (const std::string& file : now.favourites)
    if (!has(before.favourites, file) && !has(favourites, file)) favourites.push_back(file);
  if (before.recent == now.recent) recent = held.recent;
  for (const std::string& file : held.recent)
    if (!has(recent, file) && recent.size() < kMaxRecent) recent.push_back(file);
  for (const Row& row : kRows)
    std::visit([&](auto member) { if (before.*member != now.*member) held.*member = now.*member; }, row.member);
  held.favourites = std::move(favourites);
  held.recent = std::move(recent);
  return held;
}

LoadedSettings loadSettings(const std::filesystem::path& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return {};
  const auto refused = [&](const Error& error) {
    // The next write must not take away what a person may want to mend.
    std::error_code failed;
    std::filesystem::path kept = file;
    kept += ".bad";
    std::filesystem::rename(file, kept, failed);
    return LoadedSettings{{}, "The settings cannot be read, so the defaults are used" + (failed ? std::string(".") : "; the file is kept as " + kept.filename().string() + ".") + "\n  " + error.text()};
  };
  const auto text = readTextFile(file);
  if (!text) return refused(text.error());
  auto read = parseSettings(*text, file.string());
  if (!read) return refused(read.error());
  LoadedSettings out{std::move(read->settings), {}};
  if (!read->faults.empty()) out.problem = "Some settings cannot be used and keep their defaults.\n  " + Error{ErrorKind::input, read->faults}.text();
  return out;
}

void noteRecent(Settings& settings, const std::string& file) {
  std::erase(settings.recent, file);
  settings.recent.insert(settings.recent.begin(), file);
  if (settings.recent.size() > kMaxRecent) settings.recent.resize(kMaxRecent);
}

}  // namespace npsee::editor
