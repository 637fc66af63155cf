// glTF 2.0 in its binary form (.glb): for Blender, three.js, game engines (docs/reference/formats.md).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/export/styled_mesh.h"
#include "render/export/texture_variant.h"
#include "render/export/transaction/spooled_bytes.h"

namespace pomona {

/// The bytes of a .glb: a mesh per solid, a node per instance, the scene's camera. Metres, +Y up. A piece's origin is
/// its centre of mass. Vertices are interleaved: POSITION, NORMAL (float), COLOR_0 (linear, 16-bit RGBA), _PART
/// (16-bit, index into the mesh's extras.parts). Same scene and options, same bytes.
/// \param levels one entry per solid of the scene, or none: its coarser levels, finer before coarser. They become
/// nodes outside the scene, named "<instance>_LOD1", ..., which the extension MSFT_lod names at the instance's node.
/// \throws Error (bad_data) for a solid with more than 65 536 parts, or a file beyond 4 GB.
std::string write_glb(const Scene& scene, const ExportOptions& options = {},
                      std::span<const std::vector<Solid>> levels = {});

/// The same with existing meshes of the solids. \param styled the result of styled_meshes() for the scene.
std::string write_glb(const Scene& scene, std::span<const StyledMesh> styled, const ExportOptions& options,
                      std::span<const std::vector<Solid>> levels = {});

/// The same with the colours in textures: `baked` has one entry per solid of the scene. TEXCOORD_0 replaces COLOR_0,
/// and every solid has materials of its own, one where its maps tell looks; those on a page share them. \param variants
/// for KHR_materials_variants; viewers without it show `baked`. \throws Error (bug) if a variant has another atlas than
/// its solid.
std::string write_glb(const Scene& scene, std::span<const BakedSolid> baked, const ExportOptions& options = {},
                      std::span<const std::vector<BakedSolid>> levels = {},
                      std::span<const TextureVariant> variants = {});

/// Writes the same bytes from solids that are added one after another and need not stay in memory. Add them in their
/// order, any number at a time, all by the same one of the three functions.
class GlbStream {
 public:
  /// \param spool receives what is added; null = it stays in memory. Must outlive the stream.
  explicit GlbStream(ExportOptions options, SpooledBytes* spool = nullptr);
  ~GlbStream();
  GlbStream(const GlbStream&) = delete;
  GlbStream& operator=(const GlbStream&) = delete;

  /// The arguments are those of write_glb(), with entries only for these solids.
  void add(std::span<const Solid> solids, std::span<const std::vector<Solid>> levels = {});
  void add_styled(std::span<const Solid> solids, std::span<const StyledMesh> styled,
                  std::span<const std::vector<Solid>> levels = {});
  void add_baked(std::span<const Solid> solids, std::span<const BakedSolid> baked,
                 std::span<const std::vector<BakedSolid>> levels = {}, std::span<const TextureVariant> variants = {});

  /// The file; with a spool its first bytes, and the spool has the rest.
  /// \param scene with the solids that were added: of their meshes the triangles are enough.
  std::string finished(const Scene& scene) &&;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace pomona
