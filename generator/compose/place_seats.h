// The seats of a place: where instances are set.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/sweep/sweep_options.h"
#include "generator/template/template.h"

namespace pomona {

struct PlaceSeat {
  glm::dvec3 center{0};
  glm::dvec3 normal{0};      ///< unit, away from the side on which instances sit; in a cluster, from the axis
  glm::dvec3 uphill{0};      ///< unit, perpendicular to the normal
  glm::dvec3 stalk_root{0};  ///< on the axis, where the stalk leaves; of places with stalks
  double along = 0;          ///< share of the surface's vertical curve, or of the cluster's height
};

/// The number of instances that this template's own places have room for, with those within, or a few more; to be asked
/// before any seat is found.
double instance_room(const Template& fruit);

/// How many triangles these are, about.
double instance_triangles(const Template& fruit);

/// As many in all variants.
std::vector<PlaceSeat> place_seats(const Template& variant, const PlaceSketch& place, const SweepOptions& options);

}  // namespace pomona
