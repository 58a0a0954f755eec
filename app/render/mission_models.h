#pragma once

#include "app/render/mission_camera.h"
#include "app/render/model_pass.h"

#include <npsee/recording.h>

#include <optional>
#include <span>
#include <vector>

namespace npsee::render {

struct GroundCorner;
struct MissionView;

/// Colours by which the sides are told, sRGB-coded.
Colour sideColour(Side side);
Colour sidePaint(Side side);

/// A vehicle as it is drawn; `aimed_rad` is the azimuth of its turret, where it has shot lately.
ModelInstance vehicleInstance(const Recording& recording, std::size_t vehicle, double time_s, std::optional<double> aimed_rad, const ModelPass& models);

/// Azimuth of a vehicle's last shot, if that was not long ago.
std::optional<double> aimedAt(const Recording& recording, int vehicle, double time_s);

/// Factor by which something of that length is enlarged to be seen at a depth.
double enlargement(const MissionEye& eye, double length_m, double depth_m, double least_px);

/// Vehicles, guns, shells and observers at a moment, as models. What is not in the picture is left out, and vehicles whose entry of `in_pieces` is not 0.
std::vector<ModelInstance> missionModels(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models, std::span<const char> in_pieces);

/// Size of a vehicle's model on the ground, m, before enlarging.
double drawnLength(const VehicleType& type);

/// Soft shadows on the ground under vehicles, guns and observers of some pixels, three corners a triangle.
std::vector<GroundCorner> modelShadows(const Recording& recording, const std::vector<ModelInstance>& instances, const MissionEye& eye, const ModelPass& models);

}  // namespace npsee::render
