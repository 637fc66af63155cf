#include "render/diffusion/asked_fruits.h"

#include <algorithm>
#include <map>

#include "generator/base/morton.h"

namespace pomona {

namespace {

/// The points of a task along a Morton curve, so that neighbours follow each other.
void add_points(AskedFruit& asked, std::size_t task, std::span<const glm::vec3> points) {
  const std::vector<glm::dvec3> places(points.begin(), points.end());
  for (const std::uint32_t point : morton_order(places)) {
    asked.place.push_back({task, point});
    asked.sight.eye.push_back(asked.fruit->frame.normalized(points[point]));
  }
}

}  // namespace

std::vector<AskedFruit> asked_fruits(std::span<const DiffusionTask> tasks) {
  std::vector<AskedFruit> fruits;
  std::map<const DiffusionSurfaces*, std::size_t> index;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const auto [place, is_new] = index.emplace(tasks[t].surfaces, fruits.size());
    if (is_new) fruits.emplace_back().surfaces = tasks[t].surfaces;
    fruits[place->second].tasks.push_back(t);
  }
  std::stable_sort(fruits.begin(), fruits.end(), [](const AskedFruit& one, const AskedFruit& other) {
    return one.surfaces->triangle_count() > other.surfaces->triangle_count();
  });
  return fruits;
}

void make_ready(AskedFruit& asked, std::span<const DiffusionTask> tasks, KeptFruits& kept) {
  const KeptFruit found = kept.of(*asked.surfaces);
  asked.fruit = found.fruit;
  asked.sight = {found.fruit->number, &found.fruit->frame, {}, {}};
  asked.sight.surfaces = [surfaces = asked.surfaces, fruit = found.fruit] {
    return std::make_shared<const RaySurfaces>(ray_surfaces(*surfaces, fruit->tree, fruit->frame));
  };
  if (found.is_new) asked.sight.surfaces = [made = asked.sight.surfaces()] { return made; };
  for (const std::size_t task : asked.tasks) add_points(asked, task, tasks[task].points);
}

std::vector<TaskSights> sights_of_tasks(std::span<const AskedFruit> fruits, std::span<const DiffusionTask> tasks) {
  std::vector<TaskSights> sights;
  for (const DiffusionTask& task : tasks) {
    const std::size_t count = task.points.size();
    sights.push_back({nullptr, std::vector<PmvcValue>(count), std::vector<std::uint8_t>(count)});
  }
  for (const AskedFruit& asked : fruits) {
    for (const std::size_t task : asked.tasks) sights[task].fruit = asked.fruit;
    for (std::size_t i = 0; i < asked.place.size(); ++i) {
      const auto& [task, point] = asked.place[i];
      sights[task].value[point] = asked.seen[i].value;
      sights[task].near_surface[point] = asked.seen[i].near_surface ? 1 : 0;
    }
  }
  return sights;
}

}  // namespace pomona
