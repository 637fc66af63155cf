#include "render/texture/texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/mesh/edge_map.h"
#include "render/image/triangle_raster.h"

namespace pomona {

namespace {

constexpr int subsamples = 4;      // 2 x 2, where colours jump
constexpr float min_jump = 2e-3f;  // smallest jump of a linear channel
constexpr std::uint32_t unset = 0xffffffffu;

using Corners2 = std::array<glm::dvec2, 3>;

/// Barycentric coordinates of a point in the plane; undefined for a triangle without area.
glm::dvec3 barycentric(const Corners2& p, const glm::dvec2& q) {
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  const double b = cross(q - p[0], p[2] - p[0]) / area, c = cross(p[1] - p[0], q - p[0]) / area;
  return {1 - b - c, b, c};
}

struct NearestPlace {
  glm::dvec3 weight{0};
  double squared = std::numeric_limits<double>::infinity();
};

/// The place on the triangle's outline nearest to a point outside it.
NearestPlace nearest_on_outline(const Corners2& p, const glm::dvec2& q) {
  NearestPlace best;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 a = p[static_cast<std::size_t>(k)], e = p[static_cast<std::size_t>((k + 1) % 3)] - a;
    const double length = glm::dot(e, e);
    const double share = length > 0 ? std::clamp(glm::dot(q - a, e) / length, 0.0, 1.0) : 0.0;
    const glm::dvec2 d = q - (a + share * e);
    if (glm::dot(d, d) >= best.squared) continue;
    best.squared = glm::dot(d, d);
    best.weight = glm::dvec3(0);
    best.weight[k] = 1 - share;
    best.weight[(k + 1) % 3] = share;
  }
  return best;
}

/// One chart's texels, in a window of the atlas around it.
class ChartTexels {
 public:
  ChartTexels(const Solid& solid, const std::vector<Chart>& charts, std::size_t chart, const Atlas& atlas)
      : mesh_(solid.mesh), chart_(charts[chart]) {
    low_ = glm::max(glm::ivec2(glm::floor(atlas.corner[chart])) - 2, glm::ivec2(0));
    const glm::dvec2 high = atlas.corner[chart] + chart_.size * atlas.texels_per_metre;
    size_ = glm::min(glm::ivec2(glm::ceil(high)) + 2, atlas.size) - low_;
    for (const glm::dvec2& p : chart_.flat)
      at_.push_back(atlas.corner[chart] + p * atlas.texels_per_metre - glm::dvec2(low_));
    triangle_.assign(static_cast<std::size_t>(size_.x) * size_.y, unset);
    jump_.assign(triangle_.size(), -1);
  }

  std::vector<TexelSample> samples() {
    cover_middles();
    find_jumps();
    cover_subsamples();
    cover_edges();
    return gathered();
  }

 private:
  Corners2 corners(std::uint32_t t) const {
    const glm::uvec3& c = chart_.corners[t];
    return {at_[c.x], at_[c.y], at_[c.z]};
  }
  TriangleRaster<double> raster(std::uint32_t t) const {
    const Corners2 p = corners(t);
    return {p[0], p[1], p[2]};
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * size_.x + x; }

  /// Calls visit(x, y) for the texels of the window that a box, grown by `margin`, touches.
  template <typename Visit>
  void in_box(const glm::dvec2& low, const glm::dvec2& high, double margin, const Visit& visit) const {
    const glm::ivec2 from = glm::max(glm::ivec2(glm::floor(low - margin)), glm::ivec2(0));
    const glm::ivec2 to = glm::min(glm::ivec2(glm::floor(high + margin)), size_ - 1);
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) visit(x, y);
    }
  }
  template <typename Visit>
  void in_box(const Corners2& p, double margin, const Visit& visit) const {
    in_box(glm::min(p[0], glm::min(p[1], p[2])), glm::max(p[0], glm::max(p[1], p[2])), margin, visit);
  }

  void cover_middles() {
    for (std::uint32_t t = 0; t < chart_.corners.size(); ++t) {
      raster(t).for_covered({0.5, 1, {0, 0, size_.x - 1, size_.y - 1}}, [&](int x, int y, const glm::dvec3&) {
        std::uint32_t& owner = triangle_[index(x, y)];
        if (owner == unset) owner = t;
      });
    }
  }

  /// Marks the texels through which an edge runs whose two sides have different colours.
  void find_jumps() {
    EdgeMap<glm::uvec2> known;  // the solid's vertices at the edge's lower and higher place
    const auto differ = [&](std::uint32_t a, std::uint32_t b) {
      const Color d = glm::abs(mesh_.color[a] - mesh_.color[b]);
      return a != b && std::max({d.r, d.g, d.b}) > min_jump;
    };
    for (std::uint32_t t = 0; t < chart_.corners.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = chart_.corners[t][k], b = chart_.corners[t][(k + 1) % 3];
        const glm::uvec3& own = mesh_.triangle[chart_.triangles[t]];
        const EdgeKey edge(a, b);
        const glm::uvec2 side = a < b ? glm::uvec2(own[k], own[(k + 1) % 3]) : glm::uvec2(own[(k + 1) % 3], own[k]);
        const auto [other, is_new] = known.try_emplace(edge, side);
        if (!is_new && (differ(other.x, side.x) || differ(other.y, side.y))) mark_jump(at_[edge.low], at_[edge.high]);
      }
    }
  }

  void mark_jump(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 e = b - a;
    const double reach = 0.5 * (std::abs(e.x) + std::abs(e.y));
    in_box(glm::min(a, b), glm::max(a, b), 0, [&](int x, int y) {
      std::int32_t& number = jump_[index(x, y)];
      if (number >= 0 || std::abs(cross(e, glm::dvec2(x + 0.5, y + 0.5) - a)) > reach) return;
      number = jumps_++;
    });
  }

  static glm::dvec2 subsample(int x, int y, int k) { return {x + 0.25 + 0.5 * (k % 2), y + 0.25 + 0.5 * (k / 2)}; }

  void cover_subsamples() {
    sub_triangle_.assign(static_cast<std::size_t>(jumps_) * subsamples, unset);
    for (std::uint32_t t = 0; jumps_ > 0 && t < chart_.corners.size(); ++t) {
      in_box(corners(t), 0, [&](int x, int y) {
        const std::int32_t number = jump_[index(x, y)];
        for (int k = 0; number >= 0 && k < subsamples; ++k) {
          std::uint32_t& owner = sub_triangle_[static_cast<std::size_t>(number) * subsamples + k];
          if (owner == unset && raster(t).shares(subsample(x, y, k))) owner = t;
        }
      });
    }
  }

  /// Texels beside the chart that a look-up on it reads get its nearest place.
  void cover_edges() {
    nearest_.assign(triangle_.size(), {});
    nearest_triangle_.assign(triangle_.size(), unset);
    for (std::uint32_t t = 0; t < chart_.corners.size(); ++t) {
      const Corners2 p = corners(t);
      in_box(p, 1, [&](int x, int y) {
        const std::size_t i = index(x, y);
        if (triangle_[i] != unset) return;
        const NearestPlace place = nearest_on_outline(p, {x + 0.5, y + 0.5});
        if (place.squared >= std::min(2.0, nearest_[i].squared)) return;
        nearest_[i] = place;
        nearest_triangle_[i] = t;
      });
    }
  }

  std::vector<TexelSample> gathered() const {
    std::vector<TexelSample> samples;
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        const std::size_t before = samples.size(), i = index(x, y);
        for (int k = 0; jump_[i] >= 0 && k < subsamples; ++k)
          add(samples, x, y, sub_triangle_[static_cast<std::size_t>(jump_[i]) * subsamples + k], subsample(x, y, k));
        if (samples.size() > before) continue;
        if (triangle_[i] != unset) {
          add(samples, x, y, triangle_[i], {x + 0.5, y + 0.5});
        } else if (nearest_triangle_[i] != unset) {
          samples.push_back(
              {low_ + glm::ivec2(x, y), chart_.triangles[nearest_triangle_[i]], nearest_[i].weight, true});
        }
      }
    }
    return samples;
  }

  void add(std::vector<TexelSample>& samples, int x, int y, std::uint32_t t, const glm::dvec2& at) const {
    if (t == unset) return;
    samples.push_back({low_ + glm::ivec2(x, y), chart_.triangles[t], barycentric(corners(t), at), false});
  }

  const SolidMesh& mesh_;
  const Chart& chart_;
  glm::ivec2 low_{0}, size_{0};
  std::vector<glm::dvec2> at_;  // the chart's places in the window, texels

  std::vector<std::uint32_t> triangle_;  // per texel: that of the chart in which its middle lies
  std::vector<std::int32_t> jump_;       // per texel: its number among those with a jump of colours, or -1
  std::int32_t jumps_ = 0;
  std::vector<std::uint32_t> sub_triangle_;  // per jump and subsample
  std::vector<NearestPlace> nearest_;        // per texel outside
  std::vector<std::uint32_t> nearest_triangle_;
};

}  // namespace

std::vector<TexelSample> texel_samples(const Solid& solid, const std::vector<Chart>& charts, std::size_t chart,
                                       const Atlas& atlas) {
  if (atlas.speck[chart] != 0) return {};
  return ChartTexels(solid, charts, chart, atlas).samples();
}

}  // namespace pomona
