#include "generator/diffusion/harmonic/crossings.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pomona {

namespace {

using Units = std::array<std::int64_t, 3>;
__extension__ using Wide = __int128;

/// The smallest depth, in arms, that doubles distinguish from 0; their error is below 1e-11.
constexpr double clearly = 1e-9;

std::int64_t floor_shift(std::int64_t value, int bits) { return value >> bits; }
std::int64_t ceil_shift(std::int64_t value, int bits) { return -((-value) >> bits); }

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

/// The triangle seen along one axis: coordinates a lie along the axis, b and c across it.
struct Projected {
  int axis = 0;
  std::array<std::int64_t, 3> a{}, b{}, c{};
  std::int64_t area = 0;  ///< twice, made positive; the normal's component along the axis had the sign `facing`
  int facing = 0;
  std::array<bool, 3> owns_edge{};  ///< whether a line that meets edge k, opposite to corner k, counts as inside

  /// Twice the area between edge k and a line, positive inside.
  std::int64_t edge(std::size_t k, std::int64_t at_b, std::int64_t at_c) const {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return facing * ((b[j] - b[i]) * (at_c - c[i]) - (c[j] - c[i]) * (at_b - b[i]));
  }
};

Projected projected(const std::array<Units, 3>& corner, int axis) {
  Projected p;
  p.axis = axis;
  const auto a = static_cast<std::size_t>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
  for (std::size_t k = 0; k < 3; ++k) {
    p.a[k] = corner[k][a];
    p.b[k] = corner[k][b];
    p.c[k] = corner[k][c];
  }
  p.area = (p.b[1] - p.b[0]) * (p.c[2] - p.c[0]) - (p.c[1] - p.c[0]) * (p.b[2] - p.b[0]);
  p.facing = sign(p.area);
  p.area *= p.facing;

  // Moving a line by (eb, ec) changes edge() by facing * (db * ec - dc * eb); the larger of eb and ec decides.
  const bool b_is_larger = axis != 1;  // x: y before z; y: z after x; z: x before y
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const int by_b = -sign(p.c[j] - p.c[i]), by_c = sign(p.b[j] - p.b[i]);
    const int first = b_is_larger ? by_b : by_c, second = b_is_larger ? by_c : by_b;
    p.owns_edge[k] = p.facing * (first != 0 ? first : second) > 0;
  }
  return p;
}

/// Visits the triangles one by one, and for each the lines that it may cross.
class Crosser {
 public:
  Crosser(const SnappedSurfaces& snapped, const Lattice& lattice, int first_z, int end_z)
      : snapped_(snapped), bits_(lattice.unit_bits), count_(lattice.count), first_z_(first_z), end_z_(end_z) {}

  /// Reserves memory for about as many crossings as these triangles will have.
  void expect(std::span<const std::uint32_t> triangles) {
    // The number of crossings along an axis is about the area seen along that axis, in cells.
    double twice = 0;
    for (const std::uint32_t triangle : triangles) {
      set(triangle);
      for (const std::int64_t n : normal_) twice += std::fabs(static_cast<double>(n));
    }
    const auto arms = static_cast<std::size_t>(0.5 * std::ldexp(twice, -2 * bits_));
    found_.reserve(std::min(arms + arms / 8, 64 * triangles.size()) + 256);
  }

  void cross(std::uint32_t triangle) {
    set(triangle);
    for (int axis = 0; axis < 3; ++axis) {
      if (normal_[static_cast<std::size_t>(axis)] != 0) cross_lines_along(projected(corner_, axis));
    }
  }

  std::vector<ArmCrossing> found() { return std::move(found_); }

 private:
  void set(std::uint32_t triangle) {
    triangle_ = triangle;
    const glm::uvec3& t = snapped_.surfaces->triangle[triangle];
    corner_ = {snapped_.position[t.x], snapped_.position[t.y], snapped_.position[t.z]};
    Units u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = corner_[1][k] - corner_[0][k];
      v[k] = corner_[2][k] - corner_[0][k];
    }
    normal_ = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

  /// The nodes between the smallest and the largest of three coordinates.
  std::pair<std::int64_t, std::int64_t> span(const std::array<std::int64_t, 3>& v, std::size_t axis) const {
    std::int64_t low = ceil_shift(std::min({v[0], v[1], v[2]}), bits_);
    std::int64_t high = floor_shift(std::max({v[0], v[1], v[2]}), bits_);
    if (axis == 2) {
      low = std::max<std::int64_t>(low, first_z_);
      high = std::min<std::int64_t>(high, end_z_ - 1);
    }
    return {std::max<std::int64_t>(low, 0), std::min<std::int64_t>(high, count_[axis] - 1)};
  }

  void cross_lines_along(const Projected& p) {
    const auto a = static_cast<std::size_t>(p.axis);
    const auto [low_b, high_b] = span(p.b, (a + 1) % 3);
    const auto [low_c, high_c] = span(p.c, (a + 2) % 3);
    const std::int64_t step = std::int64_t{1} << bits_;
    for (std::int64_t c = low_c; c <= high_c; ++c) {
      std::array<std::int64_t, 3> edge{}, change{};
      for (std::size_t k = 0; k < 3; ++k) {
        edge[k] = p.edge(k, low_b * step, c * step);
        change[k] = -p.facing * (p.c[(k + 2) % 3] - p.c[(k + 1) % 3]) * step;
      }
      for (std::int64_t b = low_b; b <= high_b; ++b) {
        if (is_inside(p, edge)) cross_line(p, edge, b, c);
        for (std::size_t k = 0; k < 3; ++k) edge[k] += change[k];
      }
    }
  }

  static bool is_inside(const Projected& p, const std::array<std::int64_t, 3>& edge) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (edge[k] < 0 || (edge[k] == 0 && !p.owns_edge[k])) return false;
    }
    return true;
  }

  void cross_line(const Projected& p, const std::array<std::int64_t, 3>& edge, std::int64_t b, std::int64_t c) {
    // Find where on the triangle the line meets it, and how far along the line that is, in nodes.
    const auto a = static_cast<std::size_t>(p.axis);
    std::array<double, 3> weight{};
    double depth = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      weight[k] = static_cast<double>(edge[k]) / static_cast<double>(p.area);
      depth += weight[k] * static_cast<double>(p.a[k]);
    }
    depth /= static_cast<double>(std::int64_t{1} << bits_);

    // Find the arm that is crossed, if it belongs to the lattice and has an end in this range of planes.
    Node node{};
    node[(a + 1) % 3] = static_cast<int>(b);
    node[(a + 2) % 3] = static_cast<int>(c);
    node[a] = arm_at(p, depth, node);
    if (node[a] < 0 || node[a] + 1 >= count_[a]) return;
    if (a == 2 && (node[2] + 1 < first_z_ || node[2] >= end_z_)) return;

    // The arm is kept with the crossing's distance from its node, in arms.
    const double theta = std::clamp(depth - node[a], 0.0, 1.0);
    found_.push_back({triangle_,
                      node,
                      p.axis,
                      static_cast<float>(theta),
                      {static_cast<float>(weight[0]), static_cast<float>(weight[1]), static_cast<float>(weight[2])},
                      p.facing > 0});
  }

  /// The node just behind the crossing.
  int arm_at(const Projected& p, double depth, Node node) const {
    const double nearest = std::floor(depth + 0.5);
    const int behind = static_cast<int>(std::floor(depth));
    if (std::fabs(depth - nearest) > clearly) return behind;
    const int close = static_cast<int>(nearest);
    node[static_cast<std::size_t>(p.axis)] = close;
    return side_of(node) * p.facing < 0 ? close : close - 1;
  }

  /// +1 in front of the triangle's plane, -1 behind it, for the node moved by (e1, e2, e3).
  int side_of(const Node& node) const {
    Wide height = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      height += static_cast<Wide>(normal_[k]) * ((static_cast<std::int64_t>(node[k]) << bits_) - corner_[0][k]);
    }
    if (height != 0) return height > 0 ? 1 : -1;
    for (const std::int64_t n : normal_) {
      if (n != 0) return sign(n);
    }
    return 1;
  }

  const SnappedSurfaces& snapped_;
  int bits_;
  Node count_;
  int first_z_, end_z_;
  std::uint32_t triangle_ = 0;
  std::array<Units, 3> corner_{};
  Units normal_{};
  std::vector<ArmCrossing> found_;
};

}  // namespace

std::vector<ArmCrossing> arm_crossings(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles,
                                       const Lattice& lattice, int first_z, int end_z) {
  Crosser crosser(snapped, lattice, first_z, end_z);
  crosser.expect(triangles);
  for (const std::uint32_t triangle : triangles) crosser.cross(triangle);
  return crosser.found();
}

}  // namespace pomona
