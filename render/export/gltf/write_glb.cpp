#include "render/export/gltf/write_glb.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "render/export/collision/collision_shape.h"
#include "render/export/collision/settled_hulls.h"
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

/// The number of meshes styled at once; they are freed when they are in the file.
constexpr std::size_t meshes_at_once = 64;

}  // namespace

/// A file while it is written: first the meshes, solid by solid, then the nodes.
class GlbStream::Writer {
 public:
  Writer(ExportOptions options, SpooledBytes* spool)
      : options_(std::move(options)), document_(spool), materials_(document_) {}

  const ExportOptions& options() const { return options_; }

  /// Starts the scene's next solid, with `levels` levels, for the following calls of add().
  void begin(const Solid& solid, std::size_t levels);

  /// Adds a level, 0 the finest. A mesh without triangles is left out.
  void add(std::size_t level, const Solid& solid, const StyledMesh& mesh, const BakedSolid* baked = nullptr);

  /// Gives the meshes of the following calls of add() these materials, too, from the variants' textures of solid `i`.
  void set_variants(std::size_t i, std::span<const TextureVariant> variants);

  void name_variants(std::span<const TextureVariant> variants);

  /// Completes the file from the scene.
  std::string finished(const Scene& scene);

 private:
  void add_shapes(const Solid& solid, const std::string& mesh_name);
  std::vector<int> hull_meshes(const std::vector<ConvexHull>& parts, const glm::vec3& pivot,
                               const std::string& mesh_name);
  int bare_mesh(int mesh, const std::string& name);
  int copied_mesh(int mesh, const std::string& name);
  std::vector<OwnMeshes> settled_shapes(const Scene& scene);

  ExportOptions options_;
  GltfDocument document_;
  PieceMaterials materials_;
  std::vector<SolidMeshes> solids_;
  std::string name_;  ///< name of the current solid
  std::size_t levels_ = 0;
  std::vector<int> variant_textures_;

  // Of each solid: what it collides with, and the name of its mesh if hulls are to be added when all poses are known.
  std::vector<std::vector<ConvexHull>> parts_;
  std::vector<std::string> waiting_;
};

void GlbStream::Writer::begin(const Solid& solid, std::size_t levels) {
  solids_.push_back({.meshes = {}, .scales = {}, .hulls = {}, .pivot = pivot_of(solid)});
  parts_.emplace_back();
  waiting_.emplace_back();
  name_ = engine_name(options_.engine, solid.name);
  levels_ = levels;
  // Of the solid itself: its triangles on an atlas stand in another order, and are divided otherwise.
  if (!hull_name(options_.engine, name_, 0, 1).empty() && !solid.mesh.triangle.empty())
    parts_.back() = collision_parts(solid, options_.hulls);
}

void GlbStream::Writer::add(std::size_t level, const Solid& solid, const StyledMesh& mesh, const BakedSolid* baked) {
  if (mesh.triangle.empty()) return;
  SolidMeshes& made = solids_.back();
  PieceMeshOptions how{.name = level_name(options_.engine, name_, level, levels_), .pivot = made.pivot};
  if (baked != nullptr)
    how.textures = materials_.add_textures(*baked);
  else if (options_.atlas != AtlasOf::none)
    how.textures = PieceTextures{.are_shared = options_.atlas == AtlasOf::file, .is_palette = true};
  how.variant_textures = variant_textures_;
  made.meshes.push_back(add_piece_mesh(document_, materials_, solid, mesh, how, options_));
  if (options_.compress == Compression::meshopt) made.scales.push_back(coded_step(mesh, made.pivot));
  if (level > 0) return;
  for (const glm::vec3& p : mesh.position)
    made.reach = std::max(made.reach, static_cast<double>(glm::length(p - made.pivot)));
  add_shapes(solid, how.name);
}

void GlbStream::Writer::set_variants(std::size_t i, std::span<const TextureVariant> variants) {
  variant_textures_.clear();
  for (const TextureVariant& variant : variants) {
    const BakedSolid& solid = variant.solids.at(i);
    variant_textures_.push_back(materials_.add_textures(solid, " " + variant.name).color.value());
  }
}

void GlbStream::Writer::name_variants(std::span<const TextureVariant> variants) {
  if (variants.empty()) return;
  Json names = Json::array();
  for (const TextureVariant& variant : variants) names.push_back({{"name", variant.name}});
  document_.extend("KHR_materials_variants", {{"variants", std::move(names)}});
}

/// What the current solid collides with, where the engine's importer takes it from the file. Pieces of a scene wait:
/// neighbours may leave less room.
void GlbStream::Writer::add_shapes(const Solid& solid, const std::string& mesh_name) {
  SolidMeshes& made = solids_.back();
  if (hull_name(options_.engine, mesh_name, 0, 1).empty()) return;
  const bool by_triangles = !is_fruit(solid) && !triangles_name(options_.engine, mesh_name).empty();
  if (by_triangles)
    made.triangles = bare_mesh(made.meshes.front(), triangles_name(options_.engine, mesh_name));
  else
    waiting_.back() = mesh_name;
  if (waiting_.back().empty() || !solid.origin.entry.empty()) return;
  made.hulls = hull_meshes(parts_.back(), made.pivot, mesh_name);
  waiting_.back().clear();
}

std::vector<int> GlbStream::Writer::hull_meshes(const std::vector<ConvexHull>& parts, const glm::vec3& pivot,
                                                const std::string& mesh_name) {
  std::vector<int> meshes;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::vector<glm::vec3> position = parts[part].position;
    for (glm::vec3& p : position) p -= pivot;
    Json primitive = {{"attributes", {{"POSITION", add_positions(document_, position)}}}};
    primitive["indices"] = add_triangles(document_, parts[part].triangle, position.size());
    meshes.push_back(document_.add("meshes", {{"name", hull_name(options_.engine, mesh_name, part, parts.size())},
                                              {"primitives", Json::array({std::move(primitive)})}}));
  }
  return meshes;
}

/// A mesh of the same triangles, which take no more bytes, without what is only seen. Godot gives each node of a mesh
/// that it has collided with a body: if the dish had the same mesh, it would stand there twice.
int GlbStream::Writer::bare_mesh(int mesh, const std::string& name) {
  Json primitives = Json::array();
  for (const Json& seen : document_.at("meshes", mesh)["primitives"])
    primitives.push_back(
        {{"attributes", {{"POSITION", seen["attributes"]["POSITION"]}}}, {"indices", seen["indices"]}});
  return document_.add("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
}

int GlbStream::Writer::copied_mesh(int mesh, const std::string& name) {
  Json copy = document_.at("meshes", mesh);
  copy["name"] = name;
  return document_.add("meshes", std::move(copy));
}

/// What instances have of their own where neighbours leave less room; others have the shapes of their solid, which are
/// added now. Godot's shapes belong to a node. Unreal's belong to a mesh: there each shape of a solid has a mesh of its
/// own, of the same arrays, and of the name of the first piece that has it. The first of all has the solid's.
std::vector<OwnMeshes> GlbStream::Writer::settled_shapes(const Scene& scene) {
  const bool of_mesh = options_.engine == Engine::unreal;
  const std::vector<std::vector<ConvexHull>> hulls = settled_hulls(scene, parts_, options_.threads);
  std::vector<OwnMeshes> own(scene.instances.size());
  std::vector<char> is_taken(solids_.size(), 0);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const auto number = static_cast<std::size_t>(scene.instances[i].solid);
    SolidMeshes& solid = solids_[number];
    const bool is_own = !hulls[i].empty();
    const std::vector<ConvexHull>& shape = is_own ? hulls[i] : parts_[number];
    if (waiting_[number].empty() || shape.empty() || (!is_own && !solid.hulls.empty())) continue;

    const std::string node = engine_name(options_.engine, scene.instances[i].name);
    OwnMeshes made;
    std::string name = is_own ? node : waiting_[number];
    if (of_mesh) {
      const bool is_first = std::exchange(is_taken[number], 1) == 0;
      name = is_first ? waiting_[number] : level_name(options_.engine, node, 0, solid.meshes.size());
      made.mesh = is_first ? solid.meshes.front() : copied_mesh(solid.meshes.front(), name);
    }
    made.hulls = hull_meshes(shape, solid.pivot, name);
    if (is_own) {
      own[i] = std::move(made);
      continue;
    }
    solid.hulls = std::move(made.hulls);
    if (of_mesh) solid.meshes.front() = made.mesh;
  }
  return own;
}

std::string GlbStream::Writer::finished(const Scene& scene) {
  if (scene.solids.size() != solids_.size()) throw Error(ExitStatus::bug, "a .glb lacks some of the scene's solids");
  materials_.finish();
  add_nodes(document_, scene, solids_, settled_shapes(scene), options_);
  if (!options_.provenance.empty()) document_.scene()["extras"] = {{"provenance", options_.provenance}};
  return std::move(document_).bytes();
}

namespace {

std::size_t level_count(std::size_t i, const auto& levels) { return 1 + (i < levels.size() ? levels[i].size() : 0); }

}  // namespace

GlbStream::GlbStream(ExportOptions options, SpooledBytes* spool)
    : writer_(std::make_unique<Writer>(std::move(options), spool)) {}

GlbStream::~GlbStream() = default;

void GlbStream::add(std::span<const Solid> solids, std::span<const std::vector<Solid>> levels) {
  for (std::size_t first = 0; first < solids.size(); first += meshes_at_once) {
    const std::size_t count = std::min(meshes_at_once, solids.size() - first);
    const std::span<const Solid> some = solids.subspan(first, count);
    add_styled(some, styled_meshes(some, writer_->options()), levels.subspan(std::min(first, levels.size())));
  }
}

void GlbStream::add_styled(std::span<const Solid> solids, std::span<const StyledMesh> styled,
                           std::span<const std::vector<Solid>> levels) {
  for (std::size_t i = 0; i < solids.size(); ++i) {
    writer_->begin(solids[i], level_count(i, levels));
    writer_->add(0, solids[i], styled[i]);
    if (i >= levels.size()) continue;
    const std::vector<StyledMesh> coarser = styled_meshes(levels[i], writer_->options());
    for (std::size_t level = 0; level < coarser.size(); ++level)
      writer_->add(level + 1, levels[i][level], coarser[level]);
  }
}

void GlbStream::add_baked(std::span<const Solid> solids, std::span<const BakedSolid> baked,
                          std::span<const std::vector<BakedSolid>> levels, std::span<const TextureVariant> variants) {
  writer_->name_variants(variants);
  for (std::size_t i = 0; i < baked.size(); ++i) {
    for (const TextureVariant& variant : variants) {
      if (variant.solids.at(i).uv != baked[i].uv) throw Error(ExitStatus::bug, "a variant has an atlas of its own");
    }
    writer_->begin(solids[i], level_count(i, levels));
    if (!baked[i].solid.mesh.triangle.empty()) writer_->set_variants(i, variants);
    writer_->add(0, baked[i].solid, textured_mesh(baked[i]), &baked[i]);
    if (i >= levels.size()) continue;
    for (std::size_t level = 0; level < levels[i].size(); ++level) {
      const BakedSolid& coarser = levels[i][level];
      writer_->add(level + 1, coarser.solid, textured_mesh(coarser), &coarser);
    }
  }
}

std::string GlbStream::finished(const Scene& scene) && { return writer_->finished(scene); }

std::string write_glb(const Scene& scene, const ExportOptions& options, std::span<const std::vector<Solid>> levels) {
  GlbStream stream(options);
  stream.add(scene.solids, levels);
  return std::move(stream).finished(scene);
}

std::string write_glb(const Scene& scene, std::span<const StyledMesh> styled, const ExportOptions& options,
                      std::span<const std::vector<Solid>> levels) {
  GlbStream stream(options);
  stream.add_styled(scene.solids, styled, levels);
  return std::move(stream).finished(scene);
}

std::string write_glb(const Scene& scene, std::span<const BakedSolid> baked, const ExportOptions& options,
                      std::span<const std::vector<BakedSolid>> levels, std::span<const TextureVariant> variants) {
  GlbStream stream(options);
  stream.add_baked(scene.solids, baked, levels, variants);
  return std::move(stream).finished(scene);
}

}  // namespace pomona
