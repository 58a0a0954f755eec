#include "editor/ui/icons.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace npsee::editor {
namespace {

/// Pen with coordinates from -1 to 1 in the icon's square.
struct Pen {
  ImDrawList& list;
  ImVec2 centre;
  float half;
  ImU32 colour;
  float width;

  ImVec2 at(float x, float y) const { return {centre.x + x * half, centre.y + y * half}; }
  void line(std::initializer_list<ImVec2> points, bool closed = false) const {
    list.PathClear();
    for (const ImVec2& p : points) list.PathLineTo(at(p.x, p.y));
    list.PathStroke(colour, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
  }
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const { list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour); }
  void bar(float x0, float y0, float x1, float y1) const { list.AddRectFilled(at(x0, y0), at(x1, y1), colour); }
  void arc(float x, float y, float radius, float from, float to) const {
    list.PathClear();
    list.PathArcTo(at(x, y), radius * half, from, to, 20);
    list.PathStroke(colour, ImDrawFlags_None, width);
  }
};

void drawTransport(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::play: return p.triangle({-0.6f, -0.8f}, {0.8f, 0.0f}, {-0.6f, 0.8f});
    case Icon::pause: p.bar(-0.6f, -0.75f, -0.2f, 0.75f); return p.bar(0.2f, -0.75f, 0.6f, 0.75f);
    case Icon::to_start: p.bar(-0.75f, -0.7f, -0.5f, 0.7f); return p.triangle({0.7f, -0.7f}, {-0.4f, 0.0f}, {0.7f, 0.7f});
    case Icon::to_end: p.bar(0.5f, -0.7f, 0.75f, 0.7f); return p.triangle({-0.7f, -0.7f}, {0.4f, 0.0f}, {-0.7f, 0.7f});
    case Icon::step_back: return p.line({{0.35f, -0.6f}, {-0.35f, 0.0f}, {0.35f, 0.6f}});
    case Icon::step_on: return p.line({{-0.35f, -0.6f}, {0.35f, 0.0f}, {-0.35f, 0.6f}});
    case Icon::event_back: p.line({{0.1f, -0.6f}, {-0.6f, 0.0f}, {0.1f, 0.6f}}); return p.bar(0.4f, -0.65f, 0.58f, 0.65f);
    case Icon::event_on: p.line({{-0.1f, -0.6f}, {0.6f, 0.0f}, {-0.1f, 0.6f}}); return p.bar(-0.58f, -0.65f, -0.4f, 0.65f);
    case Icon::loop:
      p.arc(0.0f, 0.0f, 0.65f, -0.9f, 2.2f);
      p.arc(0.0f, 0.0f, 0.65f, 2.7f, 4.9f);
      return p.triangle({0.0f, -1.0f}, {0.0f, -0.3f}, {0.45f, -0.65f});
    default: return;
  }
}

void drawEye(const Pen& p, bool open) {
  p.line({{-0.9f, 0.0f}, {-0.45f, -0.42f}, {0.0f, -0.55f}, {0.45f, -0.42f}, {0.9f, 0.0f}, {0.45f, 0.42f}, {0.0f, 0.55f}, {-0.45f, 0.42f}}, true);
  if (open) p.list.AddCircleFilled(p.centre, 0.26f * p.half, p.colour, 12);
  else p.line({{-0.7f, 0.75f}, {0.7f, -0.75f}});
}

void drawPaper(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::copy:
      p.line({{-0.75f, -0.75f}, {0.3f, -0.75f}, {0.3f, 0.3f}, {-0.75f, 0.3f}}, true);
      return p.line({{0.3f, -0.3f}, {0.75f, -0.3f}, {0.75f, 0.75f}, {-0.3f, 0.75f}, {-0.3f, 0.3f}});
    case Icon::bin:
      p.line({{-0.75f, -0.5f}, {0.75f, -0.5f}});
      p.line({{-0.3f, -0.5f}, {-0.3f, -0.8f}, {0.3f, -0.8f}, {0.3f, -0.5f}});
      return p.line({{-0.55f, -0.5f}, {-0.45f, 0.85f}, {0.45f, 0.85f}, {0.55f, -0.5f}});
    case Icon::folder: return p.line({{-0.85f, 0.6f}, {-0.85f, -0.6f}, {-0.25f, -0.6f}, {0.0f, -0.3f}, {0.85f, -0.3f}, {0.85f, 0.6f}}, true);
    case Icon::file: return p.line({{-0.55f, 0.8f}, {-0.55f, -0.8f}, {0.2f, -0.8f}, {0.6f, -0.4f}, {0.6f, 0.8f}}, true);
    default: return;
  }
}

void drawMark(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::plus: p.line({{-0.7f, 0.0f}, {0.7f, 0.0f}}); return p.line({{0.0f, -0.7f}, {0.0f, 0.7f}});
    case Icon::minus: return p.line({{-0.7f, 0.0f}, {0.7f, 0.0f}});
    case Icon::cross: p.line({{-0.5f, -0.5f}, {0.5f, 0.5f}}); return p.line({{-0.5f, 0.5f}, {0.5f, -0.5f}});
    case Icon::reset: p.arc(0.0f, 0.1f, 0.6f, -2.4f, 2.3f); return p.triangle({-0.95f, -0.2f}, {-0.15f, -0.3f}, {-0.62f, -0.9f});
    case Icon::chevron_right: return p.line({{-0.25f, -0.5f}, {0.25f, 0.0f}, {-0.25f, 0.5f}});
    case Icon::chevron_down: return p.line({{-0.5f, -0.25f}, {0.0f, 0.25f}, {0.5f, -0.25f}});
    case Icon::up: p.line({{0.0f, 0.8f}, {0.0f, -0.7f}}); return p.line({{-0.55f, -0.15f}, {0.0f, -0.7f}, {0.55f, -0.15f}});
    case Icon::frame:
      p.line({{-0.75f, -0.3f}, {-0.75f, -0.75f}, {-0.3f, -0.75f}});
      p.line({{0.3f, -0.75f}, {0.75f, -0.75f}, {0.75f, -0.3f}});
      p.line({{0.75f, 0.3f}, {0.75f, 0.75f}, {0.3f, 0.75f}});
      return p.line({{-0.3f, 0.75f}, {-0.75f, 0.75f}, {-0.75f, 0.3f}});
    case Icon::search: p.arc(-0.15f, -0.15f, 0.5f, 0.0f, 6.2831853f); return p.line({{0.22f, 0.22f}, {0.75f, 0.75f}});
    default: return;
  }
}

void drawLock(const Pen& p, bool open) {
  p.line({{-0.5f, -0.05f}, {0.5f, -0.05f}, {0.5f, 0.75f}, {-0.5f, 0.75f}}, true);
  if (!open) p.bar(-0.5f, -0.05f, 0.5f, 0.75f);
  p.arc(open ? 0.32f : 0.0f, -0.2f, 0.32f, -3.1415927f, 0.0f);
  p.line({{open ? 0.0f : -0.32f, -0.2f}, {open ? 0.0f : -0.32f, -0.05f}});
  if (!open) p.line({{0.32f, -0.2f}, {0.32f, -0.05f}});
}

void drawDesign(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::solo: p.arc(0.0f, 0.0f, 0.62f, 0.0f, 6.2831853f); return p.list.AddCircleFilled(p.centre, 0.24f * p.half, p.colour, 12);
    case Icon::lock: return drawLock(p, false);
    case Icon::lock_open: return drawLock(p, true);
    case Icon::dice:
      p.line({{-0.7f, -0.7f}, {0.7f, -0.7f}, {0.7f, 0.7f}, {-0.7f, 0.7f}}, true);
      for (const float d : {-0.35f, 0.0f, 0.35f}) p.list.AddCircleFilled(p.at(d, d), std::max(1.0f, 0.14f * p.half), p.colour, 8);
      return;
    case Icon::seed:
      for (int i = 0; i < 6; ++i) {
        const float angle = 1.0471976f * static_cast<float>(i);
        p.line({{0.25f * std::cos(angle), 0.25f * std::sin(angle)}, {0.8f * std::cos(angle), 0.8f * std::sin(angle)}});
      }
      return;
    case Icon::paste:
      p.line({{-0.6f, -0.6f}, {0.6f, -0.6f}, {0.6f, 0.8f}, {-0.6f, 0.8f}}, true);
      return p.bar(-0.28f, -0.8f, 0.28f, -0.4f);
    case Icon::flip:
      p.line({{0.0f, -0.8f}, {0.0f, 0.8f}});
      p.triangle({-0.25f, -0.5f}, {-0.25f, 0.5f}, {-0.85f, 0.0f});
      return p.line({{0.25f, -0.5f}, {0.25f, 0.5f}, {0.85f, 0.0f}}, true);
    case Icon::grid:
      for (const float x : {-0.55f, 0.0f, 0.55f})
        for (const float y : {-0.55f, 0.0f, 0.55f}) p.bar(x - 0.18f, y - 0.18f, x + 0.18f, y + 0.18f);
      return;
    default: return;
  }
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
  const Pen pen{list, {std::floor(centre.x) + 0.5f, std::floor(centre.y) + 0.5f}, 0.5f * size, colour, std::max(1.2f, size / 11.0f)};
  if (icon <= Icon::loop) return drawTransport(pen, icon);
  if (icon == Icon::eye || icon == Icon::eye_off) return drawEye(pen, icon == Icon::eye);
  if (icon == Icon::copy || icon == Icon::bin || icon == Icon::folder || icon == Icon::file) return drawPaper(pen, icon);
  if (icon >= Icon::solo) return drawDesign(pen, icon);
  drawMark(pen, icon);
}

}  // namespace npsee::editor
