// Small pictures of an item's pieces, drawn on the processor: the same bytes on any machine.
#pragma once

#include <span>

#include "render/export/styled_mesh.h"
#include "render/image/image.h"

namespace pomona {

struct ThumbnailOptions {
  int size = 256;         ///< pixels along each edge, 16 to 1024
  bool on_paper = false;  ///< else the ground is transparent except for the shadow
};

/// The scene from its view, lit, with its shadow on the ground y = 0 and with the style's ink along outlines.
/// \param meshes one per solid, as styled_meshes() makes them. Needs 40 bytes for each of the 16 samples of a pixel: 40
/// MB for 256 pixels.
TransparentImage draw_thumbnail(const Scene& scene, std::span<const StyledMesh> meshes, const Style& style,
                                const ThumbnailOptions& options = {});

}  // namespace pomona
