#include "render/style/relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

LookPlace place_beside(const LookPlace& place, const glm::dvec3& step) {
  LookPlace beside = place;
  beside.position += step;
  beside.guide = guide_beside(place.guide, step);
  return beside;
}

double half_texel(const LookPlace& place) { return std::max(0.5 * place.footprint, min_step); }

double open_at(double below) { return std::max(min_open, 1 - closed_by_depth * below); }

/// \param corner the heights left and right below, and left and right above
Relief relief_of(std::span<const Look::Height> corner, const Directions& along, double half) {
  const Look::Height &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
  const double to_right = (b.height - a.height + d.height - c.height) / (4 * half);
  const double to_up = (c.height - a.height + d.height - b.height) / (4 * half);
  const glm::dvec3 slope = to_right * along.first + to_up * along.second;
  return {(a.height + b.height + c.height + d.height) / 4,
          slope / std::sqrt(1 + glm::dot(slope, slope) / (max_slope * max_slope)),
          open_at((a.below + b.below + c.below + d.below) / 4)};
}

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
  const double step = half_texel(place);
  const Directions along = directions_at(normal);
  const Look::Height here = look.height(unmodulated, place);
  const auto growth = [&](const glm::dvec3& direction) {
    return (look.height(unmodulated, place_beside(place, step * direction)).height - here.height) / step;
  };
  return {here.height, growth(along.first) * along.first + growth(along.second) * along.second, open_at(here.below)};
}

Relief relief_over_texel(const Look& look, const Color& unmodulated, const LookPlace& place, const glm::dvec3& normal) {
  return reliefs_over_texels(look, {&unmodulated, 1}, {&place, 1}, {&normal, 1}).front();
}

std::vector<Relief> reliefs_over_texels(const Look& look, std::span<const Color> unmodulated,
                                        std::span<const LookPlace> places, std::span<const glm::dvec3> normals) {
  // The four corners of each texel that may have a relief.
  std::vector<std::size_t> relieved;
  std::vector<Color> colors;
  std::vector<LookPlace> corners;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!may_have_relief(look, places[i])) continue;
    const Directions along = directions_at(normals[i]);
    const double half = half_texel(places[i]);
    const glm::dvec3 right = half * along.first, up = half * along.second;
    for (const glm::dvec3& step : {-right - up, right - up, -right + up, right + up}) {
      corners.push_back(place_beside(places[i], step));
      colors.push_back(unmodulated[i]);
    }
    relieved.push_back(i);
  }

  const std::vector<Look::Height> height = look.height(colors, corners);
  std::vector<Relief> reliefs(places.size());
  for (std::size_t n = 0; n < relieved.size(); ++n) {
    const std::size_t i = relieved[n];
    reliefs[i] = relief_of({&height[4 * n], 4}, directions_at(normals[i]), half_texel(places[i]));
  }
  return reliefs;
}

}  // namespace pomona
