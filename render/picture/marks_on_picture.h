// Hatching or stipple in place of paint.
#pragma once

#include <span>
#include <vector>

#include "generator/base/color.h"
#include "render/image/image.h"
#include "render/marks/mark.h"
#include "render/picture/paper.h"
#include "render/picture/stroke.h"
#include "render/style/style.h"

namespace pomona {

/// Marks as the pen draws them; a dot is a stroke from a place to itself.
std::vector<StrokePoint> stroke_of(const Mark& mark);

/// The bare paper with the painted picture as thin on it as the style's wash, and the marks above, in one ink.
Image with_marks(const Image& painted, const Paper& paper, std::span<const Mark> marks, const MarkStyle& style,
                 const Color& ink);

}  // namespace pomona
