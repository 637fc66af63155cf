// Type I and cylindrical sweeps: S(u, v) = (rho(v) h(u) / h_ref, y(v)) [Snyder & Kajiya 1992; paper, Figure 6].
#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/surface/sweep/profile.h"
#include "generator/surface/sweep/section_loop.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

namespace {

Profile checked_profile(const Template& fruit, const SurfaceSketch& sketch, int along) {
  Profile profile = sampled_profile(sketch.vertical, along);
  for (std::size_t j = 0; j < profile.points.size(); ++j) {
    const double radius = profile.points[j].x;
    if (radius < 0) refuse(fruit, sketch, "the vertical curve crosses the axis", "draw it on the right of the axis");
    const bool may_touch = !profile.closed && (j == 0 || j + 1 == profile.points.size());
    if (radius == 0 && !may_touch) {
      refuse(fruit, sketch, "the vertical curve touches the axis between its ends",
             "let only its ends lie on the axis");
    }
  }
  return profile;
}

SectionLoop checked_loop(const Template& fruit, const SurfaceSketch& sketch, const Curve& loop, int around) {
  const double reference = reference_radii(sketch).outer;
  if (!(reference > 0)) {
    refuse(fruit, sketch, "the horizontal curve does not surround the axis", "draw one closed curve around the axis");
  }
  try {
    const auto* folds = std::get_if<FoldSymmetry>(&fruit.symmetry);
    if (!folds) return sampled_loop(loop, around, reference);
    const auto count = static_cast<int>(folds->fold_angles.size());
    const int per_fold =
        std::max(count < 3 ? 3 : 1, static_cast<int>(std::lround(static_cast<double>(around) / count)));
    return sampled_folds(loop, folds->fold_angles, per_fold, reference);
  } catch (const BadLoop& bad) {
    refuse(fruit, sketch, bad.what(), bad.hint);
  }
}

SectionStops checked_loops(const Template& fruit, const SurfaceSketch& sketch, int around) {
  if (sketch.horizontal.size() != std::max<std::size_t>(1, sketch.stops.size())) {
    refuse(fruit, sketch, "a surface around the axis needs one horizontal curve, or one at each of its stops",
           "draw one closed curve");
  }
  SectionStops stops{sketch.stops, {}};
  for (const Curve& loop : sketch.horizontal) stops.loop.push_back(checked_loop(fruit, sketch, loop, around));
  return stops;
}

void append_ring(SweptGrid& grid, const SectionLoop& loop, const glm::dvec2& at, double share, double roundness) {
  for (std::size_t i = 0; i < loop.radius.size(); ++i) {
    // Ridges fade with roundness: 1 is a circle of the profile's radius.
    const double radius = at.x * (1 + (loop.radius[i] - 1) * (1 - roundness));
    grid.position.emplace_back(radius * loop.direction[i].x, at.y, -radius * loop.direction[i].y);
    grid.along.push_back(share);
    grid.around.push_back(loop.share[i]);
    grid.is_pole.push_back(0);
    grid.fold.push_back(loop.fold[i]);
    grid.depth.push_back(1);
    grid.turn.push_back(turn_of(angle_of(loop.direction[i])));
  }
}

void append_pole(SweptGrid& grid, const glm::dvec2& at, double share) {
  grid.position.emplace_back(0, at.y, 0);
  grid.along.push_back(share);
  grid.around.push_back(0);
  grid.is_pole.push_back(1);
  grid.fold.push_back(0);
  grid.depth.push_back(1);
  grid.turn.push_back(std::nullopt);
}

void set_off(SweptGrid& grid, const AxisOffset& off) {
  for (std::size_t v = 0; v < grid.position.size(); ++v)
    grid.position[v] += glm::dvec3(off.x(grid.along[v]), 0, off.z(grid.along[v]));
}

}  // namespace

SweptGrid swept_around_axis(const Template& fruit, const SurfaceSketch& sketch, int around, int along) {
  const Profile profile = checked_profile(fruit, sketch, along);
  const SectionStops loops = checked_loops(fruit, sketch, around);

  SweptGrid grid;
  grid.folds_around = fold_count(fruit);
  for (std::size_t j = 0; j < profile.points.size(); ++j) {
    const double share = profile.share[j];
    if (profile.points[j].x == 0) {
      append_pole(grid, profile.points[j], share);
    } else if (loops.at.empty()) {
      append_ring(grid, loops.loop.front(), profile.points[j], share, sketch.roundness(share));
    } else {
      append_ring(grid, loop_at(loops, share), profile.points[j], share, sketch.roundness(share));
    }
  }
  if (!sketch.off.is_zero()) set_off(grid, sketch.off);

  // The front is outside, in whichever direction the profile was drawn.
  grid.triangle =
      grid_triangles({static_cast<int>(loops.loop.front().radius.size()), static_cast<int>(profile.points.size()),
                      profile.starts_on_axis, profile.ends_on_axis, profile.closed});
  if (outward(profile) < 0) {
    for (glm::uvec3& t : grid.triangle) std::swap(t.y, t.z);
  }
  return grid;
}

}  // namespace pomona
