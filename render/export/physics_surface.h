// How surfaces rub and bounce in simulators.
#pragma once

#include "render/export/pbr_material.h"

namespace pomona {

/// Assumed, not measured: dry surfaces rub as in the heaps of scenes (generator/scene/settle), and a film of juice
/// takes up to half of it.
struct PhysicsSurface {
  double static_friction = 0.6;   ///< coefficient
  double dynamic_friction = 0.5;  ///< coefficient
  double restitution = 0.1;       ///< share of the speed that is left after a bounce
};

PhysicsSurface physics_surface_of(const PbrMaterial& look);

}  // namespace pomona
