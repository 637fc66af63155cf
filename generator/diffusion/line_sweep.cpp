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
  bins.columns = static_cast<std::int32_t>(bins_along(width));
  bins.rows = static_cast<std::int32_t>(bins_along(height));
  bins.per_u = width > 0 ? static_cast<float>(bins.columns) / width : 0;
  bins.per_v = height > 0 ? static_cast<float>(bins.rows) / height : 0;
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

LineSweep::LineSweep(const PackedSurfaces& surfaces, std::span<const glm::vec3> points)
    : surfaces_(surfaces), state_(std::make_unique<SweepState>()) {
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

  forget(state.ahead, state.points + SweepState::padding);
  forget(state.behind, state.points + SweepState::padding);
  cover(line, surfaces_.groups, state);
  shade(surfaces_, state, state.ahead, true, sums);
  shade(surfaces_, state, state.behind, false, sums);
}

}  // namespace pomona
