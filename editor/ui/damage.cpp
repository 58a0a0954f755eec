#include "editor/ui/damage.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstring>

namespace npsee::editor {
namespace {

constexpr std::size_t kMostBoxes = 8;  ///< more are joined: each goes through all that is drawn

PixelBox around(const PixelBox& a, const PixelBox& b) { return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)}; }
long long area(const PixelBox& box) { return static_cast<long long>(box.right - box.left) * (box.bottom - box.top); }

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

using Corners = std::array<ImDrawVert, 3>;

}  // namespace

PixelBox intersection(const PixelBox& a, const PixelBox& b) { return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)}; }

const std::vector<PixelBox>& Damage::find(const ImDrawData& now, std::span<const ImTextureID> redrawn) {
  boxes_.clear();
  const PixelBox window{0, 0, static_cast<int>(now.DisplaySize.x * now.FramebufferScale.x), static_cast<int>(now.DisplaySize.y * now.FramebufferScale.y)};
  const bool whole = window != window_ || scale_.x != now.FramebufferScale.x || scale_.y != now.FramebufferScale.y;
  window_ = window;
  origin_ = now.DisplayPos;
  scale_ = now.FramebufferScale;
  const auto count = static_cast<std::size_t>(now.CmdListsCount);
  next_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ImDrawList& list = *now.CmdLists[i];
    List& kept = next_[i];
    kept.commands.clear();
    for (const ImDrawCmd& command : list.CmdBuffer)
      if (command.UserCallback == nullptr) kept.commands.push_back({command.ClipRect, command.GetTexID(), command.IdxOffset, command.VtxOffset, command.ElemCount});
    kept.indices.assign(list.IdxBuffer.begin(), list.IdxBuffer.end());
    kept.vertices.assign(list.VtxBuffer.begin(), list.VtxBuffer.end());
  }
  if (whole) boxes_.push_back(window_);
  for (std::size_t i = 0; i < std::max(count, lists_.size()) && !whole; ++i) {
    if (i < count && i < lists_.size()) compare(lists_[i], next_[i]);
    else addAll(i < count ? next_[i] : lists_[i]);
    if (i < count) addTextures(next_[i], redrawn);
  }
  std::swap(lists_, next_);
  return boxes_;
}

void Damage::compare(const List& before, const List& now) {
  const bool as_many = before.commands.size() == now.commands.size();
  const auto equal = [](const Command& a, const Command& b) {
    return a.clip.x == b.clip.x && a.clip.y == b.clip.y && a.clip.z == b.clip.z && a.clip.w == b.clip.w && a.texture == b.texture && a.first_index == b.first_index && a.first_vertex == b.first_vertex && a.count == b.count;
  };
  if (as_many && same(before.indices, now.indices) && same(before.vertices, now.vertices) && std::ranges::equal(before.commands, now.commands, equal)) return;
  if (!as_many) {
    addAll(before);
    addAll(now);
    return;
  }
  for (std::size_t i = 0; i < now.commands.size(); ++i) compareCommand(before, before.commands[i], now, now.commands[i]);
}

/// What is drawn mostly differs in one place: triangles that are the same at both ends are left out.
void Damage::compareCommand(const List& before, const Command& old, const List& now, const Command& command) {
  const bool like = std::memcmp(&old.clip, &command.clip, sizeof old.clip) == 0 && old.texture == command.texture;
  const auto corner = [](const List& list, const Command& of, unsigned i) -> const ImDrawVert& { return list.vertices[of.first_vertex + list.indices[of.first_index + i]]; };
  const auto same_triangle = [&](unsigned a, unsigned b) {
    for (unsigned k = 0; k < 3; ++k)
      if (std::memcmp(&corner(before, old, 3 * a + k), &corner(now, command, 3 * b + k), sizeof(ImDrawVert)) != 0) return false;
    return true;
  };
  const unsigned had = old.count / 3, has = command.count / 3, fewer = std::min(had, has);
  unsigned first = 0, last = 0;
  while (like && first < fewer && same_triangle(first, first)) ++first;
  while (like && last < fewer - first && same_triangle(had - 1 - last, has - 1 - last)) ++last;
  addTriangles(before, old, first, had - last);
  addTriangles(now, command, first, has - last);
}

void Damage::addTextures(const List& list, std::span<const ImTextureID> redrawn) {
  for (const Command& command : list.commands)
    if (std::ranges::find(redrawn, command.texture) != redrawn.end()) addTriangles(list, command, 0, command.count / 3);
}

void Damage::addAll(const List& list) {
  for (const Command& command : list.commands) addTriangles(list, command, 0, command.count / 3);
}

void Damage::addTriangles(const List& list, const Command& command, unsigned begin, unsigned end) {
  if (begin >= end) return;
  float left = FLT_MAX, top = FLT_MAX, right = -FLT_MAX, bottom = -FLT_MAX;
  for (unsigned i = 3 * begin; i < 3 * end; ++i) {
    const ImVec2 at = list.vertices[command.first_vertex + list.indices[command.first_index + i]].pos;
    left = std::min(left, at.x), right = std::max(right, at.x), top = std::min(top, at.y), bottom = std::max(bottom, at.y);
  }
  left = std::max(left, command.clip.x), top = std::max(top, command.clip.y), right = std::min(right, command.clip.z), bottom = std::min(bottom, command.clip.w);
  if (right < left || bottom < top) return;
  // A pixel more on each side, as the rasteriser's rounding is not ours to know.
  const auto pixel = [](float at, float origin, float scale) { return static_cast<int>(std::floor((at - origin) * scale)); };
  add({pixel(left, origin_.x, scale_.x) - 1, pixel(top, origin_.y, scale_.y) - 1, pixel(right, origin_.x, scale_.x) + 2, pixel(bottom, origin_.y, scale_.y) + 2});
}

void Damage::add(PixelBox box) {
  box = intersection(box, window_);
  if (box.empty()) return;
  // Joined with what it touches, and again with what the union touches.
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t i = 0; i < boxes_.size() && !joined; ++i) {
      const PixelBox both = around(boxes_[i], box);
      if (intersection(boxes_[i], box).empty() && area(both) > area(boxes_[i]) + area(box) + 4096 && boxes_.size() < kMostBoxes) continue;
      box = both;
      boxes_.erase(boxes_.begin() + static_cast<std::ptrdiff_t>(i));
      joined = true;
    }
  }
  boxes_.push_back(box);
}

}  // namespace npsee::editor
