#include "render/style/hairs.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/random.h"

namespace pomona {

namespace {

/// Square millimetres in a square metre.
constexpr double square_millimetres = 1e6;

/// The number of hairs of a triangle, not rounded.
double hairs_on(const Solid& solid, std::size_t triangle) {
  if (solid.mesh.cut_face[triangle] >= 0) return 0;
  const Fuzz fuzz = material_of(solid, solid.mesh.part[solid.mesh.triangle[triangle].x]).fuzz;
  const double area = 0.5 * glm::length(solid.mesh.area_vector(triangle));
  return fuzz.length > 0 ? fuzz.density * area * square_millimetres : 0;
}

/// Random numbers from one stream, one after another.
class HairDraws {
 public:
  explicit HairDraws(const RandomStream& stream, std::uint64_t first) : stream_(stream), next_(first) {}
  double share() { return stream_.uniform(next_++); }
  double signed_share() { return 2 * share() - 1; }

 private:
  const RandomStream& stream_;
  std::uint64_t next_;
};

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : fallback;
}

Hair hair_on(const Solid& solid, const glm::uvec3& t, HairDraws draws) {
  // A uniformly random place in the triangle.
  double u = draws.share(), v = draws.share();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const auto blend = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return glm::dvec3(a) * (1 - u - v) + glm::dvec3(b) * u + glm::dvec3(c) * v;
  };
  const glm::dvec3 root = blend(solid.mesh.position[t.x], solid.mesh.position[t.y], solid.mesh.position[t.z]);
  const glm::dvec3 n =
      unit_or(blend(solid.mesh.normal[t.x], solid.mesh.normal[t.y], solid.mesh.normal[t.z]), {0, 1, 0});

  // Down along the skin, and to a random side.
  const double astray_x = draws.signed_share(), astray_y = draws.signed_share(), astray_z = draws.signed_share();
  const glm::dvec3 way = glm::dvec3(0, -0.8, 0) + glm::dvec3(astray_x, astray_y, astray_z);
  const glm::dvec3 along = unit_or(way - n * glm::dot(way, n), glm::dvec3(0));

  const Fuzz fuzz = material_of(solid, solid.mesh.part[t.x]).fuzz;
  const double length = fuzz.length * (0.45 + 0.55 * draws.share()), lie = fuzz.lie;
  const glm::dvec3 rise = unit_or(n * (1.05 - 0.7 * lie) + along * (0.9 * lie), n);
  const glm::dvec3 bend = unit_or(n * (1.05 - lie) + along * (0.15 + 1.2 * lie), n);
  const float light = static_cast<float>(0.7 + 0.5 * draws.share());
  const glm::dvec3 middle = root + 0.5 * length * rise;
  return {glm::vec3(root), glm::vec3(middle), glm::vec3(middle + 0.5 * length * bend), glm::vec3(n),
          glm::min(fuzz.color * light, Color(1.0f))};
}

}  // namespace

std::vector<Hair> hairs_of(const Solid& solid, std::size_t max) {
  double total = 0;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) total += hairs_on(solid, t);
  std::vector<Hair> hairs;
  if (total == 0) return hairs;
  const double kept = std::min(1.0, static_cast<double>(max) / total);

  // Goes over the triangles and sets a hair whenever their shares add up to one.
  const RandomStream stream({}, "fuzz");
  constexpr std::uint64_t draws_per_hair = 8;
  double sown = 0;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    sown += kept * hairs_on(solid, t);
    while (static_cast<double>(hairs.size()) + 0.5 < sown && hairs.size() < max) {
      hairs.push_back(hair_on(solid, solid.mesh.triangle[t], HairDraws(stream, draws_per_hair * hairs.size())));
    }
  }
  return hairs;
}

}  // namespace pomona
