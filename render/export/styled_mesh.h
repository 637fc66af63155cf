// The mesh that every exporter writes: a solid's triangles with the style's colours.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/order/export_choices.h"
#include "generator/scene/scene.h"
#include "render/style/style.h"
#include "render/texture/bake.h"

namespace pomona {

struct ExportOptions {
  Style style = {};                ///< noise and paint of the colours; in POV-Ray light, shadow and gloss, too
  std::string provenance = {};     ///< the command ("pomona scene scenes/salad.toml --seed 3"); no paths, no time
  std::string command_words = {};  ///< options of colouring for the command that makes a piece again: " --style plain"
  Threads threads = {};

  // Options of glTF and USD.
  bool instances = false;                    ///< repeated pieces are one node, or prim, with many poses
  bool feature_ids = false;                  ///< glTF: parts as EXT_mesh_features, too
  Engine engine = Engine::any;               ///< glTF: names for this importer, and shapes to collide with
  Compression compress = Compression::none;  ///< glTF: how its arrays are coded
  UpAxis up = UpAxis::y;                     ///< USD: the axis that points up
  int hulls = 1;                             ///< convex parts, at most, that a piece collides with
  bool welded = false;                       ///< USD, MJCF: pieces of one cut are joined where they touch
  AtlasOf atlas = AtlasOf::none;             ///< what shares a material, where vertices have the colours
};

/// One solid, welded: no two vertices have all attributes equal, each vertex is used, and no triangle has two corners
/// at the same position.
struct StyledMesh {
  std::vector<glm::vec3> position;  ///< metres, the fruit's own frame
  std::vector<glm::vec3> normal;    ///< unit length
  std::vector<Color> color;         ///< linear, 0..1, with the style's paint, and noise where the mesh is fine enough
  std::vector<std::int32_t> part;   ///< index into Solid::part_names
  std::vector<DetailGuide> guide;   ///< as in Solid
  std::vector<DetailFace> face;     ///< the kind of face on which the vertex lies
  std::vector<glm::vec2> uv;        ///< into a baked texture, (0, 0) its upper left corner; else empty
  std::vector<glm::vec4> tangent;   ///< tangents for a normal map; else empty
  std::vector<glm::vec2> look_place = {};  ///< into a palette of looks (look_palette.h), beside colours; else empty

  std::vector<glm::uvec3> triangle;    ///< counter-clockwise seen from the air
  std::vector<std::int32_t> cut_face;  ///< per triangle, as in Solid
};

/// One mesh per solid, in their order.
std::vector<StyledMesh> styled_meshes(std::span<const Solid> solids, const ExportOptions& options);

/// One mesh per solid of the scene.
std::vector<StyledMesh> styled_meshes(const Scene& scene, const ExportOptions& options);

/// A baked solid: the texture has the colours and their noise; `color` is left as it was.
StyledMesh textured_mesh(const BakedSolid& baked);

}  // namespace pomona
