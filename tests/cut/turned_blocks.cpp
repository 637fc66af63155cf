#include "tests/cut/turned_blocks.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/cut/cut.h"
#include "tests/shapes/shapes.h"

namespace pomona::oracle {

namespace {

using Ways = std::array<glm::dvec3, 3>;  // unit vectors along the block's edges

Ways random_turn(const RandomStream& random, std::uint64_t draw) {
  Ways way;
  for (std::uint64_t k = 0; k < 2; ++k)
    for (std::uint64_t c = 0; c < 3; ++c) way[k][static_cast<int>(c)] = random.uniform(draw + 3 * k + c) - 0.5;
  way[0] = glm::normalize(way[0]);
  way[2] = glm::normalize(glm::cross(way[0], way[1]));
  way[1] = glm::cross(way[2], way[0]);
  return way;
}

Knife knife_at(const glm::dvec3& normal, double offset) { return {PlaneCut(PlaneKnife{{normal, offset}})}; }

/// From -1e-7 to 1e-7 m, small ones as often as large ones.
double near_nothing(const RandomStream& random, std::uint64_t draw, std::uint64_t number) {
  const double highest = number % 3 == 1 ? -10 : -7;
  const double size = reproducible::exp((highest - 3 * random.uniform(draw)) * reproducible::log(10.0));
  return number % 3 == 0 ? 0 : random.below(draw + 1, 2) == 0 ? size : -size;
}

}  // namespace

BlockCut turned_block_cut(const RandomStream& random, std::uint64_t number) {
  constexpr std::uint64_t draws = 64;
  const std::uint64_t draw = draws * number;
  glm::dvec3 half, middle;
  for (int k = 0; k < 3; ++k) {
    const auto c = static_cast<std::uint64_t>(k);
    half[k] = 0.002 + 0.02 * random.uniform(draw + c);
    middle[k] = number % 4 == 3 ? 0.1 * random.uniform(draw + 3 + c) : 0;
  }
  const Ways way = random_turn(random, draw + 6);
  BlockCut task;
  task.block = shapes::box(-half, half, 1 + static_cast<int>(random.below(draw + 12, 3)), shapes::skin_paint());
  for (glm::vec3& p : task.block.position) {
    const glm::dvec3 q(p);
    p = glm::vec3(middle + q.x * way[0] + q.y * way[1] + q.z * way[2]);
  }
  task.volume = shapes::signed_volume(task.block);

  const std::size_t planes = 2 + random.below(draw + 13, 5), first = random.below(draw + 14, 6);
  const double out = near_nothing(random, draw + 15, number);
  for (std::size_t k = 0; k < planes; ++k) {
    const std::size_t face = (first + k) % 6, axis = face % 3;
    glm::dvec3 normal = (face < 3 ? 1.0 : -1.0) * way[axis];
    if (number % 2 == 1)
      normal = glm::normalize(normal + out / glm::length(half) * way[(axis + 1) % 3] * (random.uniform(draw + 20 + k)));
    const glm::dvec3 on_face = middle + half[static_cast<int>(axis)] * (face < 3 ? 1.0 : -1.0) * way[axis];
    task.knives.push_back(knife_at(normal, glm::dot(normal, on_face) + out));
  }
  return task;
}

BlockFaults faults_of(const BlockCut& task) {
  CutOptions options;
  options.coarsest = 0.2;
  options.finest = 0.1;
  options.threads = {1};
  BlockFaults faults;
  double sum = 0;
  for (const CutPiece& piece : cut(task.block, task.knives, options).pieces) {
    faults.open += piece.closed ? 0 : 1;
    faults.without_volume += piece.volume > 0 ? 0 : 1;
    sum += piece.volume;
  }
  faults.volume_error = std::fabs(sum - task.volume) / task.volume;
  return faults;
}

}  // namespace pomona::oracle
