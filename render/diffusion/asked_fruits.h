// The fruits of some diffusion tasks, with the points of each.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "generator/diffusion/diffuser.h"
#include "render/diffusion/gl_pmvc.h"
#include "render/diffusion/kept_fruits.h"

namespace pomona {

/// A fruit, and all points at which its colours are wanted.
struct AskedFruit {
  const DiffusionSurfaces* surfaces = nullptr;
  std::vector<std::size_t> tasks;

  // The result of make_ready().
  std::shared_ptr<const PreparedFruit> fruit;
  SightTask sight;
  struct Place {
    std::size_t task = 0;
    std::uint32_t point = 0;
  };
  std::vector<Place> place;  ///< by eye of `sight`

  std::vector<PointSight> seen;  ///< by eye, when the card is done
};

/// Each fruit once, however many sections it has. Those with many triangles come first, because they take longest.
std::vector<AskedFruit> asked_fruits(std::span<const DiffusionTask> tasks);

/// Finds the fruit or makes it, and orders its points. The tree of a kept fruit is made again if the card no longer has
/// it.
void make_ready(AskedFruit& asked, std::span<const DiffusionTask> tasks, KeptFruits& kept);

/// What the points of a task see, in their order.
struct TaskSights {
  std::shared_ptr<const PreparedFruit> fruit;
  std::vector<PmvcValue> value;
  std::vector<std::uint8_t> near_surface;
};
std::vector<TaskSights> sights_of_tasks(std::span<const AskedFruit> fruits, std::span<const DiffusionTask> tasks);

}  // namespace pomona
