// The files of a bare section: .ply, .png, .svg.
#pragma once

#include "generator/piece/slice.h"
#include "render/deliver/deliver_options.h"

namespace pomona {

/// The .ply keeps the diffused colours; pictures show the colours of pieces.
/// \param fruit the variant that was cut.
Delivered section_files(const Slices& slices, const Template& fruit, const Order& order, const DeliverOptions& how);

}  // namespace pomona
