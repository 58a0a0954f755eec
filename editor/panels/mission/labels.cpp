#include "editor/panels/mission/panels.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace npsee::editor {
namespace {

using MarkKind = render::MissionMark::Kind;

struct Label {
  std::string text;
  ImVec2 at;             ///< of what it names
  float above = 0.0f;    ///< px from there to the text's lower edge
  ImU32 colour = 0;
  int rank = 0;          ///< the lowest is placed first
  double depth = 0.0;
};

struct Taken {
  ImVec2 min, max;
  bool meets(const ImVec2& a, const ImVec2& b) const { return min.x < b.x && a.x < max.x && min.y < b.y && a.y < max.y; }
};

std::optional<Label> labelOf(const PanelContext& ui, const Box& box, const render::MissionMark& mark) {
  const MissionSession& mission = ui.session.mission();
  const Recording& recording = *mission.recording();
  const double t = mission.clock.time_s;
  const auto index = static_cast<std::size_t>(mark.index);
  Label out{{}, {box.at.x + static_cast<float>(mark.x), box.at.y + static_cast<float>(mark.y)}, 0.5f * std::clamp(static_cast<float>(mark.size_px), ui.px(8), ui.px(60)) + ui.px(5), 0, 5, mark.depth_m};
  const ObjectRef& selected = mission.document.selected();
  switch (mark.kind) {
    case MarkKind::vehicle: {
      const VehicleRecord& vehicle = recording.vehicles[index];
      if (mission.owner(mark.index).kind == ObjectRef::Kind::observer) return std::nullopt;
      out.text = vehicle.id;
      out.colour = vehicle.destroyedAt(t) ? ui.theme.dim : sideColour(ui, vehicle.type.side);
      out.rank = mission.selectedVehicle() == mark.index ? 0 : vehicle.destroyedAt(t) ? 6 : 3;
      break;
    }
    case MarkKind::gun:
      out.text = recording.guns[index].id;
      out.colour = ui.theme.geometry;
      out.rank = selected == ObjectRef{ObjectRef::Kind::gun, out.text} ? 0 : 4;
      break;
    case MarkKind::observer:
      out.text = recording.observers[index].id;
      out.colour = ui.theme.geometry;
      out.rank = selected == ObjectRef{ObjectRef::Kind::observer, out.text} ? 0 : 2;
      break;
    case MarkKind::shell:
      out.text = "shell " + std::to_string(recording.shells[index].number);
      out.colour = ui.theme.accent;
      out.rank = 1;
      break;
    case MarkKind::burst:
    case MarkKind::belief: return std::nullopt;
  }
  // Above the mark that stands over what it names.
  const bool marked = mark.kind != MarkKind::shell && mission.view.overlays.icons && mark.size_px <= 110.0 * static_cast<double>(ui.scale);
  if (marked) out.above = std::max(out.above, ui.px(20));
  if (out.rank == 0) out.colour = ui.theme.accent;
  // What a hill hides is named only where it is selected.
  if (mark.hidden && out.rank != 0) return std::nullopt;
  return out;
}

}  // namespace

void drawLabels(const PanelContext& ui, const Box& box) {
  std::vector<Label> labels;
  for (const render::MissionMark& mark : ui.pictures.marks(ui.session.mission(), static_cast<int>(box.width), static_cast<int>(box.height)))
    if (auto label = labelOf(ui, box, mark)) labels.push_back(std::move(*label));
  std::ranges::stable_sort(labels, [](const Label& a, const Label& b) { return a.rank != b.rank ? a.rank < b.rank : a.depth < b.depth; });
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  // In the glass a name stands well below what it names and below the scale, joined by a line: what is looked at stays free.
  const bool glass = ui.session.mission().view.camera.kind == render::MissionCamera::Kind::observer;
  // The time and the hint stand in the corner; nothing is written over them.
  std::vector<Taken> taken{{box.at, {box.at.x + ui.px(100), box.at.y + ui.px(34)}}};
  for (const Label& label : labels) {
    const ImVec2 size = ImGui::CalcTextSize(label.text.c_str());
    ImVec2 min{std::floor(label.at.x - 0.5f * size.x), std::floor(label.at.y - label.above - size.y)};
    if (label.at.x < box.at.x || label.at.x > box.right() || label.at.y < box.at.y || label.at.y > box.end().y) continue;
    // The glass shows nothing outside of its circle.
    if (glass && std::hypot(label.at.x - box.at.x - 0.5f * box.width, label.at.y - box.at.y - 0.5f * box.height) > 0.48f * static_cast<float>(render::kCircleShare) * box.height) continue;
    // Whole within the picture: at its edge beside or below rather than cut.
    min.x = std::clamp(min.x, box.at.x + ui.px(4), std::max(box.at.x + ui.px(4), box.right() - size.x - ui.px(4)));
    if (glass) {
      min.y = std::floor(label.at.y + ui.px(44));
      const float scale = box.at.y + 0.5f * box.height;
      if (min.y + size.y > scale - ui.px(8) && min.y < scale + ui.px(28)) min.y = std::floor(scale + ui.px(28));
    }
    if (!glass && min.y < box.at.y + ui.px(2)) min.y = std::floor(label.at.y + label.above);
    const ImVec2 max{min.x + size.x, min.y + size.y};
    const ImVec2 room_min{min.x - ui.px(3), min.y - ui.px(1)}, room_max{max.x + ui.px(3), max.y + ui.px(1)};
    if (label.rank != 0 && std::ranges::any_of(taken, [&](const Taken& other) { return other.meets(room_min, room_max); })) continue;
    taken.push_back({room_min, room_max});
    if (glass) list.AddLine({label.at.x, min.y - ui.px(2)}, {label.at.x, label.at.y + ui.px(10)}, faded(label.colour, 0.6f), 1.0f);
    list.AddRectFilled(room_min, room_max, faded(ui.theme.background, 0.78f), ui.px(3));
    list.AddText(min, label.colour, label.text.c_str());
    ui.item("label:" + label.text, min, max);
  }
  ImGui::PopFont();
}

}  // namespace npsee::editor
