// All marks of a picture, as its style asks.
#pragma once

#include <vector>

#include "generator/base/color.h"
#include "render/image/image.h"
#include "render/marks/mark.h"
#include "render/style/style.h"

namespace pomona {

/// The lines or dots for the tones of a painted picture on paper of this colour. Equal pictures give equal marks, to
/// the bit.
std::vector<Mark> marks_of(const Image& painted, const Color& paper, const MarkStyle& style);

}  // namespace pomona
