// Pictures of a scene with their ground truth, its ink as strokes, and POV-Ray files.
#pragma once

#include "render/deliver/deliver_options.h"

namespace pomona {

/// A .png by OpenGL, and its ground truth if the order names a folder for it.
Delivered png_files(const Output& output, const SceneViews& scene, const Order& order, const DeliverOptions& how);

/// The ink as strokes, and the marks of hatching and stipple. Warns of a style without ink.
Delivered svg_file(const Output& output, const SceneViews& scene, const Order& order, const DeliverOptions& how);

/// A .pov and the file of meshes that it includes.
Delivered pov_files(const Output& output, const Scene& scene, const Order& order, const DeliverOptions& how);

}  // namespace pomona
