#include "render/style/relief.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr double min_step = 1e-5;  // metres
constexpr double min_open = 0.4;
constexpr double closed_by_depth = 1.2;  // loss of light per depth below the mean, relative to the size of the pattern

glm::dvec3 unit(const glm::dvec3& v) { return v / std::sqrt(glm::dot(v, v)); }

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
  if (place.guide.share == glm::vec4(0) || !look.has_relief(place.face)) return {};
  const double step = std::max(0.5 * place.footprint, min_step);
  const glm::dvec3 aside = std::fabs(normal.y) < 0.8 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 first = unit(glm::cross(aside, normal)), second = glm::cross(normal, first);
  const Look::Height here = look.height(unmodulated, place);
  const auto growth = [&](const glm::dvec3& direction) {
    LookPlace beside = place;
    beside.position += step * direction;
    beside.guide = guide_beside(place.guide, step * direction);
    return (look.height(unmodulated, beside).height - here.height) / step;
  };
  return {here.height, growth(first) * first + growth(second) * second,
          std::max(min_open, 1 - closed_by_depth * here.below)};
}

}  // namespace pomona
