// Smooths a coarse solid, for pictures that show it large.
#pragma once

#include "generator/piece/solid.h"

namespace pomona {

/// The solid with every triangle divided into four, `passes` times. New vertices move towards the tangent planes at the
/// ends of their edge, so that the solid is as round as its normals say (Phong tessellation, Boubekeur and Alexa 2008).
/// A closed solid stays closed.
Solid smoothed(Solid solid, int passes);

}  // namespace pomona
