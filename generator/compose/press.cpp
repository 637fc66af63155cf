#include "generator/compose/press.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

constexpr double least_room = 0.05;   // of a body's reach: no plane comes nearer to its heart
constexpr double least_share = 0.02;  // nothing is drawn nearer to the heart

/// The second moments of a body in the fruit's frame.
glm::dmat3 spread_of(const PressedBody& body) {
  const double square = body.pose.scale * body.pose.scale;
  return body.pose.turn * body.reach->spread() * glm::transpose(body.pose.turn) * square;
}

double reach_of(const PressedBody& body, const glm::dvec3& direction) {
  return body.pose.scale * body.reach->along(body.pose.turned_back(direction));
}

}  // namespace

PressCell::PressCell(const PressSketch& press, const std::vector<PressedBody>& bodies, std::size_t own,
                     const std::vector<PressWall>& walls)
    : reach_(*bodies[own].reach), soft_(press.soft) {
  const PressedBody& body = bodies[own];
  const glm::dvec3 heart = body.heart();
  const auto add_plane = [&](const glm::dvec3& normal, double at) {
    add(body.pose.turned_back(normal), at / body.pose.scale);
  };
  for (std::size_t other = 0; other < bodies.size(); ++other) {
    if (other == own) continue;
    const glm::dvec3 way = bodies[other].heart() - heart;
    const double distance = glm::length(way);
    const double farthest = body.pose.scale * body.reach->farthest() +
                            bodies[other].pose.scale * bodies[other].reach->farthest() + press.gap;
    if (distance >= farthest || distance == 0) continue;
    const glm::dvec3 towards = way / distance;
    const double mine = reach_of(body, towards), theirs = reach_of(bodies[other], -towards);
    const glm::dvec3 meet = way * (mine / (mine + theirs));

    // Long bodies part lengthwise.
    const glm::dvec3 normal = glm::normalize(glm::inverse(spread_of(body) + spread_of(bodies[other])) * towards);
    add_plane(normal, glm::dot(meet, normal) - 0.5 * press.gap);
  }
  for (const PressWall& wall : walls) add_plane(wall.normal, glm::dot(wall.point - heart, wall.normal));
}

void PressCell::add(const glm::dvec3& normal, double at) {
  const double least = least_room * reach_.farthest();
  if (at < least) crowded_ = true;
  planes_.push_back({normal, std::max(at, least)});
}

double PressCell::share(const glm::dvec3& direction) const {
  // The soft minimum of 1 and of what each plane leaves.
  const glm::dvec3 d = direction / glm::length(direction);
  const double reach = reach_.along(d);
  double sum = reproducible::exp(-1 / soft_);
  constexpr double far = 2;
  for (const PressPlane& plane : planes_) {
    const double towards = glm::dot(d, plane.normal);
    if (towards * reach * far <= plane.at) continue;
    sum += reproducible::exp(-plane.at / (towards * reach * soft_));
  }
  return std::clamp(-reproducible::log(sum) * soft_, least_share, 1.0);
}

double PressCell::to_plane(const glm::dvec3& way) const {
  double factor = 2;
  for (const PressPlane& plane : planes_) {
    const double towards = glm::dot(way, plane.normal);
    if (towards * factor > plane.at) factor = plane.at / towards;
  }
  return factor;
}

DiffusionSurfaces PressCell::pressed(DiffusionSurfaces body) const {
  if (planes_.empty()) return body;
  for (glm::vec3& p : body.position) {
    const glm::dvec3 way = glm::dvec3(p) - reach_.heart();
    if (way == glm::dvec3(0)) continue;
    p = glm::vec3(reach_.heart() + way * std::min(share(way), to_plane(way)));
  }
  return body;
}

}  // namespace pomona
