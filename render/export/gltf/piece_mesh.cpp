#include "render/export/gltf/piece_mesh.h"

#include <utility>

#include "generator/base/error.h"
#include "generator/piece/facts_json.h"
#include "render/export/gltf/vertex_buffers.h"
#include "render/export/piece_words.h"

namespace pomona::gltf {

namespace {

/// Physical data for games and simulations, and the origin of the piece.
Json extras_of(const Solid& solid, const ExportOptions& options) {
  const PieceOrigin& origin = solid.origin;
  Json extras;
  extras["parts"] = solid.look->part_names;  // names of the vertices' part numbers
  extras.update(facts_json(solid));
  if (origin.number == 0) return extras;

  extras["template"] = origin.source;
  extras["seed"] = origin.key.seed;
  extras["index"] = origin.key.index;
  extras["knife"] = knives_text(origin);
  extras["piece"] = origin.number;
  const std::string command = command_for(solid, options, ".glb");
  if (!command.empty()) extras["command"] = command;
  return extras;
}

/// The parts of vertices again, from the same array, as EXT_mesh_features for Cesium and others.
void add_feature_ids(GltfDocument& document, Json& primitive, std::size_t parts) {
  primitive["attributes"]["_FEATURE_ID_0"] = primitive["attributes"]["_PART"];
  primitive["extensions"]["EXT_mesh_features"] = {
      {"featureIds", Json::array({{{"featureCount", parts}, {"label", "part"}, {"attribute", 0}}})}};
  document.use_extension("EXT_mesh_features");
}

/// A map of light has the share that comes through.
std::vector<MaterialGroup> without_what_maps_tell(std::vector<MaterialGroup> groups) {
  for (MaterialGroup& group : groups) group.look.transmission = 0, group.look.transmission_color = {1, 1, 1};
  return groups;
}

/// The triangles of each material, with what stands in the material itself.
std::vector<MaterialGroup> groups_of(const Solid& solid, const StyledMesh& styled,
                                     const std::optional<PieceTextures>& textures) {
  const bool has_colors = !textures || textures->is_palette;
  std::vector<MaterialGroup> groups =
      groups_by_material(solid, styled, has_colors ? LightInside::left_out : LightInside::told);
  if (textures && textures->tell_looks) groups = groups_in_maps(groups);
  if (textures && textures->are_shared && !textures->is_palette) {
    // What is that of one piece alone would give it a material of its own.
    for (MaterialGroup& group : groups) group.look.inside = {};
    if (textures->tell_looks) groups = without_what_maps_tell(std::move(groups));
  }
  return groups;
}

/// Adds each variant with its material.
void add_variants(Json& primitive, PieceMaterials& materials, const Solid& solid, const MaterialGroup& group,
                  const PieceMeshOptions& mesh) {
  Json mappings = Json::array();
  for (std::size_t i = 0; i < mesh.variant_textures.size(); ++i) {
    // Variants keep the surface's other maps.
    PieceTextures textures = mesh.textures.value_or(PieceTextures{});
    textures.color = mesh.variant_textures[i];
    Json mapping = {{"material", materials.material(solid, group, textures)}};
    mapping["variants"] = {i};
    mappings.push_back(std::move(mapping));
  }
  if (!mappings.empty()) primitive["extensions"]["KHR_materials_variants"] = {{"mappings", std::move(mappings)}};
}

}  // namespace

int add_piece_mesh(GltfDocument& document, PieceMaterials& materials, const Solid& solid, const StyledMesh& styled,
                   const PieceMeshOptions& mesh, const ExportOptions& options) {
  if (solid.look->part_names.size() > 65536)
    throw Error(ExitStatus::bad_data, solid.name + ": too many parts for glTF");
  const bool is_coded = options.compress == Compression::meshopt;
  std::vector<MaterialGroup> groups = groups_of(solid, styled, mesh.textures);
  MeshOnPalette placed;
  const StyledMesh* written = &styled;
  if (mesh.textures && mesh.textures->is_palette) {
    placed = on_palette(styled, std::move(groups), materials.palette());
    groups = without_what_maps_tell(std::move(placed.groups));
    written = &placed.mesh;
  }
  const Json attributes =
      is_coded ? add_coded_vertices(document, *written, mesh.pivot) : add_vertices(document, *written, mesh.pivot);
  Json primitives = Json::array();
  for (const MaterialGroup& group : groups) {
    Json primitive = {{"attributes", attributes}};
    primitive["indices"] = is_coded ? add_coded_triangles(document, group.triangle, written->position.size())
                                    : add_triangles(document, group.triangle, written->position.size());
    primitive["material"] = materials.material(solid, group, mesh.textures);
    add_variants(primitive, materials, solid, group, mesh);
    if (options.feature_ids) add_feature_ids(document, primitive, solid.look->part_names.size());
    primitives.push_back(std::move(primitive));
  }
  return document.add("meshes",
                      {{"name", mesh.name}, {"primitives", primitives}, {"extras", extras_of(solid, options)}});
}

}  // namespace pomona::gltf
