// A scene's ink: the strokes that an illustrator's pen would draw of it [Northrup & Markosian 2000].
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/scene.h"
#include "render/picture/stroke.h"
#include "render/strokes/solid_edges.h"
#include "render/style/style.h"

namespace pomona {

struct SceneStroke {
  std::uint32_t instance = 0;  ///< index into the scene's
  LineKind kind = LineKind::contour;
  bool closed = false;
  Color color{0};                   ///< of the ink
  std::vector<StrokePoint> points;  ///< pixels, y down
  std::vector<double> distance;     ///< per point: metres from the eye, a little nearer than all the stroke covers
};

struct StrokeOptions {
  int width = 800, height = 600;  ///< of the picture, pixels
  Threads threads{};
};

/// From back to front as they were found: finer lines first, then outlines. The same for any number of threads, on any
/// machine; a style without ink has none. Widths are those of the style and of each solid's ink; small things get finer
/// lines. The hand's tremble is tied to the fruits, so that strokes go with them when the camera moves.
/// \throws Error (usage) for sizes that are not 1 to max_picture_side.
std::vector<SceneStroke> scene_strokes(const Scene& scene, const Style& style, const StrokeOptions& options);

}  // namespace pomona
