// Layers as pictures of numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/image/deep_image.h"
#include "render/truth/layers.h"
#include "render/truth/mask.h"

namespace pomona {

struct TruthPicture {
  std::string name;  ///< name of its file, without ending: "depth"
  DeepImage image;
};

/// Metres per step of a depth picture: 1, 2 or 5 times a power of ten, the smallest with which the greatest depth has
/// at most 65 535 steps; 1 without any depth.
double depth_step(const TruthLayers& layers);

/// Whether a pixel shows an organ (Organ). Without any, files have no layer of them.
bool shows_organs(const TruthLayers& layers);

/// "instance", "fruit", "part": numbers; "organ" likewise, if it shows any. "depth": steps of depth_step(), rounded, at
/// least 1 where something is. "normal": (n + 1) / 2 * 65 535, rounded; 0 where nothing is. "section": 65 535 on cut
/// faces.
std::vector<TruthPicture> pictures_of(const TruthLayers& layers);

/// The number of instances whose masks share a picture, a bit for each.
constexpr std::size_t masks_in_picture = 16;

/// The number of pictures for the masks of this many instances.
std::size_t amodal_pictures(std::size_t instances);

/// Rows `top` to `bottom` of the picture "amodal_1", which has instances 1 to 16, for `number` 0, of "amodal_2", which
/// has 17 to 32, for 1, ...: the lowest bit is the first instance's. Whole pictures of a large heap would take
/// gigabytes together.
std::vector<std::uint16_t> amodal_rows(std::span<const Mask> amodal, std::size_t number, int width, int top,
                                       int bottom);

/// All rows.
TruthPicture amodal_picture(std::span<const Mask> amodal, std::size_t number, int width, int height);

}  // namespace pomona
