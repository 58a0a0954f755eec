#pragma once

#include <imgui.h>

#include <span>
#include <vector>

namespace npsee::editor {

/// Pixels of the window from the upper left corner; right and bottom are not part of it.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool empty() const { return right <= left || bottom <= top; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};
PixelBox intersection(const PixelBox& a, const PixelBox& b);

/// Finds what of a window has to be drawn again: where ImGui's output differs from that of the last time, and where textures were drawn anew.
class Damage {
 public:
  /// Boxes that do not overlap; none where everything is as it was. The first call gives the whole window.
  const std::vector<PixelBox>& find(const ImDrawData& now, std::span<const ImTextureID> redrawn);

 private:
  struct Command {
    ImVec4 clip;
    ImTextureID texture = nullptr;
    unsigned first_index = 0, first_vertex = 0, count = 0;
  };
  /// What was drawn last time.
  struct List {
    std::vector<Command> commands;
    std::vector<ImDrawIdx> indices;
    std::vector<ImDrawVert> vertices;
  };
  void compare(const List& before, const List& now);
  void compareCommand(const List& before, const Command& old, const List& now, const Command& command);
  void addTextures(const List& list, std::span<const ImTextureID> redrawn);
  void addAll(const List& list);
  void addTriangles(const List& list, const Command& command, unsigned begin, unsigned end);
  void add(PixelBox box);

  PixelBox window_;
  ImVec2 origin_, scale_{1.0f, 1.0f};
  std::vector<List> lists_, next_;
  std::vector<PixelBox> boxes_;
};

}  // namespace npsee::editor
