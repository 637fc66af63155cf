#include "generator/diffusion/pmvc/line_pmvc.h"

#include <algorithm>
#include <cmath>

#include <glm/vec4.hpp>

#include "generator/base/color.h"
#include "generator/base/morton.h"
#include "generator/base/units.h"
#include "generator/diffusion/pmvc/group_boxes.h"
#include "generator/diffusion/pmvc/line_sweep.h"

namespace pomona {

namespace {

constexpr std::size_t lines_per_block = 8;
constexpr std::size_t max_points_at_once = 8192;
constexpr std::size_t max_sums = std::size_t{1} << 24;  // limit of floats in the sums of all blocks: 64 MiB
constexpr std::size_t floats_per_point = 12;            // floats of a block's sums, without parts

std::size_t blocks_of(std::size_t lines) { return (lines + lines_per_block - 1) / lines_per_block; }

/// The differences d = (colour and weight of one line) - (of the other) of pairs, summed over pairs.
struct Scatter {
  std::vector<glm::vec4> squares;      ///< d * d
  std::vector<glm::vec4> with_weight;  ///< d * d.w
};

struct BlockSums {
  SweepSums sums;
  Scatter scatter;  ///< empty unless it is needed
};

/// Adds the difference between the second half of a pair, in `now` - `middle`, and the first, `middle` - `before`.
void add_difference(std::span<const glm::vec4> before, std::span<const glm::vec4> middle,
                    std::span<const glm::vec4> now, Scatter& scatter) {
  for (std::size_t i = 0; i < now.size(); ++i) {
    const glm::vec4 d = (now[i] - middle[i]) - (middle[i] - before[i]);
    scatter.squares[i] += d * d;
    scatter.with_weight[i] += d * d.w;
  }
}

BlockSums swept(const PackedSurfaces& surfaces, const GroupBoxes& boxes, std::span<const glm::vec3> points,
                std::span<const Line> lines, bool wants_scatter, bool follow_plane) {
  BlockSums block;
  block.sums.color_and_weight.assign(points.size(), glm::vec4(0));
  block.sums.fourth.assign(surfaces.fourth.empty() ? 0 : points.size(), 0);
  block.sums.part_weight.assign(points.size() * surfaces.used_parts.size(), 0);
  if (wants_scatter) {
    block.scatter.squares.assign(points.size(), glm::vec4(0));
    block.scatter.with_weight.assign(points.size(), glm::vec4(0));
  }

  LineSweep sweep(surfaces, boxes, points, follow_plane);
  std::vector<glm::vec4> before, middle;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (wants_scatter) (i % 2 == 0 ? before : middle) = block.sums.color_and_weight;
    sweep.add(lines[i], block.sums);
    if (wants_scatter && i % 2 == 1) add_difference(before, middle, block.sums.color_and_weight, block.scatter);
  }
  return block;
}

/// One set of sums for every block of lines.
std::vector<BlockSums> sweep_blocks(const PackedSurfaces& surfaces, std::span<const glm::vec3> points,
                                    std::span<const Line> lines, bool wants_scatter, bool follow_plane,
                                    Threads threads) {
  if (points.empty()) return {};
  const GroupBoxes boxes = nearest_first(surfaces, points);
  std::vector<BlockSums> blocks(blocks_of(lines.size()));
  parallel_for(blocks.size(), threads, [&](std::size_t block) {
    const std::size_t first = block * lines_per_block;
    const std::size_t count = std::min(lines_per_block, lines.size() - first);
    blocks[block] = swept(surfaces, boxes, points, lines.subspan(first, count), wants_scatter, follow_plane);
  });
  return blocks;
}

/// Sums over all blocks, one entry per point.
struct Totals {
  std::vector<glm::dvec4> color_and_weight;
  std::vector<double> fourth;
  std::vector<double> part_weight;  ///< points x used parts
  std::vector<int> lines;           ///< number of lines of each point
};

/// Adds all blocks in order; `place[i]` is the index of their point i.
void add_blocks(std::span<const BlockSums> blocks, std::span<const std::size_t> place, std::size_t parts,
                std::size_t lines, Totals& totals) {
  for (const BlockSums& block : blocks) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      totals.color_and_weight[place[i]] += glm::dvec4(block.sums.color_and_weight[i]);
      if (!block.sums.fourth.empty()) totals.fourth[place[i]] += static_cast<double>(block.sums.fourth[i]);
      for (std::size_t p = 0; p < parts; ++p) {
        totals.part_weight[place[i] * parts + p] += static_cast<double>(block.sums.part_weight[i * parts + p]);
      }
    }
  }
  for (const std::size_t i : place) totals.lines[i] += static_cast<int>(lines);
}

/// Half the difference of the encoded values of value - spread and value + spread.
double encoded_spread(double value, double spread) {
  const double low = std::clamp(value - spread, 0.0, 1.0), high = std::clamp(value + spread, 0.0, 1.0);
  return 0.5 * (srgb_from_linear(high) - srgb_from_linear(low));
}

/// Whether the colour of a point scatters more than `max`, as in LinePlan: with w the weight and f the colour, each
/// pair adds (d.rgb - f d.w) / w.
bool scatters_more_than(double max, std::span<const BlockSums> blocks, const glm::dvec4& total, std::size_t point) {
  glm::dvec4 squares(0), with_weight(0);
  for (const BlockSums& block : blocks) {
    squares += glm::dvec4(block.scatter.squares[point]);
    with_weight += glm::dvec4(block.scatter.with_weight[point]);
  }
  constexpr double steepest = 12.92;  // steepest slope of the sRGB encoding
  const glm::dvec4 f = total / total.w;
  for (int k = 0; k < 3; ++k) {
    const double sum = squares[k] - 2 * f[k] * with_weight[k] + f[k] * f[k] * squares.w;
    const double spread = std::sqrt(std::max(sum, 0.0)) / total.w;
    if (spread > max || (steepest * spread > max && encoded_spread(f[k], spread) > max)) return true;
  }
  return false;
}

PmvcValue value_of(const PackedSurfaces& surfaces, const Totals& totals, std::size_t point) {
  const std::size_t parts = surfaces.used_parts.size();
  const double* const part_weight = &totals.part_weight[point * parts];
  const glm::dvec4& sum = totals.color_and_weight[point];
  PmvcValue value;
  value.part =
      surfaces.used_parts[static_cast<std::size_t>(std::max_element(part_weight, part_weight + parts) - part_weight)];
  if (sum.w > 0) value.color = glm::dvec3(sum) / sum.w, value.fourth = totals.fourth[point] / sum.w;
  value.weight = sum.w * (2 * pi / totals.lines[point]) * surfaces.scale;
  return value;
}

/// The points of one batch, normalised.
std::vector<PmvcValue> batch_pmvc(const PackedSurfaces& surfaces, std::span<const glm::vec3> points,
                                  const LinePlan& plan, Threads threads) {
  const std::size_t parts = surfaces.used_parts.size();
  Totals totals{std::vector<glm::dvec4>(points.size(), glm::dvec4(0)), std::vector<double>(points.size(), 0),
                std::vector<double>(points.size() * parts, 0), std::vector<int>(points.size(), 0)};

  // All points.
  std::vector<std::size_t> place(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) place[i] = i;
  const std::vector<BlockSums> blocks =
      sweep_blocks(surfaces, points, plan.lines, !plan.more.empty(), plan.follow_plane, threads);
  add_blocks(blocks, place, parts, plan.lines.size(), totals);

  // The points that need more lines.
  if (!plan.more.empty()) {
    std::vector<glm::vec3> scattered;
    place.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec4& total = totals.color_and_weight[i];
      if (!(total.w > 0) || !scatters_more_than(plan.max_scatter, blocks, total, i)) continue;
      place.push_back(i);
      scattered.push_back(points[i]);
    }
    add_blocks(sweep_blocks(surfaces, scattered, plan.more, false, plan.follow_plane, threads), place, parts,
               plan.more.size(), totals);
  }

  std::vector<PmvcValue> values;
  values.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) values.push_back(value_of(surfaces, totals, i));
  return values;
}

}  // namespace

std::vector<PmvcValue> line_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, const LinePlan& plan, Threads threads,
                                 std::span<const float> fourth) {
  PackedSurfaces packed = pack(surfaces, tree);
  packed.fourth.assign(fourth.begin(), fourth.end());

  // The number of points at a time, so that the blocks' sums stay small.
  const std::size_t sums_per_point =
      blocks_of(std::max(plan.lines.size(), plan.more.size())) * (floats_per_point + packed.used_parts.size());
  const std::size_t at_once = std::clamp<std::size_t>(max_sums / sums_per_point, 1, max_points_at_once);
  std::vector<PmvcValue> values(points.size());
  const std::vector<std::uint32_t> order = morton_order(std::vector<glm::dvec3>(points.begin(), points.end()));
  for (std::size_t first = 0; first < points.size(); first += at_once) {
    std::vector<glm::vec3> batch;
    for (std::size_t i = first; i < std::min(first + at_once, points.size()); ++i) {
      batch.push_back(packed.normalized(points[order[i]]));
    }
    const std::vector<PmvcValue> found = batch_pmvc(packed, batch, plan, threads);
    for (std::size_t i = 0; i < batch.size(); ++i) values[order[first + i]] = found[i];
  }
  return values;
}

}  // namespace pomona
