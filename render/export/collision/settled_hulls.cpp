#include "render/export/collision/settled_hulls.h"

#include <algorithm>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "render/export/collision/hulls_apart.h"
#include "render/export/piece_words.h"

namespace pomona {

namespace {

std::vector<StandingHulls> standing_hulls(const Scene& scene, std::span<const std::vector<ConvexHull>> parts) {
  std::vector<StandingHulls> standing;
  for (const Instance& instance : scene.instances) {
    const auto solid = static_cast<std::size_t>(instance.solid);
    StandingHulls body{.parts = {},
                       .place = instance.pose.translation,
                       .rotation = glm::normalize(instance.pose.rotation),
                       .gives_way = is_fruit(scene.solids[solid])};
    for (const ConvexHull& part : parts[solid]) body.parts.push_back(&part);
    standing.push_back(std::move(body));
  }
  return standing;
}

}  // namespace

bool is_settled(const Scene& scene) {
  return std::any_of(scene.solids.begin(), scene.solids.end(),
                     [](const Solid& solid) { return !solid.origin.entry.empty(); });
}

std::vector<std::vector<ConvexHull>> settled_hulls(const Scene& scene, std::span<const std::vector<ConvexHull>> parts,
                                                   Threads threads) {
  std::vector<std::vector<ConvexHull>> result(scene.instances.size());
  if (!is_settled(scene)) return result;
  std::vector<TrimmedHulls> trimmed = hulls_apart(standing_hulls(scene, parts), threads);
  for (std::size_t i = 0; i < trimmed.size(); ++i) result[i] = std::move(trimmed[i].parts);
  return result;
}

std::vector<std::array<std::size_t, 2>> instances_that_overlap(const Scene& scene,
                                                               std::span<const std::vector<ConvexHull>> parts,
                                                               Threads threads) {
  return bodies_that_overlap(standing_hulls(scene, parts), threads);
}

}  // namespace pomona
