// The diffuser that an order names.
#pragma once

#include <memory>

#include "generator/diffusion/diffuser.h"
#include "generator/order/order.h"
#include "render/deliver/delivered.h"

namespace pomona {

/// \param progress of walks, which alone take long enough to show how far they are.
/// \throws Error (helper_missing) where OpenGL is wanted and not to be had.
std::unique_ptr<Diffuser> ordered_diffuser(const Order& order, const DeliveryProgress& progress = {});

}  // namespace pomona
