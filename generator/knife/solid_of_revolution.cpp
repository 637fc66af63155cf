#include "generator/knife/solid_of_revolution.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr std::size_t max_triangles = 500000;

/// The outline of the region between a profile and the axis, counter-clockwise. Of an open profile it begins and ends
/// on the axis and stays an open curve; a closed one is its own outline.
Curve around_region(Curve profile) {
  if (!profile.closed) {
    profile = joined_to_axis(std::move(profile));
    profile.points.front().x = profile.points.back().x = 0;
  }
  if (signed_area({profile.points, true}) < 0) std::reverse(profile.points.begin(), profile.points.end());
  return profile;
}

/// Turns an outline about the axis: each of its points becomes a row of vertices, and triangles go between rows.
class Revolution {
 public:
  explicit Revolution(const RevolveOptions& options) : options_(options) {}

  ClosedSurface make(const Curve& region) {
    const std::vector<glm::dvec2> points = rows_of(region);
    check(points);
    for (const glm::dvec2& p : points) add_row(p);
    for (std::size_t i = 1; i < rows_.size(); ++i) join(rows_[i - 1], rows_[i]);
    if (region.closed) join(rows_.back(), rows_.front());
    return std::move(solid_);
  }

 private:
  struct Row {
    std::uint32_t first = 0, count = 1;  ///< one vertex on the axis, or a ring
  };

  /// The length of a chord at this distance from a circle of this radius.
  double chord(double radius) const { return std::sqrt(8 * radius * options_.tolerance); }

  /// The outline's points, and more on its straight edges, so that triangles are at most three times as long as wide.
  std::vector<glm::dvec2> rows_of(const Curve& region) const {
    std::vector<glm::dvec2> rows{region.points.front()};
    const std::size_t edges = region.points.size() - (region.closed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
      const glm::dvec2 a = region.points[i], b = region.points[(i + 1) % region.points.size()];
      const double steps = std::clamp(std::ceil(glm::distance(a, b) / (3 * chord(std::max(a.x, b.x)))), 1.0, 1e5);
      for (double k = 1; k <= steps; ++k) rows.push_back(k == steps ? b : a + k / steps * (b - a));
    }
    if (region.closed) rows.pop_back();
    return rows;
  }

  /// \throws Error (usage) for too many triangles to cut with in reasonable time.
  void check(const std::vector<glm::dvec2>& rows) const {
    double triangles = 0;
    for (const glm::dvec2& p : rows) triangles += 2 * static_cast<double>(count_at(p.x));
    if (triangles <= max_triangles) return;
    throw Error(ExitStatus::usage, "a profile needs more than " + std::to_string(max_triangles) + " triangles",
                "draw it with fewer points, or make it shorter beside its width");
  }

  /// How many vertices a ring of this radius has: six times a power of two, or half as many again. Rings of similar
  /// radii then have equally many, and their triangles are alike.
  std::uint32_t count_at(double radius) const {
    if (radius == 0) return 1;

    // A chord may differ from its circle by the tolerance; takes the smallest multiple that is enough.
    const double wanted = pi * std::sqrt(radius / (2 * options_.tolerance));
    std::uint32_t count = 6;
    while (count < wanted && count < max_triangles) {
      if (1.5 * count >= wanted && count % 2 == 0) return count / 2 * 3;
      count *= 2;
    }
    return count;
  }

  void add_row(const glm::dvec2& p) {
    const Row row{static_cast<std::uint32_t>(solid_.point.size()), count_at(p.x)};
    for (std::uint32_t i = 0; i < row.count; ++i) {
      const double turn = 2 * pi * i / row.count;
      solid_.point.emplace_back(p.x * reproducible::cos(turn), p.y, -p.x * reproducible::sin(turn));
    }
    rows_.push_back(row);
  }

  /// Triangles between two rows. Goes round both at once: the row whose next vertex comes first, by its share of the
  /// full turn, takes the next triangle. A row that is one vertex on the axis takes none.
  void join(const Row& low, const Row& high) {
    std::uint32_t i = 0, j = 0;
    const auto at = [](const Row& row, std::uint32_t k) { return row.first + k % row.count; };
    const std::uint32_t low_steps = low.count == 1 ? 0 : low.count, high_steps = high.count == 1 ? 0 : high.count;
    while (i < low_steps || j < high_steps) {
      const bool along_low =
          j == high_steps || (i < low_steps && std::uint64_t{i + 1} * high.count <= std::uint64_t{j + 1} * low.count);
      if (along_low) {
        solid_.triangle.emplace_back(at(low, i), at(low, i + 1), at(high, j));
        ++i;
      } else {
        solid_.triangle.emplace_back(at(low, i), at(high, j + 1), at(high, j));
        ++j;
      }
    }
  }

  RevolveOptions options_;
  ClosedSurface solid_;
  std::vector<Row> rows_;
};

}  // namespace

ClosedSurface revolved(const Curve& profile, const RevolveOptions& options) {
  return Revolution(options).make(around_region(profile));
}

Curve half_circle(double radius, double tolerance) {
  const double step = std::sqrt(8 * tolerance / radius);
  const int steps = std::max(4, static_cast<int>(std::ceil(pi / step)));
  Curve profile;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * i / steps;
    profile.points.emplace_back(radius * reproducible::sin(angle), -radius * reproducible::cos(angle));
  }
  profile.points.front().x = profile.points.back().x = 0;
  return profile;
}

ClosedSurface posed(ClosedSurface solid, const SolidPose& pose) {
  const glm::dvec3 beside = glm::cross(pose.axis, pose.up);
  for (glm::dvec3& p : solid.point) {
    p = pose.at + p.x * beside + p.y * pose.axis + p.z * pose.up;
  }
  return solid;
}

glm::dvec3 level_beside(const glm::dvec3& direction) {
  const glm::dvec3 level(direction.z, 0, -direction.x);
  const double length = glm::length(level);
  return length > 1e-9 ? level / length : glm::dvec3(0, 0, 1);
}

}  // namespace pomona
