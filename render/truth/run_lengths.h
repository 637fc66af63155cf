// Masks as COCO writes them: run lengths, column by column.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/truth/mask.h"

namespace pomona {

/// Lengths of runs of uncovered, covered, uncovered, ... pixels; column by column from the left, each downwards. The
/// first may be 0. Their sum is width * height.
std::vector<std::uint32_t> run_lengths(const Mask& mask, int width, int height);

/// The same as the text that COCO's own tools read and write ("compressed RLE"; maskApi.c of pycocotools, rleToString):
/// differences to the run before the last one, five bits a character.
std::string packed(const std::vector<std::uint32_t>& runs);

}  // namespace pomona
