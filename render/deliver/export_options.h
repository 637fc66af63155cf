// Options of exporters and of the baker of textures, from an order.
#pragma once

#include <optional>

#include "render/deliver/deliver_options.h"
#include "render/export/styled_mesh.h"
#include "render/texture/bake.h"

namespace pomona {

/// The options of exporters.
ExportOptions export_options(const Order& order, const DeliverOptions& how);

/// Nothing unless the order wants textures.
std::optional<BakeOptions> bake_options(const Order& order);

}  // namespace pomona
