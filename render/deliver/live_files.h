// Fruit that is cut after it has left the program: pages (.html), assets (.pomona), and .glb that carry their asset.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/order/ordered_fruit.h"
#include "render/deliver/deliver_options.h"

namespace pomona {

/// The order's pages and assets; a page opens with the planes of the order's knives. The colours of the grid are those
/// of true diffusion unless the order names another diffuser.
/// \param family further fruits behind the first are shown side by side on a page; then the grids of all are drafts.
/// \throws Error (usage) for knives without planes, or too many; (bad_data) as make_asset().
Delivered live_files(std::span<const OrderedFruit> family, const Order& order, const DeliverOptions& how);

/// A .glb of the whole fruit that carries its asset (render/page/cuttable_glb.h).
/// \throws Error as make_asset()
Delivered cuttable_file(const Output& output, const Scene& scene, const OrderedFruit& fruit, const Order& order,
                        const DeliverOptions& how);

/// The bytes of a .pomona, as live_files() writes them where no diffuser is named. With `fast` they hold the same in
/// more bytes, for callers that use them at once and keep nothing.
std::string asset_bytes(const OrderedFruit& fruit, const Order& order, bool fast = false);

/// Checks the knives as live_files() does.
/// \throws Error (usage)
void check_live_knives(std::span<const Knife> knives);

}  // namespace pomona
