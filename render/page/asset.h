// A fruit that can be cut elsewhere, in a browser or an engine: its surfaces and the solved colours between them, in as
// few bytes as eight-bit colours need. docs/reference/asset.md describes the file it becomes.
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

/// How the fruit's surfaces run, at every `stride`-th node of the lattice: what texture detail on cut faces goes by
/// (generator/cut/section/detail_guide.h).
struct AssetGuide {
  int stride = 8;
  double unit = 0;                  ///< metres that a value of 1 stands for
  std::array<int, 3> count{};       ///< nodes along each axis
  std::vector<glm::i16vec4> value;  ///< to_skin and layer, in units

  /// How much each detail of cut faces counts, of 255: for every part in turn, at `depth_steps` depths below the skin
  /// from 0 to `deepest` (metres).
  std::vector<glm::u8vec4> share;
  double deepest = 0;
};
constexpr int depth_steps = 32;

/// One fruit. Metres in the fruit's own frame, +Y along the axis.
struct Asset {
  std::string name, title, latin;
  std::uint64_t seed = 0;
  std::string diffuser;  ///< what coloured the nodes

  // Nodes lie at origin + spacing * (x, y, z), 0 <= x < count.
  glm::dvec3 origin{0};
  double spacing = 0;
  std::array<int, 3> count{};
  std::vector<glm::u8vec3> node_color;  ///< sRGB, node (x, y, z) at (z * count.y + y) * count.x + x; black in air
  std::vector<std::int8_t> winding;     ///< per node: how often the boundary winds around it; 0 in air

  // Surfaces. Vertex q lies (q + 1/2) / units cells from the origin.
  int units = 1;
  std::vector<glm::u16vec3> position;
  std::vector<glm::u8vec3> front_color, back_color;  ///< sRGB, per vertex
  std::vector<glm::uvec3> triangle;                  ///< counter-clockwise seen from the front
  std::vector<std::uint8_t> hidden;                  ///< per triangle: 1 the front faces air, 2 the back; 0 none
  std::vector<std::uint16_t> front_part, back_part;  ///< per triangle, indices into parts
  std::vector<std::string> parts;
  std::vector<int> spared;  ///< parts that knives go around (generator/cut/spared.h), ascending; indices into parts
  std::vector<std::uint16_t> shell;  ///< per triangle: the shell around a spared part that it is of, from 1; 0 of none

  // How it is painted: texels as shaders/noise.glsl, detail.glsl and material.glsl read them.
  std::vector<glm::vec4> noise, details, materials;  ///< materials: one after another, a part each
  std::vector<glm::u8vec4> skin_share;               ///< per part: how much each detail of skins counts, of 255
  std::optional<AssetGuide> guide;
  Color ink{0};          ///< of its lines, linear
  double ink_width = 1;  ///< times the style's

  std::size_t node_count() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(count[2]);
  }
};

/// The most that a reader takes: what a lattice can count, and more triangles than any template has by far.
constexpr int most_asset_nodes_along = 512;
constexpr std::size_t most_asset_nodes = 40'000'000;
constexpr std::size_t most_asset_vertices = 4'000'000;
constexpr std::size_t most_asset_triangles = 8'000'000;
constexpr std::size_t most_asset_parts = 64;
constexpr std::uint32_t most_asset_shells = 65535;

}  // namespace pomona
