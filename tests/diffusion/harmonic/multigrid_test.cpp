// The multigrid, compared with a solution of the same equations without levels.
#include "generator/diffusion/harmonic/multigrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "generator/diffusion/harmonic/solve_field.h"
#include "tests/diffusion/fields.h"
#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

GridOptions sixteen_cells() { return {.spacing = 0.19, .shift = glm::dvec3(0.2, 0.6, 0.9), .threads = {2}}; }

/// A box with a ball in it, in colours that differ from place to place.
DiffusionSurfaces painted_room() {
  const DiffusionSurfaces room =
      joined(shapes::tilted(shapes::box({-1, -1, -1}, {1, 1, 1}, 4)), shapes::sphere(0.37, 6));
  return fields::painted_with(room, [](const glm::dvec3& p) {
    return glm::dvec3(0.5 + 0.3 * p.x * p.x - 0.2 * p.y, 0.5 + 0.3 * p.y * p.z, 0.5 - 0.3 * p.z);
  });
}

bool takes_part(const GridLevel& level, std::size_t node) { return (level.arms.open[node] & takes_no_part) == 0; }

/// A node's value from its neighbours': along each axis the second difference over arms of different lengths [Shortley
/// & Weller 1938], implemented a second time.
class Equations {
 public:
  explicit Equations(const GridLevel& level) : level_(level) {
    std::size_t next = 0;
    for (std::uint32_t node = 0; node < level.arms.open.size(); ++node) {
      if (!takes_part(level, node)) continue;
      const bool is_cut = next < level.arms.node.size() && level.arms.node[next].node == node;
      equation_.push_back(equation_of(node, is_cut ? &level.arms.node[next++] : nullptr));
    }
  }

  /// Gauss-Seidel in doubles until nothing changes.
  std::vector<glm::dvec4> solution() const {
    std::vector<glm::dvec4> value(level_.arms.open.size(), glm::dvec4(0));
    for (double change = 1; change > 1e-11;) {
      change = 0;
      for (const Equation& e : equation_) {
        const glm::dvec4 wanted = by_neighbours(e, value);
        change = std::max(change, glm::length(wanted - value[e.node]));
        value[e.node] = wanted;
      }
    }
    return value;
  }

  /// The max difference between a node's value and the one that follows from its neighbours.
  double residual(const std::vector<glm::dvec4>& value) const {
    double max = 0;
    for (const Equation& e : equation_) max = std::max(max, glm::length(by_neighbours(e, value) - value[e.node]));
    return max;
  }

 private:
  struct Equation {
    std::size_t node = 0;
    glm::dvec4 given{0};
    std::array<double, 6> weight{};
    std::array<std::size_t, 6> other{};
    double sum = 0;
  };

  Equation equation_of(std::uint32_t node, const CutNode* cut) const {
    const NodeBlock& block = level_.blocks[node / 8];
    const Node at{8 * block.column + static_cast<int>(node % 8), block.y, block.z};
    std::array<const ArmCut*, 6> ends{};
    std::uint32_t next = cut ? cut->first_cut : 0;
    for (std::size_t d = 0; d < 6; ++d) {
      if (cut && (cut->cut >> d & 1)) ends[d] = &level_.arms.cut[next++];
    }
    Equation e;
    e.node = node;
    for (std::size_t d = 0; d < 6; ++d) {
      const auto length = [&](std::size_t i) {
        return ends[i] ? std::max(1e-5, static_cast<double>(ends[i]->theta)) : 1;
      };
      const double weight = 2 / (length(d) * (length(d) + length(d ^ 1)));
      e.sum += weight;
      if (ends[d]) {
        e.given += weight * glm::dvec4(glm::dvec3(ends[d]->color), 1);
      } else {
        const Node other = shapes::beside(at, static_cast<int>(d));
        e.other[d] = static_cast<std::size_t>(level_.blocks.node_at(other[0], other[1], other[2]));
        e.weight[d] = weight;
      }
    }
    return e;
  }

  static glm::dvec4 by_neighbours(const Equation& e, const std::vector<glm::dvec4>& value) {
    glm::dvec4 sum = e.given;
    for (std::size_t d = 0; d < 6; ++d) {
      if (e.weight[d] > 0) sum += e.weight[d] * value[e.other[d]];
    }
    return sum / e.sum;
  }

  const GridLevel& level_;
  std::vector<Equation> equation_;
};

std::vector<glm::dvec4> values_of(const GridLevel& level) {
  std::vector<glm::dvec4> values;
  for (std::size_t i = 0; i < level.value.size(); ++i) {
    const Quad& v = level.value[i];
    values.emplace_back(v[0], v[1], v[2], v[3]);
  }
  return values;
}

double largest_difference(const GridLevel& level, const std::vector<glm::dvec4>& a, const std::vector<glm::dvec4>& b) {
  double max = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (takes_part(level, i)) max = std::max(max, glm::length(a[i] - b[i]));
  }
  return max;
}

std::vector<GridLevel> levels_of(const DiffusionSurfaces& surfaces, const GridOptions& options) {
  PreparedField field = prepared_field(surfaces, options);
  EXPECT_TRUE(field.is_sealed);
  return std::move(field.levels);
}

TEST(Multigrid, SolvesTheEquationsOfItsFinestLevel) {
  const std::vector<GridLevel> levels =
      solved(levels_of(painted_room(), sixteen_cells()), {.cycles = 12, .threads = {2}});
  const Equations equations(levels.front());
  const std::vector<glm::dvec4> truth = equations.solution();
  std::size_t parts = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!takes_part(levels.front(), i)) continue;
    ++parts;
    EXPECT_NEAR(truth[i].w, 1, 1e-6) << "all walks end on a surface";
  }
  EXPECT_GT(parts, 1000u);
  EXPECT_LT(largest_difference(levels.front(), values_of(levels.front()), truth), 3e-6);
  EXPECT_LT(equations.residual(values_of(levels.front())), 2e-6);
}

/// Every cycle removes at least four fifths of the error, down to the precision of floats.
TEST(Multigrid, LosesMostOfItsErrorInEveryCycle) {
  const std::vector<GridLevel> start = levels_of(painted_room(), sixteen_cells());
  const Equations equations(start.front());
  const std::vector<glm::dvec4> truth = equations.solution();
  std::vector<double> error;
  for (int cycles = 0; cycles <= 3; ++cycles) {
    const std::vector<GridLevel> levels =
        solved(levels_of(painted_room(), sixteen_cells()), {.cycles = cycles, .threads = {2}});
    error.push_back(largest_difference(levels.front(), values_of(levels.front()), truth));
  }
  EXPECT_LT(error[0], 0.2) << "the interpolated solution of the next level";
  for (std::size_t i = 1; i < error.size(); ++i) EXPECT_LT(error[i], std::max(0.2 * error[i - 1], 3e-6)) << i;
}

TEST(Multigrid, ReproducesLinearFields) {
  const auto linear = [](const glm::dvec3& p) { return glm::dvec3(0.5 + 0.2 * p.x, 0.5 - 0.1 * p.y + 0.1 * p.z, 0.4); };
  const DiffusionSurfaces room = fields::painted_with(shapes::tilted(fields::linear_scene()), linear);
  const std::vector<GridLevel> levels = solved(levels_of(room, sixteen_cells()), {.cycles = 12, .threads = {2}});
  for (const Node& node : shapes::nodes_of(levels.front().lattice)) {
    const std::int32_t number = levels.front().blocks.node_at(node[0], node[1], node[2]);
    if (number == SparseBlocks::none || !takes_part(levels.front(), static_cast<std::size_t>(number))) continue;
    const glm::dvec3 wanted = linear(shapes::place_of(levels.front().lattice, node));
    const Quad& found = levels.front().value[static_cast<std::size_t>(number)];
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], 2e-6);
  }
}

TEST(Multigrid, LetsNoColourThroughAWall) {
  // Red within the inner box, whose walls are thinner than a coarse cell; blue between the boxes.
  shapes::Paint inner, outer;
  inner.front = outer.back = Color(0, 0, 1);
  inner.back = Color(1, 0, 0);
  for (const double side : {0.35, 0.55}) {
    const DiffusionSurfaces boxes = joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 1, outer),
                                           shapes::tilted(shapes::box(glm::dvec3(-side), glm::dvec3(side), 1, inner)));
    const std::vector<GridLevel> levels = solved(levels_of(boxes, sixteen_cells()), {.cycles = 1, .threads = {2}});
    std::size_t red = 0, blue = 0;
    const GridLevel& level = levels.front();
    for (std::size_t i = 0; i < level.value.size(); ++i) {
      if (!takes_part(level, i)) continue;
      const Quad& value = level.value[i];
      EXPECT_EQ(std::min(value[0], value[2]), 0) << "either, never both";
      EXPECT_NEAR(std::max(value[0], value[2]) / value[3], 1, 1e-6);
      (value[0] > value[2] ? red : blue) += 1;
    }
    const double nodes_inside = 8 * side * side * side / (0.19 * 0.19 * 0.19);
    EXPECT_NEAR(static_cast<double>(red), nodes_inside, 0.3 * nodes_inside);
    EXPECT_GT(blue, 300u);
  }
}

TEST(Multigrid, IsTheSameForAnyNumberOfThreads) {
  // First enough blocks to share among threads, then more than a cache holds.
  for (const auto& [spacing, min_runs] : {std::pair{0.05, 2000u}, {0.05 / 3, 30001u}}) {
    GridOptions options = sixteen_cells();
    options.spacing = spacing;
    const auto values = [&](int threads) {
      options.threads = {threads};
      return values_of(solved(levels_of(painted_room(), options), {.threads = {threads}}).front());
    };
    const std::vector<glm::dvec4> one = values(1);
    EXPECT_GE(one.size(), 8 * min_runs);
    EXPECT_EQ(one, values(2));
    EXPECT_EQ(one, values(5));
  }
}

/// A patch and the grid around it are solved together, so the field is the same with and without the patch.
TEST(Multigrid, SolvesAPatchTogetherWithWhatIsAroundIt) {
  const auto linear = [](const glm::dvec3& p) { return glm::dvec3(0.5 + 0.2 * p.x, 0.5 - 0.1 * p.y + 0.1 * p.z, 0.4); };
  const DiffusionSurfaces room = fields::painted_with(joined(shapes::tilted(shapes::box({-1, -1, -1}, {1, 1, 1}, 2)),
                                                             shapes::moved(shapes::sphere(0.06, 3), {0.2, 0.1, 0})),
                                                      linear);
  GridOptions options = sixteen_cells();
  options.finer = 1;
  options.spacing = 0.08;  // the patch ends before the room's walls
  options.cycles = 12;
  PreparedField field = prepared_field(room, options);
  const auto [levels, patch_count] = solved_levels(field.snapped, std::move(field.levels), options);
  ASSERT_EQ(patch_count, 1u);
  ASSERT_TRUE(levels.front().is_patch);
  for (const std::size_t l : {0u, 1u}) {
    const GridLevel& level = levels[l];
    for (const Node& node : shapes::nodes_of(level.lattice)) {
      const std::int32_t number = level.blocks.node_at(node[0], node[1], node[2]);
      const glm::dvec3 place = shapes::place_of(level.lattice, node);
      const bool is_stored = number != SparseBlocks::none && takes_part(level, static_cast<std::size_t>(number));
      if (!is_stored) continue;
      const glm::dvec3 wanted = linear(place);
      const Quad& found = level.value[static_cast<std::size_t>(number)];
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[k], wanted[k], 1e-5) << "level " << l;
    }
  }
}

}  // namespace
}  // namespace pomona
