#include "generator/diffusion/pmvc/group_boxes.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "generator/mesh/box.h"

namespace pomona {

namespace {

Box<float> box_of(const TriangleGroup& group) {
  Box<float> box;
  for (int i = 0; i < TriangleGroup::size; ++i) {
    for (int k = 0; k < 3; ++k) {
      box.add({group.corner[3 * k][i], group.corner[3 * k + 1][i], group.corner[3 * k + 2][i]});
    }
  }
  return box;
}

/// Boxes around runs of neighbouring points, few enough to compare every group with all.
std::vector<Box<float>> boxes_of(std::span<const glm::vec3> points) {
  constexpr std::size_t max_boxes = 64;
  const std::size_t run = (points.size() + max_boxes - 1) / max_boxes;
  std::vector<Box<float>> boxes((points.size() + run - 1) / run);
  for (std::size_t i = 0; i < points.size(); ++i) boxes[i / run].add(points[i]);
  return boxes;
}

}  // namespace

GroupBoxes nearest_first(const PackedSurfaces& surfaces, std::span<const glm::vec3> points) {
  // Sort by distance, then by index.
  const std::vector<Box<float>> near = boxes_of(points);
  std::vector<Box<float>> boxes;
  std::vector<std::pair<float, std::uint32_t>> sorted;
  for (const TriangleGroup& group : surfaces.groups) {
    boxes.push_back(box_of(group));
    float distance = std::numeric_limits<float>::infinity();
    for (const Box<float>& box : near) distance = std::min(distance, squared_distance(box, boxes.back()));
    sorted.emplace_back(distance, static_cast<std::uint32_t>(sorted.size()));
  }
  std::sort(sorted.begin(), sorted.end());

  constexpr auto step = static_cast<std::size_t>(TriangleGroup::size);
  const std::size_t padded = (sorted.size() + step - 1) / step * step;
  GroupBoxes result;
  for (const auto& [distance, group] : sorted) result.group.push_back(group);
  for (int axis = 0; axis < 3; ++axis) {
    AlignedFloats& middle = result.middle[static_cast<std::size_t>(axis)];
    AlignedFloats& half = result.half[static_cast<std::size_t>(axis)];
    middle = aligned_array<float>(padded);
    half = aligned_array<float>(padded);
    std::fill_n(middle.get(), padded, 1e30f);
    std::fill_n(half.get(), padded, 0.0f);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const Box<float>& box = boxes[sorted[i].second];
      middle[i] = 0.5f * (box.low[axis] + box.high[axis]);
      half[i] = 0.5f * (box.high[axis] - box.low[axis]);
    }
  }
  return result;
}

}  // namespace pomona
