#pragma once

#include <npsee/error.h>
#include <npsee/preset.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// Where a facet's colour comes from.
enum class FacetPaint : std::uint8_t {
  own,    ///< its material's colour
  layer,  ///< the layer's colour: materials called body or accent, and those without a colour of their own
  torn,   ///< an inner face that a cut made
};

/// A facet of a solid: corners as indices of its points, anticlockwise seen from outside.
struct Facet {
  std::array<std::uint32_t, 3> corners{};
  std::uint16_t material = 0;  ///< index into the model's materials, or kTorn
  friend bool operator==(const Facet&, const Facet&) = default;
};
inline constexpr std::uint16_t kTorn = 0xffff;

/// A closed surface of triangles: each edge is used as often in one direction as in the other. Metres.
struct Solid {
  std::vector<Vec3> points;
  std::vector<Facet> facets;
  friend bool operator==(const Solid&, const Solid&) = default;
};

/// Volume, mass and inertia of a solid of even density.
struct MassProperties {
  double volume_m3 = 0.0;
  double mass_kg = 0.0;
  Vec3 centre_m;                          ///< of mass
  /// Inertia about the centre of mass, kg m^2: xx, yy, zz, xy, yz, zx of the tensor (products with their minus sign).
  std::array<double, 6> inertia_kgm2{};
};

/// Sums over the tetrahedra that the facets span with a point inside (divergence theorem): exact for any closed surface.
MassProperties massOf(const Solid& solid, double density_kgpm3);

/// A model to be taken apart: closed shells, in metres, x right, y up, -z ahead, standing where it shall stand relative to its origin.
struct SolidModel {
  struct Material {
    std::string name;
    FacetPaint paint = FacetPaint::layer;
    Colour colour{0.5, 0.5, 0.5};         ///< where the paint is its own
    friend bool operator==(const Material&, const Material&) = default;
  };
  std::string name;
  std::vector<Material> materials;
  std::vector<Solid> shells;              ///< at least one, each of positive volume
};

/// Limits of a model file, against mistakes and hostile inputs.
inline constexpr std::size_t kMaxModelFile = 8u << 20;    ///< bytes
inline constexpr std::size_t kMaxModelFacets = 20'000;    ///< triangles
inline constexpr std::int64_t kMaxPieces = 2'000;         ///< of one model

/// Reads a Wavefront OBJ (v, f, o, g, usemtl; what else is known of the format is passed over) with the colours of a material library.
/// Facets that touch along edges are turned one way and make a shell; holes are closed; shells without volume are left out.
/// `name` stands for the file in messages. Error kind input with lines: bad numbers and indices, too much, nothing that encloses a volume.
Expected<SolidModel> parseSolidModel(std::string_view obj, std::string_view mtl, std::string_view name);

/// The model a preset names: a shipped one ("tank"), or an OBJ file relative to `folder`, in it or below. Error kind input.
Expected<SolidModel> findSolidModel(const std::string& name, const std::filesystem::path& folder);

/// The files beside a preset (Preset::folder) that its models are made of: each OBJ that it names, and the material library that this one names.
/// Relative to that folder, each once; they may be missing. None where its models are shipped.
std::vector<std::filesystem::path> modelFiles(const Preset& preset);

/// Text of all model files that a preset names, with their materials; empty where its models are shipped. What cannot be read is left out.
std::string modelTexts(const Preset& preset);

/// What is wrong with a name as a preset may give it; empty if nothing.
std::string wrongModelName(const std::string& name);

/// Names of the shipped models, in order.
std::vector<std::string_view> shippedModelNames();

/// The model scaled, and turned about the vertical, clockwise seen from above.
SolidModel placedModel(SolidModel model, double scale, double heading_rad);

/// One piece: a closed surface around its centre of mass.
struct Piece {
  Solid solid;                            ///< relative to the centre of mass
  MassProperties mass;                    ///< centre relative to the model's origin
  double radius_m = 0.0;                  ///< of the sphere around the centre of mass that holds it
};

/// A model in pieces.
struct Fragments {
  std::vector<SolidModel::Material> materials;
  std::vector<Piece> pieces;
  std::size_t bytes() const;             ///< of memory that it holds
};

/// Where random draws of the cuts come from.
struct CutSeed {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;
};

/// Cuts a model into exactly `count` closed pieces, by planes through what is largest; fewer pieces than the model has shells are groups
/// of shells. The same arguments give the same bits. Volumes sum to the model's up to rounding (docs/physics.md).
/// Error kind input: it cannot be cut into so many.
Expected<std::shared_ptr<const Fragments>> cutToPieces(const SolidModel& model, std::int64_t count, double density_kgpm3, const CutSeed& seed);

/// The burst that flings pieces.
struct Impulse {
  double strength_Pas = 0.0;              ///< impulse per area at the burst, Pa s
  double reach_m = 1.0;                   ///< distance at which half of it is left
  Vec3 burst_m;                           ///< relative to the model's origin
};

/// How a piece leaves.
struct Fling {
  Vec3 velocity_mps;
  Vec3 spin_radps;                        ///< along the axis it turns about, right-handed
};

/// Every facet that faces the burst takes i(r) times its area seen from there, along the line from the burst to the piece's centre:
///
///   J = u sum_f i(r_f) a_f max(0, -n_f . u),   L = sum_f (x_f - c) x J_f,   v = J / m,   w = I^-1 L
///
/// i(r) = strength / (1 + (r / reach)^2) [Pa s], a_f area [m^2], n_f outward normal, r_f distance of the facet's centre x_f from the burst [m],
/// u unit vector from the burst to the centre of mass c (up, where they coincide), m mass [kg], I inertia [kg m^2].
/// Valid for impulses that are over before a piece has moved. Source: docs/physics.md, after the idea of Monahan 1991 as the thesis cites it.
Fling flingOf(const Piece& piece, const Impulse& impulse);

}  // namespace npsee
