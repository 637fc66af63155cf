#include "generator/surface/dart_throwing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/units.h"

namespace pomona {

namespace {

/// A point of a triangle darts may hit.
struct Corner {
  glm::dvec3 position{0};
  glm::dvec3 normal{0};  ///< of the front, any length
  double along = 0;
};

Corner blend(const Corner& a, double share_a, const Corner& b, double share_b) {
  return {a.position * share_a + b.position * share_b, a.normal * share_a + b.normal * share_b,
          a.along * share_a + b.along * share_b};
}

/// A triangle darts may hit, or a piece of one.
struct Target {
  std::array<Corner, 3> corner;
  glm::dvec3 uphill{0};    ///< the way `along` grows
  double area_before = 0;  ///< of all targets before this one
};

double area_of(const Target& target) {
  const auto& [a, b, c] = target.corner;
  return 0.5 * glm::length(glm::cross(b.position - a.position, c.position - a.position));
}

std::vector<glm::dvec3> grid_normals(const SweptGrid& grid) {
  std::vector<glm::dvec3> normals(grid.position.size(), glm::dvec3(0));
  for (const glm::uvec3& t : grid.triangle) {
    const glm::dvec3& a = grid.position[t.x];
    const glm::dvec3 normal = glm::cross(grid.position[t.y] - a, grid.position[t.z] - a);
    for (int k = 0; k < 3; ++k) normals[t[k]] += normal;
  }
  return normals;
}

bool in_band(const SweptGrid& grid, const glm::uvec3& t, const GrainSketch& sketch) {
  const auto [least, most] = std::minmax({grid.along[t.x], grid.along[t.y], grid.along[t.z]});
  return most >= sketch.along_from && least <= sketch.along_to;
}

double area_of(const SweptGrid& grid, const glm::uvec3& t) {
  const glm::dvec3& a = grid.position[t.x];
  return 0.5 * glm::length(glm::cross(grid.position[t.y] - a, grid.position[t.z] - a));
}

class DartThrower {
 public:
  DartThrower(std::span<const SweptGrid> grids, const GrainSketch& sketch, const RandomStream& random)
      : sketch_(sketch), random_(random) {
    for (const SweptGrid& grid : grids) add_targets(grid);
  }

  std::vector<Dart> throw_all() {
    // The first throw takes most places; the next ones aim at what is still free.
    throw_round(8);
    for (int round = 0; round < 6 && !targets_.empty(); ++round) {
      aim_at_free_places();
      throw_round(64);
    }
    return std::move(darts_);
  }

 private:
  void add_targets(const SweptGrid& grid) {
    const std::vector<glm::dvec3> normals = grid_normals(grid);
    for (const glm::uvec3& t : grid.triangle) {
      if (!in_band(grid, t, sketch_)) continue;
      Target target;
      for (int k = 0; k < 3; ++k) {
        target.corner[static_cast<std::size_t>(k)] = {grid.position[t[k]], normals[t[k]], grid.along[t[k]]};
      }
      target.uphill = uphill(target);
      add_target(target);
    }
  }

  void add_target(Target target) {
    const double area = area_of(target);
    if (!(area > 0)) return;
    target.area_before = area_;
    area_ += area;
    targets_.push_back(target);
  }

  static glm::dvec3 uphill(const Target& target) {
    const auto& [a, b, c] = target.corner;
    const glm::dvec3 normal = glm::cross(b.position - a.position, c.position - a.position);
    return glm::cross(normal, c.position - b.position) * a.along +
           glm::cross(normal, a.position - c.position) * b.along +
           glm::cross(normal, b.position - a.position) * c.along;
  }

  /// So many candidates for each disc of the Poisson diameter that the targets have room for.
  void throw_round(double per_disc) {
    const double disc = pi * sketch_.poisson_radius * sketch_.poisson_radius / 4;
    const std::uint64_t end = next_candidate_ + static_cast<std::uint64_t>(std::ceil(per_disc * area_ / disc));
    for (; next_candidate_ < end; ++next_candidate_) {
      const std::optional<Dart> dart = candidate(next_candidate_);
      if (dart && is_free(*dart)) keep(*dart);
    }
  }

  std::optional<Dart> candidate(std::uint64_t n) const {
    // A triangle by its area, a point in it evenly [Osada et al. 2002].
    const double area = random_.uniform(draws_per_candidate * n) * area_;
    const auto after =
        std::upper_bound(targets_.begin(), targets_.end(), area,
                         [](double wanted, const Target& target) { return wanted < target.area_before; });
    const Target& target = *(after - 1);
    const double root = std::sqrt(random_.uniform(draws_per_candidate * n + 1));
    const double share = random_.uniform(draws_per_candidate * n + 2);
    const Corner far = blend(target.corner[1], 1 - share, target.corner[2], share);
    const Corner place = blend(target.corner[0], 1 - root, far, root);
    if (place.along < sketch_.along_from || place.along > sketch_.along_to) return std::nullopt;

    std::optional<Dart> dart = dart_at(place);
    if (dart) {
      dart->number = n;
      dart->tangent = across(target.uphill, dart->normal);
    }
    return dart;
  }

  std::optional<Dart> dart_at(const Corner& place) const {
    const double size = glm::length(place.normal);
    if (!(size > 0)) return std::nullopt;
    Dart dart;
    dart.normal = place.normal * ((sketch_.on_front ? 1 : -1) / size);
    dart.center = place.position - dart.normal * sketch_.sink;
    return dart;
  }

  /// Halves the targets along their longest edges down to an eighth of the radius, and leaves out those that lie
  /// within the reach of one dart.
  void aim_at_free_places() {
    std::vector<Target> pending = std::move(targets_);
    targets_.clear();
    area_ = 0;
    std::size_t splits_left = 4'000'000;  // slivers could go on much longer
    while (!pending.empty()) {
      const Target target = pending.back();
      pending.pop_back();
      if (is_taken(target)) continue;
      const std::size_t edge = longest_edge(target);
      const Corner &a = target.corner[edge], &b = target.corner[(edge + 1) % 3];
      if (splits_left == 0 || glm::distance(a.position, b.position) < sketch_.poisson_radius / 8) {
        add_target(target);
        continue;
      }
      --splits_left;
      const Corner middle = blend(a, 0.5, b, 0.5);
      pending.push_back(target);
      pending.back().corner[edge] = middle;
      pending.push_back(target);
      pending.back().corner[(edge + 1) % 3] = middle;
    }
  }

  static std::size_t longest_edge(const Target& target) {
    std::array<double, 3> length{};
    for (std::size_t k = 0; k < 3; ++k) {
      length[k] = glm::distance(target.corner[k].position, target.corner[(k + 1) % 3].position);
    }
    return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  }

  bool is_taken(const Target& target) const {
    std::array<Dart, 3> dart;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<Dart> at_corner = dart_at(target.corner[k]);
      if (!at_corner) return false;
      dart[k] = *at_corner;
    }
    return any_near(dart[0].center, [&](const Dart& known) {
      return is_too_near(known, dart[0]) && is_too_near(known, dart[1]) && is_too_near(known, dart[2]);
    });
  }

  /// The unit vector across `normal` nearest to `wanted`.
  static glm::dvec3 across(const glm::dvec3& wanted, const glm::dvec3& normal) {
    const glm::dvec3 tangent = wanted - glm::dot(wanted, normal) * normal;
    const double size = glm::length(tangent);
    if (size > 1e-9 * glm::length(wanted)) return tangent / size;
    const glm::dvec3 other = std::fabs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(normal, other));
  }

  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const glm::dvec3& p) const {
    Cell cell;
    for (int k = 0; k < 3; ++k) {
      cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / sketch_.poisson_radius));
    }
    return cell;
  }

  bool is_free(const Dart& dart) const {
    return !any_near(dart.center, [&](const Dart& known) { return is_too_near(known, dart); });
  }

  /// True if the question is answered with yes for any dart that may lie within the Poisson radius.
  template <typename Question>
  bool any_near(const glm::dvec3& center, const Question& question) const {
    const Cell cell = cell_of(center);
    for (std::int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x) {
      for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
        const auto from = cells_.lower_bound(Cell{x, y, cell[2] - 1});
        for (auto it = from; it != cells_.end() && it->first <= Cell{x, y, cell[2] + 1}; ++it) {
          if (question(darts_[it->second])) return true;
        }
      }
    }
    return false;
  }

  bool is_too_near(const Dart& one, const Dart& other) const {
    return glm::distance(one.center, other.center) < sketch_.poisson_radius && glm::dot(one.normal, other.normal) > 0;
  }

  void keep(const Dart& dart) {
    cells_.emplace(cell_of(dart.center), darts_.size());
    darts_.push_back(dart);
  }

  const GrainSketch& sketch_;
  const RandomStream& random_;
  std::vector<Target> targets_;
  double area_ = 0;
  std::uint64_t next_candidate_ = 0;
  std::multimap<Cell, std::size_t> cells_;  ///< as wide as the Poisson radius
  std::vector<Dart> darts_;
};

}  // namespace

double band_area(std::span<const SweptGrid> grids, const GrainSketch& sketch) {
  double area = 0;
  for (const SweptGrid& grid : grids) {
    for (const glm::uvec3& t : grid.triangle) area += in_band(grid, t, sketch) ? area_of(grid, t) : 0;
  }
  return area;
}

std::vector<Dart> thrown_darts(std::span<const SweptGrid> grids, const GrainSketch& sketch,
                               const RandomStream& random) {
  return DartThrower(grids, sketch, random).throw_all();
}

}  // namespace pomona
