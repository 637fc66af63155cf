// Pictures of scenes by OpenGL: lit, shadowed, inked, on paper (paper, sections 5 and 6).
#pragma once

#include "generator/scene/scene.h"
#include "render/gl/context.h"
#include "render/image/image.h"
#include "render/style/style.h"

namespace pomona {

struct PictureOptions {
  int width = 800;
  int height = 600;
  int samples = 4;      ///< per pixel: 1, 4, 9 or 16
  int max_layers = 48;  ///< of see-through surfaces in their order; what lies behind counts as one more layer
  Threads threads{};    ///< of the strokes; OpenGL takes its own
};

/// The scene as its view sees it. The same picture every time on one machine and driver; others may differ by a
/// few units of 255.
/// \throws Error (usage) for sizes or samples that cannot be; (helper_missing) where OpenGL lacks something.
Image draw_scene(GlContext& context, const Scene& scene, const Style& style, const PictureOptions& options = {});

/// The same, with the first context that can be had.
Image draw_scene(const Scene& scene, const Style& style, const PictureOptions& options = {});

}  // namespace pomona
