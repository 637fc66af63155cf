#include "render/export/gltf/write_glb.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "generator/base/error.h"
#include "render/export/convex_hull.h"
#include "render/export/gltf/engine_names.h"
#include "render/export/gltf/gltf_document.h"
#include "render/export/gltf/piece_materials.h"
#include "render/export/gltf/piece_mesh.h"
#include "render/export/gltf/scene_nodes.h"
#include "render/export/gltf/vertex_buffers.h"
#include "render/export/piece_words.h"

namespace pomona {

using namespace gltf;

namespace {

/// So many meshes are styled at once, and forgotten when they are in the file.
constexpr std::size_t meshes_at_once = 64;

/// A file under way: meshes first, solid by solid, then the nodes.
class GlbWriter {
 public:
  GlbWriter(const Scene& scene, const ExportOptions& options)
      : scene_(scene), options_(options), materials_(document_), solids_(scene.solids.size()) {
    for (std::size_t i = 0; i < solids_.size(); ++i) solids_[i].pivot = pivot_of(scene.solids[i]);
  }

  /// A level, 0 the finest, of `count` of the scene's solid `i`. What has no triangles is left out.
  void add(std::size_t i, std::size_t level, std::size_t count, const Solid& solid, const StyledMesh& mesh,
           const BakedSolid* baked = nullptr);

  /// What add() adds from now on has these materials, too: by the variants' textures of solid `i`.
  void set_variants(std::size_t i, std::span<const TextureVariant> variants);

  void name_variants(std::span<const TextureVariant> variants);

  /// With what the scene says of all of them.
  std::string finished();

 private:
  std::optional<int> hull_of(const Solid& solid, const std::string& mesh_name, const glm::vec3& pivot);

  const Scene& scene_;
  const ExportOptions& options_;
  GltfDocument document_;
  PieceMaterials materials_;
  std::vector<SolidMeshes> solids_;
  std::vector<int> variant_textures_;
};

void GlbWriter::add(std::size_t i, std::size_t level, std::size_t count, const Solid& solid, const StyledMesh& mesh,
                    const BakedSolid* baked) {
  if (mesh.triangle.empty()) return;
  SolidMeshes& made = solids_[i];
  const std::string own_name = engine_name(options_.engine, scene_.solids[i].name);
  PieceMeshOptions how{.name = level_name(options_.engine, own_name, level, count), .pivot = made.pivot};
  if (baked != nullptr) how.textures = materials_.add_textures(*baked);
  how.variant_textures = variant_textures_;
  made.meshes.push_back(add_piece_mesh(document_, materials_, solid, mesh, how, options_));
  if (level == 0) made.hull = hull_of(solid, how.name, made.pivot);
}

void GlbWriter::set_variants(std::size_t i, std::span<const TextureVariant> variants) {
  variant_textures_.clear();
  for (const TextureVariant& variant : variants) {
    const BakedSolid& solid = variant.solids.at(i);
    variant_textures_.push_back(materials_.add_texture(solid.solid.name + " " + variant.name, solid.texture));
  }
}

void GlbWriter::name_variants(std::span<const TextureVariant> variants) {
  if (variants.empty()) return;
  Json names = Json::array();
  for (const TextureVariant& variant : variants) names.push_back({{"name", variant.name}});
  document_.extend("KHR_materials_variants", {{"variants", std::move(names)}});
}

std::optional<int> GlbWriter::hull_of(const Solid& solid, const std::string& mesh_name, const glm::vec3& pivot) {
  const std::string name = hull_name(options_.engine, mesh_name);
  if (name.empty()) return {};
  ConvexHull hull = convex_hull(solid.position);
  if (hull.triangle.empty()) return {};
  for (glm::vec3& p : hull.position) p -= pivot;
  Json primitive = {{"attributes", {{"POSITION", add_positions(document_, hull.position)}}}};
  primitive["indices"] = add_triangles(document_, hull.triangle, hull.position.size());
  return document_.add("meshes", {{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
}

std::string GlbWriter::finished() {
  add_nodes(document_, scene_, solids_, options_);
  if (!options_.provenance.empty()) document_.scene()["extras"] = {{"provenance", options_.provenance}};
  return document_.bytes();
}

void add_levels(GlbWriter& writer, std::size_t i, std::span<const std::vector<Solid>> levels,
                const ExportOptions& options) {
  if (i >= levels.size()) return;
  const std::vector<StyledMesh> coarser = styled_meshes(levels[i], options);
  for (std::size_t level = 0; level < coarser.size(); ++level)
    writer.add(i, level + 1, coarser.size() + 1, levels[i][level], coarser[level]);
}

std::size_t level_count(std::size_t i, const auto& levels) { return 1 + (i < levels.size() ? levels[i].size() : 0); }

}  // namespace

std::string write_glb(const Scene& scene, const ExportOptions& options, std::span<const std::vector<Solid>> levels) {
  GlbWriter writer(scene, options);
  const std::span<const Solid> solids = scene.solids;
  for (std::size_t first = 0; first < solids.size(); first += meshes_at_once) {
    const std::size_t count = std::min(meshes_at_once, solids.size() - first);
    const std::vector<StyledMesh> styled = styled_meshes(solids.subspan(first, count), options);
    for (std::size_t i = first; i < first + count; ++i) {
      writer.add(i, 0, level_count(i, levels), solids[i], styled[i - first]);
      add_levels(writer, i, levels, options);
    }
  }
  return writer.finished();
}

std::string write_glb(const Scene& scene, std::span<const StyledMesh> styled, const ExportOptions& options,
                      std::span<const std::vector<Solid>> levels) {
  GlbWriter writer(scene, options);
  for (std::size_t i = 0; i < styled.size(); ++i) {
    writer.add(i, 0, level_count(i, levels), scene.solids[i], styled[i]);
    add_levels(writer, i, levels, options);
  }
  return writer.finished();
}

std::string write_glb(const Scene& scene, std::span<const BakedSolid> baked, const ExportOptions& options,
                      std::span<const std::vector<BakedSolid>> levels, std::span<const TextureVariant> variants) {
  GlbWriter writer(scene, options);
  writer.name_variants(variants);
  for (std::size_t i = 0; i < baked.size(); ++i) {
    for (const TextureVariant& variant : variants) {
      if (variant.solids.at(i).uv != baked[i].uv) throw Error(ExitStatus::bug, "a variant has an atlas of its own");
    }
    if (!baked[i].solid.triangle.empty()) writer.set_variants(i, variants);
    writer.add(i, 0, level_count(i, levels), baked[i].solid, textured_mesh(baked[i]), &baked[i]);
    if (i >= levels.size()) continue;
    for (std::size_t level = 0; level < levels[i].size(); ++level) {
      const BakedSolid& coarser = levels[i][level];
      writer.add(i, level + 1, levels[i].size() + 1, coarser.solid, textured_mesh(coarser), &coarser);
    }
  }
  return writer.finished();
}

}  // namespace pomona
