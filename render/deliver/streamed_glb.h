// A scene's .glb that is written while the scene is still being made.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/scene/scene.h"
#include "render/deliver/delivered.h"
#include "render/deliver/scene_levels.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/output.h"
#include "render/texture/bake.h"

namespace pomona {

struct StreamedGlbOptions {
  ExportOptions exported{};
  int lod = 0;                        ///< number of further levels of detail
  std::optional<BakeOptions> bake{};  ///< none: colours at vertices
};

/// Takes solids one after another and keeps none: their bytes wait on the disk. The result has the bytes that
/// write_glb() makes of the whole scene.
class StreamedGlb {
 public:
  /// \throws Error (cannot_create)
  StreamedGlb(std::filesystem::path file, StreamedGlbOptions options);

  const std::filesystem::path& file() const { return file_; }

  /// The scene's next solids.
  void take(std::span<const Solid> solids);

  /// Call it once, after the last solid: the file, with times and counts.
  /// \param scene with the triangles of their meshes.
  Delivered finished(const Scene& scene);

 private:
  std::filesystem::path file_;
  StreamedGlbOptions options_;
  std::shared_ptr<SpooledBytes> spool_;
  GlbStream stream_;
  Delivered delivered_;  // times and counts so far
  LevelCounts levels_;
};

}  // namespace pomona
