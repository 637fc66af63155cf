// What shows a scene flat: pictures with their ground truth, ink as strokes, POV-Ray's description.
#pragma once

#include "render/deliver/deliver_options.h"

namespace pomona {

/// A .png by OpenGL, and where the order names a folder for it what each pixel shows.
Delivered png_files(const Output& output, const SceneViews& scene, const Order& order, const DeliverOptions& how);

/// The ink as strokes, and the marks of hatching and stipple. Warns of a style without ink.
Delivered svg_file(const Output& output, const SceneViews& scene, const Order& order, const DeliverOptions& how);

/// A .pov and the file of meshes that it includes.
Delivered pov_files(const Output& output, const Scene& scene, const Order& order, const DeliverOptions& how);

}  // namespace pomona
