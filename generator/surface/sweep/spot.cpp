#include "generator/surface/sweep/spot.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// The distance of the rim in a direction across the normal, over the radius: 1 plus or minus up to the raggedness.
double rim(const Spot& spot, const glm::dvec2& direction) {
  glm::dvec2 power = direction;  // the direction as a complex number, to the power of the wave's number
  double rim = 1;
  for (const glm::dvec2& wave : spot.waves) {
    power = {power.x * direction.x - power.y * direction.y, power.x * direction.y + power.y * direction.x};
    rim += glm::dot(wave, power);
  }
  return rim;
}

}  // namespace

double reach_of(const Spot& spot) { return 2 * spot.radius * std::max(1.0, spot.stretch); }

double cover_of(const Spot& spot, const glm::dvec3& point, const glm::dvec3& normal) {
  const glm::dvec3 away = point - spot.center;
  const double facing = 0.5 * (1 + glm::dot(normal, spot.normal));
  if (!(facing > 0) || glm::dot(away, away) > reach_of(spot) * reach_of(spot)) return 0;

  // The equivalent distance in a round spot.
  const double along = glm::dot(away, spot.tangent), across = glm::dot(away, glm::cross(spot.normal, spot.tangent));
  const double shortened = along / spot.stretch;
  const double chord = std::sqrt(std::max(0.0, glm::dot(away, away) - along * along + shortened * shortened));
  const double flat = std::sqrt(shortened * shortened + across * across);
  const double outline = flat > 0 ? rim(spot, glm::dvec2(shortened, across) / flat) : 1;
  const double share = chord / (std::sqrt(std::sqrt(facing)) * spot.radius * outline);

  // Full up to where the softness begins, then smoothly down to 0.
  if (share >= 1) return 0;
  if (share <= 1 - spot.softness) return spot.strength;
  const double left = (1 - share) / spot.softness;
  return spot.strength * left * left * (3 - 2 * left);
}

}  // namespace pomona
