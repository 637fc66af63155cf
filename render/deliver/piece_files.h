// The files of a cut fruit's pieces.
#pragma once

#include <span>
#include <vector>

#include "render/deliver/deliver_options.h"

namespace pomona {

/// The outputs of the order that show pieces, and the list of pieces if the order names a file for it. Meshes have the
/// pieces where they grew, or moved apart; pictures have them side by side with their cut faces towards the viewer, or,
/// moved apart, standing on the table.
/// \param pieces where they grew.
Delivered piece_files(SceneViews pieces, const OrderedFruit& fruit, const Order& order, const DeliverOptions& how);

}  // namespace pomona
