#include "generator/surface/grains/grain_room.h"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/surface/grains/grain_shape.h"

namespace pomona {

namespace {

constexpr int steps = 12;           // that a grain moves, for each of its sizes
constexpr double clearance = 0.12;  // from a wall, in grains' smallest radii
constexpr double overlap = 0.8;     // grains that moved may touch each other, but not beyond this share of their sizes

/// The pose of an ellipsoid that holds the grain and its clearance. Drops are thicker at their blunt end.
GrainPose with_clearance(GrainPose pose, const GrainForm& form) {
  const double more = clearance * min_radius(pose), blunt = 1 + 0.25 * form.pointedness;
  pose = scaled(pose, bulge_of(form.shape));
  pose.thickness *= blunt;
  pose.width *= blunt;
  for (glm::dvec3* axis : {&pose.thickness, &pose.length, &pose.width}) *axis *= 1 + more / glm::length(*axis);
  return pose;
}

/// Where the dart stands on its surface, a little towards the grain: the grain belongs on this side of all walls.
glm::dvec3 home_of(const Dart& dart, double sink) {
  constexpr double little = 1e-3;
  const double side = sink > 0 ? -1 : 1;
  return dart.center + dart.normal * (sink + side * little * min_radius(dart.pose));
}

/// The dart moved clear of all walls, if it gets there.
std::optional<Dart> moved_clear(Dart dart, const GrainForm& form, const GrainWalls& walls,
                                const std::vector<std::uint32_t>& home) {
  const GrainPose body = with_clearance(dart.pose, form);
  for (int step = 0; step < steps; ++step) {
    const WallPush push = walls.deepest({dart.center, body}, home);
    if (push.depth <= 1e-6) return dart;
    dart.center += push.by * 1.02;
  }
  return std::nullopt;
}

bool meets_any(const Dart& dart, std::span<const Dart> darts) {
  const GrainPose small = scaled(dart.pose, overlap);
  return std::any_of(darts.begin(), darts.end(), [&](const Dart& known) {
    const double reach = glm::length(small.length) + glm::length(known.pose.length);
    if (glm::distance(dart.center, known.center) > reach) return false;
    return ellipsoids_overlap(dart.center, small, known.center, scaled(known.pose, overlap));
  });
}

}  // namespace

std::vector<Dart> with_room(std::vector<Dart> darts, const GrainSketch& sketch, const GrainWalls& walls,
                            std::span<const Dart> others) {
  std::vector<Dart> kept;
  std::vector<Dart> crowded;
  for (const Dart& dart : darts) {
    const std::vector<std::uint32_t> home = walls.around(home_of(dart, sketch.stance.sink));
    if (walls.deepest({dart.center, with_clearance(dart.pose, sketch.form)}, home).depth <= 1e-6) {
      kept.push_back(dart);
    } else {
      crowded.push_back(dart);
    }
  }
  // Those that are clear have their places; the others take what is left.
  for (const Dart& dart : crowded) {
    const std::vector<std::uint32_t> home = walls.around(home_of(dart, sketch.stance.sink));
    for (const double size : {1.0, 0.85, 0.72, 0.6}) {
      Dart smaller = dart;
      smaller.pose = scaled(dart.pose, size);
      const std::optional<Dart> moved = moved_clear(smaller, sketch.form, walls, home);
      if (!moved || meets_any(*moved, kept) || meets_any(*moved, others)) continue;
      kept.push_back(*moved);
      break;
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Dart& a, const Dart& b) { return a.number < b.number; });
  return kept;
}

}  // namespace pomona
