#include "generator/cut/carve/fineness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr std::uint32_t leaf_size = 8;

double distance(const Box<double>& box, const glm::dvec3& place) {
  return glm::length(glm::max(glm::max(box.low - place, place - box.high), glm::dvec3(0)));
}

}  // namespace

Fineness::Fineness(std::vector<FinenessSource> sources, double grading)
    : source_(std::move(sources)), grading_(grading) {
  if (source_.empty()) return;
  node_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(source_.size()));
}

/// Halves at the median along the longest side.
void Fineness::split(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  // The node holds these sources.
  Node made;
  made.first = first;
  made.count = count;
  made.least = source_[first].size;
  for (std::uint32_t i = first; i < first + count; ++i) {
    made.box.add(source_[i].place);
    made.least = std::min(made.least, source_[i].size);
  }
  if (count <= leaf_size) {
    node_[node] = made;
    return;
  }

  // Too many for a leaf: two halves take them over.
  const glm::dvec3 sides = made.box.high - made.box.low;
  const int axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
  const auto begin = source_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](const FinenessSource& a, const FinenessSource& b) { return a.place[axis] < b.place[axis]; });
  made.first = static_cast<std::uint32_t>(node_.size());
  made.count = 0;
  node_[node] = made;
  node_.resize(node_.size() + 2);
  split(made.first, first, count / 2);
  split(made.first + 1, first + count / 2, count - count / 2);
}

double Fineness::at(const glm::dvec3& place, double most) const {
  if (node_.empty()) return most;
  double size = most;

  // 2^32 sources make 32 levels, each of which leaves one node behind.
  std::array<std::uint32_t, 64> stack{};
  std::size_t height = 1;
  while (height > 0) {
    const Node& node = node_[stack[--height]];
    if (node.least + grading_ * distance(node.box, place) >= size) continue;
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
