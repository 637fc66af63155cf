// A fruit that a browser or an engine can cut: its surfaces and the solved colours between them, for eight-bit colours.
// docs/reference/asset.md describes its file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/base/color.h"
#include "generator/mesh/box.h"

namespace pomona {

/// Guides of texture detail on cut faces, at every `stride`-th node of the lattice
/// (generator/cut/section/detail_guide.h).
struct AssetGuide {
  int stride = 8;
  double unit = 0;                  ///< metres per value of 1
  std::array<int, 3> count{};       ///< nodes along each axis
  std::vector<glm::i16vec4> value;  ///< to_skin and layer, in units

  /// The weight of each detail of cut faces, of 255: for every part, at `depth_steps` depths below the skin from 0 to
  /// `deepest` (metres).
  std::vector<glm::u8vec4> share;
  double deepest = 0;
};
constexpr int depth_steps = 32;

/// A tile of a detail by example (generator/template/example_tile.h).
struct AssetTile {
  int side = 0;
  std::vector<glm::u8vec3> palette;  ///< sRGB, at most 256
  std::vector<std::uint8_t> texel;   ///< numbers of the palette, x innermost
};

/// One fruit. Metres in the fruit's own frame, +Y along the axis.
struct Asset {
  std::string name, title, latin;
  std::uint64_t seed = 0;
  std::string diffuser;  ///< the method that coloured the nodes

  // Nodes lie at origin + spacing * (x, y, z), 0 <= x < count.
  glm::dvec3 origin{0};
  double spacing = 0;
  std::array<int, 3> count{};
  std::vector<glm::u8vec3> node_color;  ///< sRGB, node (x, y, z) at (z * count.y + y) * count.x + x; black in air
  std::vector<std::int8_t> winding;     ///< per node: winding number of the boundary; 0 in air

  // Surfaces. Vertex q lies (q + 1/2) / units cells from the origin.
  int units = 1;
  std::vector<glm::u16vec3> position;
  std::vector<glm::u8vec3> front_color, back_color;  ///< sRGB, per vertex
  std::vector<glm::uvec3> triangle;                  ///< counter-clockwise seen from the front
  std::vector<std::uint8_t> hidden;                  ///< per triangle: 1 the front faces air, 2 the back; 0 none
  std::vector<std::uint16_t> front_part, back_part;  ///< per triangle, indices into parts
  std::vector<std::string> parts;
  std::vector<int> spared;  ///< parts that knives go around (generator/cut/spared.h), ascending; indices into parts
  std::vector<std::uint16_t> shell;  ///< per triangle: its shell around a spared part, from 1; 0 = none

  // The paint: texels for shaders/noise.glsl, detail.glsl and material.glsl.
  std::vector<glm::vec4> noise, details, materials;  ///< the materials of the parts, one after another
  std::vector<AssetTile> tiles;                      ///< of examples, as `details` count their texels
  std::vector<glm::u8vec4> skin_share;               ///< per part: weight of each detail of skins, of 255
  std::optional<AssetGuide> guide;
  Color ink{0};          ///< colour of its lines, linear
  double ink_width = 1;  ///< times the style's

  std::size_t node_count() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(count[2]);
  }
};

/// Limits of readers: what a lattice can count, and far more triangles than any template has.
constexpr int max_asset_nodes_along = 512;
constexpr std::size_t max_asset_nodes = 40'000'000;
constexpr std::size_t max_asset_vertices = 4'000'000;
constexpr std::size_t max_asset_triangles = 8'000'000;
constexpr std::size_t max_asset_parts = 64;
constexpr std::uint32_t max_asset_shells = 65535;
constexpr std::size_t max_asset_tiles = 8;
constexpr int max_asset_tile_side = 48;

}  // namespace pomona
