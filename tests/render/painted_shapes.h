// Artificial fruit for pictures, so simple that every pixel is known.
#pragma once

#include "generator/cut/section/cross_section.h"
#include "generator/scene/scene.h"

namespace pomona::testing {

/// A red disc (radius 4 cm, in the plane z = 0) in a skin 4 mm thick, with a soft pale core. `faces` copies of
/// it, as if cut by as many parallel planes.
CrossSection disc_section(int faces = 1);

/// One colour at three bands, on `color`.
NoiseStyle some_noise(const Color& color);

/// A red ball of radius 4 cm that stands on y = 0.
Solid ball();

/// Its half where z <= 0, with a pale cut face towards +Z.
Solid half_ball();

/// One ball without ground, seen from +Z.
Scene ball_scene();

/// Balls and halves on the ground.
Scene still_life();

}  // namespace pomona::testing
