// Layers as pictures of numbers.
#pragma once

#include <string>
#include <vector>

#include "render/image/deep_image.h"
#include "render/truth/layers.h"
#include "render/truth/mask.h"

namespace pomona {

struct TruthPicture {
  std::string name;  ///< of its file, without ending: "depth"
  DeepImage image;
};

/// Metres that one step of a depth picture stands for: 1, 2 or 5 times a power of ten, as small as takes the greatest
/// depth in 65 535 steps; 1 where there is none.
double depth_step(const TruthLayers& layers);

/// "instance", "fruit", "part": numbers. "depth": steps of depth_step(), rounded, at least 1 where something is.
/// "normal": (n + 1) / 2 * 65 535, rounded; 0 where nothing is. "section": 65 535 on cut faces.
std::vector<TruthPicture> pictures_of(const TruthLayers& layers);

/// "amodal_1" has instances 1 to 16, "amodal_2" 17 to 32, ...: a bit for each, the lowest for the first.
std::vector<TruthPicture> pictures_of(const std::vector<Mask>& amodal, int width, int height);

}  // namespace pomona
