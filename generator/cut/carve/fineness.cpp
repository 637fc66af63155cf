#include "generator/cut/carve/fineness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/bounding_volume_hierarchy.h"

namespace pomona {

namespace {

constexpr std::uint32_t leaf_size = 8;

double distance(const Box<double>& box, const glm::dvec3& place) {
  return glm::length(glm::max(glm::max(box.low - place, place - box.high), glm::dvec3(0)));
}

/// Puts the half of the sources that is lower along their longest side first, and returns its number.
std::uint32_t halved(std::span<FinenessSource> sources) {
  Box<double> box;
  for (const FinenessSource& source : sources) box.add(source.place);
  const glm::dvec3 sides = box.size();
  const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
  const auto half = static_cast<std::uint32_t>(sources.size() / 2);
  std::nth_element(sources.begin(), sources.begin() + half, sources.end(),
                   [&](const FinenessSource& a, const FinenessSource& b) { return a.place[axis] < b.place[axis]; });
  return half;
}

}  // namespace

Fineness::Fineness(std::vector<FinenessSource> sources, double grading)
    : source_(std::move(sources)), grading_(grading) {
  if (source_.empty()) return;
  node_ = bounding_volume_hierarchy<Node>(
      static_cast<std::uint32_t>(source_.size()), leaf_size,
      [&](std::uint32_t first, std::uint32_t count) { return halved(std::span(source_).subspan(first, count)); });
  for (std::size_t node = node_.size(); node-- > 0;) fill(node_[node]);
}

void Fineness::fill(Node& node) const {
  node.min = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    node.box.add(source_[i].place);
    node.min = std::min(node.min, source_[i].size);
  }
  if (node.count > 0) return;
  for (const Node& child : {node_[node.first], node_[node.first + 1]}) {
    node.box.add(child.box);
    node.min = std::min(node.min, child.min);
  }
}

double Fineness::at(const glm::dvec3& place, double max) const {
  if (node_.empty()) return max;
  double size = max;

  // 2^32 sources make 32 levels, each of which leaves one node behind.
  std::array<std::uint32_t, 64> stack{};
  std::size_t height = 1;
  while (height > 0) {
    const Node& node = node_[stack[--height]];
    if (node.min + grading_ * distance(node.box, place) >= size) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      size = std::min(size, source_[i].size + grading_ * glm::distance(place, source_[i].place));
    }
    if (node.count > 0) continue;
    const auto away = [&](std::uint32_t child) { return distance(node_[child].box, place); };
    const bool left_is_nearer = away(node.first) <= away(node.first + 1);
    stack[height++] = left_is_nearer ? node.first + 1 : node.first;
    stack[height++] = left_is_nearer ? node.first : node.first + 1;
  }
  return size;
}

}  // namespace pomona
