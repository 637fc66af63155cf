#include "render/thumbnail/sample_grid.h"

#include "render/thumbnail/covered_samples.h"

namespace pomona {

namespace {

std::size_t samples_of(int side) { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }

}  // namespace

SampleGrid::SampleGrid(int side)
    : side_(side), nearness_(samples_of(side), 0.0f), owner_(samples_of(side), 0), color_(samples_of(side)) {}

void SampleGrid::draw(const std::array<GridCorner, 3>& corners, std::uint32_t owner) {
  const GridCorner &a = corners[0], &b = corners[1], &c = corners[2];
  const glm::dvec3 nearness(a.at.nearness, b.at.nearness, c.at.nearness);
  for_covered_samples({a.at, b.at, c.at}, side_, [&](int x, int y, const glm::dvec3& weight) {
    const std::size_t i = index(x, y);
    const auto here = static_cast<float>(weight.x * nearness.x + weight.y * nearness.y + weight.z * nearness.z);
    if (here <= nearness_[i]) return;
    nearness_[i] = here;
    owner_[i] = owner;
    const glm::vec3 w(weight);
    color_[i] = w.x * a.color + w.y * b.color + w.z * c.color;
  });
}

}  // namespace pomona
