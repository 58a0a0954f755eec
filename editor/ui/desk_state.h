#pragma once

#include "app/render/camera.h"
#include "app/render/mission_camera.h"
#include "editor/desk/exports.h"
#include "editor/document/quality_chooser.h"

#include <npsee/vec3.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace npsee::editor {

/// What the widgets around the documents remember from frame to frame.
struct DeskUi {
  /// A sheet takes the place of the left panels until it is closed.
  enum class Sheet { none, history, palette, messages, exports } sheet = Sheet::none;
  int shown_step = -1;     ///< of the history; another one is scrolled into view

  struct Palette {
    std::string word;
    int chosen = 0;
    bool fresh = true;     ///< the field has not had the focus yet
    bool follow = false;   ///< the chosen line is to be scrolled into view
  } palette;

  struct Library {
    enum class Show { all, favourites, recent } show = Show::all;
    std::string word, tag;
  } library;

  struct Export {
    ExportChoice choice;
    std::string folder, file;  ///< as typed
    std::string proposed_folder, proposed_file;  ///< what stands there if nobody types
    std::string size;          ///< as typed; empty = that of the choice
    std::string wrong;         ///< about what was typed
    std::string replacing;     ///< a file that would be overwritten; the button then says so and asks once more
  } exports;

  /// The picture of the explosion: what is laid over it, and how finely it is drawn.
  struct View {
    bool pictures = true;               ///< scripts may leave them out
    bool grid = true, extent = false;
    std::string background = "sky";     ///< as `--background` reads it
    std::string quality = "automatic";  ///< one of kQualityWishes
    double exposure_stops = 0.0;        ///< of the camera
    std::vector<std::string> bookmarks;

    bool ruler = false;                 ///< clicks set its ends
    std::array<Vec3, 2> ends;
    int points = 0;

    QualityChooser chooser;
    render::Camera seen;                ///< of the last frame
    render::MissionCamera seen_mission;
    std::uint64_t seen_stamp = 0;
  } view;

  int tour = -1;           ///< hint shown; -1 = none
};

}  // namespace npsee::editor
