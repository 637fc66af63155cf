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
  int lod = 0;                        ///< levels of detail besides the solids
  std::optional<BakeOptions> bake{};  ///< none: colours at vertices
};

/// Takes solids as they come, and holds none: what has become of them waits on the disk. The bytes are those that
/// write_glb() makes of the whole scene.
class StreamedGlb {
 public:
  /// \throws Error (cannot_create)
  StreamedGlb(std::filesystem::path file, StreamedGlbOptions options);

  const std::filesystem::path& file() const { return file_; }

  /// The scene's next solids.
  void take(std::span<const Solid> solids);

  /// Once, when all have been taken: the file, with what was measured and counted.
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
