#include "generator/diffusion/pmvc/line_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/diffusion/pmvc/sweep_kernels.h"

namespace pomona {

namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

/// Points nearer than 1e-5 of the size to a surface are not swept, so a smaller distance is rounding.
constexpr float min_distance = 1e-6f;

/// The number of groups of triangles that are tested before hidden groups are left out; a multiple of
/// TriangleGroup::size.
constexpr std::size_t first_round = 128;

SweepHits make_hits(std::size_t count) {
  return {aligned_array<float>(count), aligned_array<std::int32_t>(count), aligned_array<float>(count),
          aligned_array<float>(count)};
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

/// About half a point per bin if points were spread evenly over their rectangle. Bins are tall, so that a triangle
/// touches few rows, while the points of a row fill a vector. `squeeze` is the factor by which the points have been
/// compressed along u.
void lay_out_bins(SweepState& state, float squeeze) {
  constexpr float points_per_bin = 0.5f;
  constexpr float tallness = 8;    // height of a bin over its width
  constexpr float max_bins = 512;  // limit of bins along an axis
  const Range u = range_of(state.u, state.points), v = range_of(state.v, state.points);
  const float width = u.high - u.low, height = v.high - v.low;
  const float spread = width / std::max(squeeze, 1e-3f);
  const float bin_height = std::sqrt(spread * height * tallness * points_per_bin / static_cast<float>(state.points));
  const auto bins_along = [&](float length, float bin) {
    return bin > 0 ? std::clamp(length / bin, 1.0f, max_bins) : 1.0f;
  };

  SweepBins& bins = state.bins;
  bins.low_u = u.low;
  bins.low_v = v.low;
  bins.high_u = u.high;
  bins.high_v = v.high;
  bins.columns = static_cast<std::int32_t>(bins_along(spread, bin_height / tallness));
  bins.rows = static_cast<std::int32_t>(bins_along(height, bin_height));
  bins.per_u = width > min_distance ? static_cast<float>(bins.columns) / width : 0;
  bins.per_v = height > min_distance ? static_cast<float>(bins.rows) / height : 0;
}

/// Counting sort: slots are numbered by bin, then by point.
void fill_slots(SweepState& state) {
  std::vector<std::int32_t>& first = state.bins.first_slot;
  first.assign(static_cast<std::size_t>(state.bins.columns * state.bins.rows) + 1, 0);
  for (std::size_t i = 0; i < state.points; ++i) ++first[static_cast<std::size_t>(state.bin[i])];
  std::int32_t slot = 0;
  for (std::int32_t& entry : first) slot += std::exchange(entry, slot);

  // Each entry moves to the end of its bin, which is the start of the next.
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

/// The number of columns of the finest level of reach.
std::int32_t cell_columns(const SweepBins& bins) {
  return (bins.columns + SweepReach::bins_per_cell - 1) / SweepReach::bins_per_cell;
}

/// Makes as many levels as a square needs to cover all cells; nothing is hidden yet.
void lay_out_reach(SweepState& state) {
  SweepReach& reach = state.reach;
  reach.columns = cell_columns(state.bins);
  reach.cells = reach.columns * state.bins.rows;
  reach.levels = 1;
  while (1 << (reach.levels - 1) < std::max(reach.columns, state.bins.rows)) ++reach.levels;
  const auto entries = static_cast<std::size_t>(reach.cells * reach.levels);
  reach.nearest.assign(entries, -nowhere);
  reach.farthest.assign(entries, nowhere);
}

/// How far the points of every cell see so far.
void update_cells(SweepState& state) {
  SweepReach& reach = state.reach;
  const SweepBins& bins = state.bins;
  std::size_t cell = 0;
  for (std::int32_t row = 0; row < bins.rows; ++row) {
    const std::int32_t* const first_slot = &bins.first_slot[static_cast<std::size_t>(row * bins.columns)];
    for (std::int32_t column = 0; column < bins.columns; column += SweepReach::bins_per_cell, ++cell) {
      const auto end = static_cast<std::size_t>(first_slot[std::min(column + SweepReach::bins_per_cell, bins.columns)]);
      float nearest = nowhere, farthest = -nowhere;
      for (auto slot = static_cast<std::size_t>(first_slot[column]); slot < end; ++slot) {
        nearest = std::min(nearest, state.slot_w[slot] - state.behind.distance[slot]);
        farthest = std::max(farthest, state.slot_w[slot] + state.ahead.distance[slot]);
      }
      reach.nearest[cell] = nearest;
      reach.farthest[cell] = farthest;
    }
  }
}

/// Makes a level from the one below: four squares of half the side, or those of them that lie on the grid.
template <typename Better>
void double_squares(std::span<const float> below, std::span<float> level, std::int32_t columns, std::int32_t rows,
                    std::int32_t half, const Better& better) {
  for (std::int32_t y = 0; y < rows; ++y) {
    const float* const a = &below[static_cast<std::size_t>(y * columns)];
    const float* const b = &below[static_cast<std::size_t>(std::min(y + half, rows - 1) * columns)];
    float* const into = &level[static_cast<std::size_t>(y * columns)];
    const std::int32_t inner = std::max(columns - half, 0);
    for (std::int32_t x = 0; x < inner; ++x) into[x] = better(better(a[x], a[x + half]), better(b[x], b[x + half]));
    for (std::int32_t x = inner; x < columns; ++x) into[x] = better(a[x], b[x]);
  }
}

void update_reach(SweepState& state) {
  update_cells(state);
  SweepReach& reach = state.reach;
  const auto cells = static_cast<std::size_t>(reach.cells);
  const auto lesser = [](float a, float b) { return b < a ? b : a; };
  const auto greater = [](float a, float b) { return b > a ? b : a; };
  for (std::int32_t level = 1; level < reach.levels; ++level) {
    const std::size_t from = static_cast<std::size_t>(level - 1) * cells;
    const std::span nearest(reach.nearest), farthest(reach.farthest);
    const std::int32_t half = 1 << (level - 1);
    double_squares(nearest.subspan(from, cells), nearest.subspan(from + cells, cells), reach.columns, state.bins.rows,
                   half, lesser);
    double_squares(farthest.subspan(from, cells), farthest.subspan(from + cells, cells), reach.columns, state.bins.rows,
                   half, greater);
  }
}

/// Adds the hits of rays along the line, or against it.
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
    const float weight = 1 / std::max(hits.distance[slot], min_distance);
    const glm::vec4 seen = color[static_cast<std::size_t>(a)] * first + color[static_cast<std::size_t>(b)] * second +
                           color[static_cast<std::size_t>(c)] * third;

    const auto point = static_cast<std::size_t>(state.point_of_slot[slot]);
    sums.color_and_weight[point] += weight * seen;
    if (!surfaces.fourth.empty()) {
      float fourth = surfaces.fourth[static_cast<std::size_t>(a)] * first;
      fourth += surfaces.fourth[static_cast<std::size_t>(b)] * second;
      fourth += surfaces.fourth[static_cast<std::size_t>(c)] * third;
      sums.fourth[point] += weight * fourth;
    }
    const std::uint16_t part = (sees_front ? surfaces.front_part : surfaces.back_part)[triangle];
    sums.part_weight[point * parts + part] += weight;
  }
}

/// The approximate normal of the plane of all points, if there is one; it only sets the direction of bins.
std::optional<glm::vec3> normal_of_plane(std::span<const glm::vec3> points) {
  glm::vec3 far(0), normal(0);
  for (const glm::vec3& p : points) {
    const glm::vec3 offset = p - points.front();
    if (glm::dot(offset, offset) > glm::dot(far, far)) far = offset;
  }
  for (const glm::vec3& p : points) {
    const glm::vec3 n = glm::cross(far, p - points.front());
    if (glm::dot(n, n) > glm::dot(normal, normal)) normal = n;
  }
  if (glm::length(normal) < 1e-4f) return std::nullopt;
  normal = glm::normalize(normal);
  for (const glm::vec3& p : points) {
    if (std::fabs(glm::dot(normal, p - points.front())) > 1e-3f) return std::nullopt;
  }
  return normal;
}

/// The same line with across_u along the direction in which a plane looks narrower.
Line turned_towards(const Line& line, const glm::vec3& normal) {
  const glm::dvec3 along(line.along), n(normal);
  const glm::dvec3 narrow = n - glm::dot(n, along) * along;
  const double length = glm::length(narrow);
  if (length < 1e-3) return line;
  const glm::dvec3 u = narrow / length;
  return {glm::vec3(u), glm::vec3(glm::cross(along, u)), line.along};
}

}  // namespace

LineSweep::LineSweep(const PackedSurfaces& surfaces, const GroupBoxes& boxes, std::span<const glm::vec3> points,
                     bool follow_plane)
    : surfaces_(surfaces),
      boxes_(boxes),
      normal_(follow_plane ? normal_of_plane(points) : std::nullopt),
      state_(std::make_unique<SweepState>()) {
  SweepState& state = *state_;
  state.points = points.size();
  const std::size_t count = points.size() + SweepState::padding;
  for (AlignedFloats* floats :
       {&state.x, &state.y, &state.z, &state.u, &state.v, &state.w, &state.slot_u, &state.slot_v, &state.slot_w}) {
    *floats = aligned_array<float>(count);
    std::fill_n(floats->get(), count, 0.0f);
  }
  state.bin = aligned_array<std::int32_t>(count);
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

void LineSweep::add(const Line& given, SweepSums& sums) {
  SweepState& state = *state_;
  const Line line = normal_ ? turned_towards(given, *normal_) : given;
  const float squeeze = normal_ ? std::fabs(glm::dot(*normal_, given.along)) : 1;
  project_points(line, state);
  lay_out_bins(state, squeeze);
  find_bins(state);
  fill_slots(state);
  lay_out_reach(state);

  // Tests the nearest groups first, in rounds that double; later rounds leave out what is hidden by now.
  forget(state.ahead, state.points + SweepState::padding);
  forget(state.behind, state.points + SweepState::padding);
  const std::size_t groups = boxes_.group.size();
  std::size_t size = first_round;
  for (std::size_t first = 0; first < groups; size *= 2) {
    const std::size_t end = std::min(groups, first + size);
    if (first > 0) update_reach(state);
    cover(line, boxes_, first, end, surfaces_.groups, state);
    first = end;
  }
  shade(surfaces_, state, state.ahead, true, sums);
  shade(surfaces_, state, state.behind, false, sums);
}

}  // namespace pomona
