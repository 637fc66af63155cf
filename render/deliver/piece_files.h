// The files of a cut fruit's pieces.
#pragma once

#include <span>
#include <vector>

#include "render/deliver/deliver_options.h"

namespace pomona {

/// \param pieces where they grew. The outputs of the order that show pieces, and the list of pieces where the order
/// names a file for it. Meshes have the pieces where they grew, or apart as ordered; pictures have them side by side
/// with their cut faces towards the viewer, or, moved apart, standing on the table.
Delivered piece_files(SceneViews pieces, const OrderedFruit& fruit, const Order& order, const DeliverOptions& how);

}  // namespace pomona
