#include "render/style/skin_pits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/box.h"
#include "generator/mesh/disjoint_sets.h"

namespace pomona {

namespace {

constexpr int max_cells_along = 64;
constexpr std::size_t max_pits = 100'000;
constexpr std::size_t max_spots = 100'000;
constexpr double spot_step = 1.0 / 128;  // share of a spot's radius over which its slope is taken
constexpr int texels_of_pit = 2, texels_of_spot = 6;

double depth_around(const Solid& solid, std::size_t triangle) {
  return solid.mesh.cut_face[triangle] >= 0 ? 0
                                            : material_of(solid, solid.mesh.part[solid.mesh.triangle[triangle].x]).pit;
}

}  // namespace

SkinPits::SkinPits(const Solid& solid) : spots_(solid.raised) {
  const bool any = std::any_of(solid.look->materials.begin(), solid.look->materials.end(),
                               [](const MaterialSketch& material) { return material.pit > 0; });
  if (any) find(solid);
  if (spots_.size() > max_spots) spots_.resize(max_spots);
  if (!empty()) sort_into_cells();
}

/// A connected set of triangles of a part on the skin is a grain.
void SkinPits::find(const Solid& solid) {
  DisjointSets islands(solid.mesh.position.size());  // vertices that share a triangle or a place
  std::map<std::tuple<float, float, float>, std::uint32_t> known;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    if (!(depth_around(solid, t) > 0)) continue;
    const glm::uvec3& corners = solid.mesh.triangle[t];
    islands.join(corners.x, corners.y), islands.join(corners.x, corners.z);
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& p = solid.mesh.position[corners[k]];
      islands.join(corners[k], known.try_emplace({p.x, p.y, p.z}, corners[k]).first->second);
    }
  }

  // The middle of each grain's box, and its radius around it.
  struct Grain {
    Box<float> box;
    double depth = 0;
  };
  std::map<std::uint32_t, Grain> grains;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const double depth = depth_around(solid, t);
    if (!(depth > 0)) continue;
    Grain& grain = grains[islands.root(solid.mesh.triangle[t].x)];
    grain.depth = depth;
    for (int k = 0; k < 3; ++k) grain.box.add(solid.mesh.position[solid.mesh.triangle[t][k]]);
  }
  for (const auto& [island, grain] : grains) {
    const glm::dvec3 size(grain.box.size());
    const double radius = 0.5 * wider * std::sqrt(glm::dot(size, size));
    if (radius > 0 && pits_.size() < max_pits)
      pits_.push_back({glm::dvec3(grain.box.low + grain.box.high) / 2.0, radius, grain.depth});
  }
}

void SkinPits::sort_into_cells() {
  glm::dvec3 low(1e9), high(-1e9);
  double widest = 0;
  const auto hold = [&](const glm::dvec3& middle, double reach) {
    low = glm::min(low, middle - reach), high = glm::max(high, middle + reach);
    widest = std::max(widest, reach);
  };
  for (const Pit& pit : pits_) hold(pit.middle, pit.radius);
  for (const Spot& spot : spots_) hold(spot.center, reach_of(spot));
  const glm::dvec3 size = high - low;
  low_ = low;
  side_ = std::max(2 * widest, std::max({size.x, size.y, size.z}) / max_cells_along);
  count_ = glm::ivec3(glm::floor(size / side_)) + 1;
  cells_.resize(static_cast<std::size_t>(count_.x) * count_.y * count_.z);
  const auto visit = [&](const glm::dvec3& middle, double reach, const auto& put) {
    const glm::ivec3 from = glm::max(cell_at(middle - reach), glm::ivec3(0));
    const glm::ivec3 to = glm::min(cell_at(middle + reach), count_ - 1);
    for (int x = from.x; x <= to.x; ++x) {
      for (int y = from.y; y <= to.y; ++y) {
        for (int z = from.z; z <= to.z; ++z) put(cells_[index({x, y, z})]);
      }
    }
  };
  for (std::uint32_t i = 0; i < pits_.size(); ++i)
    visit(pits_[i].middle, pits_[i].radius, [&](Cell& cell) { cell.pits.push_back(i); });
  for (std::uint32_t i = 0; i < spots_.size(); ++i)
    visit(spots_[i].center, reach_of(spots_[i]), [&](Cell& cell) { cell.spots.push_back(i); });
}

glm::ivec3 SkinPits::cell_at(const glm::dvec3& place) const { return {glm::floor((place - low_) / side_)}; }

std::size_t SkinPits::index(const glm::ivec3& cell) const {
  return (static_cast<std::size_t>(cell.x) * count_.y + cell.y) * count_.z + cell.z;
}

void SkinPits::add_pits(const std::vector<std::uint32_t>& own, const glm::dvec3& place, PitPlace& found) const {
  for (const std::uint32_t i : own) {
    const Pit& pit = pits_[i];
    const glm::dvec3 away = (place - pit.middle) / pit.radius;
    const double left = 1 - glm::dot(away, away);
    if (left <= 0) continue;
    found.height -= pit.depth * left * left;
    found.slope += away * (4 * pit.depth * left / pit.radius);
    found.inside = std::max(found.inside, left * left);
  }
}

/// The slope, from two neighbouring places in the plane of the surface.
void SkinPits::add_spots(const std::vector<std::uint32_t>& own, const glm::dvec3& place, const glm::dvec3& normal,
                         PitPlace& found) const {
  const glm::dvec3 aside = std::fabs(normal.y) < 0.8 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 across = glm::cross(aside, normal), first = across / std::sqrt(glm::dot(across, across));
  const glm::dvec3 second = glm::cross(normal, first);
  for (const std::uint32_t i : own) {
    const Spot& spot = spots_[i];
    const double step = spot_step * spot.radius * std::min(1.0, spot.stretch);
    const double here = cover_of(spot, place, normal);
    const double right = cover_of(spot, place + step * first, normal) - here;
    const double up = cover_of(spot, place + step * second, normal) - here;
    found.height += spot.relief * here;
    found.slope += spot.relief / step * (right * first + up * second);
    if (spot.relief < 0) found.inside = std::max(found.inside, here);
  }
}

PitPlace SkinPits::at(const glm::dvec3& place, const glm::dvec3& normal) const {
  PitPlace found;
  if (empty()) return found;
  const glm::ivec3 cell = cell_at(place);
  for (int k = 0; k < 3; ++k)
    if (cell[k] < 0 || cell[k] >= count_[k]) return found;
  const Cell& own = cells_[index(cell)];
  add_pits(own.pits, place, found);
  if (!own.spots.empty()) add_spots(own.spots, place, normal, found);
  return found;
}

std::vector<glm::vec4> SkinPits::texels() const {
  if (empty()) return {};
  std::vector<glm::vec4> lists;
  std::vector<glm::vec4> texels;
  texels.reserve(2 + cells_.size() + texels_of_pit * pits_.size() + texels_of_spot * spots_.size());
  texels.emplace_back(low_, side_);
  texels.emplace_back(count_, 0);
  for (const Cell& own : cells_) {
    texels.emplace_back(2 + cells_.size() + lists.size(), own.pits.size(), own.spots.size(), 0);
    for (const std::uint32_t i : own.pits) {
      lists.emplace_back(pits_[i].middle, pits_[i].radius);
      lists.emplace_back(pits_[i].depth, 0, 0, 0);
    }
    for (const std::uint32_t i : own.spots) {
      const Spot& spot = spots_[i];
      lists.emplace_back(spot.center, spot.radius);
      lists.emplace_back(spot.tangent, spot.stretch);
      lists.emplace_back(spot.normal, spot.softness);
      lists.emplace_back(spot.waves[0], spot.waves[1]);
      lists.emplace_back(spot.waves[2], spot.waves[3]);
      lists.emplace_back(spot.relief, 0, 0, 0);
    }
  }
  texels.insert(texels.end(), lists.begin(), lists.end());
  return texels;
}

}  // namespace pomona
