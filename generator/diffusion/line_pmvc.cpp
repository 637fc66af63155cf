#include "generator/diffusion/line_pmvc.h"

#include <algorithm>
#include <numeric>

#include <glm/vec4.hpp>

#include "generator/base/units.h"
#include "generator/diffusion/group_boxes.h"
#include "generator/diffusion/line_sweep.h"
#include "generator/diffusion/morton.h"

namespace pomona {

namespace {

constexpr std::size_t lines_per_block = 8;
constexpr std::size_t most_points_at_once = 8192;
constexpr std::size_t most_sums = std::size_t{1} << 24;  // floats in all blocks' sums: 64 MiB

std::size_t blocks_of(std::size_t lines) { return (lines + lines_per_block - 1) / lines_per_block; }

/// One set of sums for every block of lines.
std::vector<SweepSums> sweep_blocks(const PackedSurfaces& surfaces, const GroupBoxes& boxes,
                                    std::span<const glm::vec3> points, std::span<const Line> lines, Threads threads) {
  std::vector<SweepSums> sums(blocks_of(lines.size()));
  parallel_for(sums.size(), threads, [&](std::size_t block) {
    sums[block].color_and_weight.assign(points.size(), glm::vec4(0));
    sums[block].part_weight.assign(points.size() * surfaces.used_parts.size(), 0);
    LineSweep sweep(surfaces, boxes, points);
    const std::size_t end = std::min(lines.size(), (block + 1) * lines_per_block);
    for (std::size_t i = block * lines_per_block; i < end; ++i) sweep.add(lines[i], sums[block]);
  });
  return sums;
}

/// All blocks of one point, in order.
PmvcValue total(const PackedSurfaces& surfaces, std::span<const SweepSums> sums, std::size_t point,
                double solid_angle) {
  const std::size_t parts = surfaces.used_parts.size();
  glm::dvec4 color_and_weight{0};
  std::vector<double> part_weight(parts, 0);
  for (const SweepSums& block : sums) {
    color_and_weight += glm::dvec4(block.color_and_weight[point]);
    for (std::size_t p = 0; p < parts; ++p) part_weight[p] += static_cast<double>(block.part_weight[point * parts + p]);
  }

  PmvcValue value;
  const auto largest = std::max_element(part_weight.begin(), part_weight.end()) - part_weight.begin();
  value.part = surfaces.used_parts[static_cast<std::size_t>(largest)];
  if (color_and_weight.w > 0) value.color = glm::dvec3(color_and_weight) / color_and_weight.w;
  value.weight = color_and_weight.w * solid_angle * surfaces.scale;
  return value;
}

}  // namespace

std::vector<PmvcValue> line_pmvc(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                 std::span<const glm::vec3> points, int line_count, Threads threads) {
  const PackedSurfaces packed = pack(surfaces, tree);
  const std::vector<Line> lines = line_directions(line_count);
  const double solid_angle = 2 * pi / line_count;

  // As many points at a time as keep the blocks' sums small.
  const std::size_t sums_per_point = blocks_of(lines.size()) * (4 + packed.used_parts.size());
  const std::size_t at_once = std::clamp<std::size_t>(most_sums / sums_per_point, 1, most_points_at_once);
  std::vector<PmvcValue> values(points.size());
  const std::vector<std::uint32_t> order = morton_order(std::vector<glm::dvec3>(points.begin(), points.end()));
  for (std::size_t first = 0; first < points.size(); first += at_once) {
    std::vector<glm::vec3> batch;
    for (std::size_t i = first; i < std::min(first + at_once, points.size()); ++i) {
      batch.push_back(packed.normalized(points[order[i]]));
    }
    const std::vector<SweepSums> sums = sweep_blocks(packed, nearest_first(packed, batch), batch, lines, threads);
    parallel_for(batch.size(), threads,
                 [&](std::size_t i) { values[order[first + i]] = total(packed, sums, i, solid_angle); });
  }
  return values;
}

}  // namespace pomona
