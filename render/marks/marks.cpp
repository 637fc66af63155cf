#include "render/marks/marks.h"

#include <algorithm>

#include "render/marks/flow_field.h"
#include "render/marks/hatching.h"
#include "render/marks/solid_spots.h"
#include "render/marks/stippling.h"
#include "render/marks/tone_map.h"

namespace pomona {

std::vector<Mark> marks_of(const Image& painted, const Color& paper, const MarkStyle& style) {
  // Marks stay wide enough to be distinguished in small pictures.
  const double side = std::min(painted.width, painted.height);
  const double width = std::max(style.width * side, 0.7), spacing = std::max(style.spacing * side, 1.5);
  std::vector<Mark> marks = style.kind == MarkKind::stipple
                                ? stippled(tones_of(painted, paper, {.blur = 0.25 * width}), {.width = width})
                                : hatched(tones_of(painted, paper, {.blur = 0.3 * spacing}),
                                          flow_of(painted, {.scale = spacing}), {.spacing = spacing, .width = width});
  const std::vector<Mark> spots = solid_spots(tones_of(painted, paper, {.blur = 0.6, .stretched = false}),
                                              {.around = 3.5 * spacing, .longest = 8 * spacing});
  marks.insert(marks.end(), spots.begin(), spots.end());
  return marks;
}

}  // namespace pomona
