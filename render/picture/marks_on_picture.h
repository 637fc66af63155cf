// Hatching or stipple instead of paint.
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

/// A mark as a stroke of the pen; a dot is a stroke of length 0.
std::vector<StrokePoint> stroke_of(const Mark& mark);

/// The paper with the painted picture on it, as transparent as the style's wash, and the marks above it, in one ink.
Image with_marks(const Image& painted, const Paper& paper, std::span<const Mark> marks, const MarkStyle& style,
                 const Color& ink);

}  // namespace pomona
