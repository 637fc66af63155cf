#include "render/diffusion/ray_surfaces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <glm/common.hpp>

#include "generator/diffusion/used_parts.h"
#include "generator/mesh/box.h"

namespace pomona {

namespace {

constexpr std::size_t max_in_leaf = 4;

/// Boxes are this much larger than what they hold, normalised: more than what rounding does to a crossing.
constexpr float slack = 0x1p-19f;

float half_area(const Box<float>& box) {
  const glm::vec3 size = box.size();
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// A triangle on its way into the tree.
struct BoxedTriangle {
  Box<float> box;
  glm::vec3 middle{0};
  std::uint32_t triangle = 0;
};

glm::uvec4 bits(const glm::vec3& corner, std::uint32_t last) {
  return {std::bit_cast<std::uint32_t>(corner.x), std::bit_cast<std::uint32_t>(corner.y),
          std::bit_cast<std::uint32_t>(corner.z), last};
}

/// The levels that halving `count` triangles needs.
int levels_for(std::size_t count) { return static_cast<int>(std::bit_width((count + max_in_leaf - 1) / max_in_leaf)); }

Box<float> bounds(std::span<const BoxedTriangle> part) {
  Box<float> box;
  for (const BoxedTriangle& p : part) box.add(p.box);
  return box;
}

/// Two parts of some triangles, the first `count` and the rest, with their boxes.
struct Split {
  std::size_t count = 0;
  Box<float> one, other;
};

/// Equal slices of a box, and what of the triangles has its middle in each.
class Bins {
 public:
  Bins(const Box<float>& box, int axis, std::span<const BoxedTriangle> part)
      : axis_(axis), low_(box.low[axis]), per_length_(bins * 0.9999f / (box.high[axis] - box.low[axis])) {
    for (const BoxedTriangle& p : part) {
      const auto bin = static_cast<std::size_t>(bin_of(p));
      box_[bin].add(p.box);
      ++count_[bin];
    }
  }

  int bin_of(const BoxedTriangle& p) const { return static_cast<int>((p.middle[axis_] - low_) * per_length_); }

  /// The border before which a bin goes into the first part, and that part: where rays have least work to do, by
  /// surface areas times triangles. A count of 0 if all are in one bin.
  std::pair<int, Split> best() const {
    // From the last bin backwards: the boxes behind each border.
    std::array<Box<float>, bins> after{};
    std::array<std::size_t, bins> count_after{};
    for (std::size_t border = bins - 1; border > 0; --border) {
      if (border + 1 < bins) {
        after[border] = after[border + 1];
        count_after[border] = count_after[border + 1];
      }
      after[border].add(box_[border]);
      count_after[border] += count_[border];
    }

    // From the first bin onwards: finds the border with the least work.
    std::pair<int, Split> best;
    float min = std::numeric_limits<float>::max();
    Box<float> before;
    std::size_t count = 0;
    for (std::size_t border = 1; border < bins; ++border) {
      before.add(box_[border - 1]);
      count += count_[border - 1];
      if (count == 0 || count_after[border] == 0) continue;
      const float cost = half_area(before) * static_cast<float>(count) +
                         half_area(after[border]) * static_cast<float>(count_after[border]);
      if (cost >= min) continue;
      min = cost;
      best = {static_cast<int>(border), {count, before, after[border]}};
    }
    return best;
  }

 private:
  static constexpr std::size_t bins = 16;
  int axis_;
  float low_, per_length_;
  std::array<Box<float>, bins> box_{};
  std::array<std::size_t, bins> count_{};
};

class RayTreeBuilder {
 public:
  explicit RayTreeBuilder(std::vector<BoxedTriangle>& placed) : placed_(placed) {
    node_.reserve(placed.size() / 2 + 1);
    const Box<float> all = bounds(placed_);
    const int root = child(0, placed.size(), all, 0);
    if (root == 0) return;

    // The triangles fit into one leaf: makes a root with this leaf only.
    node_.emplace_back();
    set(0, root, all, ~0, Box<float>{});
  }

  std::vector<RayNode> take() { return std::move(node_); }

 private:
  /// Triangles [first, first + count) as a child of a node, `depth` below the root.
  int child(std::size_t first, std::size_t count, const Box<float>& box, int depth) {
    if (count <= max_in_leaf) return ~static_cast<int>(8 * first + count);
    const std::size_t index = node_.size();
    node_.emplace_back();
    const Split parts = split({placed_.data() + first, count}, box, depth);
    const int one = child(first, parts.count, parts.one, depth + 1);
    const int other = child(first + parts.count, count - parts.count, parts.other, depth + 1);
    set(index, one, parts.one, other, parts.other);
    return static_cast<int>(index);
  }

  void set(std::size_t index, int one, const Box<float>& box, int other, const Box<float>& other_box) {
    node_[index] = {bits(box.low - slack, static_cast<std::uint32_t>(one)), bits(box.high + slack, 0),
                    bits(other_box.low - slack, static_cast<std::uint32_t>(other)), bits(other_box.high + slack, 0)};
  }

  /// Puts the triangles of the first part first.
  static Split split(std::span<BoxedTriangle> part, const Box<float>& box, int depth) {
    const glm::vec3 size = box.size();
    const int axis = longest_axis(size);

    // By surface area, unless all middles are in one bin or the tree gets too deep for halving.
    if (size[axis] > 0 && depth + levels_for(part.size()) < RaySurfaces::max_depth - 2) {
      const Bins bins(box, axis, part);
      const auto [border, found] = bins.best();
      if (found.count > 0) {
        std::partition(part.begin(), part.end(),
                       [&, last = border](const BoxedTriangle& p) { return bins.bin_of(p) < last; });
        return found;
      }
    }
    const std::size_t half = part.size() / 2;
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(part.begin(), middle, part.end(), [&](const BoxedTriangle& p, const BoxedTriangle& q) {
      return std::pair(p.middle[axis], p.triangle) < std::pair(q.middle[axis], q.triangle);
    });
    return {half, bounds(part.first(half)), bounds(part.subspan(half))};
  }

  std::vector<BoxedTriangle>& placed_;
  std::vector<RayNode> node_;
};

std::vector<glm::vec3> normalized_positions(const DiffusionSurfaces& surfaces, const RaySurfaces& frame) {
  std::vector<glm::vec3> positions;
  positions.reserve(surfaces.vertex_count());
  for (const glm::vec3& position : surfaces.position) positions.push_back(frame.normalized(position));
  return positions;
}

std::vector<BoxedTriangle> placed_triangles(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                            std::span<const glm::vec3> positions) {
  std::vector<BoxedTriangle> placed(tree.order.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    placed[i].triangle = tree.order[i];
    const glm::uvec3& corner = surfaces.triangle[tree.order[i]];
    for (int k = 0; k < 3; ++k) placed[i].box.add(positions[corner[k]]);
    placed[i].middle = placed[i].box.center();
  }
  return placed;
}

}  // namespace

glm::vec3 RaySurfaces::normalized(const glm::vec3& point) const {
  return glm::vec3((glm::dvec3(point) - middle) * scale);
}

RaySurfaces ray_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  RaySurfaces result;
  result.middle = tree.levels.back().front().center();
  int exponent = 0;
  std::frexp(tree.size, &exponent);
  result.scale = std::ldexp(1.0, 1 - exponent);

  const std::vector<glm::vec3> positions = normalized_positions(surfaces, result);
  std::vector<BoxedTriangle> placed = placed_triangles(surfaces, tree, positions);
  result.node = RayTreeBuilder(placed).take();

  // Everything else in the order of the leaves.
  UsedParts parts = used_parts(surfaces);
  result.used_parts = std::move(parts.part);
  result.triangle.reserve(placed.size());
  result.side.reserve(placed.size());
  result.color.reserve(2 * surfaces.vertex_count());
  for (const BoxedTriangle& p : placed) {
    RayTriangle corners;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = surfaces.triangle[p.triangle][k];
      corners.corner[k] = bits(positions[vertex], vertex);
    }
    result.triangle.push_back(corners);
    result.side.emplace_back(p.triangle, parts.front[p.triangle] | std::uint32_t{parts.back[p.triangle]} << 16);
  }
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    result.color.emplace_back(surfaces.front_color[v], 1);
    result.color.emplace_back(surfaces.back_color[v], 1);
  }
  return result;
}

}  // namespace pomona
