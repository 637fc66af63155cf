#include "render/picture/line_opacity.h"

#include <algorithm>

namespace pomona {

double line_opacity(double oklab_distance) {
  const double t = std::clamp((oklab_distance - 0.03) / (0.18 - 0.03), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace pomona
