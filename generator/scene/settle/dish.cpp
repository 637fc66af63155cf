#include "generator/scene/settle/dish.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/curve.h"
#include "generator/mesh/triangle_tree.h"

namespace pomona {

namespace {

/// Appends the points that the stretch behind `first`, up to `last`, needs [Douglas & Peucker 1973].
void simplify(const std::vector<glm::dvec2>& samples, std::size_t first, std::size_t last, double tolerance,
              std::vector<glm::dvec2>& kept) {
  std::size_t farthest = first;
  double max_distance = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d = distance_to_segment(samples[i], samples[first], samples[last]);
    if (d > max_distance) max_distance = d, farthest = i;
  }
  if (farthest == first) {
    kept.push_back(samples[last]);
    return;
  }
  simplify(samples, first, farthest, tolerance, kept);
  simplify(samples, farthest, last, tolerance, kept);
}

/// Points (distance from the axis, height) of the upper surface, from the axis out to `radius`, metres: as few as keep
/// the error below `tolerance`, metres. The mesh must be round about the axis and reach as far as `radius`.
std::vector<glm::dvec2> stand_profile(const TriangleTree& stand, double radius, double tolerance) {
  constexpr int count = 1024;
  const double sky = stand.box().high.y + 1;
  std::vector<glm::dvec2> samples;
  for (int i = 0; i <= count; ++i) {
    // Along a direction that is no multiple of any usual step around, so as to meet no mesh edge end on.
    const double r = radius * i / count;
    samples.emplace_back(r, stand.height_below({0.99713 * r + 1e-7, sky, -0.07571 * r + 1e-7}));
  }
  std::vector<glm::dvec2> kept{samples.front()};
  simplify(samples, 0, samples.size() - 1, tolerance, kept);
  return kept;
}

}  // namespace

Dish::Dish(const DishForm& dish, const DishOptions& options) {
  const Solid* const bowl = dish.solid;
  if (bowl) {
    for (const glm::vec3& p : bowl->mesh.position) {
      const double radius = std::sqrt(static_cast<double>(p.x) * p.x + static_cast<double>(p.z) * p.z);
      widest_ = std::max(widest_, radius);
      if (p.y > rim_height_) rim_height_ = p.y, rim_radius_ = radius;
    }
  }
  lay_ground(bowl, options.ground);
  if (has_bowl() && dish.turned) bake(options);
  if (has_bowl() && !dish.turned)
    form_ =
        std::make_shared<const MeshDish>(*bowl, TriangleTree(bowl->mesh.position, bowl->mesh.triangle), dish.on_top);
}

bool Dish::holds() const {
  if (!has_bowl()) return true;
  if (form_) return !form_->places().empty();
  constexpr double shallowest = 0.05;  // smallest depth of a bowl, as a share of the rim's height
  return turned_height(0) < (1 - shallowest) * rim_height_;
}

bool Dish::covers(const glm::dvec3& point) const {
  if (!has_bowl()) return true;
  if (form_) return form_->covers(point.x, point.z);
  return point.x * point.x + point.z * point.z <= rim_radius_ * rim_radius_;
}

/// The ground is a slab with its upper face at y = 0.
void Dish::lay_ground(const Solid* bowl, double min) {
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> triangle;
  if (bowl) position = bowl->mesh.position, triangle = bowl->mesh.triangle;
  const auto first = static_cast<unsigned>(position.size());
  const float wide = static_cast<float>(std::max(4 * rim_radius_, min)), deep = -0.25f * wide;
  for (const float y : {deep, 0.0f})
    for (const glm::vec2& xz : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
      position.emplace_back(xz.x * wide, y, xz.y * wide);
  for (const glm::uvec3& t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3), glm::uvec3(4, 6, 5), glm::uvec3(4, 7, 6)})
    triangle.push_back(t + first);
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = (i + 1) % 4;
    triangle.push_back(glm::uvec3(i, 4 + i, j) + first);
    triangle.push_back(glm::uvec3(j, 4 + i, 4 + j) + first);
  }
  mesh_ = {TriangleTree(position, triangle), glm::dvec3(0), bowl ? 2 * rim_radius_ : wide};
}

void Dish::bake(const DishOptions& options) {
  constexpr double tolerance = 2e-4;  // error of the profile, as a share of the rim's radius
  profile_ = stand_profile(mesh_.mesh, 1.02 * widest_, tolerance * rim_radius_);
  const double reach = widest_ + options.around, low = -3 * options.cell;
  profile_.emplace_back(2 * reach, profile_.back().y);

  cell_ = static_cast<float>(options.cell);
  lowest_ = static_cast<float>(low);
  columns_ = static_cast<int>(reach / options.cell) + 2;
  rows_ = static_cast<int>((rim_height_ + options.around - low) / options.cell) + 2;
  values_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int j = 0; j < rows_; ++j) {
    for (int i = 0; i < columns_; ++i) {
      const glm::dvec2 point(i * options.cell, low + j * options.cell);
      double nearest = 2 * reach;
      for (std::size_t k = 1; k < profile_.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(point, profile_[k - 1], profile_[k]));
      values_.push_back(static_cast<float>(point.y < turned_height(point.x) ? -nearest : nearest));
    }
  }
}

double Dish::height(double x, double z) const {
  if (!has_bowl()) return 0;
  return form_ ? form_->height(x, z) : turned_height(std::sqrt(x * x + z * z));
}

double Dish::turned_height(double radius) const {
  const auto next = std::find_if(profile_.begin(), profile_.end(), [&](const auto& p) { return p.x >= radius; });
  if (next == profile_.end()) return 0;
  if (next == profile_.begin()) return next->y;
  const glm::dvec2 before = *(next - 1);
  const double width = next->x - before.x;
  return width > 1e-12 ? before.y + (next->y - before.y) * ((radius - before.x) / width) : next->y;
}

float Dish::field(float radius, float height) const {
  const float x = radius / cell_, y = std::max(0.0f, (height - lowest_) / cell_);
  if (x >= static_cast<float>(columns_ - 1)) return height;  // the bowl is far away: the ground
  if (y >= static_cast<float>(rows_ - 1)) return height - static_cast<float>(rim_height_);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float right = x - static_cast<float>(i), up = y - static_cast<float>(j);
  const float* const below = &values_[static_cast<std::size_t>(j * columns_ + i)];
  const float* const above = below + columns_;
  const float low = below[0] + (below[1] - below[0]) * right, high = above[0] + (above[1] - above[0]) * right;
  return low + (high - low) * up;
}

float Dish::distance(const glm::vec3& point) const {
  if (form_) return std::min(form_->distance(point), point.y);
  return has_bowl() ? field(std::sqrt(point.x * point.x + point.z * point.z), point.y) : point.y;
}

glm::vec3 Dish::direction(const glm::vec3& point) const {
  const glm::vec3 upwards(0, 1, 0);
  if (form_) return form_->distance(point) < point.y ? form_->direction(point) : upwards;
  const float radius = std::sqrt(point.x * point.x + point.z * point.z);
  if (!has_bowl() || radius < 1e-6f) return upwards;
  const float e = 0.5f * cell_;
  const float out = field(radius + e, point.y) - field(std::fabs(radius - e), point.y);
  const float up = field(radius, point.y + e) - field(radius, point.y - e);
  const float length = std::sqrt(out * out + up * up);
  if (length < 1e-12f) return upwards;
  return glm::vec3(out * point.x / radius, up, out * point.z / radius) / length;
}

}  // namespace pomona
