// The end of the road: a scene becomes the bytes of all files that an order names. Command line, batches, studio and
// library write by it.
#pragma once

#include <memory>
#include <vector>

#include "render/deliver/deliver_options.h"

namespace pomona {

/// The bytes of every output that shows a scene: meshes, drawings, pictures with their ground truth, layouts. It skips
/// outputs of other things, which live_files.h, section_files.h and scene_page_files.h make.
/// \throws Error (usage) if something cannot be written as ordered.
Delivered files(const SceneViews& scene, const Order& order, const DeliverOptions& how);

/// The same in the style that the order names; it must be one of the program's own.
Delivered files(const Scene& scene, const Order& order, const Provenance& provenance = {});

/// The surfaces of a grown fruit, as .ply: as swept, or with MeshOrder::sheets everything that the diffuser sees.
Delivered surface_files(const OrderedFruit& fruit, const Order& order);

/// A stream for each .glb of the order, unless another output needs the whole scene at once.
std::vector<std::unique_ptr<StreamedGlb>> streams_of(const Order& order, const DeliverOptions& how);

/// Width over height of the order's pictures.
double picture_aspect(const Order& order, const DeliverOptions& how);

}  // namespace pomona
