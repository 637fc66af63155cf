// The diffuser that an order names.
#pragma once

#include <memory>

#include "generator/diffusion/diffuser.h"
#include "generator/order/order.h"
#include "render/deliver/delivered.h"

namespace pomona {

/// \param progress for walks only, because they take long.
/// \throws Error (helper_missing) if OpenGL is needed and does not work.
std::unique_ptr<Diffuser> ordered_diffuser(const Order& order, const DeliveryProgress& progress = {});

}  // namespace pomona
