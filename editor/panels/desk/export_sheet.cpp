// Exports: what is made of the effect as it is now, by processes beside the editing.

#include "editor/panels/desk/sheets.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;
using State = Exports::Job::State;

constexpr std::array kKinds{ExportKind::picture, ExportKind::sequence, ExportKind::contact_sheet, ExportKind::sprite_sheet, ExportKind::video};
constexpr std::array kBackgrounds{"sky", "transparent", "black", "white"};

bool isSheet(ExportKind kind) { return kind == ExportKind::contact_sheet || kind == ExportKind::sprite_sheet; }

void label(const PanelContext& ui, const char* text) {
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  ImGui::PushFont(ui.fonts.small);
  ImGui::TextDisabled("%s", text);
  ImGui::PopFont();
}

/// A choice over the whole width. True if it was changed.
template <class Names>
bool choice(const PanelContext& ui, const std::string& name, std::string now, const Names& names, std::string& into) {
  ImGui::SetNextItemWidth(-1);
  const bool open = beginChoice(ui, name, now);
  ui.item("choice:" + name);
  if (!open) return false;
  bool changed = false;
  for (const auto& option : names) {
    const std::string text(option);
    if (ImGui::Selectable(text.c_str(), text == now)) {
      into = text;
      changed = true;
    }
    ui.item("choice:" + name + '=' + text);
  }
  ImGui::EndCombo();
  return changed;
}

void field(const PanelContext& ui, const char* name, std::string& text, const char* hint) {
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint((std::string("##") + name).c_str(), hint, &text);
  ui.item(std::string("field:") + name);
}

/// Makes the name and folder of the file anew for another kind or document, unless a person has written others.
void proposeFile(const PanelContext& ui) {
  DeskUi::Export& my = ui.state.desk.exports;
  const auto propose = [](std::string& text, std::string& proposed, std::string now) {
    if (text == proposed) text = now;
    proposed = std::move(now);
  };
  std::error_code ignored;
  const fs::path& path = ui.session.document.path();
  propose(my.file, my.proposed_file, exportFile(my.choice.kind, ui.session.document.name()));
  propose(my.folder, my.proposed_folder, (path.empty() ? fs::current_path(ignored) : fs::absolute(path, ignored).parent_path()).string());
}

void setKind(DeskUi::Export& my, ExportKind kind) {
  const bool was_sheet = isSheet(my.choice.kind);
  // A written name stays; its ending is the kind's.
  const std::string ending = exportFile(my.choice.kind, {});
  if (my.file != my.proposed_file && my.file.ends_with(ending)) my.file = exportFile(kind, my.file.substr(0, my.file.size() - ending.size()));
  my.choice.kind = kind;
  my.size.clear();
  if (kind == ExportKind::sprite_sheet) my.choice.width = my.choice.height = 128, my.choice.columns = my.choice.rows = 8;
  else if (kind == ExportKind::contact_sheet) my.choice.width = 320, my.choice.height = 180, my.choice.columns = 4, my.choice.rows = 3;
  else if (was_sheet) my.choice.width = 1280, my.choice.height = 720;
}

void drawKind(const PanelContext& ui) {
  DeskUi::Export& my = ui.state.desk.exports;
  std::array<std::string, kKinds.size()> names;
  std::ranges::transform(kKinds, names.begin(), [](ExportKind kind) { return std::string(exportName(kind)); });
  std::string chosen;
  label(ui, "What");
  if (!choice(ui, "export", std::string(exportName(my.choice.kind)), names, chosen)) return;
  setKind(my, kKinds[static_cast<std::size_t>(std::ranges::find(names, chosen) - names.begin())]);
}

/// "1920x1080" as two numbers.
bool readPair(const std::string& text, int most, int& first, int& second) {
  int a = 0, b = 0;
  const char* const end = text.data() + text.size();
  const auto one = std::from_chars(text.data(), end, a);
  if (one.ec != std::errc() || one.ptr == end || *one.ptr != 'x') return false;
  const auto two = std::from_chars(one.ptr + 1, end, b);
  if (two.ec != std::errc() || two.ptr != end || a < 1 || b < 1 || a > most || b > most) return false;
  first = a;
  second = b;
  return true;
}

void drawSizes(const PanelContext& ui) {
  DeskUi::Export& my = ui.state.desk.exports;
  ExportChoice& to = my.choice;
  if (my.size.empty()) {
    my.size = std::to_string(to.width) + 'x' + std::to_string(to.height);
    if (isSheet(to.kind)) my.size += ", " + std::to_string(to.columns) + 'x' + std::to_string(to.rows);
    else if (to.kind != ExportKind::picture) my.size += ", " + shortNumber(to.fps) + " fps";
  }
  label(ui, isSheet(to.kind) ? "Size of each picture, columns x rows" : to.kind == ExportKind::picture ? "Size in pixels" : "Size in pixels, frames a second");
  field(ui, "export size", my.size, "1280x720");
  const std::size_t comma = my.size.find(", ");
  bool good = readPair(my.size.substr(0, comma), render::kMaxPictureSize, to.width, to.height);
  if (isSheet(to.kind)) good = good && comma != std::string::npos && readPair(my.size.substr(comma + 2), 64, to.columns, to.rows);
  if ((to.kind == ExportKind::sequence || to.kind == ExportKind::video) && comma != std::string::npos) {
    const double fps = std::strtod(my.size.c_str() + comma + 2, nullptr);
    good = good && fps >= 1.0 && fps <= 240.0;
    if (good) to.fps = fps;
  }
  my.wrong = good ? "" : isSheet(to.kind) ? "Write for example 320x180, 4x3." : to.kind == ExportKind::picture ? "Write for example 1280x720." : "Write for example 1280x720, 30 fps.";
}

void drawLook(const PanelContext& ui) {
  ExportChoice& to = ui.state.desk.exports.choice;
  if (to.kind != ExportKind::sprite_sheet) {
    label(ui, "Background");
    choice(ui, "export background", to.background, kBackgrounds, to.background);
  }
  label(ui, "Camera");
  std::string chosen;
  constexpr std::array kCameras{"as in the viewport", "the whole effect"};
  if (choice(ui, "export camera", kCameras[to.whole_effect ? 1 : 0], kCameras, chosen)) to.whole_effect = chosen == kCameras[1];
}

void drawJob(const PanelContext& ui, std::size_t index) {
  const Exports::Job& job = ui.desk.exports().jobs()[index];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(44);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool runs = job.state == State::running;
  const std::string share = job.total > 0 ? std::to_string(job.done) + " of " + std::to_string(job.total) : "working";
  const std::string text = runs ? share : job.state == State::done ? "done" : job.state == State::cancelled ? "cancelled" : "not made";
  rowText(at, width - ui.px(34), ui.px(22), ui.theme.text, job.label);
  ImGui::PushFont(ui.fonts.small);
  rowText({at.x, at.y + ui.px(18)}, width - ui.px(34), ui.px(18), job.state == State::failed ? ui.theme.error : job.state == State::done ? ui.theme.good : ui.theme.dim, text);
  ImGui::PopFont();
  list.AddRectFilled({at.x, at.y + ui.px(38)}, {at.x + width, at.y + ui.px(41)}, ui.theme.background, ui.px(1));
  const float part = job.state == State::done ? 1.0f : job.total > 0 ? static_cast<float>(job.done) / static_cast<float>(job.total) : 0.0f;
  if (part > 0.0f) list.AddRectFilled({at.x, at.y + ui.px(38)}, {at.x + part * width, at.y + ui.px(41)}, runs ? ui.theme.accent : ui.theme.line, ui.px(1));
  ui.item("export:" + std::to_string(index), at, {at.x + width, at.y + height});
  if (runs) {
    ImGui::SetCursorScreenPos({at.x + width - ui.px(28), at.y + ui.px(4)});
    if (iconButton(ui, Icon::cross, "cancel export " + std::to_string(index), "Cancel; nothing half made stays")) ui.desk.exports().cancel(index);
  }
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  if (!job.message.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.theme.error), "%s", job.message.c_str());
    ImGui::PopTextWrapPos();
  }
}

ExportView viewOf(const PanelContext& ui) { return {ui.session.playback.time_s, ui.session.explosion() != nullptr ? ui.session.explosion()->duration_s() : 0.0, ui.session.camera, ui.state.desk.view.exposure_stops}; }

ExportChoice choiceOf(const PanelContext& ui) {
  const DeskUi::Export& my = ui.state.desk.exports;
  ExportChoice out = my.choice;
  out.output = my.file.empty() ? fs::path() : fs::path(my.folder) / my.file;
  return out;
}

/// Whether an export would overwrite a file that nobody has agreed to lose; asks then.
bool asksToReplace(const PanelContext& ui) {
  std::string& replacing = ui.state.desk.exports.replacing;
  const fs::path first = firstOutput(choiceOf(ui));
  std::error_code ignored;
  const bool asks = fs::exists(first, ignored) && replacing != first.string();
  replacing = asks ? first.string() : std::string();
  return asks;
}

void startExport(const PanelContext& ui) {
  if (asksToReplace(ui)) return;
  if (const auto started = ui.desk.exports().start(ui.session.document.preset(), choiceOf(ui), viewOf(ui)); !started) ui.session.notices.error = started.error().text();
}

}  // namespace

void copyCommandLine(const PanelContext& ui) {
  proposeFile(ui);
  const auto line = ui.desk.commandLine(ui.session.document, choiceOf(ui), viewOf(ui));
  if (!line) {
    ui.session.notices.error = line.error().text();
    return;
  }
  ImGui::SetClipboardText(line->c_str());
  ui.session.notices.note = "Copied the command line that makes the same " + std::string(exportName(ui.state.desk.exports.choice.kind)) + '.';
}

void openExport(const PanelContext& ui, ExportKind kind) {
  if (ui.state.desk.exports.choice.kind != kind || ui.state.desk.exports.size.empty()) setKind(ui.state.desk.exports, kind);
  ui.state.desk.sheet = DeskUi::Sheet::exports;
  ui.state.show_help = false;
}

void drawExportSheet(const PanelContext& ui) {
  DeskUi::Export& my = ui.state.desk.exports;
  sheetHeading(ui, "Export");
  ImGui::BeginChild("export", ImVec2(0, 0));
  drawKind(ui);
  drawSizes(ui);
  drawLook(ui);
  proposeFile(ui);
  label(ui, "File");
  field(ui, "export file", my.file, "name");
  field(ui, "export folder", my.folder, "folder");
  if (!my.wrong.empty()) ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.theme.error), "%s", my.wrong.c_str());
  if (!ui.session.design.solo.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.theme.accent), "All layers are exported, not only those shown alone. Switch the others off to leave them out.");
    ImGui::PopTextWrapPos();
    ui.item("export:all layers");
  }
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  ImGui::BeginDisabled(!my.wrong.empty());
  if (my.replacing != firstOutput(choiceOf(ui)).string()) my.replacing.clear();
  if (!my.replacing.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.theme.accent), "%s exists. Replace it, or choose another name.", fs::path(my.replacing).filename().c_str());
    ImGui::PopTextWrapPos();
  }
  const bool exported = textButton(ui, my.replacing.empty() ? "Export" : "Replace", "export", true);
  ImGui::SameLine();
  const bool copied = textButton(ui, "Copy command line", "copy command line");
  ImGui::EndDisabled();
  if (exported) startExport(ui);
  if (copied) copyCommandLine(ui);
  const auto& jobs = ui.desk.exports().jobs();
  if (!jobs.empty()) {
    ImGui::Dummy(ImVec2(1, ui.px(6)));
    heading(ui, "At work and done");
    for (std::size_t i = jobs.size(); i-- > 0;) drawJob(ui, i);
    if (static_cast<int>(jobs.size()) > ui.desk.exports().running() && textButton(ui, "Clear what is done", "clear exports")) ui.desk.exports().clearFinished();
  }
  ImGui::EndChild();
}

}  // namespace npsee::editor
