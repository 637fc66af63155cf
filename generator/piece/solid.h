// Solids: finished pieces and whole fruits, ready to be drawn, exported and settled.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/cut/cut.h"
#include "generator/mesh/moments.h"
#include "generator/piece/piece_origin.h"
#include "generator/surface/sweep/spot.h"
#include "generator/template/template.h"

namespace pomona {

class GuideLattice;
class SectionColors;

/// A triangle mesh that faces air. Vertices are split where colour or normal jumps; after welding equal positions it is
/// closed wherever the fruit's shells are.
struct SolidMesh {
  std::vector<glm::vec3> position;  ///< positions, metres, in the fruit's own frame, to which noise is tied
  std::vector<glm::vec3> normal;
  std::vector<Color> color;        ///< colours, linear, before style
  std::vector<std::int32_t> part;  ///< index into FruitLook::part_names
  std::vector<DetailGuide> guide;  ///< empty if no detail needs it

  /// The ways and layers of the guides at any place of cut faces; null if no detail needs them.
  std::shared_ptr<const GuideLattice> guide_lattice = nullptr;

  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> cut_face;  ///< per triangle: index of the cut face, -1 on skin and cavity walls
  std::vector<std::int32_t> surface;   ///< per triangle: surface for skin, -1 on cut faces; for ink
  std::vector<std::int32_t> instance;  ///< per triangle: the organ it is of (organs.h); empty if none was asked for

  std::array<glm::dvec3, 3> corners(std::size_t t) const {
    return {position[triangle[t].x], position[triangle[t].y], position[triangle[t].z]};
  }

  /// The outward normal of a triangle, of twice its area.
  glm::dvec3 area_vector(std::size_t t) const {
    const auto [a, b, c] = corners(t);
    return glm::cross(b - a, c - a);
  }

  /// A place on a triangle, by barycentric weights.
  glm::dvec3 place(std::size_t t, const glm::dvec3& weight) const {
    const auto [a, b, c] = corners(t);
    return weight.x * a + weight.y * b + weight.z * c;
  }
};

/// The look that all pieces of one fruit share.
struct FruitLook {
  std::vector<std::string> part_names = {};
  std::vector<MaterialSketch> materials = {};  ///< per part; parts beyond the list have the default
  std::vector<std::uint8_t> on_skin = {};      ///< per part: whether the whole fruit shows it on its skin; empty if
                                               ///< unknown
  NoiseStyle noise = {};
  std::vector<DetailSketch> details = {};
  InkStyle ink = {};
};

/// The noise, ink and materials of a template, for these parts.
FruitLook look_of(const Template& fruit, const std::vector<std::string>& part_names);

/// What a piece has of one organ of its fruit, or of the fruit around them: a berry of a bunch, or half of one.
struct Organ {
  std::int32_t instance = 0;  ///< number (organs.h): of a placed template that in surface files; 0: the fruit itself
  std::string name;           ///< "berry"
  double volume = 0;          ///< cubic metres
  double mass = 0;            ///< kilograms
};

/// One piece, or a whole fruit.
struct Solid {
  std::string name;  ///< "tomato-3.wedge-2": unique within a scene
  SolidMesh mesh;
  std::shared_ptr<const FruitLook> look = std::make_shared<const FruitLook>();  ///< never null
  PieceOrigin origin;
  std::vector<Spot> raised;  ///< spots of its skin with relief
  float opacity = 1.0f;      ///< below 1 if it is transparent: opacity seen at right angles
  double volume = 0;         ///< cubic metres
  double density = 1000;     ///< kilograms per cubic metre; by default that of water

  /// Moments by the densities of the parts inside, in the fruit's frame (weigh.h); nothing if the density is uniform.
  std::optional<RigidMass> weighed;
  bool closed = true;
  bool crumb = false;

  /// The instances of placed templates whose skin it has, ascending, 0: the fruit's own; empty where nothing is placed.
  std::vector<std::int32_t> instances;

  /// All that it has of each organ, on its skin or within; ascending; if asked for (SliceOptions::organs). Their
  /// volumes and masses add up to its own.
  std::vector<Organ> organs;

  /// The source of the cut faces' colours, for textures; else null (generator/piece/section_colors.h).
  std::shared_ptr<const SectionColors> section_colors;

  /// Gives it its own copy of the look, which may be changed until others share it.
  FruitLook& own_look() {
    const auto own = std::make_shared<FruitLook>(*look);
    look = own;
    return *own;
  }
};

/// The material of one of a solid's parts.
inline MaterialSketch material_of(const Solid& solid, std::int32_t part) {
  const auto index = static_cast<std::size_t>(part);
  return part >= 0 && index < solid.look->materials.size() ? solid.look->materials[index] : MaterialSketch{};
}

/// The pieces of a cut with its coloured section. `name` is the prefix of their names. slice() does all of it
/// (slice.h).
std::vector<Solid> solids(std::span<const CutPiece> pieces, const CrossSection& colored_section, const Template& fruit,
                          const std::string& name);

}  // namespace pomona
