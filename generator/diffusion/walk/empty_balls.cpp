#include "generator/diffusion/walk/empty_balls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Cells of the coarse grid along an edge of the cube; a power of two.
constexpr int coarse = 8;

/// How often a coarse cell may be halved: down to 1/128 of the cube's edge.
constexpr int deepest = 4;

/// A cell with no more groups than this is not divided further.
constexpr std::size_t few_groups = 12;

/// A cell is far when its middle is this many times farther from all surfaces than from the cell's corners.
constexpr float far_away = 4;

/// Within this share of the distance from its cell's middle, a point takes the bound instead of looking closer.
constexpr float near_middle = 0.2f;

constexpr auto edge = static_cast<float>(EmptyBalls::half_edge);
constexpr float coarse_cell = 2 * edge / coarse;

float half_edge_at(int level) { return 0.5f * coarse_cell / static_cast<float>(1 << level); }

/// The middle of the child with the given bits, x lowest.
glm::vec3 middle_of_child(const glm::vec3& middle, unsigned child, float half) {
  return middle + half * glm::vec3((child & 1) != 0 ? 1 : -1, (child & 2) != 0 ? 1 : -1, (child & 4) != 0 ? 1 : -1);
}

bool is_nearer(const NearGroup& a, const NearGroup& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.group < b.group;
}

float min_of(const GroupDistances& squared) { return *std::min_element(squared.begin(), squared.end()); }

}  // namespace

EmptyBalls::EmptyBalls(TriangleFrames frames, Threads threads)
    : frames_(std::move(frames)), branches_(coarse * coarse * coarse) {
  parallel_for(branches_.size(), threads, [&](std::size_t i) {
    const glm::vec3 index(i % coarse, i / coarse % coarse, i / (coarse * coarse));
    branches_[i] = grown((index + 0.5f) * coarse_cell - edge);
  });
}

EmptyBalls::Branch EmptyBalls::grown(const glm::vec3& middle) const {
  std::vector<NearGroup> all(frames_.groups.size());
  for (std::uint32_t g = 0; g < all.size(); ++g) all[g].group = g;
  Branch branch;
  branch.cells.emplace_back();
  divide(branch, 0, middle, 0, std::move(all));
  return branch;
}

void EmptyBalls::divide(Branch& branch, std::size_t cell, const glm::vec3& middle, int level,
                        std::vector<NearGroup> candidates) const {
  // Measures the distance of each group from the middle.
  for (NearGroup& near : candidates) {
    near.distance = std::sqrt(min_of(squared_distances(frames_.groups[near.group], middle)));
  }
  const float nearest = std::min_element(candidates.begin(), candidates.end(), is_nearer)->distance;
  branch.cells[cell].distance = nearest;
  const float half = half_edge_at(level), to_corner = std::sqrt(3.0f) * half;
  if (nearest >= far_away * to_corner) {
    branch.cells[cell].count = is_far;
    return;
  }

  // A group is nearest somewhere in the cell only if it is not farther from the middle than this.
  const float reach = nearest + 2 * to_corner + 4 * static_cast<float>(slack);
  std::erase_if(candidates, [&](const NearGroup& near) { return near.distance > reach; });
  if (candidates.size() <= few_groups || level == deepest) {
    std::sort(candidates.begin(), candidates.end(), is_nearer);
    branch.cells[cell].first = static_cast<std::uint32_t>(branch.near.size());
    branch.cells[cell].count = static_cast<std::uint32_t>(candidates.size());
    branch.near.insert(branch.near.end(), candidates.begin(), candidates.end());
    return;
  }

  // Divides the cell into eight.
  const std::size_t first = branch.cells.size();
  branch.cells[cell].first = static_cast<std::uint32_t>(first);
  branch.cells[cell].count = is_divided;
  branch.cells.resize(first + 8);
  for (unsigned child = 0; child < 8; ++child) {
    divide(branch, first + child, middle_of_child(middle, child, 0.5f * half), level + 1, candidates);
  }
}

EmptyBalls::Place EmptyBalls::place_of(const glm::vec3& point) const {
  // The coarse cell.
  int index[3];
  glm::vec3 middle;
  for (int k = 0; k < 3; ++k) {
    index[k] = std::clamp(static_cast<int>((point[k] + edge) * (1 / coarse_cell)), 0, coarse - 1);
    middle[k] = (static_cast<float>(index[k]) + 0.5f) * coarse_cell - edge;
  }
  const Branch& branch = branches_[index[0] + coarse * (index[1] + coarse * index[2])];

  // The smallest cell in it.
  const Cell* cell = branch.cells.data();
  for (float half = 0.25f * coarse_cell; cell->count == is_divided; half *= 0.5f) {
    const unsigned child =
        (point.x >= middle.x ? 1u : 0u) | (point.y >= middle.y ? 2u : 0u) | (point.z >= middle.z ? 4u : 0u);
    middle = middle_of_child(middle, child, half);
    cell = &branch.cells[cell->first + child];
  }
  return {&branch, cell, glm::length(point - middle)};
}

double EmptyBalls::radius_at(const glm::dvec3& point) const {
  const glm::vec3 single(point);
  const Place place = place_of(single);
  const Cell& cell = *place.cell;
  double distance = 0;
  if (cell.count == is_far || place.from_middle < near_middle * cell.distance) {
    distance = cell.distance - place.from_middle;
  } else {
    distance = std::sqrt(min_squared_distance(frames_.groups.data(), &place.branch->near[cell.first], cell.count,
                                              place.from_middle, single));
  }
  return std::max(0.0, distance - slack);
}

std::vector<std::uint32_t> EmptyBalls::nearest_triangles(const glm::dvec3& point) const {
  const glm::vec3 single(point);
  const Place place = place_of(single);
  const Cell& cell = *place.cell;
  const NearGroup* near = &place.branch->near[cell.first];
  const float limit =
      std::sqrt(min_squared_distance(frames_.groups.data(), near, cell.count, place.from_middle, single)) +
      4 * static_cast<float>(slack);
  std::vector<std::uint32_t> found;
  for (std::size_t n = 0; n < cell.count && near[n].distance - place.from_middle <= limit; ++n) {
    const FrameGroup& group = frames_.groups[near[n].group];
    const GroupDistances squared = squared_distances(group, single);
    for (int i = 0; i < FrameGroup::size; ++i) {
      if (squared[i] <= limit * limit) found.push_back(group.triangle[i]);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace pomona
