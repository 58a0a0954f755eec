#pragma once

#include "app/render/mission_scene.h"
#include "editor/desk/desk.h"
#include "editor/document/session.h"
#include "editor/ui/desk_state.h"
#include "editor/ui/items.h"
#include "editor/ui/mission_state.h"
#include "editor/ui/theme.h"

#include <npsee/parameters.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace npsee::editor {

/// An explosion beside the edited one, at a moment.
struct BesidePicture {
  const Preset& preset;
  const std::shared_ptr<const Explosion>& explosion;
  const Frame& frame;
  double time_s = 0.0;  ///< of the frame
};

/// Pictures that panels show. The panels ask by size; who answers knows GL.
class Pictures {
 public:
  virtual ~Pictures() = default;
  /// Texture of the explosion (template) drawn at that size in pixels, origin lower left; null when nothing was drawn.
  virtual ImTextureID explosion(const Session& session, int width, int height) = 0;
  virtual ImTextureID shape(const Session& session, render::TemplateHandle active, int width, int height) = 0;
  /// Another explosion through the session's camera; `which` (0 to 9) keeps such textures apart. Its frame holds render::kSceneFields.
  virtual ImTextureID other(const Session& session, const BesidePicture& beside, int which, int width, int height) = 0;
  /// The mission at the moment shown, as its camera sees it; and where its things stand in that picture. Null and empty before there
  /// is a recording.
  virtual ImTextureID mission(const MissionSession& session, int width, int height) = 0;
  /// A picture file; null where it cannot be read.
  virtual ImTextureID file(const std::filesystem::path& path) = 0;
  virtual const std::vector<render::MissionMark>& marks(const MissionSession& session, int width, int height) = 0;
};

/// What the widgets remember from frame to frame. Panels have no other state.
struct UiState {
  float left_width = 252, right_width = 396, template_height = 330;  ///< unscaled pixels
  bool show_left = true, show_right = true, show_help = false, light = false;
  std::string search;
  std::set<Section> folded{Section::about, Section::layer, Section::hierarchy, Section::pieces};

  /// The slider or number being dragged.
  struct Drag {
    std::string name;
    double fraction = 0.0;  ///< where the thumb would be, unclamped
    float pressed_x = 0.0f;
    bool moving = false;
  } drag;

  /// A click on a slider's track jumps there unless it turns out to be a double click.
  struct Click {
    std::string name;
    double fraction = 0.0;
    double age_s = 0.0;
  } click;

  /// The field being typed in.
  struct Typing {
    std::string name;
    std::string text;
    std::string wrong;  ///< why the text was not taken
    bool fresh = true;  ///< the field has not had the focus yet
    int tab = 0;        ///< Tab (1) or Shift+Tab (-1) left the field
    bool shown = true;  ///< the field was drawn in this frame; one that is not any more is given up
  } typing;

  /// Tab goes from one row's field to another's.
  struct Tabbing {
    int by = 0;        ///< 1 on, -1 back; 0 = the target is known, or there is none
    std::string from, to;
    std::string before;  ///< the row drawn last that can be typed in
  } tabbing;

  /// The item under the pointer, for how long.
  struct Hover {
    std::string name;
    double seconds = 0.0;
    bool seen = false;
  } hover;
  std::string hint;  ///< one line about it, for the status line

  /// Values that a script typed: parameter name to text; the parameter's row takes them as if typed there.
  std::map<std::string, std::string> typed;
  std::string typed_error;

  /// The point of a curve or gradient that is held, or was last.
  struct Life {
    std::string name;
    int point = -1;
    double top = 1.0;    ///< of the graph when it was taken
    bool snap = false;
    bool moving = false;
    std::string picker;  ///< stop whose colours are to be opened
  } life;
  std::set<std::string> unfolded;  ///< curves and gradients whose points are listed
  render::TemplateHandle handle = render::TemplateHandle::none;  ///< of the template, under the pointer or held
  std::optional<double> sweep_from_s;  ///< where a range to be looped was begun on the time line
  std::string seen_layer;  ///< the selected one; another one is scrolled into view
  bool template_particles = true;  ///< the template shows where particles start
  /// The layer being dragged in the list, and where it would go.
  struct LayerDrag {
    std::string name;
    bool moving = false;
  } layer_drag;
  bool rename_layer = false;  ///< the selected layer's name is being edited
  MissionUi mission;
  DeskUi desk;
};

/// What every panel function gets: the document with its session, and the means to draw.
struct PanelContext {
  Session& session;
  Desk& desk;
  UiState& state;
  Items& items;
  Pictures& pictures;
  const Theme& theme;
  const Fonts& fonts;
  float scale = 1.0f;
  double elapsed_s = 0.0;
  std::optional<float> frame_ms;  ///< measured time of a frame; none in scripts, whose pictures must not depend on it

  /// Length in pixels of the display.
  float px(float length) const { return length * scale; }
  /// Names the last widget, so that scripts find it, and scrolls to it where that was asked for.
  void item(const std::string& name) const;
  /// The same for a rectangle.
  void item(const std::string& name, ImVec2 min, ImVec2 max) const;
  /// True when the pointer has rested on the last widget long enough for its tooltip. `hint` goes to the status line at once.
  bool resting(const std::string& name, const std::string& hint = {}) const;
};

/// "fragments.speed_mean" or "gravity": how scripts and the command line name a parameter.
std::string parameterName(const Document& document, const Parameter& parameter);

}  // namespace npsee::editor
