#include "generator/compose/placed_instances.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "generator/compose/collected_surfaces.h"
#include "generator/compose/place_seats.h"
#include "generator/compose/press.h"
#include "generator/compose/stalk.h"
#include "generator/surface/sweep/swept_grid.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

constexpr double max_instances = 4096, max_triangles = 4e6;

[[noreturn]] void refuse_place(const Template& fruit, const PlaceSketch& place, const std::string& why,
                               const std::string& hint) {
  const std::string file = fruit.file.empty() ? fruit.name : fruit.file;
  throw Error(ExitStatus::bad_data,
              {{entry_place(file, "place", place.name), "place \"" + place.name + "\": " + why, hint}});
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

bool is_drawn_key(const VariantKey& key) { return key.seed == 0 && key.index == 0; }

/// A variant that several instances may share.
struct IndividualGrown {
  GrownFruit grown;
  Box<double> box;
  std::optional<ReachTable> reach;  ///< if it is pressed
};

std::int32_t instances_within(const GrownFruit& grown) {
  std::int32_t most = 0;
  for (const std::int32_t i : grown.swept.instance) most = std::max(most, i);
  for (const std::int32_t i : grown.grains.instance) most = std::max(most, i);
  return most;
}

/// Goes through the seats of one place.
class SetPlace {
 public:
  SetPlace(const Template& variant, const PlaceSketch& place, VariantKey key, const GrowOptions& options)
      : variant_(variant),
        place_(place),
        key_(key),
        options_(options),
        draws_(key, "place/" + place.name),
        seats_(place_seats(variant, place, {.detail = options.detail, .key = key, .threads = options.threads})) {
    for (const int part : place.parts) part_names_.push_back(variant.parts[static_cast<std::size_t>(part)]);
  }

  /// Grows all individuals, lays them, presses them.
  void prepare(const GrowPlaced& grow_placed) {
    if (seats_.empty()) return;
    grow_individuals(grow_placed);
    const RandomStream pose_draws(key_, "place/" + place_.name + "/pose");
    for (std::size_t i = 0; i < seats_.size(); ++i)
      poses_.push_back(instance_pose(place_, seats_[i], individual(i).box, i, pose_draws, options_.scale));
    if (place_.press) find_cells();
    pressed_.resize(seats_.size());
    parallel_for(seats_.size(), options_.threads, [&](std::size_t i) {
      if (cells_.empty()) return;
      pressed_[i].swept = cells_[i].pressed(individual(i).grown.swept);
      pressed_[i].grains = cells_[i].pressed(individual(i).grown.grains);
    });
  }

  /// \return the number of the last instance
  std::int32_t collect(CollectedSurfaces& swept, CollectedSurfaces& grains, std::vector<Spot>& raised,
                       std::int32_t last) const {
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      const std::int32_t number = ++last;
      const Pressed& of = pressed_[i];
      const GrownFruit& grown = individual(i).grown;
      swept.add(cells_.empty() ? grown.swept : of.swept, poses_[i], place_.name, part_names_, number);
      grains.add(cells_.empty() ? grown.grains : of.grains, poses_[i], place_.name, part_names_, number);
      for (const Spot& spot : grown.raised) raised.push_back(laid(spot, poses_[i]));
      if (place_.stalk) add_stalk(swept, i, number);
      last += instances_within(grown);
    }
    return last;
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> crowded;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!cells_[i].is_crowded()) continue;
      crowded.push_back("place \"" + place_.name + "\": instance " + std::to_string(i + 1) +
                        " has no room between its neighbours, and may cross them");
      if (crowded.size() == 3) break;
    }
    return crowded;
  }

 private:
  struct Pressed {
    DiffusionSurfaces swept, grains;
  };

  std::size_t individual_count() const {
    if (is_drawn_key(key_)) return 1;
    const auto shared = static_cast<std::size_t>(place_.individuals);
    return shared == 0 ? seats_.size() : std::min(shared, seats_.size());
  }

  const IndividualGrown& individual(std::size_t instance) const { return individuals_[instance % individuals_.size()]; }

  VariantKey key_of(std::size_t i) const {
    if (is_drawn_key(key_)) return key_;
    return {draws_.bits(2 * i), draws_.bits(2 * i + 1)};
  }

  /// What is asked of the whole fruit holds for what is placed, as far as it can.
  GrowOptions options_within() const {
    GrowOptions within = options_;
    within.folds = {};
    within.scale = 1;
    within.browning = 0;
    within.detail = std::clamp(options_.detail * place_.detail, 0.1, 4.0);
    within.as_drawn = options_.as_drawn || is_drawn_key(key_);
    if (!place_.placed->ripeness.declared()) within.ripeness = {};
    return within;
  }

  void grow_individuals(const GrowPlaced& grow_placed) {
    std::vector<VariantKey> keys;
    for (std::size_t i = 0; i < individual_count(); ++i) keys.push_back(key_of(i));
    for (GrownFruit& grown : grow_placed(*place_.placed, keys, options_within())) {
      IndividualGrown one{std::move(grown), {}, {}};
      one.box = bounds_of(one.grown.swept);
      individuals_.push_back(std::move(one));
    }
    if (!place_.press) return;
    parallel_for(individuals_.size(), options_.threads,
                 [&](std::size_t i) { individuals_[i].reach = reach_of_individual(individuals_[i]); });
  }

  ReachTable reach_of_individual(const IndividualGrown& one) const {
    const std::string& name = place_.placed->surfaces[static_cast<std::size_t>(place_.press->surface)].name;
    const auto& names = one.grown.swept.surface_names;
    const auto skin = static_cast<std::int32_t>(std::find(names.begin(), names.end(), name) - names.begin());
    const glm::dvec3 heart(0, one.box.low.y + place_.press->heart * one.box.size().y, 0);
    ReachTable reach(one.grown.swept, skin, heart);
    if (!reach.is_closed())
      refuse_place(variant_, place_, "the skin \"" + name + "\" does not surround the heart from which it is pressed",
                   "name a closed surface, or move the heart");
    return reach;
  }

  /// Neighbours that do not give way: the ground at the seat, and surfaces that are as
  /// hard.
  std::vector<std::vector<PressWall>> walls() const {
    std::vector<std::vector<PressWall>> all(seats_.size());
    if (place_.press->root) {
      for (std::size_t i = 0; i < seats_.size(); ++i)
        all[i].push_back({seats_[i].center - seats_[i].normal * *place_.press->root, -seats_[i].normal});
    }
    std::vector<int> hard = place_.press->against;
    if (place_.stalk) hard.push_back(place_.stalk->from);
    for (const int surface : hard) {
      const std::vector<SweptGrid> grids =
          swept_grids(variant_, variant_.surfaces.at(static_cast<std::size_t>(surface)),
                      {.detail = options_.detail, .key = key_, .threads = options_.threads});
      for (std::size_t i = 0; i < seats_.size(); ++i) {
        if (const std::optional<PressWall> nearest = nearest_wall(grids, i)) all[i].push_back(*nearest);
      }
    }
    return all;
  }

  /// The plane towards the nearest place that has all of the surface within reach behind it.
  std::optional<PressWall> nearest_wall(const std::vector<SweptGrid>& grids, std::size_t i) const {
    const glm::dvec3 heart = poses_[i](individual(i).reach->heart());
    std::optional<glm::dvec3> nearest;
    for (const SweptGrid& grid : grids) {
      for (const glm::uvec3& t : grid.triangle) {
        const glm::dvec3 middle = (grid.position[t.x] + grid.position[t.y] + grid.position[t.z]) / 3.0;
        if (!nearest || glm::distance(middle, heart) < glm::distance(*nearest, heart)) nearest = middle;
      }
    }
    if (!nearest || *nearest == heart) return {};
    const glm::dvec3 normal = glm::normalize(*nearest - heart);
    const double within = 2 * poses_[i].scale * individual(i).reach->farthest();
    double least = glm::dot(*nearest - heart, normal);
    for (const SweptGrid& grid : grids) {
      for (const glm::dvec3& p : grid.position) {
        if (glm::distance(p, heart) < within) least = std::min(least, glm::dot(p - heart, normal));
      }
    }
    return PressWall{heart + normal * (least - place_.press->gap), normal};
  }

  void find_cells() {
    std::vector<PressedBody> bodies;
    for (std::size_t i = 0; i < seats_.size(); ++i) bodies.push_back({&*individual(i).reach, poses_[i]});
    const std::vector<std::vector<PressWall>> wall = walls();
    std::vector<std::optional<PressCell>> cells(bodies.size());
    parallel_for(bodies.size(), options_.threads,
                 [&](std::size_t i) { cells[i].emplace(*place_.press, bodies, i, wall[i]); });
    for (std::optional<PressCell>& cell : cells) cells_.push_back(std::move(*cell));
  }

  static Spot laid(Spot spot, const InstancePose& pose) {
    spot.center = pose(spot.center);
    spot.normal = pose.turned(spot.normal);
    spot.tangent = pose.turned(spot.tangent);
    spot.radius *= pose.scale;
    spot.relief *= pose.scale;
    return spot;
  }

  void add_stalk(CollectedSurfaces& swept, std::size_t i, std::int32_t number) const {
    const StalkSketch& stalk = *place_.stalk;
    const glm::dvec3 top = stalk_top(i), root = seats_[i].stalk_root;
    if (!(glm::distance(top, root) > stalk.depth)) return;
    const std::string& part = variant_.parts[static_cast<std::size_t>(stalk.part)];
    swept.add(stalk_between(stalk, part, root, top), {}, place_.name, {part}, number);
  }

  /// A little within the instance's skin, where its own axis leaves it.
  glm::dvec3 stalk_top(std::size_t i) const {
    const InstancePose& pose = poses_[i];
    const IndividualGrown& one = individual(i);
    const glm::dvec3 up(0, 1, 0);
    if (!one.reach) return pose({0, one.box.high.y - place_.stalk->depth / pose.scale, 0});
    const double reach = one.reach->along(up) * cells_[i].share(up);
    return pose(one.reach->heart() + up * std::max(0.0, reach - place_.stalk->depth / pose.scale));
  }

  const Template& variant_;
  const PlaceSketch& place_;
  VariantKey key_;
  const GrowOptions& options_;
  RandomStream draws_;
  std::vector<PlaceSeat> seats_;
  std::vector<std::string> part_names_;
  std::vector<IndividualGrown> individuals_;
  std::vector<InstancePose> poses_;
  std::vector<PressCell> cells_;  ///< none without a press
  std::vector<Pressed> pressed_;
};

}  // namespace

GrownFruit with_placed(GrownFruit fruit, const Template& variant, VariantKey key, const GrowOptions& options,
                       const GrowPlaced& grow_placed) {
  if (variant.places.empty()) return fruit;
  check_room(variant, options);
  CollectedSurfaces swept(std::move(fruit.swept)), grains(std::move(fruit.grains));
  std::vector<std::string> notes;
  std::int32_t last = 0;
  for (const PlaceSketch& place : variant.places) {
    SetPlace set(variant, place, key, options);
    set.prepare(grow_placed);
    last = set.collect(swept, grains, fruit.raised, last);
    const std::vector<std::string> more = set.notes();
    notes.insert(notes.end(), more.begin(), more.end());
  }
  fruit.swept = swept.take();
  fruit.swept.notes.insert(fruit.swept.notes.end(), notes.begin(), notes.end());
  fruit.grains = grains.take();
  fruit.skin = {};  // that of the fruit alone
  return fruit;
}

}  // namespace pomona
