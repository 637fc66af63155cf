#include "render/export/physics_surface.h"

#include <algorithm>
#include <cmath>

namespace pomona {

namespace {

double in_hundredths(double coefficient) { return std::round(100 * coefficient) / 100; }

}  // namespace

PhysicsSurface physics_surface_of(const PbrMaterial& look) {
  const double left = 1 - 0.5 * std::clamp(look.clearcoat, 0.0, 1.0);
  const PhysicsSurface dry;
  return {in_hundredths(left * dry.static_friction), in_hundredths(left * dry.dynamic_friction), dry.restitution};
}

}  // namespace pomona
