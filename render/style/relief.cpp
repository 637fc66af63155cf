#include "render/style/relief.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr double min_step = 1e-5;  // metres
constexpr double min_open = 0.4;
constexpr double closed_by_depth = 1.2;  // loss of light per depth below the mean, relative to the size of the pattern

constexpr double max_slope = 0.8;  // of a texel

glm::dvec3 unit(const glm::dvec3& v) { return v / std::sqrt(glm::dot(v, v)); }

bool may_have_relief(const Look& look, const LookPlace& place) {
  return place.guide.share != glm::vec4(0) && look.has_relief(place.face);
}

/// Two directions at right angles to each other and to the normal.
struct Directions {
  glm::dvec3 first{0}, second{0};
};

Directions directions_at(const glm::dvec3& normal) {
  const glm::dvec3 aside = std::fabs(normal.y) < 0.8 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 first = unit(glm::cross(aside, normal));
  return {first, glm::cross(normal, first)};
}

Look::Height height_beside(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& step) {
  LookPlace beside = place;
  beside.position += step;
  beside.guide = guide_beside(place.guide, step);
  return look.height(unmodulated, beside);
}

double open_at(double below) { return std::max(min_open, 1 - closed_by_depth * below); }

}  // namespace

DetailGuide guide_beside(const DetailGuide& guide, const glm::dvec3& step) {
  const glm::dvec3 way(guide.to_skin);
  const double length = std::sqrt(glm::dot(way, way));
  if (length < 1e-6) return guide;
  const double nearer = glm::dot(step, way) / length;
  DetailGuide beside = guide;
  beside.to_skin = glm::vec3(way * (1 - nearer / length));
  beside.layer = static_cast<float>(static_cast<double>(guide.layer) - nearer);
  return beside;
}

glm::dvec3 tilted(const glm::dvec3& normal, const glm::dvec3& slope) { return unit(normal - slope); }

Relief relief_at(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& normal) {
  if (!may_have_relief(look, place)) return {};
  const double step = std::max(0.5 * place.footprint, min_step);
  const Directions along = directions_at(normal);
  const Look::Height here = look.height(unmodulated, place);
  const auto growth = [&](const glm::dvec3& direction) {
    return (height_beside(look, unmodulated, place, step * direction).height - here.height) / step;
  };
  return {here.height, growth(along.first) * along.first + growth(along.second) * along.second, open_at(here.below)};
}

Relief relief_over_texel(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& normal) {
  if (!may_have_relief(look, place)) return {};
  const double half = std::max(0.5 * place.footprint, min_step);
  const Directions along = directions_at(normal);
  const glm::dvec3 right = half * along.first, up = half * along.second;
  const Look::Height a = height_beside(look, unmodulated, place, -right - up);
  const Look::Height b = height_beside(look, unmodulated, place, right - up);
  const Look::Height c = height_beside(look, unmodulated, place, -right + up);
  const Look::Height d = height_beside(look, unmodulated, place, right + up);
  const double to_right = (b.height - a.height + d.height - c.height) / (4 * half);
  const double to_up = (c.height - a.height + d.height - b.height) / (4 * half);
  const glm::dvec3 slope = to_right * along.first + to_up * along.second;
  return {(a.height + b.height + c.height + d.height) / 4,
          slope / std::sqrt(1 + glm::dot(slope, slope) / (max_slope * max_slope)),
          open_at((a.below + b.below + c.below + d.below) / 4)};
}

}  // namespace pomona
