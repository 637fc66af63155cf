#include "generator/surface/grains/grain_shape.h"

#include <algorithm>
#include <cmath>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/section_loop.h"

namespace pomona {

namespace {

/// A drop narrows towards its tip with the sine of half the angle from there; 0.7698 is its widest.
double narrowing(double from_tip, double pointedness) {
  const double drop = reproducible::sin(from_tip / 2) / 0.7698;
  return 1 + pointedness * (drop - 1);
}

/// Maps a point of the unit sphere to the shape. Each map is one to one, so closed meshes stay closed.
glm::dvec3 shaped(GrainShape shape, const glm::dvec3& p) {
  switch (shape) {
    case GrainShape::lens:  // |x| = 1 - y^2 - z^2
      return {p.x * std::fabs(p.x), p.y, p.z};
    case GrainShape::disc:  // x^2 = 1 - (y^2 + z^2)^2
      return {p.x * std::sqrt(2 - p.x * p.x), p.y, p.z};
    case GrainShape::rod: {  // r^4 + y^4 = 1
      const double r2 = p.x * p.x + p.z * p.z, y2 = p.y * p.y;
      return p / std::sqrt(std::sqrt(r2 * r2 + y2 * y2));
    }
    case GrainShape::spindle: {  // r = 1 - y^2
      const double r = std::sqrt(p.x * p.x + p.z * p.z);
      return {p.x * r, p.y, p.z * r};
    }
    case GrainShape::bean:  // an ellipsoid sheared along its bent middle line
      return {p.x, p.y, 0.8 * p.z + 0.2 - 0.9 * p.y * p.y};
    case GrainShape::cushion: {  // x^4 + y^4 + z^4 = 1
      const glm::dvec3 q = p * p;
      return p / std::sqrt(std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z));
    }
    case GrainShape::ellipsoid:
      break;
  }
  return p;
}

}  // namespace

double bulge_of(GrainShape shape) {
  switch (shape) {
    case GrainShape::disc:
      return 1.12;
    case GrainShape::rod:
      return 1.19;
    case GrainShape::bean:
      return 1.22;
    case GrainShape::cushion:
      return 1.32;
    case GrainShape::ellipsoid:
    case GrainShape::lens:
    case GrainShape::spindle:
      break;
  }
  return 1;
}

SweptGrid unit_grain(const GrainForm& form) {
  // Vertices are points of the unit sphere, as the shape carries them, with their places in the ramps.
  const int around = std::max(3, form.around), rings = std::max(3, form.along);
  SweptGrid grain;
  const auto append = [&](const glm::dvec3& on_sphere, double narrow, int ring, int spoke) {
    const glm::dvec3 p = shaped(form.shape, on_sphere);
    grain.position.emplace_back(p.x * narrow, p.y, p.z * narrow);
    grain.along.push_back(static_cast<double>(ring) / (rings - 1));
    grain.around.push_back(static_cast<double>(spoke) / around);
    grain.is_pole.push_back(ring == 0 || ring == rings - 1 ? 1 : 0);
  };

  // The rings follow from pole to pole; the last pole is the tip, towards which a pointed grain narrows.
  append({0, -1, 0}, 1, 0, 0);
  for (int j = 1; j + 1 < rings; ++j) {
    const double from_tip = pi * (1 - static_cast<double>(j) / (rings - 1));
    const double radius = reproducible::sin(from_tip), narrow = narrowing(from_tip, form.pointedness);
    for (int i = 0; i < around; ++i) {
      const glm::dvec2 spoke = direction_of(2 * pi * i / around);
      append({radius * spoke.x, reproducible::cos(from_tip), -radius * spoke.y}, narrow, j, i);
    }
  }
  append({0, 1, 0}, narrowing(0, form.pointedness), rings - 1, 0);

  // A grain lies in no fold, and so its depth is 1 everywhere.
  grain.fold.assign(grain.position.size(), 0);
  grain.depth.assign(grain.position.size(), 1);
  grain.triangle = grid_triangles({around, rings, true, true, false});
  return grain;
}

}  // namespace pomona
