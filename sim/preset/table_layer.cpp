#include "sim/preset/row.h"

namespace npsee::table {
namespace {

using enum Section;
using Rows = std::vector<Parameter>;
using Why = std::string_view;

// Why a parameter has no effect with the others as they are; empty where it has.

constexpr Why kFlung = "the burst's impulse flings the pieces", kWhole = "the pieces start where they are in the model";
Why flung(const Preset&, const Layer& layer) { return layer.form == Form::pieces ? kFlung : ""; }
Why withoutPieces(const Preset&, const Layer& layer) { return layer.form == Form::pieces ? "" : "the form is not pieces"; }
template <RegionShape... shapes>
Why unlessShape(const Preset&, const Layer& layer) {
  if (layer.form == Form::pieces && layer.count > 0) return kWhole;
  return ((layer.region_shape == shapes) || ...) ? "" : "the region's shape has no such size";
}
Why inNoRegion(const Preset&, const Layer& layer) { return layer.form == Form::pieces && layer.count > 0 ? kWhole : ""; }
Why ofAPoint(const Preset& preset, const Layer& layer) {
  if (const Why why = inNoRegion(preset, layer); !why.empty()) return why;
  return layer.region_shape == RegionShape::point ? "a point has no inside" : "";
}
Why withACount(const Preset&, const Layer& layer) { return layer.count > 0 ? "the count says how many" : ""; }
Why withoutParent(const Preset&, const Layer& layer) { return layer.parent.empty() ? "the layer hangs on the burst" : ""; }
Why inAllDirections(const Preset& preset, const Layer& layer) {
  if (layer.form == Form::pieces) return kFlung;
  if (layer.directionality == Directionality::neutral) return "the directionality is neutral";
  return layer.directionality == Directionality::burst && preset.burst == BurstKind::air && layer.parent.empty() ? "an air burst throws in all directions" : "";
}
Why withoutDeviation(const Layer& layer, double deviation) { return layer.form == Form::pieces ? kFlung : deviation == 0.0 ? "the deviation is 0" : ""; }
Why straight(const Preset&, const Layer& layer) { return layer.trajectory == Trajectory::linear ? "the trajectory is linear" : ""; }
Why alongTheGround(const Preset&, const Layer& layer) { return layer.follow_ground ? "the layer flows along the ground" : ""; }
Why withoutContact(const Preset& preset, const Layer& layer) { return layer.collide ? alongTheGround(preset, layer) : "ground collision is off"; }
Why offAPath(const Preset&, const Layer& layer) { return layer.parent.empty() || layer.trigger != Trigger::path ? "the layer is not spread along a path" : ""; }
Why withoutTurbulence(const Preset&, const Layer& layer) { return layer.turbulence_m == 0.0 ? "there is no turbulence" : ""; }
Why cold(const Preset&, const Layer& layer) { return layer.temperature_k > 0.0 ? "" : "the layer is cold"; }
Why ofThePieces(const Preset&, const Layer& layer) { return layer.form == Form::pieces ? "the pieces have the model's colours" : ""; }
Why overLife(const Preset&, const Layer& layer) { return layer.colour_over_life.empty() ? "" : "the colour over life replaces it"; }

void addIdentity(Rows& rows) {
  rows.push_back(row(&Layer::name, std::string("fragments"), {.key = "name", .label = "Name", .thesis = "", .doc = "Unique name of the layer; letters, digits, space, - and _.", .section = layer, .hard = {1, 40}}));
  rows.push_back(row(&Layer::enabled, true, {.key = "enabled", .label = "Enabled", .thesis = "", .doc = "A disabled layer, and all that hangs on it, starts no particles.", .section = layer}));
  rows.push_back(row(&Layer::variation, std::int64_t{0}, {.key = "variation", .label = "Variation", .thesis = "", .doc = "Another number draws this layer's particles anew and leaves all other layers as they are.", .section = layer, .hard = {0, 4294967295.0}, .slider = {0, 999}}));
}

void addHierarchy(Rows& rows) {
  rows.push_back(row(&Layer::parent, std::string(), {.key = "parent", .label = "Hangs on", .thesis = "hierarchy of systems", .doc = "Name of the layer whose particles start this one's; empty for the burst itself.", .section = hierarchy, .hard = {0, 40}}));
  rows.push_back(row(&Layer::trigger, Trigger::none, {.key = "trigger", .label = "Trigger", .thesis = "", .doc = "When a parent particle starts children: at its birth, spread along its path, at each bounce, or at its death; none without a parent.", .section = hierarchy, .idle = withoutParent}));
  rows.push_back(row(&Layer::path_spacing, PathSpacing::time, {.key = "path_spacing", .label = "Path spacing", .thesis = "", .doc = "Children along a path start at even times, so that they stand close where the parent is slow, or at even distances, so that a trail has neither gaps nor knots.", .section = hierarchy, .idle = offAPath}));
  rows.push_back(row(&Layer::inherit_velocity, 0.0, {.key = "inherit_velocity", .label = "Inherit velocity", .thesis = "", .doc = "Share of the parent particle's velocity at that moment that is added to a child's launch velocity.", .section = hierarchy, .unit = Unit::fraction, .hard = {-2, 2}, .slider = {0, 1}, .idle = withoutParent}));
}

void addRegion(Rows& rows) {
  rows.push_back(row(&Layer::region_shape, RegionShape::disc, {.key = "region.shape", .label = "Region shape", .thesis = "shape of the region", .doc = "Where particles start. Disc, ring and square lie on the ground plane, line along x; the others have height.", .section = region, .idle = inNoRegion}));
  rows.push_back(row(&Layer::region_fill, RegionFill::filled, {.key = "region.fill", .label = "Region fill", .thesis = "", .doc = "Particles start throughout the region, or only on its outer curve or surface (a disc's rim, a sphere's skin, a line's two ends).", .section = region, .idle = ofAPoint}));
  rows.push_back(row(&Layer::region_radius_m, 3.0, {.key = "region.radius", .label = "Region radius", .thesis = "size of the region", .doc = "Radius of disc, ring, sphere, hemisphere and cylinder.", .section = region, .unit = Unit::metre, .hard = {0, 1000}, .slider = {0, 30}, .idle = unlessShape<RegionShape::disc, RegionShape::ring, RegionShape::sphere, RegionShape::hemisphere, RegionShape::cylinder>}));
  rows.push_back(row(&Layer::region_inner_radius_m, 1.5, {.key = "region.inner_radius", .label = "Inner radius", .thesis = "", .doc = "Inner radius of a ring; larger than the radius counts as equal to it.", .section = region, .unit = Unit::metre, .hard = {0, 1000}, .slider = {0, 30}, .idle = unlessShape<RegionShape::ring>}));
  rows.push_back(row(&Layer::region_length_m, 6.0, {.key = "region.length", .label = "Region length", .thesis = "", .doc = "Extent along x of square, line and box; a square has it along z too.", .section = region, .unit = Unit::metre, .hard = {0, 2000}, .slider = {0, 60}, .idle = unlessShape<RegionShape::square, RegionShape::line, RegionShape::box>}));
  rows.push_back(row(&Layer::region_width_m, 6.0, {.key = "region.width", .label = "Region width", .thesis = "", .doc = "Extent along z of a box.", .section = region, .unit = Unit::metre, .hard = {0, 2000}, .slider = {0, 60}, .idle = unlessShape<RegionShape::box>}));
  rows.push_back(row(&Layer::region_height_m, 3.0, {.key = "region.height", .label = "Region height", .thesis = "", .doc = "Extent along y of box and cylinder, upward from the burst's centre in a ground burst and about it in an air burst.", .section = region, .unit = Unit::metre, .hard = {0, 2000}, .slider = {0, 60}, .idle = unlessShape<RegionShape::box, RegionShape::cylinder>}));
  rows.push_back(row(&Layer::region_offset_m, Vec3{}, {.key = "region.offset", .label = "Region offset", .thesis = "", .doc = "Place of the region's centre relative to the burst, or to the parent particle.", .section = region, .unit = Unit::metre, .hard = {-1000, 1000}, .slider = {-20, 20}}));
  rows.push_back(row(&Layer::density, 3.5, {.key = "density", .label = "Density", .thesis = "density of the initial distribution", .doc = "Particles per metre, square metre or cubic metre of the region; per event in a layer with a parent. Not used where a count is given.", .section = region, .unit = Unit::per_metre, .hard = {0, 1000000}, .slider = {0.01, 1000}, .scale = Scale::logarithmic, .idle = withACount}));
  rows.push_back(row(&Layer::count, std::int64_t{0}, {.key = "count", .label = "Count", .thesis = "", .doc = "Number of particles, per event in a layer with a parent; 0 takes it from the density.", .section = region, .unit = Unit::particle, .hard = {0, static_cast<double>(kMaxParticles)}, .slider = {0, 2000}}));
}

void addLaunch(Rows& rows) {
  rows.push_back(row(&Layer::direction, Vec3{0.0, 1.0, 0.0}, {.key = "direction", .label = "Direction", .thesis = "principal orientation", .doc = "Principal direction of the ejection, of any length but zero: x east, y up, z south.", .section = launch, .hard = {-1000, 1000}, .slider = {-1, 1}, .idle = inAllDirections}));
  rows.push_back(row(&Layer::directionality, Directionality::burst, {.key = "directionality", .label = "Directionality", .thesis = "directionality", .doc = "Cone: within the ejection angle of the direction. Neutral: equally in all directions. Burst: a cone in a ground burst, neutral in an air burst.", .section = launch, .idle = flung}));
  rows.push_back(row(&Layer::ejection_angle_rad, 50.0, {.key = "ejection_angle", .label = "Ejection angle", .thesis = "Ejection angle", .doc = "Limiting angle between a particle's launch and the principal direction; the lean of the template's sides.", .section = launch, .unit = Unit::degree, .hard = {0, 180}, .slider = {0, 90}, .idle = inAllDirections}));
  rows.push_back(row(&Layer::angle_distribution, AngleDistribution::normal, {.key = "angle_distribution", .label = "Angle distribution", .thesis = "normal distribution within the ejection angle", .doc = "Normal: angle from the direction is half-normal, its deviation half the ejection angle, cut off at the ejection angle. Uniform: every direction within the cone is as likely (uniform in solid angle). Place: particles lean as the template's sides, tan(angle) growing from 0 at the region's centre to the ejection angle's at its rim.", .section = launch, .idle = inAllDirections}));
  rows.push_back(row(&Layer::outward, true, {.key = "outward", .label = "Outward", .thesis = "", .doc = "A particle leans away from the region's centre, as the template's sides do; otherwise to a random side.", .section = launch, .idle = inAllDirections}));
  rows.push_back(row(&Layer::speed_mean_mps, 15.0, {.key = "speed_mean", .label = "Y-mag", .thesis = "Y-mag", .doc = "Mean launch speed; the template's height.", .section = launch, .unit = Unit::metre_per_second, .hard = {0, 3000}, .slider = {0, 150}, .idle = flung}));
  rows.push_back(row(&Layer::speed_deviation_mps, 3.0, {.key = "speed_deviation", .label = "Y-mag deviation", .thesis = "variance of Y-mag", .doc = "Standard deviation of the launch speed, or its largest departure from the mean where the distribution is uniform. Draws below zero count as zero.", .section = launch, .unit = Unit::metre_per_second, .hard = {0, 1000}, .slider = {0, 50}, .idle = flung}));
  rows.push_back(row(&Layer::speed_distribution, Distribution::normal, {.key = "speed_distribution", .label = "Y-mag distribution", .thesis = "eq. 4.18", .doc = "Normal, or uniform within mean +- deviation (thesis eq. 4.18 with Rand() read as -1 to 1).", .section = launch, .idle = [](const Preset&, const Layer& layer) { return withoutDeviation(layer, layer.speed_deviation_mps); }}));
  rows.push_back(row(&Layer::size_mean_m, 0.6, {.key = "size_mean", .label = "XZ-mag", .thesis = "XZ-mag", .doc = "Mean particle size (diameter of the sphere around it); the template's overall scale.", .section = launch, .unit = Unit::metre, .hard = {0, 100}, .slider = {0.01, 5}, .scale = Scale::logarithmic, .idle = flung}));
  rows.push_back(row(&Layer::size_deviation_m, 0.15, {.key = "size_deviation", .label = "XZ-mag deviation", .thesis = "variance of XZ-mag", .doc = "Standard deviation of the size, or its largest departure from the mean where the distribution is uniform. Draws below zero count as zero.", .section = launch, .unit = Unit::metre, .hard = {0, 100}, .slider = {0, 2}, .idle = flung}));
  rows.push_back(row(&Layer::size_distribution, Distribution::normal, {.key = "size_distribution", .label = "XZ-mag distribution", .thesis = "eq. 4.18", .doc = "Normal, or uniform within mean +- deviation.", .section = launch, .idle = [](const Preset&, const Layer& layer) { return withoutDeviation(layer, layer.size_deviation_m); }}));
  rows.push_back(row(&Layer::spin_mean_radps, 1.5, {.key = "spin_mean", .label = "Spin", .thesis = "", .doc = "Mean rate at which a particle tumbles about an axis of its own until it comes to rest.", .section = launch, .unit = Unit::revolution_per_second, .hard = {0, 100}, .slider = {0, 10}, .idle = flung}));
  rows.push_back(row(&Layer::spin_deviation_radps, 0.5, {.key = "spin_deviation", .label = "Spin deviation", .thesis = "", .doc = "Standard deviation of the tumbling rate.", .section = launch, .unit = Unit::revolution_per_second, .hard = {0, 100}, .slider = {0, 5}, .idle = flung}));
}

void addTime(Rows& rows) {
  rows.push_back(row(&Layer::start_s, 0.0, {.key = "start", .label = "Start", .thesis = "", .doc = "Time after the burst, or after the parent's event, at which the layer begins.", .section = time, .unit = Unit::second, .hard = {0, 600}, .slider = {0, 5}}));
  rows.push_back(row(&Layer::duration_s, 0.0, {.key = "duration", .label = "Duration", .thesis = "", .doc = "Time over which particles are started at an even rate; 0 starts all at once.", .section = time, .unit = Unit::second, .hard = {0, 600}, .slider = {0, 5}}));
  rows.push_back(row(&Layer::lifetime_mean_s, 6.0, {.key = "lifetime_mean", .label = "Lifetime", .thesis = "lifetime", .doc = "Mean time from a particle's birth to its death.", .section = time, .unit = Unit::second, .hard = {0, 600}, .slider = {0.1, 20}, .scale = Scale::logarithmic}));
  rows.push_back(row(&Layer::lifetime_deviation_s, 0.8, {.key = "lifetime_deviation", .label = "Lifetime deviation", .thesis = "", .doc = "Standard deviation of the lifetime, so that particles do not vanish all at once. Draws below zero count as zero.", .section = time, .unit = Unit::second, .hard = {0, 600}, .slider = {0, 5}}));
}

void addFlight(Rows& rows) {
  rows.push_back(row(&Layer::trajectory, Trajectory::parabolic, {.key = "trajectory", .label = "Trajectory", .thesis = "linear or parabolic", .doc = "Linear: straight at launch velocity, without gravity, drag or wind. Parabolic: under gravity, with drag if there is any.", .section = flight}));
  rows.push_back(row(&Layer::drag_ps, 0.0, {.key = "drag", .label = "Drag", .thesis = "", .doc = "Rate at which velocity relative to the wind decays; 0 is flight without air.", .section = flight, .unit = Unit::per_second, .hard = {0, 100}, .slider = {0, 5}, .idle = straight}));
  rows.push_back(row(&Layer::buoyancy_mps2, 0.0, {.key = "buoyancy", .label = "Buoyancy", .thesis = "", .doc = "Upward acceleration that works against gravity, as hot gas has it.", .section = flight, .unit = Unit::metre_per_second2, .hard = {-100, 100}, .slider = {0, 20}, .idle = straight}));
  rows.push_back(row(&Layer::turbulence_m, 0.0, {.key = "turbulence", .label = "Turbulence", .thesis = "", .doc = "Farthest that eddies carry a particle off its path; about a quarter of it is usual, and it grows from nothing at birth. 0 is still air. A layer that collides has it on flat ground only.", .section = flight, .unit = Unit::metre, .hard = {0, 100}, .slider = {0, 10}}));
  rows.push_back(row(&Layer::turbulence_size_m, 4.0, {.key = "turbulence_size", .label = "Eddy size", .thesis = "", .doc = "Size of the largest eddies: particles nearer to each other than that move together.", .section = flight, .unit = Unit::metre, .hard = {0.01, 1000}, .slider = {0.1, 30}, .scale = Scale::logarithmic, .idle = withoutTurbulence}));
}

void addGround(Rows& rows) {
  rows.push_back(row(&Layer::follow_ground, false, {.key = "follow_ground", .label = "Follow the ground", .thesis = "", .doc = "Particles flow along the ground instead of falling and bouncing, as a skirt of dust does: nothing pulls them down, drag slows them upward as along the ground, only buoyancy beyond gravity lifts them, and over terrain they rise and sink with it.", .section = ground}));
  rows.push_back(row(&Layer::collide, true, {.key = "collide", .label = "Ground collision", .thesis = "ground collision", .doc = "Particles bounce on the ground; otherwise they pass through it.", .section = ground, .idle = alongTheGround}));
  rows.push_back(row(&Layer::restitution, 0.45, {.key = "restitution", .label = "Restitution", .thesis = "damping of energy", .doc = "Speed away from the ground after a bounce over the speed towards it before.", .section = ground, .unit = Unit::fraction, .hard = {0, 1}, .idle = withoutContact}));
  rows.push_back(row(&Layer::friction, 0.25, {.key = "friction", .label = "Friction", .thesis = "", .doc = "Share of the speed along the ground that a bounce takes away.", .section = ground, .unit = Unit::fraction, .hard = {0, 1}, .idle = withoutContact}));
  rows.push_back(row(&Layer::bounce_limit, std::int64_t{8}, {.key = "bounce_limit", .label = "Bounce limit", .thesis = "", .doc = "Bounces after which a particle stays where it touches the ground next.", .section = ground, .hard = {0, 64}, .slider = {0, 16}, .idle = withoutContact}));
  rows.push_back(row(&Layer::rest_speed_mps, 0.5, {.key = "rest_speed", .label = "Rest speed", .thesis = "", .doc = "A particle whose speed away from the ground after a bounce would be below this comes to rest there.", .section = ground, .unit = Unit::metre_per_second, .hard = {0, 100}, .slider = {0, 5}, .idle = withoutContact}));
}

void addLook(Rows& rows) {
  rows.push_back(row(&Layer::form, Form::tetrahedron, {.key = "form", .label = "Form", .thesis = "tetrahedron", .doc = "What a particle is drawn as; disc and sphere are the thesis's earlier choices. A shock is a blast front with its ring on the ground: its size is the diameter at the end of its life, and growth and fading follow the law of a strong shock unless curves over life are given. A scorch is a burnt patch on the ground under the particle. Pieces are those of a model that comes apart; see the parameters of that group.", .section = look}));
  rows.push_back(row(&Layer::colour, Colour{0.82, 0.70, 0.52}, {.key = "colour", .label = "Initial colour", .thesis = "initial colour", .doc = "Colour of the particles, sRGB.", .section = look, .hard = {0, 1}, .idle = overLife}));
  rows.push_back(row(&Layer::colour_variation, 0.15, {.key = "colour_variation", .label = "Colour variation", .thesis = "", .doc = "Largest share by which a particle is brighter or darker than its layer.", .section = look, .unit = Unit::fraction, .hard = {0, 1}, .idle = ofThePieces}));
  rows.push_back(row(&Layer::temperature_k, 0.0, {.key = "temperature", .label = "Temperature", .thesis = "", .doc = "Temperature at birth of what is so hot that it glows, as a black body of it does: fragments from about 1200 K, fire about 1900 K. 0 does not glow.", .section = look, .unit = Unit::kelvin, .hard = {0, 6000}, .slider = {0, 3000}}));
  rows.push_back(row(&Layer::cooling_s, 1.0, {.key = "cooling", .label = "Cooling", .thesis = "", .doc = "Time after which the temperature has fallen to 63 %, as that of a body does that cools by its radiation.", .section = look, .unit = Unit::second, .hard = {0.01, 600}, .slider = {0.1, 20}, .scale = Scale::logarithmic, .idle = cold}));
  rows.push_back(row(&Layer::opacity, 1.0, {.key = "opacity", .label = "Opacity", .thesis = "", .doc = "Opacity of the particles.", .section = look, .unit = Unit::fraction, .hard = {0, 1}}));
  rows.push_back(row(&Layer::colour_over_life, Gradient{}, {.key = "colour_over_life", .label = "Colour over life", .thesis = "", .doc = "Stops [fraction of life, colour]; replaces the initial colour. Empty keeps it.", .section = look, .hard = {0, 1}}));
  rows.push_back(row(&Layer::opacity_over_life, Curve{}, {.key = "opacity_over_life", .label = "Opacity over life", .thesis = "", .doc = "Points [fraction of life, factor on the opacity]. Empty is 1 throughout.", .section = look, .hard = {0, 1}}));
  rows.push_back(row(&Layer::size_over_life, Curve{}, {.key = "size_over_life", .label = "Size over life", .thesis = "", .doc = "Points [fraction of life, factor on the size]. Empty is 1 throughout.", .section = look, .hard = {0, 100}, .slider = {0, 4}}));
}

void addPieces(Rows& rows) {
  rows.push_back(row(&Layer::pieces_model, std::string("block"), {.key = "pieces.model", .label = "Model", .thesis = "", .doc = "The model that comes apart into as many pieces as there are particles: a shipped one, such as tank or truck, or an OBJ file in the preset's folder or below, named with .obj. It stands with its origin at the region's offset, turned by the heading.", .section = pieces, .hard = {0, 200}, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_scale, 1.0, {.key = "pieces.scale", .label = "Scale", .thesis = "", .doc = "Metres that the model's unit of length stands for.", .section = pieces, .hard = {0.001, 1000}, .slider = {0.1, 10}, .scale = Scale::logarithmic, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_heading_rad, 0.0, {.key = "pieces.heading", .label = "Heading", .thesis = "", .doc = "Where the model's front points, clockwise from north (-z).", .section = pieces, .unit = Unit::degree, .hard = {-360, 360}, .slider = {-180, 180}, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_density_kgpm3, 1000.0, {.key = "pieces.density", .label = "Mass density", .thesis = "", .doc = "Mass of a piece by its volume. Models are solid: for what is hollow, its mass over its outer volume (masonry 2000, a tank 2500, a car 250).", .section = pieces, .unit = Unit::kilogram_per_metre3, .hard = {1, 30000}, .slider = {50, 8000}, .scale = Scale::logarithmic, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_impulse_Pas, 10.0, {.key = "pieces.impulse", .label = "Impulse", .thesis = "", .doc = "Impulse per area that the burst gives at its place. A piece leaves with this times the area it shows to the burst over its mass; it turns as the impulse passes by its centre of mass.", .section = pieces, .unit = Unit::kilopascal_second, .hard = {0, 1000}, .slider = {0, 50}, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_reach_m, 3.0, {.key = "pieces.reach", .label = "Reach", .thesis = "", .doc = "Distance from the burst at which half of the impulse is left; far beyond, it falls with the square of the distance.", .section = pieces, .unit = Unit::metre, .hard = {0.01, 1000}, .slider = {0.1, 30}, .scale = Scale::logarithmic, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_burst_m, Vec3{}, {.key = "pieces.burst", .label = "Burst point", .thesis = "", .doc = "Where the burst that flings the pieces is, relative to the model's origin, in the directions of the world. Pieces leave along the line from there to their centres, the nearest first where the layer has a duration.", .section = pieces, .unit = Unit::metre, .hard = {-1000, 1000}, .slider = {-10, 10}, .idle = withoutPieces}));
  rows.push_back(row(&Layer::pieces_stand, true, {.key = "pieces.stand", .label = "Stands before", .thesis = "", .doc = "The model stands whole from the beginning until its pieces start; otherwise it appears when they do.", .section = pieces, .idle = withoutPieces}));
}

}  // namespace

std::vector<Parameter> layerRows() {
  Rows rows;
  addIdentity(rows);
  addHierarchy(rows);
  addRegion(rows);
  addLaunch(rows);
  addTime(rows);
  addFlight(rows);
  addGround(rows);
  addLook(rows);
  addPieces(rows);
  return rows;
}

}  // namespace npsee::table
