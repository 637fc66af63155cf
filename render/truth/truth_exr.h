// All layers of a picture's ground truth as one OpenEXR file.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/truth/cryptomatte.h"
#include "render/truth/layers.h"
#include "render/truth/mask.h"
#include "render/truth/truth_pictures.h"

namespace pomona {

/// The bytes of an OpenEXR file of one part, 32-bit floats, ZIP: channels Instance.X, Fruit.X, Part.X, Organ.X if
/// any shows, Section.X, Depth.Z (metres), Normal.X .Y .Z, Amodal1.X, ... (numbers as in the PNGs of those names), and
/// Cryptomatte's <name>00.R .G .B .A, ... with its metadata. The same for the same layers.
/// \param amodal per instance.
std::string write_truth_exr(const TruthLayers& layers, std::span<const Mask> amodal,
                            std::span<const Cryptomatte> mattes, const std::string& made_by);

}  // namespace pomona
