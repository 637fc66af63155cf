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

namespace pomona {

namespace {

constexpr std::size_t most_in_leaf = 4;

/// Boxes are this much larger than what they hold, normalised: more than what rounding does to a crossing.
constexpr float slack = 0x1p-19f;

struct FloatBox {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  void grow(const glm::vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void grow(const FloatBox& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  float half_area() const {
    const glm::vec3 size = high - low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }
};

/// A triangle on its way into the tree.
struct Placed {
  FloatBox box;
  glm::vec3 middle{0};
  std::uint32_t triangle = 0;
};

glm::uvec4 bits(const glm::vec3& corner, std::uint32_t last) {
  return {std::bit_cast<std::uint32_t>(corner.x), std::bit_cast<std::uint32_t>(corner.y),
          std::bit_cast<std::uint32_t>(corner.z), last};
}

/// The levels that halving `count` triangles needs.
int levels_for(std::size_t count) {
  return static_cast<int>(std::bit_width((count + most_in_leaf - 1) / most_in_leaf));
}

class TreeBuilder {
 public:
  explicit TreeBuilder(std::vector<Placed>& placed) : placed_(placed) {
    node_.reserve(placed.size() / 2);
    const int root = child(0, placed_.size(), 0);
    if (root == 0) return;

    // So few triangles that they are one leaf: a root above it, with nothing beside it.
    node_.emplace_back();
    set(0, {child(0, placed_.size(), 0), bounds(0, placed_.size())}, {~0, FloatBox{}});
  }

  std::vector<RayNode> take() { return std::move(node_); }

 private:
  struct Child {
    int index = 0;
    FloatBox box;
  };

  /// Triangles [first, first + count) as a child of a node, `depth` below the root.
  int child(std::size_t first, std::size_t count, int depth) {
    if (count <= most_in_leaf) return ~static_cast<int>(8 * first + count);
    const std::size_t index = node_.size();
    node_.emplace_back();
    const std::size_t left = split(first, count, depth);
    const Child one{child(first, left, depth + 1), bounds(first, left)};
    const Child other{child(first + left, count - left, depth + 1), bounds(first + left, count - left)};
    set(index, one, other);
    return static_cast<int>(index);
  }

  void set(std::size_t index, const Child& one, const Child& other) {
    node_[index] = {bits(one.box.low - slack, static_cast<std::uint32_t>(one.index)), bits(one.box.high + slack, 0),
                    bits(other.box.low - slack, static_cast<std::uint32_t>(other.index)),
                    bits(other.box.high + slack, 0)};
  }

  FloatBox bounds(std::size_t first, std::size_t count) const {
    FloatBox box;
    for (std::size_t i = first; i < first + count; ++i) box.grow(placed_[i].box);
    return box;
  }

  /// Puts the triangles of the first child first, and says how many they are.
  std::size_t split(std::size_t first, std::size_t count, int depth) {
    const std::span<Placed> part(placed_.data() + first, count);
    FloatBox middles;
    for (const Placed& p : part) middles.grow(p.middle);
    const glm::vec3 size = middles.high - middles.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);

    // By surface area, unless the middles coincide or the tree gets too deep for halving.
    if (size[axis] > 0 && depth + levels_for(count) < RaySurfaces::most_depth - 2) {
      const float per_length = bins * 0.9999f / size[axis];
      const auto bin_of = [&](const Placed& p) {
        return static_cast<int>((p.middle[axis] - middles.low[axis]) * per_length);
      };
      const int best = best_border(part, bin_of);
      const auto border =
          std::stable_partition(part.begin(), part.end(), [&](const Placed& p) { return bin_of(p) < best; });
      const auto left = static_cast<std::size_t>(border - part.begin());
      if (left > 0 && left < count) return left;
    }
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(part.begin(), middle, part.end(), [&](const Placed& p, const Placed& q) {
      return std::pair(p.middle[axis], p.triangle) < std::pair(q.middle[axis], q.triangle);
    });
    return count / 2;
  }

  /// The number of bins, of 1 ... bins - 1, whose triangles go into the first child.
  template <typename BinOf>
  int best_border(std::span<const Placed> part, const BinOf& bin_of) const {
    std::array<FloatBox, bins> box{};
    std::array<std::size_t, bins> count{};
    for (const Placed& p : part) {
      const int bin = bin_of(p);
      box[bin].grow(p.box);
      ++count[bin];
    }

    // What the bins from each border on would cost, then what those before it do.
    std::array<float, bins> after{};
    FloatBox grown;
    std::size_t sum = 0;
    for (int border = bins - 1; border > 0; --border) {
      grown.grow(box[border]);
      sum += count[border];
      after[border] = sum == 0 ? 0 : grown.half_area() * static_cast<float>(sum);
    }
    grown = FloatBox{};
    sum = 0;
    int best = 1;
    float least = std::numeric_limits<float>::max();
    for (int border = 1; border < bins; ++border) {
      grown.grow(box[border - 1]);
      sum += count[border - 1];
      const float cost = after[border] + (sum == 0 ? 0 : grown.half_area() * static_cast<float>(sum));
      if (cost < least) {
        least = cost;
        best = border;
      }
    }
    return best;
  }

  static constexpr int bins = 16;
  std::vector<Placed>& placed_;
  std::vector<RayNode> node_;
};

std::vector<Placed> placed_triangles(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                     const RaySurfaces& frame) {
  std::vector<Placed> placed(tree.order.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    placed[i].triangle = tree.order[i];
    for (int k = 0; k < 3; ++k) {
      placed[i].box.grow(frame.normalized(surfaces.position[surfaces.triangle[tree.order[i]][k]]));
    }
    placed[i].middle = 0.5f * (placed[i].box.low + placed[i].box.high);
  }
  return placed;
}

}  // namespace

glm::vec3 RaySurfaces::normalized(const glm::vec3& point) const {
  return glm::vec3((glm::dvec3(point) - middle) * scale);
}

RaySurfaces ray_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  RaySurfaces result;
  const Box& all = tree.levels.back().front();
  result.middle = 0.5 * (all.low + all.high);
  int exponent = 0;
  std::frexp(tree.size, &exponent);
  result.scale = std::ldexp(1.0, 1 - exponent);

  std::vector<Placed> placed = placed_triangles(surfaces, tree, result);
  result.node = TreeBuilder(placed).take();

  // Everything else in the order of the leaves.
  UsedParts parts = used_parts(surfaces);
  result.used_parts = std::move(parts.part);
  for (const Placed& p : placed) {
    RayTriangle corners;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = surfaces.triangle[p.triangle][k];
      corners.corner[k] = bits(result.normalized(surfaces.position[vertex]), vertex);
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
