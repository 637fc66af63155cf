#include "generator/scene/settle/surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/box.h"
#include "generator/mesh/edges.h"

namespace pomona {

namespace {

constexpr int max_in_ball = 12;

/// Two ends and the middle of every edge at which the surface turns by more than 40 degrees.
std::vector<glm::vec3> on_sharp_edges(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle) {
  constexpr double cosine = 0.77;
  const auto normal = [&](std::uint32_t i) {
    const glm::uvec3& t = triangle[i];
    const glm::dvec3 n = glm::cross(position[t.y] - position[t.x], position[t.z] - position[t.x]);
    return n / std::max(1e-30, glm::length(n));
  };
  std::vector<glm::vec3> points;
  const std::vector<HalfEdge> sorted = sorted_half_edges(triangle);
  for_each_edge(sorted, [&](std::span<const HalfEdge> edge) {
    if (edge.size() < 2 || glm::dot(normal(edge[0].triangle), normal(edge[1].triangle)) > cosine) return;
    const glm::dvec3 &a = position[edge[0].low], &b = position[edge[0].high];
    for (const glm::dvec3& p : {a, b, 0.5 * (a + b)}) points.emplace_back(p);
  });
  return points;
}

std::vector<glm::vec3> on_the_surface(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle) {
  std::vector<glm::vec3> points(position.begin(), position.end());
  for (const glm::uvec3& t : triangle) points.emplace_back((position[t.x] + position[t.y] + position[t.z]) / 3.0);
  return points;
}

/// Keeps the first point in each cell of a grid.
std::vector<glm::vec3> thinned(const std::vector<glm::vec3>& points, float spacing) {
  struct Entry {
    std::array<int, 3> cell;
    std::size_t point;
    bool operator<(const Entry& other) const { return cell != other.cell ? cell < other.cell : point < other.point; }
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::ivec3 cell(glm::floor(points[i] / spacing));
    entries.push_back({{cell.x, cell.y, cell.z}, i});
  }
  std::sort(entries.begin(), entries.end());
  std::vector<glm::vec3> kept;
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (i == 0 || entries[i].cell != entries[i - 1].cell) kept.push_back(points[entries[i].point]);
  return kept;
}

/// Halves the points at the middle of their longest side until few are left.
void add_balls(SurfaceSamples& samples, int first, int count) {
  const auto begin = samples.point.begin() + first;
  Box<float> box;
  for (auto p = begin; p != begin + count; ++p) box.add(*p);
  const bool is_leaf = count <= max_in_ball;
  SampleBall ball{box.center(), 0, first, is_leaf ? count : 0, 0};
  for (auto p = begin; p != begin + count; ++p) ball.radius = std::max(ball.radius, glm::distance(ball.center, *p));

  const std::size_t me = samples.ball.size();
  samples.ball.push_back(ball);
  if (!is_leaf) {
    const int axis = longest_axis(box.size());
    std::stable_sort(begin, begin + count, [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    add_balls(samples, first, count / 2);
    add_balls(samples, first + count / 2, count - count / 2);
  }
  samples.ball[me].after = static_cast<int>(samples.ball.size());
}

}  // namespace

SurfaceSamples surface_samples(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle,
                               SampleOptions options) {
  SurfaceSamples samples;
  if (triangle.empty()) return samples;
  const std::vector<glm::vec3> sharp = on_sharp_edges(position, triangle);
  const std::vector<glm::vec3> smooth = on_the_surface(position, triangle);
  for (;; options.along_edges *= 1.15, options.elsewhere *= 1.1) {
    samples.point = thinned(sharp, static_cast<float>(options.along_edges));
    const std::vector<glm::vec3> more = thinned(smooth, static_cast<float>(options.elsewhere));
    samples.point.insert(samples.point.end(), more.begin(), more.end());
    if (samples.point.size() <= options.max_points) break;
  }
  add_balls(samples, 0, static_cast<int>(samples.point.size()));
  return samples;
}

}  // namespace pomona
