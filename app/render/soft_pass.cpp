#include "app/render/soft_pass.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace npsee::render {
namespace {

/// Vertices of an instance; shaders/soft.vert makes them.
constexpr GLsizei kCorners = 8;
constexpr int kNoiseSize = 64;

/// Integer hash of a lattice point (xorshift-multiply rounds); only its look matters.
std::uint32_t hashed(std::uint32_t x, std::uint32_t y, std::uint32_t octave) {
  std::uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u ^ octave * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

/// Tiling value noise of one octave with `cells` lattice points a side, 0..1.
double valueNoise(int x, int y, int cells, std::uint32_t octave) {
  const double u = static_cast<double>(x) * cells / kNoiseSize, v = static_cast<double>(y) * cells / kNoiseSize;
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double fx = smooth(u - i), fy = smooth(v - j);
  const auto at = [&](int a, int b) { return hashed(static_cast<std::uint32_t>(a % cells), static_cast<std::uint32_t>(b % cells), octave) / 4294967295.0; };
  const double low = at(i, j) + (at(i + 1, j) - at(i, j)) * fx;
  const double high = at(i, j + 1) + (at(i + 1, j + 1) - at(i, j + 1)) * fx;
  return low + (high - low) * fy;
}

gl::Texture makeNoise() {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < kNoiseSize; ++y)
    for (int x = 0; x < kNoiseSize; ++x) {
      const double v = 0.55 * valueNoise(x, y, 8, 0) + 0.30 * valueNoise(x, y, 16, 1) + 0.15 * valueNoise(x, y, 32, 2);
      pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * v)));
    }
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kNoiseSize, kNoiseSize, 0, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

}  // namespace

Expected<SoftPass> SoftPass::create(ParticleOutput output) {
  SoftPass pass;
  if (auto done = pass.program_.load("soft.vert", output == ParticleOutput::surface ? "soft_surface.frag" : "soft.frag"); !done) return tl::unexpected<Error>(done.error());
  if (output == ParticleOutput::light)
    if (auto done = pass.smoke_.load("soft.vert", "smoke.frag"); !done) return tl::unexpected<Error>(done.error());
  pass.attributes_ = gl::VertexArray::make();
  pass.noise_ = makeNoise();
  return pass;
}

void SoftPass::draw(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, bool smoke) const {
  const gl::Program& program = smoke ? smoke_ : program_;
  program.use();
  drawInstances(program, view, particles, first, count, ground);
}

void SoftPass::drawSurfaces(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, const SurfaceFrame& frame) const {
  program_.use();
  setSurfaceFrame(program_, frame);
  drawInstances(program_, view, particles, first, count, ground);
}

void SoftPass::drawInstances(const gl::Program& program, const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  setView(program, view);
  setGround(program, view, ground);
  program.set("u_noise", 0);
  program.set("u_detail", detail_ ? 1.0f : 0.0f);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, noise_.name());
  glBindSampler(0, 0);
  glBindVertexArray(attributes_.name());
  particles.bind(first, true);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kCorners, static_cast<GLsizei>(count));
}

}  // namespace npsee::render
