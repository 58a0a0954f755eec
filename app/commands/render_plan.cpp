#include "app/commands/render_plan.h"

#include "app/commands/render_caption.h"

#include "sim/core/text.h"

#include <npsee/parameters.h>
#include <npsee/units.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <thread>

namespace npsee::commands {
namespace {

/// Latest time that can be asked for, s: a day, far beyond any effect's end.
constexpr double kMaxTime_s = 86400.0;
constexpr double kMaxFps = 1000.0;
constexpr std::int64_t kMaxGifPixels = 500'000'000;

tl::unexpected<Error> refused(std::string_view option, std::string_view text, const std::string& why, std::string remedy) {
  return fail(ErrorKind::usage, std::string(option) + ' ' + std::string(text) + ": " + why, std::move(remedy));
}

std::optional<std::int64_t> wholeNumber(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "AxB" with whole numbers.
std::optional<std::pair<std::int64_t, std::int64_t>> twoNumbers(std::string_view text) {
  const auto parts = splitAt(text, 'x');
  if (parts.size() != 2) return std::nullopt;
  const auto a = wholeNumber(parts[0]), b = wholeNumber(parts[1]);
  if (!a || !b) return std::nullopt;
  return std::pair(*a, *b);
}

Expected<double> readTime(std::string_view option, std::string_view whole, std::string_view text) {
  const auto time = parseQuantity(text, Unit::second);
  const std::string remedy = option == "--time" ? "For example --time 0.5 or --time 500ms." : "Write --frames FROM:TO in seconds, for example --frames 0:2.";
  if (!time) return refused(option, whole, time.error().faults.front().what, remedy);
  if (!(*time >= 0.0 && *time <= kMaxTime_s)) return refused(option, whole, "times go from 0 to 86400 s.", remedy);
  return *time;
}

Expected<void> readSize(const RenderOptions& options, RenderPlan& plan) {
  if (options.size.empty()) {
    if (plan.kind == RenderKind::sheet) plan.width = 320, plan.height = 180;
    if (plan.kind == RenderKind::template_view) plan.width = plan.height = 640;
  } else {
    const auto size = twoNumbers(options.size);
    const std::string remedy = "Write WIDTHxHEIGHT in pixels, for example --size 1280x720; at most " + std::to_string(render::kMaxPictureSize) + " a side and " + std::to_string(kMaxPicturePixels) + " in all.";
    if (!size) return refused("--size", options.size, "this is no size.", remedy);
    const auto fits = [](std::int64_t side) { return side >= 1 && side <= render::kMaxPictureSize; };
    if (!fits(size->first) || !fits(size->second)) return refused("--size", options.size, "width and height go from 1 to " + std::to_string(render::kMaxPictureSize) + " pixels.", remedy);
    if (size->first * size->second > kMaxPicturePixels) return refused("--size", options.size, "that is more than " + std::to_string(kMaxPicturePixels) + " pixels in all.", remedy);
    plan.width = static_cast<int>(size->first);
    plan.height = static_cast<int>(size->second);
  }
  const std::int64_t pixels = static_cast<std::int64_t>(plan.width) * plan.height * plan.columns * plan.rows;
  if (pixels > kMaxPicturePixels)
    return refused("--sheet", options.sheet, "the sheet would have " + std::to_string(pixels) + " pixels, above the limit of " + std::to_string(kMaxPicturePixels) + ".", "Choose fewer pictures or a smaller --size, which is that of each picture in the sheet.");
  return {};
}

Expected<void> readSheet(const RenderOptions& options, RenderPlan& plan) {
  const auto size = twoNumbers(options.sheet);
  const auto fits = [](std::int64_t side) { return side >= 1 && side <= kMaxSheetSide; };
  if (!size || !fits(size->first) || !fits(size->second))
    return refused("--sheet", options.sheet, "this is no number of columns and rows from 1 to " + std::to_string(kMaxSheetSide) + ".", "Write COLUMNSxROWS, for example --sheet 4x4.");
  plan.columns = static_cast<int>(size->first);
  plan.rows = static_cast<int>(size->second);
  return {};
}

/// "30", "29.97" or "30000/1001" as an exact fraction.
Expected<FrameRate> readRate(std::string_view text) {
  const std::string remedy = "Write frames per second above 0 and at most 1000, for example --fps 30, --fps 29.97 or --fps 30000/1001.";
  const auto no = [&] { return refused("--fps", text, "this is no frame rate.", remedy); };
  FrameRate rate;
  const std::size_t slash = text.find('/'), point = text.find('.');
  if (slash != std::string_view::npos) {
    const auto numerator = wholeNumber(text.substr(0, slash)), denominator = wholeNumber(text.substr(slash + 1));
    if (!numerator || !denominator) return no();
    rate = {*numerator, *denominator};
  } else {
    std::string digits(text);
    std::size_t places = 0;
    if (point != std::string_view::npos) {
      digits.erase(point, 1);
      places = text.size() - point - 1;
    }
    const auto whole = wholeNumber(digits);
    if (!whole || places > 6) return no();
    rate = {*whole, 1};
    for (std::size_t i = 0; i < places; ++i) rate.denominator *= 10;
  }
  const bool sane = rate.numerator >= 1 && rate.denominator >= 1 && rate.numerator <= 1'000'000'000 && rate.denominator <= 1'000'000'000;
  if (!sane || static_cast<double>(rate.numerator) > kMaxFps * static_cast<double>(rate.denominator)) return no();
  return rate;
}

Expected<void> readRange(const RenderOptions& options, RenderPlan& plan) {
  const auto parts = splitAt(options.frames, ':');
  const std::string remedy = "Write --frames FROM:TO in seconds, for example --frames 0:2.";
  if (parts.size() != 2) return refused("--frames", options.frames, "this is no range of times.", remedy);
  const auto from = readTime("--frames", options.frames, trimmed(parts[0])), to = readTime("--frames", options.frames, trimmed(parts[1]));
  if (!from) return tl::unexpected<Error>(from.error());
  if (!to) return tl::unexpected<Error>(to.error());
  if (*from == *to) return refused("--frames", options.frames, "the range is empty: it ends where it begins.", remedy);
  if (!(*from < *to)) return refused("--frames", options.frames, "the range ends before it begins.", remedy);
  plan.range_s = {*from, *to};
  return {};
}

/// First frame whose time k / rate is not before `time`.
std::int64_t firstFrame(const FrameRate& rate, double time_s) {
  // The slack takes a product like 0.3 * 10 for the whole number that was meant.
  return static_cast<std::int64_t>(std::ceil(time_s * static_cast<double>(rate.numerator) / static_cast<double>(rate.denominator) - 1e-6));
}

/// Frames whose time k / rate lies in [from, to).
Expected<void> countFrames(const RenderOptions& options, RenderPlan& plan) {
  const double per_second = static_cast<double>(plan.rate.numerator) / static_cast<double>(plan.rate.denominator);
  plan.first_frame = firstFrame(plan.rate, plan.range_s->first);
  plan.frame_count = firstFrame(plan.rate, plan.range_s->second) - plan.first_frame;
  if (plan.frame_count < 1) return refused("--frames", options.frames, "no frame of " + shortest(per_second) + " per second lies in this range.", "Choose a longer range or a higher --fps.");
  if (plan.frame_count > kMaxFrames)
    return refused("--frames", options.frames, "that is " + std::to_string(plan.frame_count) + " frames, above the limit of " + std::to_string(kMaxFrames) + ".", "Choose a shorter range or a lower --fps.");
  return {};
}

Expected<render::Background> readBackground(std::string_view text) {
  using Kind = render::Background::Kind;
  if (text.empty() || text == "sky") return render::Background{};
  if (text == "transparent") return render::Background{Kind::transparent, {}};
  constexpr std::pair<std::string_view, double> kGreys[] = {{"black", 0.0}, {"white", 1.0}};
  for (const auto& [name, grey] : kGreys)
    if (text == name) return render::Background{Kind::colour, {grey, grey, grey}};
  const auto colour = parseValue(*findParameter(Scope::burst, "ground.colour"), text);
  if (!colour) return refused("--background", text, "this is no background.", "Write sky, transparent, black, white, or a colour such as \"#20242c\" or 0.1,0.1,0.2.");
  return render::Background{Kind::colour, std::get<Colour>(*colour)};
}

Expected<double> readExposure(std::string_view text) {
  if (text.empty()) return 0.0;
  const auto stops = parseQuantity(text, Unit::none);
  if (!stops || std::abs(*stops) > render::kMostExposure_stops) return refused("--exposure", text, "exposures go from -4 to 4 stops.", "Write for example 1.5: 1 is twice the light, -1 half of it.");
  return *stops;
}

Expected<int> readThreads(std::string_view text) {
  if (text.empty()) return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u));
  const auto threads = wholeNumber(text);
  if (!threads || *threads < 1 || *threads > kMaxThreads)
    return refused("--threads", text, "threads are a whole number from 1 to " + std::to_string(kMaxThreads) + ".", "Leave it out to use all processors.");
  return static_cast<int>(*threads);
}

/// "0.5", "500ms", "25%", or several of them with commas between.
Expected<std::vector<Moment>> readMoments(std::string_view text) {
  std::vector<Moment> out;
  for (const std::string_view part : splitAt(text, ',')) {
    std::string_view word = trimmed(part);
    if (word.ends_with('%')) {
      word.remove_suffix(1);
      const auto share = parseQuantity(trimmed(word), Unit::none);
      if (!share || !(*share >= 0.0 && *share <= 100.0)) return refused("--time", text, "this is no share of the effect's duration.", "Write 0% to 100%, for example --time 25%.");
      out.push_back({*share / 100.0, true});
      continue;
    }
    const auto time = readTime("--time", text, word);
    if (!time) return tl::unexpected<Error>(time.error());
    out.push_back({*time, false});
  }
  if (out.size() > kMaxMoments) return refused("--time", "", "that is more than " + std::to_string(kMaxMoments) + " moments.", "Write a sequence with --frames.");
  return out;
}

Expected<Shard> readShard(std::string_view text) {
  const auto parts = splitAt(text, '/');
  const auto index = wholeNumber(parts[0]), count = wholeNumber(parts.size() == 2 ? parts[1] : "");
  if (!index || !count || *index < 1 || *count < *index || *count > kMaxShards)
    return refused("--shard", text, "this is no part of the work.", "Write PART/PARTS, counted from 1: --shard 2/5 is the second of five.");
  return Shard{*index, *count};
}

Expected<render::TemplateView> readView(std::string_view text) {
  if (text == "splines") return render::TemplateView::splines;
  if (text == "polygons") return render::TemplateView::polygons;
  if (text.empty() || text == "surface") return render::TemplateView::surface;
  return refused("--view", text, "there is no such view of the template.", "Write splines, polygons or surface.");
}

/// What the encoders cannot do.
Expected<void> checkVideo(const RenderOptions& options, const RenderPlan& plan) {
  const std::string name = endingOf(plan.format).substr(1);
  if (plan.format != FileFormat::gif && (plan.width % 2 != 0 || plan.height % 2 != 0))
    return refused("--size", options.size, "width and height of " + name + " videos are even numbers.", "Add or take away one pixel.");
  if (plan.format == FileFormat::mp4 && plan.background.kind == render::Background::Kind::transparent)
    return refused("--background", options.background, "mp4 videos cannot be transparent.", "Write .webm or .gif, or choose another background.");
  return {};
}

/// What is drawn in single precision, for 16-bit PNG and OpenEXR.
Expected<std::optional<render::FloatRequest>> readFloats(const RenderOptions& options, const RenderPlan& plan) {
  const auto no = [&](std::string_view option, std::string_view text, const std::string& why, const std::string& remedy) -> Expected<std::optional<render::FloatRequest>> { return refused(option, text, why, remedy); };
  if (!options.bits.empty() && options.bits != "8" && options.bits != "16") return no("--bits", options.bits, "a PNG has 8 or 16 bits per component.", "Write 8 or 16; an .exr holds floating-point numbers.");
  const bool deep = options.bits == "16", exr = plan.format == FileFormat::exr;
  if (!options.bits.empty() && plan.format != FileFormat::png) return no("--bits", options.bits, "this is for PNG pictures.", "Leave it out, or write .png.");
  if (!options.passes.empty() && !exr) return no("--pass", options.passes, "passes are written as OpenEXR.", "End the name in .exr, or add --format exr.");
  if (!deep && !exr) return std::optional<render::FloatRequest>();
  if (plan.kind != RenderKind::picture && plan.kind != RenderKind::sequence)
    return no(exr ? "--format" : "--bits", exr ? "exr" : options.bits, "sheets and templates are 8-bit PNG.", "Draw pictures or a sequence, or write an 8-bit .png.");
  render::FloatRequest out;
  out.linear = exr;
  out.frame_s = plan.rate.timeOf(1);
  if (options.passes.empty()) return std::optional(out);
  out.colour = false;
  const std::vector<std::string_view> known{"colour", "depth", "motion"};
  bool* const slots[] = {&out.colour, &out.depth, &out.motion};
  for (const std::string_view part : splitAt(options.passes, ',')) {
    const auto found = std::ranges::find(known, trimmed(part));
    if (found == known.end()) return no("--pass", options.passes, "there is no pass \"" + std::string(trimmed(part)) + "\".", "Write colour, depth, motion, or several of them with commas.");
    *slots[found - known.begin()] = true;
  }
  return std::optional(out);
}

/// What kind of result is asked for; options that contradict each other are refused, none is ignored.
Expected<RenderKind> readKind(const RenderOptions& options, FileFormat format) {
  const auto clash = [](const std::string& what, const std::string& remedy) { return fail(ErrorKind::usage, what, remedy); };
  const bool moving = !options.frames.empty() || !options.sheet.empty() || !options.fps.empty();
  if (!options.view.empty() && !options.as_template) return clash("--view is one of the template's views.", "Add --template.");
  if (!options.layer.empty() && !options.as_template) return clash("--layer chooses whose template is drawn; a picture of the explosion shows all layers.", "Add --template.");
  if (options.as_template && (moving || !options.time.empty() || !options.camera.empty()))
    return clash("--template shows the settings, which have no time and no camera.", "Leave out --time, --frames, --fps, --sheet and --camera.");
  if (options.sheet.empty() && (options.index || !options.caption.empty())) return clash("--index and --caption belong to a sheet.", "Add --sheet, for example --sheet 4x4.");
  if (isVideo(format)) {
    if (options.as_template || !options.sheet.empty() || !options.time.empty()) return clash("a video shows the effect in motion.", "Leave out --template, --sheet and --time; --frames FROM:TO chooses a part.");
    return RenderKind::video;
  }
  if (options.as_template) return RenderKind::template_view;
  if (!options.time.empty() && (!options.frames.empty() || !options.sheet.empty())) return clash("--time asks for one moment, --frames and --sheet for several.", "Leave one of them out.");
  if (!options.sheet.empty() && !options.fps.empty()) return clash("--fps is for sequences; a sheet divides its time evenly.", "Leave out --fps, or --sheet.");
  if (!options.sheet.empty()) return RenderKind::sheet;
  if (!options.frames.empty()) return RenderKind::sequence;
  if (!options.fps.empty() && options.passes.find("motion") == std::string::npos) return clash("--fps is the rate of a sequence, and no sequence is asked for.", "Add --frames FROM:TO.");
  return RenderKind::picture;
}

}  // namespace

Expected<render::Quality> readQuality(std::string_view text) {
  if (text.empty()) return render::Quality::normal;
  const auto found = std::ranges::find(render::kQualityNames, text);
  if (found == render::kQualityNames.end()) return refused("--quality", text, "there is no such quality.", "Write draft, normal or fine.");
  return static_cast<render::Quality>(found - render::kQualityNames.begin());
}

Expected<RenderPlan> makePlan(const RenderOptions& options) {
  RenderPlan plan;
  const auto take = [](auto read, auto& slot) -> Expected<void> {
    if (!read) return tl::unexpected<Error>(read.error());
    slot = std::move(*read);
    return {};
  };
  Expected<void> done = take(readFormat(options.format, options.output), plan.format);
  if (done) done = take(readKind(options, plan.format), plan.kind);
  if (done && !options.sheet.empty()) done = readSheet(options, plan);
  if (done) done = readSize(options, plan);
  if (done) done = take(readBackground(options.background), plan.background);
  if (done) done = take(readQuality(options.quality), plan.quality);
  if (done) done = take(readExposure(options.exposure), plan.exposure_stops);
  if (done) done = take(readThreads(options.threads), plan.threads);
  if (done) done = take(readView(options.view), plan.view);
  if (done && !options.time.empty()) done = take(readMoments(options.time), plan.moments);
  if (done && !options.shard.empty()) done = take(readShard(options.shard), plan.shard);
  if (done && !options.fps.empty()) done = take(readRate(options.fps), plan.rate);
  if (done && !options.frames.empty()) done = readRange(options, plan);
  if (done && plan.range_s && (plan.kind == RenderKind::sequence || plan.kind == RenderKind::video)) done = countFrames(options, plan);
  if (done && plan.kind == RenderKind::video) done = checkVideo(options, plan);
  if (done) done = take(readFloats(options, plan), plan.floats);
  if (done) done = checkCaption(options.caption);
  if (!done) return tl::unexpected<Error>(done.error());
  if (!options.camera.empty()) plan.camera = options.camera;
  plan.layer = options.layer;
  plan.index = options.index;
  // A transparent sheet is a sprite sheet: nothing but the effect.
  plan.caption = !options.caption.empty() ? options.caption : plan.background.kind == render::Background::Kind::transparent ? "none" : kUsualCaption;
  if (plan.caption == "none") plan.caption.clear();
  return plan;
}

Expected<int> templateLayer(const RenderPlan& plan, const Preset& preset) {
  if (plan.kind != RenderKind::template_view) return 0;
  if (preset.layers.empty()) return fail(ErrorKind::input, "the preset has no layer, so there is no template to draw.", "Add a layer to its \"layers\".");
  if (plan.layer.empty()) {
    const auto enabled = std::ranges::find(preset.layers, true, &Layer::enabled);
    return enabled != preset.layers.end() ? static_cast<int>(enabled - preset.layers.begin()) : 0;
  }
  if (const int index = findLayer(preset, plan.layer); index >= 0) return index;
  const auto names = namesOf(preset.layers, &Layer::name);
  const auto near = nearest(plan.layer, names);
  return refused("--layer", plan.layer, "the preset has no such layer." + (near ? " Did you mean " + std::string(*near) + "?" : std::string()), "Its layers are " + listed(names) + ".");
}

Shot shotOf(const RenderPlan& plan, std::int64_t number, double duration_s) {
  if (plan.kind == RenderKind::sequence) return {plan.rate.timeOf(number), number};
  return {plan.moments.at(static_cast<std::size_t>(number)).at(duration_s), number};
}

Expected<std::vector<Shot>> videoShots(const RenderPlan& plan, double duration_s) {
  const std::int64_t count = plan.range_s ? plan.frame_count : std::max<std::int64_t>(firstFrame(plan.rate, duration_s), 1);
  if (count > kMaxFrames) return fail(ErrorKind::usage, "the video would have " + std::to_string(count) + " frames, above the limit of " + std::to_string(kMaxFrames) + ".", "Choose a part of it with --frames, or a lower --fps.");
  // ffmpeg keeps all frames of a GIF until it knows their colours.
  if (plan.format == FileFormat::gif && count * plan.width * plan.height > kMaxGifPixels)
    return fail(ErrorKind::usage, "a GIF of " + std::to_string(count) + " frames of this size would take more than 2 GB to make.", "Choose a smaller --size, a lower --fps or a part with --frames; or write .webm.");
  std::vector<Shot> shots;
  for (std::int64_t k = plan.first_frame; k < plan.first_frame + count; ++k) shots.push_back({plan.rate.timeOf(k), k});
  return shots;
}

std::vector<Shot> sheetShots(const RenderPlan& plan, double duration_s) {
  // Without the end, as a sequence: by then every particle is gone or at rest.
  const auto [from, to] = plan.range_s.value_or(std::pair(0.0, duration_s));
  const std::int64_t count = static_cast<std::int64_t>(plan.columns) * plan.rows;
  std::vector<Shot> shots;
  for (std::int64_t i = 0; i < count; ++i) shots.push_back({from + (to - from) * static_cast<double>(i) / static_cast<double>(count), i});
  return shots;
}

}  // namespace npsee::commands
