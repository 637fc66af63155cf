// Solids: finished pieces and whole fruits, ready to be drawn, exported and settled.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/cut/cut.h"
#include "generator/mesh/moments.h"
#include "generator/piece/piece_origin.h"
#include "generator/surface/sweep/spot.h"
#include "generator/template/template.h"

namespace pomona {

class SectionColors;

/// One piece as a triangle mesh that faces air. Vertices are split where colour or normal jumps; after welding
/// equal positions the mesh is closed wherever the fruit's shells are.
struct Solid {
  std::string name;                 ///< "tomato-3.wedge-2": unique within a scene
  std::vector<glm::vec3> position;  ///< metres, in the fruit's own frame: what noise is tied to
  std::vector<glm::vec3> normal;
  std::vector<Color> color;        ///< linear, before style
  std::vector<std::int32_t> part;  ///< index into part_names
  std::vector<DetailGuide> guide;  ///< per vertex; empty if no detail needs it
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> cut_face;  ///< per triangle: index of the cut face, -1 on skin and cavity walls
  std::vector<std::int32_t> surface;   ///< per triangle: surface for skin, -1 on cut faces; for ink
  std::vector<std::string> part_names;
  std::vector<MaterialSketch> materials;  ///< per part; fewer: the others have the default
  std::vector<std::uint8_t> on_skin;      ///< per part: whether the whole fruit shows it; empty where nobody knows
  NoiseStyle noise;
  std::vector<DetailSketch> details;
  std::vector<Spot> raised;  ///< spots of its skin that stand out or are sunk
  InkStyle ink;
  float opacity = 1.0f;   ///< below 1 where one sees through it, looking at right angles
  double volume = 0;      ///< cubic metres
  double density = 1000;  ///< kilograms per cubic metre; that of water, as long as nothing says otherwise

  /// By the densities of the parts inside, in the fruit's frame (weigh.h); none: it is equally dense all over.
  std::optional<RigidMass> weighed;
  PieceOrigin origin;
  bool closed = true;
  bool crumb = false;

  /// What coloured the cut faces, for textures; null where nobody wants any (generator/piece/section_colors.h).
  std::shared_ptr<const SectionColors> section_colors;
};

/// The material of one of a solid's parts.
inline MaterialSketch material_of(const Solid& solid, std::int32_t part) {
  const auto index = static_cast<std::size_t>(part);
  return part >= 0 && index < solid.materials.size() ? solid.materials[index] : MaterialSketch{};
}

/// The template's materials, in the order of these parts.
std::vector<MaterialSketch> materials_of(const Template& fruit, const std::vector<std::string>& part_names);

/// The pieces of a cut, whose section has been coloured since. `name` becomes the prefix of theirs. slice() does all
/// of it (slice.h).
std::vector<Solid> solids(std::span<const CutPiece> pieces, const CrossSection& colored_section, const Template& fruit,
                          const std::string& name);

/// Its triangles, what it weighs, and where it comes from, without what it looks like: enough to settle it, and to name
/// it in files.
Solid without_looks(Solid solid);

}  // namespace pomona
