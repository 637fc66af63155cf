#include "generator/piece/organs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/enclosures.h"
#include "generator/piece/organ_volumes.h"
#include "generator/piece/piece_facts.h"
#include "generator/piece/region_rays.h"
#include "generator/piece/weigh.h"
#include "generator/surface/part_regions.h"

namespace pomona {

namespace {

/// Where the surfaces face air and are of an organ, its number; else 0.
class SkinNumbers {
 public:
  SkinNumbers(const DiffusionSurfaces& surfaces, const std::vector<std::uint8_t>& is_grain)
      : surfaces_(surfaces), number_(surfaces.triangle_count(), 0) {
    for (std::size_t t = 0; t < number_.size(); ++t)
      if (surfaces.is_boundary(t)) number_[t] = surfaces.instance_of(t);
    number_grains(is_grain);
  }

  const std::vector<std::int32_t>& numbers() const { return number_; }

 private:
  /// Grains share no vertices.
  void number_grains(const std::vector<std::uint8_t>& is_grain) {
    const auto is_of_grain = [&](std::size_t t) {
      return is_grain[static_cast<std::size_t>(surfaces_.surface[t])] != 0 && surfaces_.is_boundary(t);
    };
    DisjointSets sets(surfaces_.vertex_count());
    for (std::size_t t = 0; t < number_.size(); ++t) {
      if (!is_of_grain(t)) continue;
      sets.join(surfaces_.triangle[t].x, surfaces_.triangle[t].y);
      sets.join(surfaces_.triangle[t].x, surfaces_.triangle[t].z);
    }
    std::int32_t last = 0;
    for (const std::int32_t instance : surfaces_.instance) last = std::max(last, instance);
    std::map<std::uint32_t, std::int32_t> grain;
    for (std::size_t t = 0; t < number_.size(); ++t) {
      if (!is_of_grain(t)) continue;
      const auto next = static_cast<std::int32_t>(grain.size()) + last + 1;
      number_[t] = grain.try_emplace(sets.root(surfaces_.triangle[t].x), next).first->second;
    }
  }

  const DiffusionSurfaces& surfaces_;
  std::vector<std::int32_t> number_;
};

/// Per surface, whether it is of grains at seats of a law that are bodies of their own.
std::vector<std::uint8_t> organ_grains(const DiffusionSurfaces& surfaces, const Template& fruit) {
  std::vector<std::uint8_t> is_grain(surfaces.surface_names.size(), 0);
  for (const GrainSketch& grains : fruit.grains) {
    if (!grains.spacing.law || grains.front.hidden == grains.back.hidden) continue;
    const auto& names = surfaces.surface_names;
    const auto at = std::find(names.begin(), names.end(), grains.name);
    if (at != names.end()) is_grain[static_cast<std::size_t>(at - names.begin())] = 1;
  }
  return is_grain;
}

std::vector<Enclosures::Triangle> skins_of(const DiffusionSurfaces& surfaces, const std::vector<std::int32_t>& number) {
  std::vector<Enclosures::Triangle> skins;
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (!surfaces.is_boundary(t)) continue;
    const glm::uvec3& v = surfaces.triangle[t];
    const bool turned = surfaces.is_hidden(t, SideOf::back);
    const auto at = [&](std::uint32_t vertex) { return glm::dvec3(surfaces.position[vertex]); };
    skins.push_back({{at(v.x), at(turned ? v.z : v.y), at(turned ? v.y : v.z)}, static_cast<std::uint32_t>(number[t])});
  }
  return skins;
}

/// That of their surfaces; of what is placed without their last word.
std::vector<std::string> names_of(const DiffusionSurfaces& surfaces, const std::vector<std::int32_t>& number,
                                  const std::string& fruit) {
  std::vector<std::string> names{fruit};
  for (const std::int32_t instance : surfaces.instance)
    names.resize(std::max(names.size(), static_cast<std::size_t>(instance) + 1));
  for (std::size_t t = 0; t < number.size(); ++t) {
    const auto organ = static_cast<std::size_t>(number[t]);
    if (names.size() <= organ) names.resize(organ + 1);
    if (!names[organ].empty()) continue;
    const std::string& name = surfaces.surface_names[static_cast<std::size_t>(surfaces.surface[t])];
    names[organ] = surfaces.instance_of(t) != 0 ? name.substr(0, name.rfind('.')) : name;
  }
  return names;
}

/// A little behind the middle of a triangle.
glm::dvec3 place_behind(const std::array<glm::dvec3, 3>& corner) {
  constexpr double little = 1e-6;  // metres
  const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double size = glm::length(normal);
  const glm::dvec3 middle = (corner[0] + corner[1] + corner[2]) / 3.0;
  return size > 0 ? middle - little / size * normal : middle;
}

/// Exact ones have their own volumes; the rest of the piece is shared by the fruit itself and the other organs as the
/// rays say.
std::map<std::int32_t, double> shared_volumes(const Solid& piece, const std::map<std::int32_t, OwnVolume>& own,
                                              const std::map<std::int32_t, double>& by_rays) {
  std::map<std::int32_t, double> volumes, others;
  double exact = 0, rest = 0;
  for (const auto& [organ, volume] : own) {
    if (!volume.is_exact()) continue;
    exact += volumes[organ] = std::max(volume.volume, 0.0);
  }
  for (const auto& [organ, volume] : by_rays)
    if (!volumes.contains(organ)) rest += others[organ] = volume;
  const std::vector<std::int32_t>& shown = piece.mesh.instance;
  if (others.empty() && std::find(shown.begin(), shown.end(), 0) != shown.end()) rest = others[0] = 1;
  for (const std::int32_t organ : shown) volumes.try_emplace(organ, 0);

  // Where nothing is left, rounding is shared by all.
  const double left = std::max(piece.volume - exact, 0.0);
  const double share = rest > 0 ? left / rest : 0,
               factor = rest > 0 && exact <= piece.volume ? 1 : piece.volume / exact;
  for (auto& [organ, volume] : volumes)
    if (exact > 0) volume *= factor;
  for (const auto& [organ, volume] : others) volumes[organ] = share * volume;
  return volumes;
}

bool needs_rays(const std::map<std::int32_t, OwnVolume>& own) {
  return std::any_of(own.begin(), own.end(), [](const auto& organ) { return !organ.second.is_exact(); });
}

/// Triangles of organs that are thinner than rounding are of the piece's largest one.
void drop_slivers(Solid& piece, std::map<std::int32_t, double>& volumes) {
  constexpr double least = 1e-9;  // share of the piece
  const auto largest = std::max_element(volumes.begin(), volumes.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
  if (largest == volumes.end()) return;
  const std::int32_t home = largest->first;
  const auto is_sliver = [&](std::int32_t organ) { return organ != home && volumes.at(organ) < least * piece.volume; };
  for (std::int32_t& organ : piece.mesh.instance)
    if (is_sliver(organ)) organ = home;
  std::erase_if(volumes, [&](const auto& entry) { return entry.first != home && entry.second < least * piece.volume; });
}

std::vector<Organ> organs_of(const Solid& piece, const std::map<std::int32_t, double>& volumes,
                             const std::vector<std::string>& names, std::span<const double> densities) {
  std::vector<Organ> organs;
  double sum = 0;
  for (const auto& [instance, volume] : volumes) {
    const auto number = static_cast<std::size_t>(instance);
    const double density = number < densities.size() ? densities[number] : piece.density;
    organs.push_back({instance, names[number], volume, density * volume});
    sum += organs.back().mass;
  }
  const double mass = facts_of(piece).mass;
  for (Organ& organ : organs)
    if (sum > 0) organ.mass *= mass / sum;
  return organs;
}

/// The organ that holds most places just within a region.
std::int32_t organ_of(const FruitOrgans& organs, const PartRegions& regions, const PartRegions::Region& region) {
  constexpr std::size_t places = 15;
  std::map<std::int32_t, int> votes;
  for (std::size_t k = 0; k < places; ++k) {
    const glm::uvec3& t = regions.triangle[region.first + k * region.count / places];
    const auto at = [&](std::uint32_t v) { return glm::dvec3(regions.position[v]); };
    ++votes[organs.at(place_behind({at(t.x), at(t.y), at(t.z)}))];
  }
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Per region its volume without the regions within it.
std::vector<double> own_volumes(const PartRegions& regions) {
  std::vector<Enclosures::Triangle> triangles;
  std::vector<double> own;
  for (std::size_t r = 0; r < regions.region.size(); ++r) {
    const PartRegions::Region& region = regions.region[r];
    own.push_back(region.volume);
    for (std::size_t t = region.first; t < region.first + region.count; ++t) {
      const auto at = [&](int k) { return glm::dvec3(regions.position[regions.triangle[t][k]]); };
      triangles.push_back({{at(0), at(1), at(2)}, static_cast<std::uint32_t>(r)});
    }
  }
  const Enclosures all(std::move(triangles));
  for (std::size_t r = 0; r < regions.region.size(); ++r) {
    const glm::dvec3 place(regions.position[regions.triangle[regions.region[r].first].x]);
    for (const auto& [around, winding] : all.around(place)) {
      if (around <= r || winding <= 0) continue;
      own[around] -= regions.region[r].volume;  // the smallest one around it
      break;
    }
  }
  for (double& volume : own) volume = std::max(volume, 0.0);
  return own;
}

/// The mean density of each organ by the volumes of its regions; none where all parts are as dense.
std::vector<double> organ_densities(const FruitOrgans& organs, const GrownFruit& grown, const Template& fruit) {
  if (fruit.densities.empty()) return {};
  const PartRegions regions = part_regions(joined(grown.swept, grown.grains));
  const std::vector<double> excess = excess_densities(regions, fruit);
  std::vector<double> volume(organs.names().size(), 0), mass(volume);
  const std::vector<double> own = own_volumes(regions);
  for (std::size_t r = 0; r < regions.region.size(); ++r) {
    const auto organ = static_cast<std::size_t>(organ_of(organs, regions, regions.region[r]));
    volume[organ] += own[r];
    mass[organ] += own[r] * (fruit.density + excess[r]);
  }
  for (std::size_t i = 0; i < mass.size(); ++i) mass[i] = volume[i] > 0 ? mass[i] / volume[i] : fruit.density;
  return mass;
}

}  // namespace

FruitOrgans::FruitOrgans(const DiffusionSurfaces& surfaces, const Template& fruit)
    : is_grain_(organ_grains(surfaces, fruit)), around_({}) {
  if (surfaces.instance.empty() && std::find(is_grain_.begin(), is_grain_.end(), 1) == is_grain_.end()) return;
  const SkinNumbers skin(surfaces, is_grain_);
  names_ = names_of(surfaces, skin.numbers(), fruit.name);
  skins_ = skins_of(surfaces, skin.numbers());
  around_ = Enclosures(skins_);
}

std::int32_t FruitOrgans::at(const glm::dvec3& place) const {
  std::int32_t last = 0;
  for (const auto& [organ, winding] : around_.around(place)) {
    if (winding <= 0) continue;
    if (organ == 0) return 0;
    last = static_cast<std::int32_t>(organ);
  }
  return last;
}

std::vector<std::int32_t> FruitOrgans::of_triangles(const SolidMesh& mesh) const {
  std::vector<std::int32_t> organ = mesh.instance;  // of the skin: what is placed
  organ.resize(mesh.triangle.size(), 0);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const bool is_cut = mesh.cut_face[t] >= 0;
    if (is_cut || is_grain_[static_cast<std::size_t>(mesh.surface[t])] != 0)
      organ[t] = at(place_behind(mesh.corners(t)));
  }
  return organ;
}

std::vector<Solid> with_organs(std::vector<Solid> pieces, const GrownFruit& grown, const Template& fruit) {
  const FruitOrgans organs(grown.sheets, fruit);
  if (organs.empty()) return pieces;
  const std::vector<double> densities = organ_densities(organs, grown, fruit);
  std::vector<std::map<std::int32_t, OwnVolume>> own;
  for (Solid& piece : pieces) {
    piece.mesh.instance = organs.of_triangles(piece.mesh);
    own.push_back(piece.mesh.triangle.empty() ? std::map<std::int32_t, OwnVolume>() : organ_volumes(piece.mesh));
  }
  std::vector<std::map<std::int32_t, double>> by_rays(pieces.size());
  if (std::any_of(own.begin(), own.end(), needs_rays)) {
    constexpr int each = 100, most = 40'000;
    const auto rays = std::min<std::size_t>(each * organs.names().size(), most);
    by_rays = organ_ray_volumes(pieces, organs.skins(), {.rays = static_cast<int>(rays)});
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::map<std::int32_t, double> volumes = shared_volumes(pieces[i], own[i], by_rays[i]);
    drop_slivers(pieces[i], volumes);
    pieces[i].organs = organs_of(pieces[i], volumes, organs.names(), densities);
  }
  return pieces;
}

}  // namespace pomona
