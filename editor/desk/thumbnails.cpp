#include "editor/desk/thumbnails.h"

#include "app/render/shipped_assets.h"
#include "editor/document/document.h"
#include "sim/core/files.h"
#include "sim/core/sha256.h"

#include <npsee/fragments.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

/// Pictures kept in the cache; about 30 kB each.
constexpr std::size_t kMostKept = 1000;

bool there(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

std::vector<FileStamp> stampsOf(const std::vector<fs::path>& files) {
  std::vector<FileStamp> out;
  out.reserve(files.size());
  for (const fs::path& file : files) out.push_back(stampOf(file));
  return out;
}

/// The picture that is shipped beside a preset which nobody has changed.
fs::path shippedPicture(const fs::path& preset, std::string_view text) {
  const std::string file = preset.filename().string();
  if (!file.ends_with(kPresetEnding)) return {};
  const std::string name = file.substr(0, file.size() - kPresetEnding.size());
  const auto assets = render::shippedPresets();
  const bool same = std::ranges::any_of(assets, [&](const render::ShippedAsset& asset) { return asset.name == name && asset.text == text; });
  const fs::path picture = preset.parent_path() / "thumbnails" / (name + ".png");
  return same && there(picture) ? picture : fs::path();
}

}  // namespace

Thumbnails::Thumbnails(fs::path cache, fs::path program) : folder_(cache.empty() ? fs::path() : cache / "thumbnails"), program_(std::move(program)) {
  if (!folder_.empty()) prune();
}

/// A cache may not grow for ever: the oldest pictures go.
void Thumbnails::prune() const {
  std::error_code error;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (auto entry = fs::directory_iterator(folder_, error); !error && entry != fs::end(entry); entry.increment(error)) {
    std::error_code ignored;
    files.emplace_back(entry->last_write_time(ignored), entry->path());
  }
  if (files.size() <= kMostKept) return;
  std::ranges::sort(files);
  for (std::size_t i = 0; i + kMostKept / 2 < files.size(); ++i) fs::remove_all(files[i].second, error);
}

fs::path Thumbnails::picture(const fs::path& preset) {
  auto known = known_.find(preset);
  if (known != known_.end() && known->second.looked == looks_) return known->second.shown;
  if (known == known_.end() || known->second.stamps != stampsOf(known->second.files)) known = known_.insert_or_assign(preset, look(preset)).first;
  Known& now = known->second;
  now.looked = looks_;
  return now.shown = now.picture.empty() || !there(now.picture) ? fs::path() : now.picture;
}

Thumbnails::Known Thumbnails::look(const fs::path& file) {
  // Stamps first: what is written meanwhile is noticed later.
  Known out{{file}, stampsOf({file}), {}, {}, 0};
  auto text = readTextFile(file);
  if (!text) return out;
  out.picture = shippedPicture(file, *text);
  if (!out.picture.empty() || folder_.empty() || program_.empty()) return out;
  // Models of its own are part of what is seen.
  std::string models;
  if (const auto preset = parsePreset(*text, file.string(), file.parent_path())) {
    for (const fs::path& model : modelFiles(*preset)) {
      out.files.push_back(file.parent_path() / model);
      out.stamps.push_back(stampOf(out.files.back()));
    }
    models = modelTexts(*preset);
  }
  out.picture = folder_ / (sha256(*text + models) + ".png");
  if (!there(out.picture) && asked_.insert(out.picture).second) wanted_.push_back({std::move(*text), file.parent_path(), out.picture});
  return out;
}

fs::path Thumbnails::workFolder() const {
  fs::path out = now_.picture;
  return out.replace_extension(".work");
}

void Thumbnails::startNext() {
  now_ = std::move(wanted_.front());
  wanted_.pop_front();
  std::error_code ignored;
  fs::create_directories(workFolder(), ignored);
  // The bytes whose fingerprint names the picture, whatever the file holds by now.
  const fs::path recipe = workFolder() / ("preset" + std::string(kPresetEnding));
  const auto preset = parsePreset(now_.text, recipe.string(), now_.folder);
  if (!preset || !writeFileAtomically(recipe, now_.text) || !bringModels(*preset, workFolder())) {
    fs::remove_all(workFolder(), ignored);
    return;
  }
  auto child = Child::start(program_, {"render", recipe.string(), "-o", now_.picture.string(), "--size", "256x160", "--jobs", "1", "--progress", "never"});
  if (child) child_ = std::move(*child);
}

void Thumbnails::update(bool wait) {
  do {
    if (child_ && wait) child_->wait();
    if (child_ && !child_->running()) {
      child_.reset();
      lookAgain();
      std::error_code ignored;
      fs::remove_all(workFolder(), ignored);
    }
    if (!child_ && !wanted_.empty()) startNext();
  } while (wait && busy());
}

}  // namespace npsee::editor
