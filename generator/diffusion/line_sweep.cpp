#include "generator/diffusion/line_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/diffusion/sweep_kernels.h"

namespace pomona {

namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

/// Points nearer than 1e-5 of the size to a surface never come here, so that a smaller distance is rounding.
constexpr float least_distance = 1e-6f;

/// Groups of triangles tested before the first look at what they hide; a multiple of TriangleGroup::size.
constexpr std::size_t first_round = 128;

SweepHits make_hits(std::size_t count) {
  return {hwy::AllocateAligned<float>(count), hwy::AllocateAligned<std::int32_t>(count),
          hwy::AllocateAligned<float>(count), hwy::AllocateAligned<float>(count)};
}

void forget(SweepHits& hits, std::size_t count) {
  std::fill_n(hits.distance.get(), count, nowhere);
  std::fill_n(hits.side.get(), count, -1);
}

struct Range {
  float low = 0, high = 0;
};

Range range_of(const AlignedFloats& values, std::size_t count) {
  Range range{values[0], values[0]};
  for (std::size_t i = 1; i < count; ++i) {
    range.low = std::min(range.low, values[i]);
    range.high = std::max(range.high, values[i]);
  }
  return range;
}

/// About three points a bin if they were spread evenly over their rectangle.
void lay_out_bins(SweepState& state) {
  constexpr float points_per_bin = 3;
  constexpr float most_bins = 512;  // along an axis
  const Range u = range_of(state.u, state.points), v = range_of(state.v, state.points);
  const float width = u.high - u.low, height = v.high - v.low;
  const float side = std::sqrt(width * height * points_per_bin / static_cast<float>(state.points));
  const auto bins_along = [&](float length) { return side > 0 ? std::clamp(length / side, 1.0f, most_bins) : 1.0f; };

  SweepBins& bins = state.bins;
  bins.low_u = u.low;
  bins.low_v = v.low;
  bins.high_u = u.high;
  bins.high_v = v.high;
  bins.columns = static_cast<std::int32_t>(bins_along(width));
  bins.rows = static_cast<std::int32_t>(bins_along(height));
  bins.per_u = width > least_distance ? static_cast<float>(bins.columns) / width : 0;
  bins.per_v = height > least_distance ? static_cast<float>(bins.rows) / height : 0;
}

/// Counting sort: slots are numbered by bin, then by point.
void fill_slots(SweepState& state) {
  std::vector<std::int32_t>& first = state.bins.first_slot;
  first.assign(static_cast<std::size_t>(state.bins.columns * state.bins.rows) + 1, 0);
  for (std::size_t i = 0; i < state.points; ++i) ++first[static_cast<std::size_t>(state.bin[i])];
  std::int32_t slot = 0;
  for (std::int32_t& entry : first) slot += std::exchange(entry, slot);

  // Each entry walks to the end of its bin, and thereby to the beginning of the next.
  for (std::size_t i = 0; i < state.points; ++i) {
    const auto place = static_cast<std::size_t>(first[static_cast<std::size_t>(state.bin[i])]++);
    state.slot_u[place] = state.u[i];
    state.slot_v[place] = state.v[i];
    state.slot_w[place] = state.w[i];
    state.point_of_slot[place] = static_cast<std::int32_t>(i);
  }
  std::copy_backward(first.begin(), first.end() - 1, first.end());
  first.front() = 0;
}

/// Lays out the levels of reach over the bins: the last is a single square.
void lay_out_reach(SweepState& state) {
  SweepReach& reach = state.reach;
  reach.levels = 0;
  std::int32_t entries = 0;
  for (std::int32_t columns = state.bins.columns, rows = state.bins.rows;;) {
    const auto level = static_cast<std::size_t>(reach.levels++);
    reach.first[level] = entries;
    reach.columns[level] = columns;
    entries += columns * rows;
    if (columns == 1 && rows == 1) break;
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
  }
  reach.nearest.assign(static_cast<std::size_t>(entries), nowhere);
  reach.farthest.assign(static_cast<std::size_t>(entries), -nowhere);
}

/// What the points of each bin see by now; squares of bins; and each with its three neighbours.
void update_reach(SweepState& state) {
  SweepReach& reach = state.reach;
  const auto include = [&](std::size_t into, std::size_t from) {
    reach.nearest[into] = std::min(reach.nearest[into], reach.nearest[from]);
    reach.farthest[into] = std::max(reach.farthest[into], reach.farthest[from]);
  };
  const auto bins = static_cast<std::size_t>(state.bins.columns * state.bins.rows);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    float nearest = nowhere, farthest = -nowhere;
    const auto end = static_cast<std::size_t>(state.bins.first_slot[bin + 1]);
    for (auto slot = static_cast<std::size_t>(state.bins.first_slot[bin]); slot < end; ++slot) {
      nearest = std::min(nearest, state.slot_w[slot] - state.behind.distance[slot]);
      farthest = std::max(farthest, state.slot_w[slot] + state.ahead.distance[slot]);
    }
    reach.nearest[bin] = nearest;
    reach.farthest[bin] = farthest;
  }

  std::int32_t columns = state.bins.columns, rows = state.bins.rows;
  for (std::size_t level = 0; level < static_cast<std::size_t>(reach.levels); ++level) {
    const std::int32_t next_columns = (columns + 1) / 2;
    const bool is_last = level + 1 == static_cast<std::size_t>(reach.levels);
    if (!is_last) {
      const std::size_t next = static_cast<std::size_t>(reach.first[level + 1]);
      std::fill(reach.nearest.begin() + reach.first[level + 1], reach.nearest.end(), nowhere);
      std::fill(reach.farthest.begin() + reach.first[level + 1], reach.farthest.end(), -nowhere);
      for (std::int32_t y = 0; y < rows; ++y) {
        for (std::int32_t x = 0; x < columns; ++x) {
          include(next + static_cast<std::size_t>(y / 2 * next_columns + x / 2),
                  static_cast<std::size_t>(reach.first[level] + y * columns + x));
        }
      }
    }
    for (std::int32_t y = 0; y < rows; ++y) {
      for (std::int32_t x = 0; x < columns; ++x) {
        const auto at = static_cast<std::size_t>(reach.first[level] + y * columns + x);
        if (x + 1 < columns) include(at, at + 1);
        if (y + 1 < rows) include(at, at + static_cast<std::size_t>(columns));
        if (x + 1 < columns && y + 1 < rows) include(at, at + static_cast<std::size_t>(columns) + 1);
      }
    }
    columns = next_columns;
    rows = (rows + 1) / 2;
  }
}

/// Adds the hits one way, seen by rays along the line (or against it).
void shade(const PackedSurfaces& surfaces, const SweepState& state, const SweepHits& hits, bool is_ahead,
           SweepSums& sums) {
  const std::size_t parts = surfaces.used_parts.size();
  for (std::size_t slot = 0; slot < state.points; ++slot) {
    if (hits.side[slot] < 0) continue;
    const auto triangle = static_cast<std::size_t>(hits.side[slot] / 2);
    const bool front_looks_along = hits.side[slot] % 2 == 1;
    const bool sees_front = front_looks_along != is_ahead;

    const auto& [a, b, c] = surfaces.triangle[triangle];
    const std::vector<glm::vec4>& color = sees_front ? surfaces.front_color : surfaces.back_color;
    const float second = hits.second[slot], third = hits.third[slot], first = 1 - second - third;
    const float weight = 1 / std::max(hits.distance[slot], least_distance);
    const glm::vec4 seen = color[static_cast<std::size_t>(a)] * first + color[static_cast<std::size_t>(b)] * second +
                           color[static_cast<std::size_t>(c)] * third;

    const auto point = static_cast<std::size_t>(state.point_of_slot[slot]);
    sums.color_and_weight[point] += weight * seen;
    const std::uint16_t part = (sees_front ? surfaces.front_part : surfaces.back_part)[triangle];
    sums.part_weight[point * parts + part] += weight;
  }
}

}  // namespace

LineSweep::LineSweep(const PackedSurfaces& surfaces, const GroupBoxes& boxes, std::span<const glm::vec3> points)
    : surfaces_(surfaces), boxes_(boxes), state_(std::make_unique<SweepState>()) {
  SweepState& state = *state_;
  state.points = points.size();
  const std::size_t count = points.size() + SweepState::padding;
  for (AlignedFloats* floats :
       {&state.x, &state.y, &state.z, &state.u, &state.v, &state.w, &state.slot_u, &state.slot_v, &state.slot_w}) {
    *floats = hwy::AllocateAligned<float>(count);
    std::fill_n(floats->get(), count, 0.0f);
  }
  state.bin = hwy::AllocateAligned<std::int32_t>(count);
  state.point_of_slot.resize(count);
  state.ahead = make_hits(count);
  state.behind = make_hits(count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    state.x[i] = points[i].x;
    state.y[i] = points[i].y;
    state.z[i] = points[i].z;
  }
}

LineSweep::~LineSweep() = default;

void LineSweep::add(const Line& line, SweepSums& sums) {
  SweepState& state = *state_;
  project_points(line, state);
  lay_out_bins(state);
  find_bins(state);
  fill_slots(state);
  lay_out_reach(state);

  // Nearest groups first, in rounds that double: what they hide is left out from the next round on.
  forget(state.ahead, state.points + SweepState::padding);
  forget(state.behind, state.points + SweepState::padding);
  const std::size_t groups = boxes_.group.size();
  std::size_t size = first_round;
  for (std::size_t first = 0; first < groups; size *= 2) {
    const std::size_t end = std::min(groups, first + size);
    update_reach(state);
    cover(line, boxes_, first, end, surfaces_.groups, state);
    first = end;
  }
  shade(surfaces_, state, state.ahead, true, sums);
  shade(surfaces_, state, state.behind, false, sums);
}

}  // namespace pomona
