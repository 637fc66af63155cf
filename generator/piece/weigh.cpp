#include "generator/piece/weigh.h"

#include <algorithm>

#include "generator/piece/region_rays.h"
#include "generator/surface/part_regions.h"

namespace pomona {

namespace {

/// Finds parts by name, because grains have their own list of parts.
double density_of(const Template& fruit, const std::string& part) {
  const auto at =
      static_cast<std::size_t>(std::find(fruit.parts.begin(), fruit.parts.end(), part) - fruit.parts.begin());
  return at < fruit.densities.size() ? fruit.densities[at] : fruit.density;
}

}  // namespace

std::vector<double> excess_densities(const PartRegions& regions, const Template& fruit) {
  std::vector<double> excess;
  for (const PartRegions::Region& region : regions.region)
    excess.push_back(density_of(fruit, regions.part_names[static_cast<std::size_t>(region.part)]) - fruit.density);
  return excess;
}

std::vector<Solid> weighed(std::vector<Solid> pieces, const GrownFruit& grown, const Template& fruit) {
  if (fruit.densities.empty()) return pieces;
  const PartRegions regions = part_regions(joined(grown.swept, grown.grains));
  const std::vector<double> excess = excess_densities(regions, fruit);
  const glm::dvec3 origin = bounds_of(grown.swept).center();
  const std::vector<Moments> more = excess_moments(pieces, regions, excess, origin);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].closed) continue;
    Moments all;
    all.add(moments_of(pieces[i].mesh.position, pieces[i].mesh.triangle, origin), fruit.density);
    all.add(more[i]);
    if (all.mass > 0) pieces[i].weighed = rigid_mass(all, origin);
  }
  return pieces;
}

}  // namespace pomona
