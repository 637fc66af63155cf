// Positive mean values by OpenGL, for many fruits at once.
#pragma once

#include <span>
#include <vector>

#include "generator/diffusion/pmvc_value.h"
#include "render/diffusion/gl_ray_caster.h"

namespace pomona {

/// The number of lines through each point, used in both directions.
struct LineSampling {
  int lines = 0;
  int fine_lines = 0;      ///< instead, where colours scatter by more than `max_scatter`; 0 = nowhere
  double max_scatter = 0;  ///< linear; see Sight
};

/// Points in one of several fruits.
struct SightTask {
  std::size_t fruit = 0;
  std::span<const glm::vec3> points;  ///< metres
};

/// Positive mean values, an entry for every point of every task. They do not depend on what else is asked for.
/// \throws Error (helper_missing) if a fruit is too large for this OpenGL, or memory does not suffice.
std::vector<std::vector<PmvcValue>> gl_pmvc(const CurrentGl& gl, const GlRayCaster& caster,
                                            std::span<const RaySurfaces> fruits, std::span<const SightTask> tasks,
                                            const LineSampling& sampling);

}  // namespace pomona
