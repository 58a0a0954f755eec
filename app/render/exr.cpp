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
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

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

/// A channel whose values lie `values` of type T apart, `at` into each pixel; `pixels` begin with the row `first` of the picture.
template <class T>
exr::Slice sliceOf(T* pixels, exr::PixelType type, std::size_t values, std::size_t at, int width, int first = 0) {
  const std::size_t row = values * sizeof(T) * static_cast<std::size_t>(width);
  // The library counts from the picture's corner, which lies before the memory of a band: added up as a number, not as a pointer.
  const std::uintptr_t corner = reinterpret_cast<std::uintptr_t>(pixels + at) - row * static_cast<std::size_t>(first);
  return exr::Slice(type, reinterpret_cast<char*>(corner), values * sizeof(T), row);
}

/// The channels of the passes that are there, in single floats.
void addFloatSlices(exr::FrameBuffer& buffer, FloatImage& image, int first = 0) {
  if (!image.depth.empty()) buffer.insert(kDepth, sliceOf(image.depth.data(), exr::FLOAT, 1, 0, image.width, first));
  if (!image.motion.empty())
    for (std::size_t c = 0; c < kMotion.size(); ++c) buffer.insert(kMotion[c], sliceOf(image.motion.data(), exr::FLOAT, kMotion.size(), c, image.width, first));
}

/// The library writes into a file that has a temporary name.
class FileOutput : public exr::OStream {
 public:
  explicit FileOutput(const std::filesystem::path& path) : exr::OStream("picture"), file_(path, std::ios::binary | std::ios::trunc) { check(); }
  void write(const char* bytes, int count) override {
    file_.write(bytes, count);
    check();
  }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(file_.tellp()); }
  void seekp(std::uint64_t at) override {
    file_.seekp(static_cast<std::streamoff>(at));
    check();
  }
  void close() {
    file_.close();
    check();
  }

 private:
  void check() const {
    if (!file_) throw std::runtime_error("its file cannot be written (no room?)");
  }
  std::ofstream file_;
};

class FileInput : public exr::IStream {
 public:
  explicit FileInput(const std::filesystem::path& path) : exr::IStream("picture"), file_(path, std::ios::binary) {}
  bool read(char* to, int count) override {
    if (!file_.read(to, count)) throw std::runtime_error("it ends too early");
    return file_.peek() != std::char_traits<char>::eof();
  }
  std::uint64_t tellg() override { return static_cast<std::uint64_t>(file_.tellg()); }
  void seekg(std::uint64_t at) override {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(at));
  }

 private:
  std::ifstream file_;
};

/// Writes a picture in bands of rows.
class Bands {
 public:
  Bands(exr::OStream& output, int width, int height, const FloatRequest& passes, std::string_view recipe) : file_(output, headerOf(width, height, passes, recipe), 0) {}

  void add(const FloatImage& band) {
    colour_.clear();
    colour_.reserve(band.rgba.size());
    for (const float value : band.rgba) colour_.emplace_back(std::clamp(value, -kMostHalf, kMostHalf));
    // The library takes the memory of what it only reads as its own to change.
    auto& source = const_cast<FloatImage&>(band);
    exr::FrameBuffer buffer;
    for (std::size_t c = 0; c < kColour.size() && !colour_.empty(); ++c) buffer.insert(kColour[c], sliceOf(colour_.data(), exr::HALF, kColour.size(), c, band.width, file_.currentScanLine()));
    addFloatSlices(buffer, source, file_.currentScanLine());
    file_.setFrameBuffer(buffer);
    file_.writePixels(band.height);
  }

 private:
  static exr::Header headerOf(int width, int height, const FloatRequest& passes, std::string_view recipe) {
    // Primaries and white of Rec. 709 are the library's default; some programs want to see them.
    exr::Header header(width, height);
    header.compression() = exr::ZIP_COMPRESSION;
    exr::addChromaticities(header, exr::Chromaticities());
    header.insert("software", exr::StringAttribute("npsee"));
    header.insert(kRecipeAttribute, exr::StringAttribute(std::string(recipe)));
    if (passes.colour)
      for (const char* name : kColour) header.channels().insert(name, exr::Channel(exr::HALF));
    if (passes.depth) header.channels().insert(kDepth, exr::Channel(exr::FLOAT));
    if (passes.motion)
      for (const char* name : kMotion) header.channels().insert(name, exr::Channel(exr::FLOAT));
    return header;
  }

  // No threads of the library's own: pictures are encoded side by side.
  exr::OutputFile file_;
  std::vector<half> colour_;
};

FloatRequest passesOf(const FloatImage& image) { return {.colour = !image.rgba.empty(), .depth = !image.depth.empty(), .motion = !image.motion.empty()}; }

tl::unexpected<Error> notEncoded(const std::exception& error) { return fail(ErrorKind::output, std::string("a picture cannot be encoded as OpenEXR: ") + error.what() + "."); }

/// Width and height of a whole picture of ours. Throws where it is none.
std::pair<int, int> sizeOf(const exr::InputFile& file, std::size_t most_pixels) {
  const Box2i window = file.header().dataWindow();
  const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1, height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
  if (window.min.x != 0 || window.min.y != 0 || width < 1 || height < 1) throw std::runtime_error("it is no whole picture");
  if (static_cast<std::size_t>(width) > most_pixels / static_cast<std::size_t>(height)) throw std::runtime_error("it is larger than expected");
  if (!file.isComplete()) throw std::runtime_error("it is not complete");
  return {static_cast<int>(width), static_cast<int>(height)};
}

/// What a band of `rows` rows has to hold.
void makeRoom(const exr::Header& header, int width, int rows, FloatImage& image) {
  const auto has = [&](const char* name) { return header.channels().findChannel(name) != nullptr; };
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  image.width = width;
  image.height = rows;
  if (has(kColour.front())) image.rgba.resize(kColour.size() * pixels);
  if (has(kDepth)) image.depth.resize(pixels);
  if (has(kMotion.front())) image.motion.resize(kMotion.size() * pixels);
}

void readBand(exr::InputFile& file, FloatImage& image, int first, int rows) {
  exr::FrameBuffer buffer;
  for (std::size_t c = 0; c < kColour.size() && !image.rgba.empty(); ++c) buffer.insert(kColour[c], sliceOf(image.rgba.data(), exr::FLOAT, kColour.size(), c, image.width, first));
  addFloatSlices(buffer, image, first);
  file.setFrameBuffer(buffer);
  file.readPixels(first, first + rows - 1);
}

std::string recipeOf(const exr::Header& header) {
  const auto* recipe = header.findTypedAttribute<exr::StringAttribute>(kRecipeAttribute);
  return recipe != nullptr ? recipe->value() : std::string();
}

ExrPicture readAll(std::string_view bytes, std::size_t most_pixels) {
  Input input(bytes);
  exr::InputFile file(input, 0);
  const auto [width, height] = sizeOf(file, most_pixels);
  ExrPicture out;
  makeRoom(file.header(), width, height, out.image);
  readBand(file, out.image, 0, height);
  out.recipe = recipeOf(file.header());
  return out;
}

}  // namespace

struct ExrWriter::Impl {
  explicit Impl(const std::filesystem::path& path) : output(path) {}
  FileOutput output;
  std::optional<Bands> bands;
};

ExrWriter::ExrWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ExrWriter::~ExrWriter() = default;

Expected<std::unique_ptr<ExrWriter>> ExrWriter::open(const std::filesystem::path& path, int width, int height, const FloatRequest& passes, std::string_view recipe) {
  try {
    auto impl = std::make_unique<Impl>(path);
    impl->bands.emplace(impl->output, width, height, passes, recipe);
    return std::unique_ptr<ExrWriter>(new ExrWriter(std::move(impl)));
  } catch (const std::exception& error) {
    return notEncoded(error);
  }
}

Expected<void> ExrWriter::add(const FloatImage& band) {
  try {
    impl_->bands->add(band);
    return {};
  } catch (const std::exception& error) {
    return notEncoded(error);
  }
}

Expected<void> ExrWriter::finish() {
  try {
    impl_->bands.reset();
    impl_->output.close();
    return {};
  } catch (const std::exception& error) {
    return notEncoded(error);
  }
}

std::optional<std::string> recipeOfWholeExr(const std::filesystem::path& path) {
  // As many rows as the library packs together.
  constexpr int kRows = 16;
  constexpr std::size_t kMostPixels = 36'000'000;
  try {
    FileInput input(path);
    exr::InputFile file(input, 0);
    const auto [width, height] = sizeOf(file, kMostPixels);
    FloatImage band;
    makeRoom(file.header(), width, kRows, band);
    for (int first = 0; first < height; first += kRows) readBand(file, band, first, std::min(kRows, height - first));
    return recipeOf(file.header());
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

Expected<std::vector<std::uint8_t>> encodeExr(const FloatImage& image, std::string_view recipe) {
  const std::size_t pixels = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0));
  const auto fits = [&](const std::vector<float>& pass, std::size_t values) { return pass.empty() || pass.size() == values * pixels; };
  const bool any = !image.rgba.empty() || !image.depth.empty() || !image.motion.empty();
  if (pixels == 0 || !any || !fits(image.rgba, 4) || !fits(image.depth, 1) || !fits(image.motion, 2)) return fail(ErrorKind::output, "an empty picture cannot be written as OpenEXR.");
  Output output;
  try {
    // The file is complete when the bands are gone.
    Bands(output, image.width, image.height, passesOf(image), recipe).add(image);
  } catch (const std::exception& error) {
    return notEncoded(error);
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
