#include <npsee/weapons.h>

#include <npsee/units.h>

#include "sim/core/files.h"
#include "sim/core/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace npsee {
namespace {

struct Token {
  std::string_view text;
  int line = 0;
  std::string comments;  ///< that stand before it, as written
};

/// The seven values of a D record, in order. One table serves reading, checking and the messages.
struct DataField {
  std::string_view name, meaning;
  double max;
  bool whole;
};
constexpr DataField kData[] = {
    {"range", "absolute maximum range, m", 1e7, true},
    {"muzzle_velocity", "m/s", 10000.0, false},
    {"killsize", "lethal radius, m", 100000.0, true},
    {"damagesize", "radius of damage, m", 100000.0, true},
    {"knowledgesize", "radius within which it is noticed, m", 100000.0, true},
    {"targettype", "0 any, 1 heavy armor, 2 light armor, 3 wheeled vehicle, 4 personnel, 5 aircraft, 6 watercraft", 6.0, true},
    {"pathtype", "0 low angle, 1 high angle, 2 linear, 3 gravity bomb", 3.0, true},
};
constexpr std::size_t kNameLimit = 20, kWeaponLimit = 10000;

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

class Reader {
 public:
  Reader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  std::vector<Fault> faults;
  Weapons weapons;

  void run() {
    tokenize();
    while (at_ < tokens_.size() && weapons.list.size() < kWeaponLimit) {
      if (tokens_[at_].text == "I") weapon();
      else if (tokens_[at_].text == "D") stray("this D record has no I record before it.", "Begin each weapon with: I NAME ID");
      else stray("\"" + std::string(tokens_[at_].text) + "\" begins no record.", "Records begin with I (name, id) or D (seven values); comments stand between /* and */.");
    }
    if (at_ < tokens_.size()) fault(tokens_[at_].line, "here begins more than the " + std::to_string(kWeaponLimit) + " weapons that a file may have.", "Split the file.");
    weapons.comment_end = end_comments_;
  }

 private:
  void fault(int line, std::string what, std::string remedy = {}) {
    faults.push_back({.what = std::move(what), .remedy = std::move(remedy), .file = std::string(file_), .line = line, .pointer = {}});
  }

  void tokenize() {
    std::string comments;
    std::size_t i = 0;
    int line = 1;
    while (i < text_.size()) {
      if (isSpace(text_[i])) {
        line += text_[i++] == '\n' ? 1 : 0;
      } else if (text_.substr(i, 2) == "/*") {
        const std::size_t end = text_.find("*/", i + 2);
        if (end == std::string_view::npos) return fault(line, "this comment has no end.", "Close it with */.");
        const std::string_view comment = text_.substr(i, end + 2 - i);
        if (!comments.empty()) comments += '\n';
        comments += comment;
        line += static_cast<int>(std::ranges::count(comment, '\n'));
        i = end + 2;
      } else if (text_.substr(i, 2) == "//") {
        fault(line, "a comment begins with //.", "Write /* ... */; the file is older than //.");
        while (i < text_.size() && text_[i] != '\n') ++i;
      } else {
        const std::size_t begin = i;
        while (i < text_.size() && !isSpace(text_[i]) && text_.substr(i, 2) != "/*") ++i;
        tokens_.push_back({text_.substr(begin, i - begin), line, std::move(comments)});
        comments.clear();
      }
    }
    end_comments_ = std::move(comments);
  }

  /// Reports what stands here and goes on at the next record.
  void stray(std::string what, std::string remedy) {
    fault(tokens_[at_].line, std::move(what), std::move(remedy));
    ++at_;
    skip();
  }
  void skip() {
    while (at_ < tokens_.size() && tokens_[at_].text != "I" && tokens_[at_].text != "D") ++at_;
  }

  bool ends() const { return at_ >= tokens_.size() || tokens_[at_].text == "I" || tokens_[at_].text == "D"; }

  /// Comments at the border of two tokens: on the line of the first they belong to it, else to what follows.
  std::string commentsAfter() {
    std::string& comments = at_ < tokens_.size() ? tokens_[at_].comments : end_comments_;
    if (comments.empty()) return {};
    const Token& before = tokens_[at_ - 1];
    const auto offset = static_cast<std::size_t>(before.text.data() - text_.data()) + before.text.size();
    const std::size_t start = text_.find("/*", offset);
    if (text_.substr(offset, start - offset).find('\n') != std::string_view::npos) return {};
    // Only the first of several belongs to the record.
    const std::size_t close = comments.find("*/") + 2;
    std::string mine = comments.substr(0, close);
    comments.erase(0, std::min(comments.size(), close + 1));
    return mine;
  }

  void weapon() {
    const int line = tokens_[at_].line;
    Weapon weapon;
    weapon.comment_before = std::move(tokens_[at_].comments);
    ++at_;
    bool good = identity(weapon, line);
    if (!good) skip();
    weapon.comment_identity = commentsAfter();
    if (at_ >= tokens_.size() || tokens_[at_].text != "D") {
      const int here = at_ < tokens_.size() ? tokens_[at_].line : tokens_[at_ - 1].line;
      const bool more = at_ < tokens_.size() && tokens_[at_].text != "I";
      if (good) fault(here, more ? "\"" + std::string(tokens_[at_].text) + "\" stands where the D record of " + weapon.name + " is expected." : "the weapon " + weapon.name + " has no D record.",
                      "After I NAME ID goes: D range muzzle_velocity killsize damagesize knowledgesize targettype pathtype");
      skip();
      if (at_ >= tokens_.size() || tokens_[at_].text != "D") return;
    }
    if (!tokens_[at_].comments.empty()) weapon.comment_identity += (weapon.comment_identity.empty() ? "" : "\n") + tokens_[at_].comments;
    good = data(weapon) && good;
    weapon.comment_data = commentsAfter();
    if (!good) return;
    doubts(weapon, line);
    lines_.push_back(line);
    weapons.list.push_back(std::move(weapon));
  }

  bool identity(Weapon& weapon, int line) {
    if (ends()) {
      fault(line, "the I record has no name.", "It reads: I NAME ID");
      return false;
    }
    weapon.name = std::string(tokens_[at_].text);
    bool good = true;
    if (weapon.name.size() > kNameLimit) {
      fault(tokens_[at_].line, "the name \"" + weapon.name + "\" has " + std::to_string(weapon.name.size()) + " characters, above the limit of " + std::to_string(kNameLimit) + ".", "Shorten it; it may not contain spaces.");
      good = false;
    }
    ++at_;
    if (ends()) {
      fault(line, "the weapon " + weapon.name + " has no id.", "It reads: I NAME ID; a name may not contain spaces.");
      return false;
    }
    const Token& token = tokens_[at_];
    const auto id = number(token.text);
    if (!id || *id != std::floor(*id) || *id < 2 || *id > 1e9 || token.text.find_first_not_of("0123456789") != std::string_view::npos) {
      fault(token.line, "the id of " + weapon.name + " is \"" + std::string(token.text) + "\", but must be a whole number from 2.", "USSR weapons have numbers from 2, US weapons from 100.");
      good = false;
    } else {
      weapon.id = static_cast<int>(*id);
      good = unique(weapon, token.line) && good;
    }
    ++at_;
    return good;
  }

  bool unique(const Weapon& weapon, int line) {
    for (std::size_t i = 0; i < weapons.list.size(); ++i) {
      if (weapons.list[i].id != weapon.id) continue;
      fault(line, "the id " + std::to_string(weapon.id) + " is taken by " + weapons.list[i].name + " on line " + std::to_string(lines_[i]) + ".", "Give each weapon a number of its own.");
      return false;
    }
    return true;
  }

  static std::optional<double> number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
  }

  bool data(Weapon& weapon) {
    const int line = tokens_[at_++].line;
    double values[std::size(kData)] = {};
    bool good = true;
    for (std::size_t i = 0; i < std::size(kData); ++i, ++at_) {
      const DataField& field = kData[i];
      if (ends()) {
        fault(line, "the D record of " + weapon.name + " ends after " + std::to_string(i) + " of 7 values; " + std::string(field.name) + " is next.", std::string(field.name) + ": " + std::string(field.meaning) + ".");
        return false;
      }
      if (i > 0 && !tokens_[at_].comments.empty()) weapon.comment_identity += (weapon.comment_identity.empty() ? "" : "\n") + tokens_[at_].comments;
      const auto value = number(tokens_[at_].text);
      if (!value || *value < 0.0 || *value > field.max || (field.whole && *value != std::floor(*value)) || (!field.whole && *value == 0.0)) {
        fault(tokens_[at_].line, std::string(field.name) + " of " + weapon.name + " is \"" + std::string(tokens_[at_].text) + "\", but must be a " + (field.whole ? "whole " : "") + "number from 0 to " + shortest(field.max) + (field.whole ? "." : " and not 0."),
              std::string(field.name) + ": " + std::string(field.meaning) + ".");
        good = false;
      } else {
        values[i] = *value;
      }
    }
    weapon.range_m = static_cast<int>(values[0]);
    weapon.muzzle_velocity_mps = values[1];
    weapon.kill_radius_m = static_cast<int>(values[2]);
    weapon.damage_radius_m = static_cast<int>(values[3]);
    weapon.knowledge_radius_m = static_cast<int>(values[4]);
    weapon.target = static_cast<TargetType>(static_cast<int>(values[5]));
    weapon.path = static_cast<PathType>(static_cast<int>(values[6]));
    if (good && !ends()) {
      fault(tokens_[at_].line, "the D record of " + weapon.name + " has more than 7 values: \"" + std::string(tokens_[at_].text) + "\".", "Its values are range, muzzle_velocity, killsize, damagesize, knowledgesize, targettype and pathtype.");
      good = false;
    }
    skip();
    return good;
  }

  void doubts(const Weapon& weapon, int line) {
    // A light beam and a bomb do not fly from a muzzle.
    if (weapon.path == PathType::linear || weapon.path == PathType::gravity_bomb) return;
    const double reach = weapon.muzzle_velocity_mps * weapon.muzzle_velocity_mps / kStandardGravity_mps2;
    if (weapon.range_m <= reach) return;
    weapons.warnings.push_back({.what = weapon.name + " states a range of " + std::to_string(weapon.range_m) + " m, but at " + shortest(weapon.muzzle_velocity_mps) + " m/s even a vacuum gives only " +
                                        std::to_string(static_cast<int>(reach)) + " m.",
                                .remedy = "The stated range is not relied on.", .file = std::string(file_), .line = line, .pointer = {}});
  }

  std::string_view text_, file_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::string end_comments_;
  std::vector<int> lines_;
};

}  // namespace

const Weapon* Weapons::find(std::string_view name_or_id) const {
  for (const Weapon& weapon : list)
    if (weapon.name == name_or_id || std::to_string(weapon.id) == name_or_id) return &weapon;
  return nullptr;
}

Expected<Weapons> parseWeapons(std::string_view text, std::string_view file) {
  Reader reader(text, file);
  reader.run();
  if (!reader.faults.empty()) {
    std::ranges::stable_sort(reader.faults, {}, &Fault::line);
    return tl::unexpected<Error>(Error{ErrorKind::input, std::move(reader.faults)});
  }
  return std::move(reader.weapons);
}

Expected<Weapons> loadWeapons(const std::filesystem::path& path) {
  const auto text = readTextFile(path);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseWeapons(*text, path.string());
}

std::string weaponsText(const Weapons& weapons) {
  std::string out;
  const auto after = [&](const std::string& comment) {
    if (!comment.empty()) out += ' ' + comment;
    out += '\n';
  };
  for (const Weapon& w : weapons.list) {
    if (!out.empty()) out += '\n';
    if (!w.comment_before.empty()) out += w.comment_before + '\n';
    out += "I " + w.name + ' ' + std::to_string(w.id);
    after(w.comment_identity);
    // The thesis writes velocities with a decimal point: they are floats.
    std::string speed = shortest(w.muzzle_velocity_mps);
    if (speed.find_first_of(".e") == std::string::npos) speed += ".0";
    out += "D " + std::to_string(w.range_m) + ' ' + speed;
    for (const int value : {w.kill_radius_m, w.damage_radius_m, w.knowledge_radius_m, static_cast<int>(w.target), static_cast<int>(w.path)}) out += ' ' + std::to_string(value);
    after(w.comment_data);
  }
  if (!weapons.comment_end.empty()) out += '\n' + weapons.comment_end + '\n';
  return out;
}

Expected<void> saveWeapons(const Weapons& weapons, const std::filesystem::path& path) {
  const std::string text = weaponsText(weapons);
  const auto again = parseWeapons(text, "the list of weapons");
  if (!again) return tl::unexpected<Error>(again.error());
  if (!(*again == weapons)) return fail(ErrorKind::input, "the list of weapons would not read back as it is.", "A comment must be of the form /* ... */.");
  return writeFileAtomically(path, text);
}

}  // namespace npsee
