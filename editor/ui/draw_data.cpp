#include "editor/ui/draw_data.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace npsee::editor {
namespace {

void describeVertices() {
  constexpr auto stride = static_cast<GLsizei>(sizeof(ImDrawVert));
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  for (GLuint slot = 0; slot < 3; ++slot) glEnableVertexAttribArray(slot);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, pos)));
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, offset(offsetof(ImDrawVert, uv)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(ImDrawVert, col)));
}

void setState(int width, int height) {
  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
}

void drawCommand(const ImDrawCmd& command, const ImDrawData& data, int height, std::span<const PixelBox> boxes, std::span<const ImTextureID> opaque) {
  const ImVec2 scale = data.FramebufferScale, origin = data.DisplayPos;
  const PixelBox clip{std::max(static_cast<int>((command.ClipRect.x - origin.x) * scale.x), 0), static_cast<int>((command.ClipRect.y - origin.y) * scale.y),
                      static_cast<int>((command.ClipRect.z - origin.x) * scale.x), static_cast<int>((command.ClipRect.w - origin.y) * scale.y)};
  bool ready = false;
  for (const PixelBox& box : boxes) {
    const PixelBox shown = intersection(clip, box);
    if (shown.empty()) continue;
    if (!std::exchange(ready, true)) {
      glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
      if (std::ranges::find(opaque, command.GetTexID()) != opaque.end()) glDisable(GL_BLEND);
      else glEnable(GL_BLEND);
    }
    glScissor(shown.left, height - shown.bottom, shown.right - shown.left, shown.bottom - shown.top);
    constexpr GLenum type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), type, reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)), static_cast<GLint>(command.VtxOffset));
  }
}

}  // namespace

Expected<DrawDataRenderer> DrawDataRenderer::create() {
  DrawDataRenderer out;
  auto program = gl::Program::fromFiles("ui.vert", "ui.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  out.program_ = std::move(*program);
  out.array_ = gl::VertexArray::make();
  out.vertices_ = gl::Buffer::make();
  out.indices_ = gl::Buffer::make();
  glBindVertexArray(out.array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, out.vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, out.indices_.name());
  describeVertices();
  glBindVertexArray(0);
  out.uploadFonts();
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  return out;
}

void DrawDataRenderer::uploadFonts() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  fonts_ = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, fonts_.name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(fonts_.name())));
}

void DrawDataRenderer::draw(const ImDrawData& data, std::span<const PixelBox> boxes, std::span<const ImTextureID> opaque) const {
  const auto width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x), height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width <= 0 || height <= 0) return;
  setState(width, height);
  program_.use();
  program_.set("size", data.DisplaySize.x, data.DisplaySize.y);
  program_.set("picture", 0);
  glBindVertexArray(array_.name());
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.VtxBuffer.size_in_bytes()), list.VtxBuffer.Data, GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.IdxBuffer.size_in_bytes()), list.IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer)
      if (command.UserCallback == nullptr) drawCommand(command, data, height, boxes, opaque);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

}  // namespace npsee::editor
