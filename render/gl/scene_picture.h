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
  int max_layers = 48;  ///< number of ordered transparent layers; all behind them count as one more
  Threads threads{};    ///< threads for the strokes; OpenGL has its own
};

/// The picture of the scene from its view. It is the same every time on one machine and driver; others may differ by a
/// few units of 255.
/// \throws Error (usage) for invalid sizes or samples; (helper_missing) if OpenGL lacks something.
Image draw_scene(GlContext& context, const Scene& scene, const Style& style, const PictureOptions& options = {});

/// The same, on a thread that has its context already (gl_thread.h).
Image draw_scene(const CurrentGl& gl, const Scene& scene, const Style& style, const PictureOptions& options = {});

/// The same, with the first context that works.
Image draw_scene(const Scene& scene, const Style& style, const PictureOptions& options = {});

}  // namespace pomona
