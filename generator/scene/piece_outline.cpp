#include "generator/scene/piece_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/box.h"
#include "generator/piece/piece_facts.h"

namespace pomona {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

std::size_t bin_of(const glm::dvec3& direction, int cells) {
  const int axis = longest_axis(glm::abs(direction));
  const auto cell = [&](int other) {
    return std::min(static_cast<int>(0.5 * (1 + direction[other] / std::fabs(direction[axis])) * cells), cells - 1);
  };
  const int side = 2 * axis + (direction[axis] < 0 ? 1 : 0);
  return static_cast<std::size_t>((side * cells + cell((axis + 1) % 3)) * cells + cell((axis + 2) % 3));
}

}  // namespace

PieceOutline::PieceOutline(const Solid& solid) : center_(facts_of(solid).center) {
  constexpr int cells = 14;
  std::vector<std::size_t> farthest(6 * cells * cells, none);
  std::vector<double> reach(farthest.size(), -1);
  for (std::size_t i = 0; i < solid.mesh.position.size(); ++i) {
    const glm::dvec3 arm = glm::dvec3(solid.mesh.position[i]) - center_;
    const double length = glm::length(arm);
    if (!(length > 0)) continue;
    const std::size_t bin = bin_of(arm, cells);
    if (length > reach[bin]) {
      reach[bin] = length;
      farthest[bin] = i;
    }
    radius_ = std::max(radius_, length);
  }
  for (const std::size_t i : farthest)
    if (i != none) arms_.push_back(glm::dvec3(solid.mesh.position[i]) - center_);
}

glm::dvec3 PieceOutline::rested(glm::dvec3 up) const {
  double step = 0.08;
  for (int i = 0; i < 90 && !arms_.empty(); ++i, step *= 0.94) {
    const glm::dvec3 arm = lowest(up);  // from the centre of mass to the point on which it stands
    const glm::dvec3 aside = arm - glm::dot(arm, up) * up;
    const double off = glm::length(aside);
    if (off < 1e-3 * radius_) break;
    up = glm::normalize(up + std::min(step, off / radius_) * aside / off);
  }
  return up;
}

PieceOutline::Plan PieceOutline::plan(const glm::dvec3& up) const {
  const glm::dvec3 first = level_direction(up), second = glm::cross(up, first);
  Plan plan{first, 0};
  for (int i = 0; i < 36; ++i) {
    const double angle = i * 5 * pi / 180;
    const glm::dvec3 along = reproducible::cos(angle) * first + reproducible::sin(angle) * second;
    const double width = extent(glm::cross(up, along));
    const double ratio = width > 0 ? extent(along) / width : 1;
    if (ratio > plan.ratio) plan = {along, ratio};
  }
  return plan;
}

glm::dvec3 PieceOutline::lowest(const glm::dvec3& up) const {
  glm::dvec3 arm(0);
  double min = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& a : arms_) {
    const double height = glm::dot(a, up);
    if (height < min) {
      min = height;
      arm = a;
    }
  }
  return arm;
}

double PieceOutline::extent(const glm::dvec3& along) const {
  double low = 0, high = 0;
  for (const glm::dvec3& a : arms_) {
    low = std::min(low, glm::dot(a, along));
    high = std::max(high, glm::dot(a, along));
  }
  return high - low;
}

glm::dvec3 level_direction(const glm::dvec3& up) {
  const glm::dvec3 helper = std::fabs(up.y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  return glm::normalize(helper - glm::dot(helper, up) * up);
}

bool stands_on_a_tail(const Solid& solid) {
  if (solid.mesh.triangle.empty()) return false;
  const Box<float> box = box_around(solid.mesh.position);
  const double top = box.low.y + 0.2 * box.size().y;

  // The middle of the lowest fifth's surface, and its mean horizontal distance from it.
  struct Patch {
    glm::dvec3 middle;
    double area;
  };
  std::vector<Patch> patches;
  glm::dvec3 sum(0);
  double area = 0;
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const glm::dvec3 a(solid.mesh.position[t.x]), b(solid.mesh.position[t.y]), c(solid.mesh.position[t.z]);
    const Patch patch{(a + b + c) / 3.0, 0.5 * glm::length(glm::cross(b - a, c - a))};
    if (patch.middle.y > top) continue;
    patches.push_back(patch);
    sum += patch.area * patch.middle;
    area += patch.area;
  }
  if (!(area > 0)) return false;
  double away = 0;
  for (const Patch& patch : patches) {
    const glm::dvec3 aside = patch.middle - sum / area;
    away += patch.area * std::sqrt(aside.x * aside.x + aside.z * aside.z);
  }
  const float width = std::min(box.size().x, box.size().z);
  return away / area < width / 16;
}

bool stands_on_flat_ground(const Solid& solid) {
  const Box<float> box = box_around(solid.mesh.position);
  if (solid.mesh.triangle.empty() || box.size().y > std::max(box.size().x, box.size().z)) return false;
  const float bottom = box.low.y + 0.01f * box.size().y;
  double ground = 0, all = 0;  // areas as seen from below
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const auto [a, b, c] = solid.mesh.corners(t);
    const glm::dvec3 normal = 0.5 * solid.mesh.area_vector(t);
    if (normal.y >= 0) continue;
    all -= normal.y;
    const bool is_low = std::max({a.y, b.y, c.y}) <= static_cast<double>(bottom);
    if (is_low && solid.mesh.cut_face[t] < 0 && -normal.y > 0.99 * glm::length(normal)) ground -= normal.y;
  }
  return all > 0 && ground >= 0.6 * all;
}

}  // namespace pomona
