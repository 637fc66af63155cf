#include "generator/compose/placed_instances.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/compose/collected_surfaces.h"
#include "generator/compose/place_seats.h"
#include "generator/compose/press.h"
#include "generator/compose/stalk.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/template/read/entry_place.h"
#include "generator/variation/species_key.h"

namespace pomona {

namespace {

constexpr double max_instances = 4096, max_triangles = 4e6;

/// What is set where, and how it grows.
struct PlaceTask {
  const Template& variant;
  const PlaceSketch& place;
  VariantKey key;
  const GrowOptions& options;
};

/// A variant that several instances may share.
struct IndividualGrown {
  GrownFruit grown;
  Box<double> box;
  std::optional<ReachTable> reach;  ///< if it is pressed
};

/// The instances of one place, not yet pressed: as many seats as poses. They take the individuals in turn.
struct LaidInstances {
  std::vector<PlaceSeat> seats;
  std::vector<InstancePose> poses;
  std::vector<IndividualGrown> individuals;

  const IndividualGrown& individual(std::size_t instance) const { return individuals[instance % individuals.size()]; }
  glm::dvec3 heart(std::size_t instance) const { return poses[instance](individual(instance).reach->heart()); }
};

[[noreturn]] void refuse_place(const Template& fruit, const PlaceSketch& place, const std::string& why,
                               const std::string& hint) {
  refuse_entry(fruit, "place", place.name, why, hint);
}

void check_room(const Template& fruit, const GrowOptions& options) {
  const double square = options.detail * options.detail;
  if (instance_room(fruit) > max_instances)
    refuse_place(fruit, fruit.places.front(), "more than 4096 instances, with those within",
                 "make the spacing of its law larger");
  if (instance_triangles(fruit) * std::min(square, 1.0) > max_triangles)
    refuse_place(fruit, fruit.places.front(), "more than 4 000 000 triangles together",
                 "lower \"detail\", or \"around\" and \"along\" of what is placed");
}

std::int32_t instances_within(const GrownFruit& grown) {
  std::int32_t most = 0;
  for (const std::int32_t i : grown.swept.instance) most = std::max(most, i);
  for (const std::int32_t i : grown.grains.instance) most = std::max(most, i);
  return most;
}

// ---- Growing and laying ----

/// One for each individual; so many instances share them.
std::vector<VariantKey> individual_keys(const PlaceTask& task, std::size_t instances) {
  if (is_drawn(task.key)) return {task.key};
  const auto shared = static_cast<std::size_t>(task.place.individuals);
  const RandomStream draws(task.key, "place/" + task.place.name);
  std::vector<VariantKey> keys;
  for (std::size_t i = 0; i < (shared == 0 ? instances : std::min(shared, instances)); ++i)
    keys.push_back({draws.bits(2 * i), draws.bits(2 * i + 1)});
  return keys;
}

/// What is asked of the whole fruit holds for what is placed, as far as it can.
GrowOptions options_within(const PlaceTask& task) {
  GrowOptions within = task.options;
  within.folds = {};
  within.scale = 1;
  within.browning = 0;
  within.detail = std::clamp(task.options.detail * task.place.detail, 0.1, 4.0);
  within.as_drawn = task.options.as_drawn || is_drawn(task.key);
  if (!task.place.placed->ripeness.declared()) within.ripeness = {};
  return within;
}

ReachTable reach_of(const IndividualGrown& one, const PlaceTask& task) {
  const std::string& name = task.place.placed->surfaces[static_cast<std::size_t>(task.place.press->surface)].name;
  const auto& names = one.grown.swept.surface_names;
  const auto skin = static_cast<std::int32_t>(std::find(names.begin(), names.end(), name) - names.begin());
  const glm::dvec3 heart(0, one.box.low.y + task.place.press->heart * one.box.size().y, 0);
  ReachTable reach(one.grown.swept, skin, heart);
  if (!reach.is_closed())
    refuse_place(task.variant, task.place,
                 "the skin \"" + name + "\" does not surround the heart from which it is pressed",
                 "name a closed surface, or move the heart");
  return reach;
}

std::vector<IndividualGrown> grown_individuals(const PlaceTask& task, std::size_t instances,
                                               const GrowPlaced& grow_placed) {
  std::vector<IndividualGrown> individuals;
  const std::vector<VariantKey> keys = individual_keys(task, instances);
  for (GrownFruit& grown : grow_placed(*task.place.placed, keys, options_within(task))) {
    IndividualGrown one{std::move(grown), {}, {}};
    one.box = bounds_of(one.grown.swept);
    individuals.push_back(std::move(one));
  }
  if (!task.place.press) return individuals;
  parallel_for(individuals.size(), task.options.threads,
               [&](std::size_t i) { individuals[i].reach = reach_of(individuals[i], task); });
  return individuals;
}

SweepOptions sweep_options(const PlaceTask& task) {
  return {.detail = task.options.detail, .key = task.key, .threads = task.options.threads};
}

LaidInstances laid_instances(const PlaceTask& task, const GrowPlaced& grow_placed) {
  LaidInstances laid;
  laid.seats = place_seats(task.variant, task.place, sweep_options(task));
  if (laid.seats.empty()) return laid;
  laid.individuals = grown_individuals(task, laid.seats.size(), grow_placed);
  const RandomStream draws(task.key, "place/" + task.place.name + "/pose");
  for (std::size_t i = 0; i < laid.seats.size(); ++i)
    laid.poses.push_back(instance_pose(task.place, laid.seats[i], laid.individual(i).box, i, draws));
  return laid;
}

// ---- The press ----

/// The plane towards the nearest place of a surface that has all of it within reach behind it.
std::optional<PressWall> nearest_wall(const std::vector<SweptGrid>& grids, const LaidInstances& laid, std::size_t i,
                                      double gap) {
  const glm::dvec3 heart = laid.heart(i);
  std::optional<glm::dvec3> nearest;
  for (const SweptGrid& grid : grids) {
    for (const glm::uvec3& t : grid.triangle) {
      const glm::dvec3 middle = (grid.position[t.x] + grid.position[t.y] + grid.position[t.z]) / 3.0;
      if (!nearest || glm::distance(middle, heart) < glm::distance(*nearest, heart)) nearest = middle;
    }
  }
  if (!nearest || *nearest == heart) return {};
  const glm::dvec3 normal = glm::normalize(*nearest - heart);
  const double within = 2 * laid.poses[i].scale * laid.individual(i).reach->farthest();
  double least = glm::dot(*nearest - heart, normal);
  for (const SweptGrid& grid : grids) {
    for (const glm::dvec3& p : grid.position) {
      if (glm::distance(p, heart) < within) least = std::min(least, glm::dot(p - heart, normal));
    }
  }
  return PressWall{heart + normal * (least - gap), normal};
}

/// Neighbours that do not give way: the ground at the seat, and surfaces that are as hard.
std::vector<std::vector<PressWall>> walls_of(const PlaceTask& task, const LaidInstances& laid) {
  const PressSketch& press = *task.place.press;
  std::vector<std::vector<PressWall>> all(laid.seats.size());
  for (std::size_t i = 0; press.root && i < laid.seats.size(); ++i)
    all[i].push_back({laid.seats[i].center - laid.seats[i].normal * *press.root, -laid.seats[i].normal});
  std::vector<int> hard = press.against;
  if (task.place.stalk) hard.push_back(task.place.stalk->from);
  for (const int surface : hard) {
    const SurfaceSketch& sketch = task.variant.surfaces.at(static_cast<std::size_t>(surface));
    const std::vector<SweptGrid> grids = swept_grids(task.variant, sketch, sweep_options(task));
    for (std::size_t i = 0; i < laid.seats.size(); ++i) {
      if (const std::optional<PressWall> nearest = nearest_wall(grids, laid, i, press.gap)) all[i].push_back(*nearest);
    }
  }
  return all;
}

/// A cell for each instance, which looks things up in `laid`; none without a press.
std::vector<PressCell> cells_of(const PlaceTask& task, const LaidInstances& laid) {
  if (!task.place.press || laid.seats.empty()) return {};
  std::vector<PressedBody> bodies;
  for (std::size_t i = 0; i < laid.seats.size(); ++i) bodies.push_back({&*laid.individual(i).reach, laid.poses[i]});
  const std::vector<std::vector<PressWall>> walls = walls_of(task, laid);
  std::vector<std::optional<PressCell>> found(bodies.size());
  parallel_for(bodies.size(), task.options.threads,
               [&](std::size_t i) { found[i].emplace(*task.place.press, bodies, i, walls[i]); });
  std::vector<PressCell> cells;
  for (std::optional<PressCell>& cell : found) cells.push_back(std::move(*cell));
  return cells;
}

std::vector<std::string> crowded_notes(const PlaceTask& task, const std::vector<PressCell>& cells) {
  constexpr std::size_t most = 3;
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < cells.size() && notes.size() < most; ++i) {
    if (!cells[i].is_crowded()) continue;
    notes.push_back("place \"" + task.place.name + "\": instance " + std::to_string(i + 1) +
                    " has no room between its neighbours, and may cross them");
  }
  return notes;
}

// ---- Collecting ----

/// One instance as its neighbours leave it.
struct Pressed {
  DiffusionSurfaces swept, grains;
};

std::vector<Pressed> pressed_instances(const LaidInstances& laid, const std::vector<PressCell>& cells,
                                       Threads threads) {
  std::vector<Pressed> pressed(cells.size());
  parallel_for(cells.size(), threads, [&](std::size_t i) {
    pressed[i].swept = cells[i].pressed(laid.individual(i).grown.swept);
    pressed[i].grains = cells[i].pressed(laid.individual(i).grown.grains);
  });
  return pressed;
}

Spot laid_spot(Spot spot, const InstancePose& pose) {
  spot.center = pose(spot.center);
  spot.normal = pose.turned(spot.normal);
  spot.tangent = pose.turned(spot.tangent);
  spot.radius *= pose.scale;
  spot.relief *= pose.scale;
  return spot;
}

/// A little within an instance's skin, where its own axis leaves it.
/// \param cell null without a press
glm::dvec3 stalk_top(const StalkSketch& stalk, const IndividualGrown& one, const InstancePose& pose,
                     const PressCell* cell) {
  const glm::dvec3 up(0, 1, 0);
  if (!one.reach || !cell) return pose({0, one.box.high.y - stalk.depth / pose.scale, 0});
  const double reach = one.reach->along(up) * cell->share(up);
  return pose(one.reach->heart() + up * std::max(0.0, reach - stalk.depth / pose.scale));
}

/// A fruit, to which instances are added.
struct CollectedFruit {
  CollectedSurfaces swept, grains;
  std::vector<Spot> raised;
  std::int32_t last = 0;  ///< the number of the last instance
};

CollectedFruit with_instances(CollectedFruit fruit, const PlaceTask& task, const LaidInstances& laid,
                              const std::vector<PressCell>& cells) {
  std::vector<std::string> part_names;
  for (const int part : task.place.parts) part_names.push_back(task.variant.parts[static_cast<std::size_t>(part)]);
  const std::vector<Pressed> pressed = pressed_instances(laid, cells, task.options.threads);
  for (std::size_t i = 0; i < laid.seats.size(); ++i) {
    const std::int32_t number = ++fruit.last;
    const IndividualGrown& one = laid.individual(i);
    const InstancePose& pose = laid.poses[i];
    fruit.swept.add(cells.empty() ? one.grown.swept : pressed[i].swept, pose, task.place.name, part_names, number);
    fruit.grains.add(cells.empty() ? one.grown.grains : pressed[i].grains, pose, task.place.name, part_names, number);
    for (const Spot& spot : one.grown.raised) fruit.raised.push_back(laid_spot(spot, pose));
    fruit.last += instances_within(one.grown);
    if (!task.place.stalk) continue;
    const StalkSketch& stalk = *task.place.stalk;
    const glm::dvec3 root = laid.seats[i].stalk_root;
    const glm::dvec3 top = stalk_top(stalk, one, pose, cells.empty() ? nullptr : &cells[i]);
    if (!(glm::distance(top, root) > stalk.depth)) continue;
    const std::string& part = task.variant.parts[static_cast<std::size_t>(stalk.part)];
    fruit.swept.add(stalk_between(stalk, part, root, top), {}, task.place.name, {part}, number);
  }
  return fruit;
}

}  // namespace

GrownFruit with_placed(GrownFruit fruit, const Template& variant, VariantKey key, const GrowOptions& options,
                       const GrowPlaced& grow_placed) {
  if (variant.places.empty()) return fruit;
  check_room(variant, options);
  CollectedFruit all{CollectedSurfaces(std::move(fruit.swept)), CollectedSurfaces(std::move(fruit.grains)),
                     std::move(fruit.raised)};
  std::vector<std::string> notes;
  for (const PlaceSketch& place : variant.places) {
    const PlaceTask task{variant, place, key, options};
    const LaidInstances laid = laid_instances(task, grow_placed);
    const std::vector<PressCell> cells = cells_of(task, laid);
    all = with_instances(std::move(all), task, laid, cells);
    const std::vector<std::string> more = crowded_notes(task, cells);
    notes.insert(notes.end(), more.begin(), more.end());
  }
  fruit.swept = all.swept.take();
  fruit.swept.notes.insert(fruit.swept.notes.end(), notes.begin(), notes.end());
  fruit.grains = all.grains.take();
  fruit.raised = std::move(all.raised);
  fruit.skin = {};  // that of the fruit alone
  return fruit;
}

}  // namespace pomona
