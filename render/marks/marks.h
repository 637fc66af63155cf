// All marks of a picture, as its style asks.
#pragma once

#include <vector>

#include "generator/base/color.h"
#include "render/image/image.h"
#include "render/marks/mark.h"
#include "render/style/style.h"

namespace pomona {

/// The lines or dots that stand for a painted picture's tones on paper of this colour. Pictures alike, marks alike, to
/// the bit.
std::vector<Mark> marks_of(const Image& painted, const Color& paper, const MarkStyle& style);

}  // namespace pomona
