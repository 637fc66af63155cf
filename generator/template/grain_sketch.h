// Grains of a template: seeds and the like, strewn over a surface.
#pragma once

#include <string>

#include "generator/template/side.h"

namespace pomona {

/// Grains (seeds) scattered by dart throwing over one surface (paper, section 4, step 2).
struct GrainSketch {
  std::string name;
  int surface = 0;                              ///< index into Template::surfaces
  bool on_front = true;                         ///< which side they sit on and point away from
  double poisson_radius = 0;                    ///< metres: no two centres on surfaces facing the same way are nearer
  double length = 0, width = 0, thickness = 0;  ///< full axes of the grain, metres; length runs along the surface
  double sink = 0;                      ///< how deep its centre lies below the surface, metres (negative = above)
  double size_jitter = 0;               ///< share, 0..0.9
  double angle_jitter = 0;              ///< radians, about the normal
  double tilt = 0;                      ///< radians, of the tip away from the surface
  double pointedness = 0;               ///< 0 = ellipsoid, 1 = drop with its tip at the +length end
  double along_from = 0, along_to = 1;  ///< the band of the vertical curve they grow on
  Side front;
  Side back;
  double blur = 0;
  int around = 8, along = 6;
};

}  // namespace pomona
