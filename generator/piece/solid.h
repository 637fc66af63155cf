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

class SectionColors;

/// A triangle mesh that faces air. Vertices are split where colour or normal jumps; after welding equal positions it is
/// closed wherever the fruit's shells are.
struct SolidMesh {
  std::vector<glm::vec3> position;  ///< metres, in the fruit's own frame: what noise is tied to
  std::vector<glm::vec3> normal;
  std::vector<Color> color;        ///< linear, before style
  std::vector<std::int32_t> part;  ///< index into FruitLook::part_names
  std::vector<DetailGuide> guide;  ///< empty where no detail asks for it
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> cut_face;  ///< per triangle: index of the cut face, -1 on skin and cavity walls
  std::vector<std::int32_t> surface;   ///< per triangle: surface for skin, -1 on cut faces; for ink

  std::array<glm::dvec3, 3> corners(std::size_t t) const {
    return {position[triangle[t].x], position[triangle[t].y], position[triangle[t].z]};
  }

  /// Across a triangle, outwards, twice as long as its area is large.
  glm::dvec3 area_vector(std::size_t t) const {
    const auto [a, b, c] = corners(t);
    return glm::cross(b - a, c - a);
  }

  /// A place on a triangle, by its corners' weights.
  glm::dvec3 place(std::size_t t, const glm::dvec3& weight) const {
    const auto [a, b, c] = corners(t);
    return weight.x * a + weight.y * b + weight.z * c;
  }
};

/// What all pieces of one fruit look like.
struct FruitLook {
  std::vector<std::string> part_names = {};
  std::vector<MaterialSketch> materials = {};  ///< per part; fewer: the others have the default
  std::vector<std::uint8_t> on_skin = {};      ///< per part: whether the whole fruit shows it; empty where nobody knows
  NoiseStyle noise = {};
  std::vector<DetailSketch> details = {};
  InkStyle ink = {};
};

/// The noise, ink and materials of a template, for these parts.
FruitLook look_of(const Template& fruit, const std::vector<std::string>& part_names);

/// One piece, or a whole fruit.
struct Solid {
  std::string name;  ///< "tomato-3.wedge-2": unique within a scene
  SolidMesh mesh;
  std::shared_ptr<const FruitLook> look = std::make_shared<const FruitLook>();  ///< never null
  PieceOrigin origin;
  std::vector<Spot> raised;  ///< spots of its skin that stand out or are sunk
  float opacity = 1.0f;      ///< below 1 where one sees through it, looking at right angles
  double volume = 0;         ///< cubic metres
  double density = 1000;     ///< kilograms per cubic metre; that of water, as long as nothing says otherwise

  /// By the densities of the parts inside, in the fruit's frame (weigh.h); none: it is equally dense all over.
  std::optional<RigidMass> weighed;
  bool closed = true;
  bool crumb = false;

  /// What coloured the cut faces, for textures; null where nobody wants any (generator/piece/section_colors.h).
  std::shared_ptr<const SectionColors> section_colors;

  /// Gives it a look of its own, a copy of what it had, to be changed before others share it.
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

/// The pieces of a cut, whose section has been coloured since. `name` becomes the prefix of theirs. slice() does all
/// of it (slice.h).
std::vector<Solid> solids(std::span<const CutPiece> pieces, const CrossSection& colored_section, const Template& fruit,
                          const std::string& name);

}  // namespace pomona
