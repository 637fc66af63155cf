#include "generator/scene/lay_out.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

namespace {

/// Where cut faces look: up and towards the eye, so that they are seen without much foreshortening.
const glm::dvec3 shown_direction = glm::normalize(glm::dvec3(0.0, 1.0, 0.75));

/// The direction in which a piece shows the most of its cut faces; zero for a whole fruit.
glm::dvec3 cut_direction(const Solid& solid) {
  std::map<std::int32_t, glm::dvec3> area;  // of each cut face, as a vector along its normal
  for (std::size_t t = 0; t < solid.triangle.size(); ++t) {
    if (solid.cut_face[t] < 0) continue;
    const glm::uvec3& v = solid.triangle[t];
    const glm::dvec3 a(solid.position[v.x]), b(solid.position[v.y]), c(solid.position[v.z]);
    area[solid.cut_face[t]] += glm::cross(b - a, c - a);
  }
  glm::dvec3 sum(0.0), largest(0.0);
  double total = 0;
  for (const auto& [face, vector] : area) {
    sum += vector;
    total += glm::length(vector);
    if (glm::length(vector) > 1.001 * glm::length(largest)) largest = vector;
  }
  if (total == 0) return glm::dvec3(0.0);

  // The faces of a wedge are shown together; those of a slice look away from each other, so one is shown.
  return glm::normalize(glm::length(sum) > 0.2 * total ? sum : largest);
}

/// Right-handed frame with `forward` as its third axis and its second as near to `up` as can be.
glm::dmat3 frame(const glm::dvec3& forward, const glm::dvec3& up) {
  const glm::dvec3 helper = std::abs(glm::dot(forward, up)) > 0.95 ? glm::dvec3(0, 0, -1) : up;
  const glm::dvec3 right = glm::normalize(glm::cross(helper, forward));
  return {right, glm::cross(forward, right), forward};
}

glm::dquat shown(const Solid& solid) {
  const glm::dvec3 direction = cut_direction(solid);
  if (direction == glm::dvec3(0.0)) return {1, 0, 0, 0};
  const glm::dvec3 up(0, 1, 0);
  return glm::normalize(glm::quat_cast(frame(shown_direction, up) * glm::transpose(frame(direction, up))));
}

Box<double> turned_bounds(const Solid& solid, const glm::dquat& rotation) {
  if (solid.position.empty()) return {glm::dvec3(0), glm::dvec3(0)};
  Box<double> bounds;
  for (const glm::vec3& p : solid.position) bounds.add(rotation * glm::dvec3(p));
  return bounds;
}

/// What a piece takes up on the table, seen from shown_direction: a tall one hides what lies behind it.
glm::dvec2 footprint(const Box<double>& bounds) {
  const double hidden_behind = bounds.size().y * shown_direction.z / shown_direction.y;
  return {bounds.size().x, bounds.size().z + hidden_behind};
}

/// Rows are filled up to this width, metres: half again as wide as deep, like a picture.
double row_width(const std::vector<glm::dvec2>& footprints) {
  double area = 0, widest = 0;
  for (const glm::dvec2& size : footprints) {
    area += size.x * size.y;
    widest = std::max(widest, size.x);
  }
  return std::max(widest, 1.5 * std::sqrt(area)) * 1.2;
}

/// Larger pieces first, so that crumbs share a row.
std::vector<std::size_t> by_size(const std::vector<glm::dvec2>& footprints) {
  std::vector<std::size_t> order(footprints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rough_size = [&](std::size_t i) {
    return std::lround(2 * reproducible::log(footprints[i].x + footprints[i].y));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rough_size(a) > rough_size(b); });
  return order;
}

}  // namespace

Scene laid_out(const Scene& scene) {
  Scene table = scene;
  std::vector<Box<double>> bounds;
  std::vector<glm::dvec2> footprints;
  for (Instance& instance : table.instances) {
    const Solid& solid = table.solids[static_cast<std::size_t>(instance.solid)];
    instance.pose.rotation = shown(solid);
    bounds.push_back(turned_bounds(solid, instance.pose.rotation));
    footprints.push_back(footprint(bounds.back()));
  }

  // Fill rows from the left, the first row farthest from the eye; gaps follow the size of the pieces.
  constexpr double gap = 0.15;
  const double width = row_width(footprints);
  double x = 0, z = 0, depth = 0;
  for (const std::size_t i : by_size(footprints)) {
    const glm::dvec2 size = footprints[i] * (1 + gap);
    if (x > 0 && x + size.x > width) {
      x = 0;
      z += depth;
      depth = 0;
    }
    // Nearer rows hide what lies behind them: leave their height's shadow free on the far side.
    const double behind = footprints[i].y - bounds[i].size().z;
    table.instances[i].pose.translation = glm::dvec3(x, 0.0, z + behind) - bounds[i].low;
    x += size.x;
    depth = std::max(depth, size.y);
  }
  table.ground = true;
  table.view = fitted_view(table, shown_direction);
  return table;
}

}  // namespace pomona
