#pragma once

#include "app/gl/loader.h"

namespace npsee::gl {

/// What passes begin from. A pass sets all the state it needs and relies on nothing that another one left.

/// Fragments replace what is there, whatever their depth.
inline void drawPlainly() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

/// The nearest of what is opaque is seen, from outside.
inline void drawSolid() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glDisable(GL_CLIP_DISTANCE0);
}

/// Premultiplied colours are laid over what is there. Whether depth is tested is the caller's to say; it is not written.
inline void blendOver() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
  glDepthMask(GL_FALSE);
}

}  // namespace npsee::gl
