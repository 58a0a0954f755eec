#include "app/commands/golden.h"

#include <npsee/units.h>

#include <algorithm>
#include <span>

namespace npsee::commands {
namespace {

/// Text inside HTML and XML; what neither may hold becomes a question mark.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20 && c != '\n') out += '?';
    else out += c;
  }
  return out;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) { return i + k < bytes.size() ? std::uint32_t{bytes[i + k]} : 0u; };
    const std::uint32_t three = at(0) << 16 | at(1) << 8 | at(2);
    for (std::size_t k = 0; k < 4; ++k) out += i + k < bytes.size() + 1 ? kDigits[three >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --line: #8885; --good: #2e8b57; --near: #b8860b; --bad: #c0392b; }
body { font: 15px/1.45 Inter, system-ui, sans-serif; margin: 2rem auto; max-width: 1500px; padding: 0 1rem; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.05rem; margin: 0 0 .3rem; }
.counts span { display: inline-block; margin-right: 1.2rem; } b { font-weight: 650; }
section { border: 1px solid var(--line); border-radius: 8px; padding: 1rem; margin: 1rem 0; }
.tag { border-radius: 4px; color: #fff; font-size: .8rem; padding: .1rem .5rem; margin-left: .6rem; background: var(--bad); }
.tag.same { background: var(--good); } .tag.within { background: var(--near); }
.three { display: grid; grid-template-columns: repeat(auto-fit, minmax(280px, 1fr)); gap: .8rem; margin-top: .7rem; }
figure { margin: 0; } figcaption { font-size: .85rem; opacity: .75; }
img { width: 100%; display: block; border-radius: 4px; background: repeating-conic-gradient(#999 0 25%, #777 0 50%) 0 0/16px 16px; }
.flip { position: relative; } .flip img + img { position: absolute; inset: 0; opacity: 0; } .flip:hover img + img { opacity: 1; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; } td, th { padding: .15rem .9rem .15rem 0; text-align: left; }
pre { white-space: pre-wrap; margin: .4rem 0; font: .85rem/1.4 'JetBrains Mono', monospace; }
)";

std::string imageTag(const std::vector<std::uint8_t>& png, std::string_view what) {
  return png.empty() ? std::string() : "<img alt=\"" + std::string(what) + "\" src=\"data:image/png;base64," + base64(png) + "\">";
}

std::string figure(const std::string& inside, std::string_view caption) {
  return inside.empty() ? std::string() : "<figure>" + inside + "<figcaption>" + std::string(caption) + "</figcaption></figure>\n";
}

std::string tag(const GoldenResult& result) {
  const std::string_view kind = result.pair.verdict == Verdict::same ? "same" : result.pair.verdict == Verdict::within ? "within" : "bad";
  return "<span class=\"tag " + std::string(kind) + "\">" + std::string(verdictName(result.pair.verdict)) + (result.updated ? ", updated" : "") + "</span>";
}

std::string sectionOf(const GoldenResult& result) {
  std::string text = pairText(result.pair);
  text.erase(0, text.find('\n') + 1);
  std::string out = "<section>\n<h2>" + escaped(result.pair.pair.name) + tag(result) + "</h2>\n<pre>" + escaped(text) + "</pre>\n<div class=\"three\">\n";
  out += figure(imageTag(result.before, "before"), "before");
  const std::string after = imageTag(result.after, "after");
  out += figure(result.before.empty() || after.empty() ? after : "<div class=\"flip\">" + after + imageTag(result.before, "before") + "</div>", result.before.empty() ? "after" : "after (point at it to see it before)");
  out += figure(imageTag(result.difference, "difference"), "difference: blue one level, red, yellow all");
  if (result.after.empty()) out += "<p>No pictures: the page had grown too large.</p>\n";
  return out + "</div>\n</section>\n";
}

std::string rowOf(const GoldenResult& result) {
  const render::ImageDifference& d = result.pair.difference;
  return "<tr><td>" + escaped(result.pair.pair.name) + "</td><td>" + tag(result) + "</td><td>" + rounded(d.max, 3) + "</td><td>" + rounded(d.mean, 5) + "</td><td>" + rounded(d.ssim, 6) + "</td><td>" + std::to_string(d.over) + "</td></tr>\n";
}

}  // namespace

std::string goldenPage(const GoldenCheck& check) {
  const GoldenCounts counts = countsOf(check.results());
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>npsee goldens</title>\n<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>npsee goldens: " +
                    (counts.failed == 0 ? "all is well" : std::to_string(counts.failed) + " of " + std::to_string(check.results().size()) + " failed") + "</h1>\n";
  out += "<p class=\"counts\"><span><b>" + std::to_string(counts.same) + "</b> same</span><span><b>" + std::to_string(counts.within) + "</b> within the tolerance</span><span><b>" + std::to_string(counts.failed) + "</b> different or missing</span><span><b>" + std::to_string(counts.updated) + "</b> updated</span></p>\n";
  out += "<p>" + escaped(check.settings().folder.string()) + " compared with npsee " NPSEE_VERSION ", " + escaped(check.settings().machine.driver) + ", " + escaped(check.settings().machine.processor) + "</p>\n";
  for (const bool failed : {true, false})
    for (const GoldenResult& result : check.results())
      if (result.pair.verdict != Verdict::same && passes(result.pair.verdict) != failed) out += sectionOf(result);
  out += "<section><h2>All pictures</h2>\n<table><tr><th>picture</th><th></th><th>max</th><th>mean</th><th>SSIM</th><th>pixels over</th></tr>\n";
  for (const GoldenResult& result : check.results()) out += rowOf(result);
  return out + "</table></section>\n</body>\n</html>\n";
}

std::string goldenJunit(const GoldenCheck& check) {
  const GoldenCounts counts = countsOf(check.results());
  const std::string numbers = "tests=\"" + std::to_string(check.results().size()) + "\" failures=\"" + std::to_string(counts.failed) + "\" errors=\"0\"";
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + numbers + ">\n<testsuite name=\"npsee goldens\" " + numbers + ">\n";
  for (const GoldenResult& result : check.results()) {
    out += "<testcase classname=\"" + escaped(check.settings().folder.string()) + "\" name=\"" + escaped(result.pair.pair.name) + "\"";
    if (passes(result.pair.verdict)) {
      out += "/>\n";
      continue;
    }
    std::string reasons;
    for (const std::string& reason : result.pair.reasons) reasons += (reasons.empty() ? "" : "; ") + reason;
    out += ">\n<failure type=\"" + std::string(verdictName(result.pair.verdict)) + "\" message=\"" + escaped(reasons) + "\">" + escaped(pairText(result.pair)) + "</failure>\n</testcase>\n";
  }
  return out + "</testsuite>\n</testsuites>\n";
}

}  // namespace npsee::commands
