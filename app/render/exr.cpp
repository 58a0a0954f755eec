#include "app/render/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace npsee::render {
namespace {

namespace exr = OPENEXR_IMF_NAMESPACE;
using IMATH_NAMESPACE::Box2i;

constexpr const char* kRecipeAttribute = "npseeRecipe";
constexpr std::array<const char*, 4> kColour{"R", "G", "B", "A"};
constexpr const char* kDepth = "Z";
constexpr std::array<const char*, 2> kMotion{"forward.u", "forward.v"};
/// Largest half float.
constexpr float kMostHalf = 65504.0f;

/// The library writes into memory, so that the file appears whole or not at all.
class Output : public exr::OStream {
 public:
  Output() : exr::OStream("picture") {}
  void write(const char* bytes, int count) override {
    const std::size_t end = at_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + at_, bytes, static_cast<std::size_t>(count));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

class Input : public exr::IStream {
 public:
  explicit Input(std::string_view bytes) : exr::IStream("picture"), bytes_(bytes) {}
  bool read(char* to, int count) override {
    if (count < 0 || at_ > bytes_.size() || static_cast<std::size_t>(count) > bytes_.size() - at_) throw std::runtime_error("it ends too early");
    std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// A channel whose values lie `values` of type T apart, `at` into each pixel.
template <class T>
exr::Slice sliceOf(T* pixels, exr::PixelType type, std::size_t values, std::size_t at, int width) {
  return exr::Slice(type, reinterpret_cast<char*>(pixels + at), values * sizeof(T), values * sizeof(T) * static_cast<std::size_t>(width));
}

/// The channels of the passes that are there, in single floats.
void addFloatSlices(exr::FrameBuffer& buffer, FloatImage& image) {
  if (!image.depth.empty()) buffer.insert(kDepth, sliceOf(image.depth.data(), exr::FLOAT, 1, 0, image.width));
  if (!image.motion.empty())
    for (std::size_t c = 0; c < kMotion.size(); ++c) buffer.insert(kMotion[c], sliceOf(image.motion.data(), exr::FLOAT, kMotion.size(), c, image.width));
}

void writeAll(const FloatImage& image, std::string_view recipe, Output& output) {
  // Primaries and white of Rec. 709 are the library's default; some programs want to see them.
  exr::Header header(image.width, image.height);
  header.compression() = exr::ZIP_COMPRESSION;
  exr::addChromaticities(header, exr::Chromaticities());
  header.insert("software", exr::StringAttribute("npsee"));
  header.insert(kRecipeAttribute, exr::StringAttribute(std::string(recipe)));
  // The library takes the memory of what it only reads as its own to change.
  auto& source = const_cast<FloatImage&>(image);
  exr::FrameBuffer buffer;
  std::vector<half> colour;
  colour.reserve(image.rgba.size());
  for (const float value : image.rgba) colour.emplace_back(std::clamp(value, -kMostHalf, kMostHalf));
  for (std::size_t c = 0; c < kColour.size() && !colour.empty(); ++c) buffer.insert(kColour[c], sliceOf(colour.data(), exr::HALF, kColour.size(), c, image.width));
  addFloatSlices(buffer, source);
  for (auto slice = buffer.begin(); slice != buffer.end(); ++slice) header.channels().insert(slice.name(), exr::Channel(slice.slice().type));
  // No threads of the library's own: pictures are encoded side by side.
  exr::OutputFile file(output, header, 0);
  file.setFrameBuffer(buffer);
  file.writePixels(image.height);
}

ExrPicture readAll(std::string_view bytes, std::size_t most_pixels) {
  Input input(bytes);
  exr::InputFile file(input, 0);
  const exr::Header& header = file.header();
  const Box2i window = header.dataWindow();
  const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1, height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
  if (window.min.x != 0 || window.min.y != 0 || width < 1 || height < 1) throw std::runtime_error("it is no whole picture");
  if (static_cast<std::size_t>(width) > most_pixels / static_cast<std::size_t>(height)) throw std::runtime_error("it is larger than expected");
  if (!file.isComplete()) throw std::runtime_error("it is not complete");
  ExrPicture out;
  out.image.width = static_cast<int>(width);
  out.image.height = static_cast<int>(height);
  const auto pixels = static_cast<std::size_t>(width * height);
  const auto has = [&](const char* name) { return header.channels().findChannel(name) != nullptr; };
  if (has(kColour.front())) out.image.rgba.resize(kColour.size() * pixels);
  if (has(kDepth)) out.image.depth.resize(pixels);
  if (has(kMotion.front())) out.image.motion.resize(kMotion.size() * pixels);
  exr::FrameBuffer buffer;
  for (std::size_t c = 0; c < kColour.size() && !out.image.rgba.empty(); ++c) buffer.insert(kColour[c], sliceOf(out.image.rgba.data(), exr::FLOAT, kColour.size(), c, out.image.width));
  addFloatSlices(buffer, out.image);
  file.setFrameBuffer(buffer);
  file.readPixels(0, out.image.height - 1);
  if (const auto* recipe = header.findTypedAttribute<exr::StringAttribute>(kRecipeAttribute)) out.recipe = recipe->value();
  return out;
}

}  // namespace

Expected<std::vector<std::uint8_t>> encodeExr(const FloatImage& image, std::string_view recipe) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0));
  const auto fits = [&](const std::vector<float>& pass, std::size_t values) { return pass.empty() || pass.size() == values * pixels; };
  const bool any = !image.rgba.empty() || !image.depth.empty() || !image.motion.empty();
  if (pixels == 0 || !any || !fits(image.rgba, 4) || !fits(image.depth, 1) || !fits(image.motion, 2)) return fail(ErrorKind::output, "an empty picture cannot be written as OpenEXR.");
  Output output;
  try {
    writeAll(image, recipe, output);
  } catch (const std::exception& error) {
    return fail(ErrorKind::output, std::string("a picture cannot be encoded as OpenEXR: ") + error.what() + ".");
  }
  return std::move(output.bytes());
}

Expected<ExrPicture> parseExr(std::string_view bytes, const std::string& name, std::size_t most_pixels) {
  try {
    return readAll(bytes, most_pixels);
  } catch (const std::exception& error) {
    return fail(ErrorKind::input, {.what = std::string("is no OpenEXR picture that can be read: ") + error.what() + ".", .remedy = "Render it anew.", .file = name, .line = 0, .pointer = {}});
  }
}

}  // namespace npsee::render
