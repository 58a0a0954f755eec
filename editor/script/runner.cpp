#include "editor/script/runner.h"

#include "editor/mission/session.h"

#include "sim/core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace npsee::editor {
namespace {

constexpr int kPatience = 6;     ///< frames in which a wanted item is scrolled or unfolded into view
constexpr int kDragFrames = 8;   ///< a drag moves in so many steps, as a hand does
constexpr int kApart = 24;       ///< frames between clicks that are not a double click

std::optional<float> number(const std::string& text) {
  float value = 0.0f;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || std::abs(value) > 1e6f) return std::nullopt;
  return value;
}

int buttonOf(const ScriptCommand& command) {
  if (command.arguments.empty() || command.arguments[0] == "left") return ImGuiMouseButton_Left;
  return command.arguments[0] == "right" ? ImGuiMouseButton_Right : command.arguments[0] == "middle" ? ImGuiMouseButton_Middle : -1;
}

/// Prefixes under which a command looks for a name that is no item's full name.
std::vector<std::string> prefixesFor(const std::string& command) {
  if (command == "drag") return {"", "thumb:", "number:", "splitter:", "handle:"};
  if (command == "rightclick" || command == "hover") return {"", "row:", "button:", "layer:", "tab:", "toggle:", "vehicle:", "gun:", "observer:", "battery:"};
  if (command == "doubleclick") return {"", "value:", "number:", "layer:", "vehicle:", "gun:", "observer:"};
  return {"", "button:", "menu:", "item:", "toggle:", "choice:", "colour:", "text:", "life:", "layer:", "row:", "tab:", "mode:", "vehicle:", "gun:", "observer:", "battery:", "event:"};
}

/// The parameter meant by "LAYER.key" or "key", with or without an item's prefix and a component behind it.
const Parameter* parameterNamed(const Document& document, std::string_view name, int& layer) {
  if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  for (std::string_view tried = name;;) {
    if (const Parameter* parameter = findParameter(Scope::burst, tried)) return parameter;
    const std::size_t dot = tried.find('.');
    if (dot != std::string_view::npos) {
      layer = findLayer(document.preset(), tried.substr(0, dot));
      if (const Parameter* parameter = layer >= 0 ? findParameter(Scope::layer, tried.substr(dot + 1)) : nullptr) return parameter;
    }
    const std::size_t last = tried.find_last_of(".=");
    if (last == std::string_view::npos) return nullptr;
    tried = tried.substr(0, last);
  }
}

bool holds(const std::string& now, const std::string& op, const std::string& wanted) {
  if (op == "contains") return now.find(wanted) != std::string::npos;
  const auto a = number(now), b = number(wanted);
  if (!a || !b) return op == "=" ? now == wanted : op == "!=" && now != wanted;
  double x = 0.0, y = 0.0;
  std::from_chars(now.data(), now.data() + now.size(), x);
  std::from_chars(wanted.data(), wanted.data() + wanted.size(), y);
  if (op == "=") return x == y;
  if (op == "!=") return x != y;
  if (op == "<") return x < y;
  if (op == ">") return x > y;
  return op == "<=" ? x <= y : x >= y;
}

}  // namespace

ScriptRunner::ScriptRunner(std::vector<ScriptCommand> commands, std::string file, std::function<void(const std::string&)> print)
    : commands_(std::move(commands)), file_(std::move(file)), print_(std::move(print)) {}

Expected<bool> ScriptRunner::next(Editor& editor) {
  picture_.reset();
  while (steps_.empty()) {
    if (at_ >= commands_.size() || failure_) return false;
    const auto progress = begin(editor, commands_[at_]);
    if (!progress) return tl::unexpected<Error>(progress.error());
    if (*progress == Progress::again) {
      ++attempts_;
      return true;
    }
    attempts_ = 0;
    ++at_;
  }
  apply(steps_.front());
  steps_.pop_front();
  return true;
}

Expected<ScriptRunner::Progress> ScriptRunner::begin(Editor& editor, const ScriptCommand& command) {
  const std::string& name = command.name;
  if (name == "set") return set(editor, command);
  if (name == "expect") return expect(editor, command);
  if (name == "print") return print(editor, command);
  if (name == "drag" || name.ends_with("click") || name == "hover") return pointAt(editor, command);
  if (name == "key") {
    const KeyStroke stroke = *parseKeyStroke(command.arguments[0]);
    steps_.push_back({.key = std::pair(stroke, true)});
    steps_.push_back({.key = std::pair(stroke, false)});
    steps_.push_back({});
  } else if (name == "hold" || name == "let") {
    const std::string& modifier = command.arguments[0];
    if (modifier != "ctrl" && modifier != "shift" && modifier != "alt") return bad(command, "\"" + printable(modifier) + "\" is no modifier.", "Write ctrl, shift or alt.");
    steps_.push_back({.modifier = std::pair(modifier[0], name == "hold")});
  } else if (name == "type") {
    steps_.push_back({.text = command.arguments[0]});
    steps_.push_back({});
  } else if (name == "clipboard") {
    ImGui::SetClipboardText(command.arguments.empty() ? "" : command.arguments[0].c_str());
  } else if (name == "drop") {
    editor.session().drop({command.arguments[0]});
    steps_.push_back({});
    steps_.push_back({});
  } else if (name == "settle") {
    editor.desk().settle(editor.session());
    // What is drawn now is found in the frame after.
    steps_.push_back({});
    steps_.push_back({});
  } else if (name == "pictures") {
    const std::string& wish = command.arguments[0];
    if (wish != "on" && wish != "off") return bad(command, "\"" + printable(wish) + "\" is neither on nor off.");
    editor.state().desk.view.pictures = wish == "on";
  } else if (name == "save") {
    steps_.push_back({.picture = command.arguments[0]});
  } else if (name == "note") {
    for (auto& [fact_name, value] : editor.facts()) noted_[fact_name] = value;
    for (const Parameter& parameter : parameters())
      if (!editor.session().inMission() && (parameter.scope == Scope::burst || editor.session().document.hasLayer())) {
        const std::string parameter_name = parameterName(editor.session().document, parameter);
        noted_[parameter_name] = *fact(editor, parameter_name);
      }
  } else {
    if (name != "press" && name != "release" && !number(command.arguments[0])) return bad(command, "\"" + printable(command.arguments[0]) + "\" is not a number.");
    if (name == "mouse" && !number(command.arguments[1])) return bad(command, "\"" + printable(command.arguments[1]) + "\" is not a number.");
    if ((name == "press" || name == "release") && buttonOf(command) < 0) return bad(command, "there is no mouse button \"" + printable(command.arguments[0]) + "\".", "Write left, right or middle.");
    pointer(command);
  }
  return Progress::done;
}

void ScriptRunner::pointer(const ScriptCommand& command) {
  if (command.name == "mouse") steps_.push_back({.mouse = ImVec2(*number(command.arguments[0]), *number(command.arguments[1]))});
  if (command.name == "press") steps_.push_back({.button = std::pair(buttonOf(command), true)});
  if (command.name == "release") steps_.push_back({.button = std::pair(buttonOf(command), false)});
  if (command.name == "wheel") steps_.push_back({.wheel = *number(command.arguments[0])});
  if (command.name == "wait") steps_.insert(steps_.end(), static_cast<std::size_t>(std::clamp(*number(command.arguments[0]), 0.0f, 36000.0f)), Step{});
  if (command.name != "wait") steps_.push_back({});
}

Expected<ScriptRunner::Progress> ScriptRunner::set(Editor& editor, const ScriptCommand& command) {
  const std::string &name = command.arguments[0], &value = command.arguments[1];
  Session& session = editor.session();
  if (name == "time") {
    const auto time = parseQuantity(value, Unit::second);
    if (!time) return bad(command, time.error().faults.front().what);
    if (session.inMission()) {
      session.mission().clock.playing = false;
      session.mission().clock.seek(*time);
    } else {
      session.playback.playing = false;
      session.playback.seek(*time);
    }
    steps_.push_back({});
    return Progress::done;
  }
  if (session.inMission()) return setInMission(editor, command);
  int layer = session.document.selected();
  if (attempts_ == 0) {
    const Parameter* parameter = parameterNamed(session.document, name, layer);
    if (parameter == nullptr) return noSuch(editor, command, "parameter", name);
    if (parameter->scope == Scope::layer) session.document.select(layer);
    editor.state().typed[name] = value;
    editor.state().show_right = true;
    return Progress::again;
  }
  if (std::string wrong = std::exchange(editor.state().typed_error, {}); !wrong.empty()) return bad(command, wrong);
  if (!editor.state().typed.contains(name)) {
    steps_.push_back({});  // in which the explosion follows
    return Progress::done;
  }
  if (attempts_ < kPatience) return Progress::again;
  editor.state().typed.clear();
  return noSuch(editor, command, "parameter", name);
}

/// "fo1.sensing.location_cep" selects fo1; "world.weather.visibility" the mission; the forms of the person in the loop are "call.x" and
/// the like.
Expected<ScriptRunner::Progress> ScriptRunner::setInMission(Editor& editor, const ScriptCommand& command) {
  const std::string &name = command.arguments[0], &value = command.arguments[1];
  MissionDocument& document = editor.session().mission().document;
  const bool form = name.starts_with("call.") || name.starts_with("correct.");
  if (attempts_ == 0) {
    if (!form) document.select({});
    for (const std::string& id : allNames(document.scenario()))
      for (const auto kind : {ObjectRef::Kind::vehicle, ObjectRef::Kind::group, ObjectRef::Kind::battery, ObjectRef::Kind::gun, ObjectRef::Kind::observer})
        if (name.starts_with(id + '.') && exists(document.scenario(), {kind, id})) document.select({kind, id});
    editor.state().typed[name] = value;
    editor.state().show_right = true;
    editor.state().mission.right = form ? MissionUi::Right::command : MissionUi::Right::parameters;
    return Progress::again;
  }
  if (std::string wrong = std::exchange(editor.state().typed_error, {}); !wrong.empty()) return bad(command, wrong);
  if (!editor.state().typed.contains(name)) {
    steps_.push_back({});
    return Progress::done;
  }
  if (attempts_ < kPatience) return Progress::again;
  editor.state().typed.clear();
  return noSuch(editor, command, "parameter", name);
}

Expected<ScriptRunner::Progress> ScriptRunner::pointAt(Editor& editor, const ScriptCommand& command) {
  const std::string& name = command.arguments[0];
  const auto dx = command.name == "drag" ? number(command.arguments[1]) : 0.0f;
  const auto dy = command.arguments.size() > 2 ? number(command.arguments[2]) : 0.0f;
  if (!dx || !dy) return bad(command, "the distance is not a number.", "Write: drag ITEM DX [DY]");
  const std::vector<std::string> prefixes = prefixesFor(command.name);
  const Items::Item* hidden = nullptr;
  for (const std::string& prefix : prefixes) {
    const Items::Item* item = editor.items().find(prefix + name);
    if (item != nullptr && !item->visible && hidden == nullptr) hidden = item;
    if (item == nullptr || !item->visible) continue;
    editor.items().want({});
    const ImVec2 at = item->centre();
    if (command.name == "drag") dragFrom(at, *dx, *dy);
    else if (command.name == "hover") {
      steps_.push_back({.mouse = at});
      steps_.insert(steps_.end(), 40, Step{});
    } else click(at, command.name == "rightclick" ? ImGuiMouseButton_Right : ImGuiMouseButton_Left, command.name == "doubleclick" ? 2 : 1);
    return Progress::done;
  }
  int layer = editor.session().document.selected();
  const bool mission = editor.session().inMission();
  const Parameter* parameter = mission ? nullptr : parameterNamed(editor.session().document, name, layer);
  // In a mission any name may be that of a row or list entry which is not drawn yet.
  if (mission && hidden == nullptr && attempts_ < kPatience) {
    editor.items().want(name);
    return Progress::again;
  }
  if ((parameter != nullptr || hidden != nullptr) && attempts_ < kPatience) {
    if (parameter != nullptr && parameter->scope == Scope::layer) editor.session().document.select(layer);
    // Unfold and scroll first; then the widget itself can be found.
    editor.items().want(hidden != nullptr ? hidden->name : "row:" + name);
    return Progress::again;
  }
  editor.items().want({});
  if (hidden != nullptr) return bad(command, "\"" + printable(name) + "\" is not visible.", "Widen the window, or show its panel.");
  return noSuch(editor, command, "item", name);
}

void ScriptRunner::dragFrom(ImVec2 at, float dx, float dy) {
  steps_.push_back({.mouse = at});
  steps_.push_back({.button = std::pair(0, true)});
  for (int i = 1; i <= kDragFrames; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(kDragFrames);
    steps_.push_back({.mouse = ImVec2(at.x + std::round(dx * share), at.y + std::round(dy * share))});
  }
  steps_.push_back({.button = std::pair(0, false)});
  // A drag that follows at the same place is no double click.
  steps_.insert(steps_.end(), kApart, Step{});
}

void ScriptRunner::click(ImVec2 at, int button, int times) {
  steps_.push_back({.mouse = at});
  steps_.push_back({});
  for (int i = 0; i < times; ++i) {
    steps_.push_back({.button = std::pair(button, true)});
    steps_.push_back({.button = std::pair(button, false)});
  }
  steps_.insert(steps_.end(), kApart, Step{});
}

void ScriptRunner::apply(const Step& step) {
  ImGuiIO& io = ImGui::GetIO();
  if (step.mouse) io.MousePos = *step.mouse;
  if (step.button) io.MouseDown[step.button->first] = step.button->second;
  if (step.key) {
    const auto& [stroke, down] = *step.key;
    io.KeysDown[stroke.code] = down;
    io.KeyCtrl = ctrl_ || (down && stroke.ctrl);
    io.KeyShift = shift_ || (down && stroke.shift);
    io.KeyAlt = alt_ || (down && stroke.alt);
  }
  if (step.modifier) {
    const auto [letter, down] = *step.modifier;
    (letter == 'c' ? ctrl_ : letter == 's' ? shift_ : alt_) = down;
    io.KeyCtrl = ctrl_;
    io.KeyShift = shift_;
    io.KeyAlt = alt_;
  }
  if (!step.text.empty()) io.AddInputCharactersUTF8(step.text.c_str());
  io.MouseWheel = step.wheel;
  picture_ = step.picture;
}

std::optional<std::string> ScriptRunner::fact(Editor& editor, const std::string& name) const {
  for (const auto& [known, value] : editor.facts())
    if (known == name) return value;
  if (editor.session().inMission()) return std::nullopt;
  const Document& document = editor.session().document;
  if (const Parameter* parameter = findParameter(Scope::burst, name)) return valueText(*parameter, parameter->get(document.preset()));
  const std::size_t dot = name.find('.');
  const int layer = dot == std::string::npos ? -1 : findLayer(document.preset(), name.substr(0, dot));
  const Parameter* parameter = layer < 0 ? nullptr : findParameter(Scope::layer, name.substr(dot + 1));
  if (parameter == nullptr) return std::nullopt;
  return valueText(*parameter, parameter->get(document.preset().layers[static_cast<std::size_t>(layer)]));
}

Expected<ScriptRunner::Progress> ScriptRunner::expect(Editor& editor, const ScriptCommand& command) {
  const std::string& name = command.arguments[0];
  const auto failed = [&](const std::string& what) { failure_ = file_ + ':' + std::to_string(command.line) + ": " + what; };
  if (name == "visible" || name == "hidden") {
    // A name with spaces need not be quoted here either.
    const std::string wanted = command.arguments[1] + (command.arguments.size() > 2 ? ' ' + command.arguments[2] : std::string());
    const Items::Item* item = editor.items().find(wanted);
    const bool visible = item != nullptr && item->visible;
    if (visible != (name == "visible")) failed("\"" + wanted + "\" is " + (visible ? "visible." : "not visible."));
    return Progress::done;
  }
  constexpr std::array<std::string_view, 7> kOperators{"=", "!=", "<", ">", "<=", ">=", "contains"};
  // An empty value is written by leaving it out: `expect error =`.
  const std::string op = command.arguments[1];
  if (std::ranges::find(kOperators, op) == kOperators.end()) return bad(command, "\"" + printable(op) + "\" is no comparison.", "Use = != < > <= >= or contains, or write: expect visible ITEM");
  const auto now = fact(editor, name);
  if (!now) return noSuch(editor, command, "fact", name);
  std::string wanted = command.arguments.size() > 2 ? command.arguments[2] : std::string();
  if (wanted == "noted") {
    const auto noted = noted_.find(name);
    if (noted == noted_.end()) return bad(command, name + " was not noted.", "Write `note` in a line before.");
    wanted = noted->second;
  } else if (int layer = 0; const Parameter* parameter = editor.session().inMission() ? nullptr : parameterNamed(editor.session().document, name, layer)) {
    // Values may be written with any unit that fits.
    if (const auto value = parseValue(*parameter, wanted)) wanted = valueText(*parameter, *value);
  }
  if (!holds(*now, op, wanted)) failed(name + " is \"" + *now + "\", expected " + op + " \"" + wanted + "\".");
  return Progress::done;
}

Expected<ScriptRunner::Progress> ScriptRunner::print(Editor& editor, const ScriptCommand& command) {
  const std::string& name = command.arguments[0];
  if (name == "items") {
    for (const Items::Item& item : editor.items().all()) print_((item.visible ? "item " : "hidden ") + shortest(std::round(item.centre().x)) + ',' + shortest(std::round(item.centre().y)) + ' ' + item.name);
  } else if (name == "all") {
    for (const auto& [known, value] : editor.facts()) print_(known + '=' + value);
  } else if (const auto value = fact(editor, name)) {
    print_(name + '=' + *value);
  } else {
    return noSuch(editor, command, "fact", name);
  }
  return Progress::done;
}

tl::unexpected<Error> ScriptRunner::noSuch(Editor& editor, const ScriptCommand& command, const std::string& kind, const std::string& name) const {
  std::vector<std::string> names;
  const Document& document = editor.session().document;
  if (kind == "item")
    for (const Items::Item& item : editor.items().all())
      if (item.visible) names.push_back(item.name);
  if (kind == "fact")
    for (const auto& [known, value] : editor.facts()) names.push_back(known);
  if (editor.session().inMission() && kind == "parameter")
    for (const Items::Item& item : editor.items().all())
      if (item.name.starts_with("row:")) names.push_back(item.name.substr(4));
  for (const Parameter& parameter : parameters(Scope::burst)) names.emplace_back(parameter.key);
  for (const Layer& layer : document.preset().layers)
    for (const Parameter& parameter : parameters(Scope::layer)) names.push_back(layer.name + '.' + std::string(parameter.key));
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto near = nearest(name, views);
  return bad(command, "there is no " + kind + " \"" + printable(name) + "\".", near ? "Did you mean " + std::string(*near) + "?" : "`print items` and `print all` list what there is.");
}

tl::unexpected<Error> ScriptRunner::bad(const ScriptCommand& command, std::string what, std::string remedy) const {
  return fail(ErrorKind::input, {.what = std::move(what), .remedy = std::move(remedy), .file = file_, .line = command.line, .pointer = {}});
}

}  // namespace npsee::editor
