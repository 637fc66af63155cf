#include "render/style/look.h"

namespace pomona {

Look::Look(const NoiseStyle& noise, const std::vector<DetailSketch>& details) : modulation_(noise), details_(details) {}

Color Look::operator()(const Color& unmodulated, const LookPlace& place) const {
  return modulation_(unmodulated, place.position, place.footprint);
}

}  // namespace pomona
