// Models of simulators: .xml (MJCF) and .urdf.
#pragma once

#include "render/deliver/deliver_options.h"

namespace pomona {

/// One output of these formats; of a .urdf with its meshes beside it.
Delivered model_files(const Output& output, const Scene& scene, const Order& order, const DeliverOptions& how);

}  // namespace pomona
