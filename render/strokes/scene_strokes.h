// The strokes of a scene, as an illustrator's pen would draw them [Northrup & Markosian 2000].
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
  Color color{0};                   ///< colour of the ink
  std::vector<StrokePoint> points;  ///< pixels, y down
  std::vector<double> distance;     ///< per point: distance from the eye, metres; a little less than of what it covers
};

struct StrokeOptions {
  int width = 800, height = 600;  ///< width and height of the picture, pixels
  Threads threads{};
};

/// The strokes in the order of drawing: finer lines first, then outlines. The result is the same for any number of
/// threads, on any machine. A style without ink gives none. Widths are those of the style and of each solid's ink;
/// small objects get thinner lines. The tremble of the hand belongs to the fruits, so that strokes move with them when
/// the camera moves.
/// \throws Error (usage) for sizes that are not 1 to max_picture_side.
std::vector<SceneStroke> scene_strokes(const Scene& scene, const Style& style, const StrokeOptions& options);

}  // namespace pomona
