#include "generator/surface/grains/volume_grains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/box.h"
#include "generator/mesh/distance_tree.h"
#include "generator/mesh/enclosures.h"
#include "generator/surface/grains/grain_shape.h"
#include "generator/surface/sweep/body_map.h"
#include "generator/surface/sweep/dart_cells.h"
#include "generator/surface/sweep/profile.h"
#include "generator/surface/sweep/surface_grids.h"

namespace pomona {

namespace {

constexpr int tries = 60;       // of a grain at each of its sizes
constexpr double shrunk = 0.8;  // factor from one size to the next
constexpr int shrinkings = 10;  // down to a tenth

/// The integral of size^power over the sizes.
double integral(const GrainVolume& volume, double power) {
  const double n = power + 1;
  if (std::fabs(n) < 1e-9) return reproducible::log(volume.to / volume.from);
  return (reproducible::pow(volume.to, n) - reproducible::pow(volume.from, n)) / n;
}

/// The mean of the cube of the sizes.
double mean_cube(const GrainVolume& volume) {
  if (!(volume.to > volume.from * (1 + 1e-9))) return volume.to * volume.to * volume.to;
  return integral(volume, 3 - volume.exponent) / integral(volume, -volume.exponent);
}

GrainPose grown_by(GrainPose pose, double length) {
  for (glm::dvec3* axis : {&pose.thickness, &pose.length, &pose.width}) *axis *= 1 + length / glm::length(*axis);
  return pose;
}

/// The space between the surface that holds the grains and those of which they keep clear.
class GrainSpace {
 public:
  GrainSpace(const Template& fruit, const GrainSketch& sketch, const SweepOptions& options) {
    std::vector<glm::vec3> position;
    std::vector<glm::uvec3> triangle;
    std::vector<Enclosures::Triangle> closed;
    std::vector<int> surfaces = sketch.volume->clear_of;
    surfaces.insert(surfaces.begin(), sketch.surface);
    std::uint32_t mesh = 0;
    for (const int surface : surfaces) {
      for (const SweptGrid& grid : swept_grids(fruit, fruit.surfaces.at(static_cast<std::size_t>(surface)), options)) {
        const auto first = static_cast<std::uint32_t>(position.size());
        for (const glm::dvec3& p : grid.position) position.emplace_back(p);
        for (const glm::uvec3& t : grid.triangle) {
          triangle.push_back(t + first);
          closed.push_back({{grid.position[t.x], grid.position[t.y], grid.position[t.z]}, mesh});
        }
        ++mesh;
      }
    }
    walls_ = DistanceTree(TriangleTree(position, triangle));
    meshes_ = Enclosures(std::move(closed));
  }

  /// Whether a place lies inside the surface, and outside the others.
  bool holds(const glm::dvec3& place) const {
    const auto around = meshes_.around(place);
    return around.size() == 1 && around.front().first == 0;
  }

  /// The distance from the nearest wall, metres, at most `reach`.
  double depth(const glm::dvec3& place, double reach) const {
    return std::min(reach, walls_.nearest(place, reach).distance);
  }

 private:
  DistanceTree walls_;
  Enclosures meshes_{std::vector<Enclosures::Triangle>{}};
};

/// Directions at a place: along the axis, away from it, around it.
struct AxisFrame {
  glm::dvec3 along{0, 1, 0}, out{1, 0, 0}, around{0, 0, -1};
};

AxisFrame frame_at(const BodyMap& map, const glm::dvec3& straight) {
  constexpr double step = 1e-6;  // metres
  const glm::dvec3 here = map(straight);
  AxisFrame frame;
  frame.along = glm::normalize(map(straight + glm::dvec3(0, step, 0)) - here);
  const glm::dvec3 out = map(straight + away_from_axis(straight) * step) - here;
  frame.out = glm::normalize(out - glm::dot(out, frame.along) * frame.along);
  frame.around = glm::cross(frame.along, frame.out);
  return frame;
}

/// Chance of one grain's pose: the same wherever it comes to lie.
struct GrainChance {
  double heading_a = 0, heading_b = 0, roll = 0;
  glm::dvec3 any{0, 1, 0};
};

GrainChance chance_of(const RandomStream& random, std::uint64_t number) {
  GrainChance chance{random.normal(3 * number), random.normal(3 * number + 1), random.normal(3 * number + 2)};
  const double up = 2 * random.uniform(2 * number) - 1, turn = 2 * pi * random.uniform(2 * number + 1);
  const double level = std::sqrt(std::max(0.0, 1 - up * up));
  chance.any = {level * reproducible::cos(turn), up, level * reproducible::sin(turn)};
  return chance;
}

glm::dvec3 volume_heading(const GrainVolume& volume, const AxisFrame& frame, const GrainChance& chance) {
  switch (volume.heading) {
    case GrainVolume::Heading::along:
      return frame.along;
    case GrainVolume::Heading::out:
      return frame.out;
    case GrainVolume::Heading::up:
      return {0, 1, 0};
    case GrainVolume::Heading::around:
      return frame.around;
    case GrainVolume::Heading::any:
      break;
  }
  return chance.any;
}

/// The half axes of a grain of this size: flat towards the axis, where it is not round.
GrainPose pose_in(const GrainSketch& sketch, const AxisFrame& frame, const GrainChance& chance, double size) {
  const GrainVolume& volume = *sketch.volume;
  glm::dvec3 tip = volume_heading(volume, frame, chance);
  glm::dvec3 flat = across(tip, {frame.out, frame.along, frame.around});
  const glm::dvec3 side = glm::cross(flat, tip);
  // The tangent of a standard deviation of 60 degrees and more means any direction.
  const double sway = reproducible::sin(volume.stray) / std::max(0.1, reproducible::cos(volume.stray));
  tip = glm::normalize(tip + sway * (chance.heading_a * flat + chance.heading_b * side));
  flat = across(tip, {flat, side, frame.along});
  const double roll = volume.stray * chance.roll;
  flat = flat * reproducible::cos(roll) + glm::cross(flat, tip) * reproducible::sin(roll);
  const double half = 0.5 * size / volume.to;
  GrainPose pose;
  pose.thickness = flat * (half * sketch.form.thickness);
  pose.length = tip * (half * sketch.form.length);
  pose.width = glm::cross(flat, tip) * (half * sketch.form.width);
  return pose;
}

/// Fills the space with grains, one after another.
class VolumeFiller {
 public:
  VolumeFiller(const Template& fruit, const GrainSketch& sketch, VariantKey key, const SweepOptions& options,
               const std::vector<GrainObstacle>& others)
      : sketch_(sketch),
        volume_(*sketch.volume),
        map_(fruit),
        space_(fruit, sketch, options),
        places_(key, "grains/" + sketch.name + "/places"),
        cells_(volume_.from) {
    const SurfaceSketch& surface = fruit.surfaces.at(static_cast<std::size_t>(sketch.surface));
    const int along = std::max(8, surface.along), around = std::max(8, surface.around);
    for (const glm::dvec3& p : swept_around_axis(fruit, surface, around, along).position) box_.add(p);
    for (const GrainObstacle& other : others) add(other.center, other.body);
    for (const auto& stop : volume_.near_skin.stops) skin_ = std::max(skin_, stop.at);
  }

  /// The grain, where it finds room.
  std::optional<Dart> place(const Dart& wanted, double size, const GrainChance& chance) {
    for (int k = 0; k <= shrinkings; ++k, size *= shrunk) {
      for (int i = 0; i < tries; ++i) {
        const std::uint64_t draw = 3 * ((wanted.number * (shrinkings + 1) + static_cast<std::uint64_t>(k)) * tries +
                                        static_cast<std::uint64_t>(i));
        if (std::optional<Dart> dart = tried(wanted, size, chance, draw)) return dart;
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<Dart> tried(Dart dart, double size, const GrainChance& chance, std::uint64_t draw) {
    const glm::dvec3 share{places_.uniform(draw), places_.uniform(draw + 1), places_.uniform(draw + 2)};
    const glm::dvec3 straight = box_.low + share * box_.size();
    dart.center = map_(straight);
    const AxisFrame frame = frame_at(map_, straight);
    const int look = dart.pose.look;
    dart.pose = pose_in(sketch_, frame, chance, size);
    dart.pose.look = look;
    const GrainPose held = body_of(dart.pose, sketch_.form), body = grown_by(held, volume_.apart / 2);
    if (meets(dart.center, body) || !space_.holds(dart.center)) return std::nullopt;
    const double need = max_radius(held) + volume_.wall;
    const double depth = space_.depth(dart.center, std::max(need, skin_));
    if (depth < need || size > volume_.to * volume_.near_skin(depth)) return std::nullopt;
    dart.normal = frame.out;
    dart.tangent = frame.along;
    dart.spacing = size;
    add(dart.center, body);
    return dart;
  }

  bool meets(const glm::dvec3& center, const GrainPose& body) const {
    return cells_.any_meets(center, 2 * max_radius(body), [&](std::size_t i) {
      return ellipsoids_overlap(center, body, bodies_[i].center, bodies_[i].body);
    });
  }

  void add(const glm::dvec3& center, const GrainPose& body) {
    cells_.add(center, 2 * max_radius(body), bodies_.size());
    bodies_.push_back({center, body});
  }

  const GrainSketch& sketch_;
  const GrainVolume& volume_;
  BodyMap map_;
  GrainSpace space_;
  RandomStream places_;
  DartCells cells_;
  Box<double> box_;  ///< of the surface before its axis bends
  double skin_ = 0;  ///< the depth below which near_skin stays the same, metres
  std::vector<GrainObstacle> bodies_;
};

}  // namespace

double volume_room(const GrainSketch& sketch, const Curve& vertical) {
  const double solid = pi * std::fabs(outward(sampled_profile(vertical, 512)));
  const GrainVolume& volume = *sketch.volume;
  const GrainForm& form = sketch.form;
  const double shape = form.length * form.width * form.thickness / (volume.to * volume.to * volume.to);
  return std::round(volume.share * solid / (pi / 6 * shape * mean_cube(volume)));
}

double volume_size(const GrainVolume& volume, std::size_t number, std::size_t count) {
  // At even steps of the share of grains that are larger.
  const double larger = (static_cast<double>(number) + 0.5) / static_cast<double>(count);
  const double n = 1 - volume.exponent;
  if (std::fabs(n) < 1e-9) return volume.to * reproducible::pow(volume.from / volume.to, larger);
  const double low = reproducible::pow(volume.from, n), high = reproducible::pow(volume.to, n);
  return reproducible::pow(high + larger * (low - high), 1 / n);
}

GrainPose body_of(const GrainPose& pose, const GrainForm& form) {
  return scaled(pose, bulge_of(form.shape) * (1 + 0.25 * form.pointedness));
}

std::vector<Dart> volume_darts(const Template& fruit, const GrainSketch& sketch, const GrainDraws& draws,
                               VariantKey key, const SweepOptions& options, const std::vector<GrainObstacle>& others) {
  const SurfaceSketch& surface = fruit.surfaces.at(static_cast<std::size_t>(sketch.surface));
  const auto count = static_cast<std::size_t>(volume_room(sketch, surface.vertical));
  if (swept_grids(fruit, surface, options).empty()) return {};
  VolumeFiller filler(fruit, sketch, key, options, others);
  const RandomStream poses(key, "grains/" + sketch.name + "/poses");
  std::vector<Dart> darts;
  for (std::size_t n = 0; n < count; ++n) {
    Dart wanted;
    wanted.number = n;
    wanted.pose.look = drawn_look(sketch, n, draws);
    double size = volume_size(*sketch.volume, n, count);
    if (wanted.pose.look >= 0) size *= sketch.looks[static_cast<std::size_t>(wanted.pose.look)].scale;
    const std::optional<Dart> dart = filler.place(wanted, size, chance_of(poses, n));
    if (!dart) throw NoRoom{size};
    darts.push_back(*dart);
  }
  return darts;
}

}  // namespace pomona
