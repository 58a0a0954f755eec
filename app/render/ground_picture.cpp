#include "app/render/ground_picture.h"

namespace npsee::render {
namespace {

GLuint boundFramebuffer() {
  GLint name = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  return static_cast<GLuint>(name);
}

void copy(GLuint from, GLuint to, int width, int height) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

}  // namespace

int boundSamples() {
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return samples;
}

bool GroundPicture::restore(const GroundKey& key) const {
  if (!kept_ || !(key == key_)) return false;
  const GLuint target = boundFramebuffer();
  copy(frame_.name(), target, key.width, key.height);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  return true;
}

void GroundPicture::drawn(const GroundKey& key) {
  const bool again = key == key_;
  key_ = key;
  kept_ = false;
  if (!again) return;
  const GLuint target = boundFramebuffer();
  if (width_ != key.width || height_ != key.height || samples_ != key.samples) {
    colour_ = gl::Renderbuffer::make();
    depth_ = gl::Renderbuffer::make();
    frame_ = gl::Framebuffer::make();
    // The same formats as Target's: copies of several samples ask for that.
    glBindRenderbuffer(GL_RENDERBUFFER, colour_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, key.samples, GL_RGBA16F, key.width, key.height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, key.samples, GL_DEPTH_COMPONENT24, key.width, key.height);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    const bool usable = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && gl::pendingError() == nullptr;
    width_ = usable ? key.width : 0;
    height_ = key.height;
    samples_ = key.samples;
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    // No room for a second picture: then it is drawn every time.
    if (!usable) return;
  }
  copy(target, frame_.name(), key.width, key.height);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  kept_ = true;
}

}  // namespace npsee::render
