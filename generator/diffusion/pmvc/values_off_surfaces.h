// Computes positive mean values only for points that do not lie on a surface.
#pragma once

#include <span>
#include <vector>

#include "generator/diffusion/pmvc_value.h"
#include "generator/diffusion/resolved_colors.h"

namespace pomona {

/// One value for each point; points on a surface have none. `values_at` computes all the others at once.
template <typename ValuesAt>
std::vector<PmvcValue> values_off_surfaces(const SidesOfPoints& sides, std::span<const glm::vec3> points,
                                           const ValuesAt& values_at) {
  std::vector<glm::vec3> off;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!sides[i]) off.push_back(points[i]);
  const std::vector<PmvcValue> found = values_at(std::span<const glm::vec3>(off));
  std::vector<PmvcValue> all(points.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!sides[i]) all[i] = found[next++];
  return all;
}

}  // namespace pomona
