#include "generator/diffusion/harmonic/short_rays.h"

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// A surface that is behind a corner by less than this share of the ray hides the corner, too. If it is the same side,
/// both have the same colour; else the corner lies behind it.
constexpr float reach = 1.0002f;

/// A fraction larger than that of any hit.
constexpr float free_way = 2;

}  // namespace

ShortRays::ShortRays(const glm::vec3& low) : across_{{{low.x, low.x + 1}, {low.y, low.y + 1}, {low.z, low.z + 1}}} {
  for (Four& four : four_) four.fraction = Quad{free_way, free_way, free_way, free_way};
}

void ShortRays::meet(const SeenTriangle& triangle, std::uint32_t number) {
  // A ray d meets the triangle where all three volumes (d, edge) have one sign; those of a shared edge are each other's
  // exact negatives.
  const std::array<glm::vec3, 3> across = {glm::cross(triangle.b, triangle.c), glm::cross(triangle.c, triangle.a),
                                           glm::cross(triangle.a, triangle.b)};
  const float volume = glm::dot(triangle.a, across[0]);
  for (int upper = 0; upper < 2; ++upper) {
    std::array<Quad, 3> part;
    for (std::size_t e = 0; e < 3; ++e) {
      const float x0 = across_[0][0] * across[e].x, x1 = across_[0][1] * across[e].x;
      const float y0 = across_[1][0] * across[e].y, y1 = across_[1][1] * across[e].y;
      part[e] = Quad{x0 + y0, x1 + y0, x0 + y1, x1 + y1} + across_[2][static_cast<std::size_t>(upper)] * across[e].z;
    }
    const Quad sum = part[0] + part[1] + part[2];
    const Quad fraction = volume / sum;
    Four& four = four_[static_cast<std::size_t>(upper)];
    const auto inside =
        ((part[0] >= 0) & (part[1] >= 0) & (part[2] >= 0)) | ((part[0] <= 0) & (part[1] <= 0) & (part[2] <= 0));
    const auto nearer = inside & (fraction >= 0) & (fraction <= reach) & (fraction < four.fraction);
    if ((nearer[0] | nearer[1] | nearer[2] | nearer[3]) == 0) continue;
    const Quad inverse = 1.0f / sum;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!nearer[k]) continue;
      four.fraction[k] = fraction[k];
      four.weight_a[k] = part[0][k] * inverse[k];
      four.weight_b[k] = part[1][k] * inverse[k];
      four.triangle[k] = number;
      four.sees_front[k] = volume < 0;
    }
  }
}

std::optional<ShortRayHit> ShortRays::hit(int k) const {
  const Four& four = four_[static_cast<std::size_t>(k >> 2)];
  const auto lane = static_cast<std::size_t>(k & 3);
  if (four.fraction[lane] == free_way) return std::nullopt;
  const float a = four.weight_a[lane], b = four.weight_b[lane];
  return ShortRayHit{four.fraction[lane], four.triangle[lane], {a, b, 1 - a - b}, four.sees_front[lane]};
}

}  // namespace pomona
