#include "generator/piece/organs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/enclosures.h"
#include "generator/mesh/signed_volume.h"
#include "generator/mesh/weld.h"
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

/// An edge of an organ's triangles, from the lower point to the higher one: so many more run this way than back.
struct OrganEdge {
  std::int32_t instance = 0;
  std::uint32_t low = 0, high = 0;
  int times = 0;

  bool is_at(const OrganEdge& other) const {
    return instance == other.instance && low == other.low && high == other.high;
  }
};

/// What an organ's own triangles in a piece enclose, its holes closed flat.
struct OwnVolume {
  double volume = 0, area = 0;  // cubic and square metres
  double open = 0;              // square metres of the area that close its holes

  /// Whether so little is open that it does not matter how it is closed: a stalk's end.
  bool is_exact() const { return open <= 0.05 * area; }
};

/// The volumes of all organs in a mesh, by instance, but for the fruit itself.
class OrganVolumes {
 public:
  explicit OrganVolumes(const SolidMesh& mesh) : mesh_(mesh), first_(weld(mesh.position)) {}

  std::map<std::int32_t, OwnVolume> run() {
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) {
      if (mesh_.instance[t] != 0) add(t);
    }
    keep_open_edges();
    for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
      while (end < edges_.size() && edges_[end].instance == edges_[begin].instance) ++end;
      close(std::span(edges_).subspan(begin, end - begin));
    }
    return std::move(own_);
  }

 private:
  glm::dvec3 at(std::uint32_t point) const {
    return glm::dvec3(mesh_.position[point]) - glm::dvec3(mesh_.position.front());
  }

  void add(std::size_t t) {
    const std::int32_t instance = mesh_.instance[t];
    const glm::uvec3& v = mesh_.triangle[t];
    const std::array<std::uint32_t, 3> p{first_[v.x], first_[v.y], first_[v.z]};
    add_to(own_[instance], at(p[0]), at(p[1]), at(p[2]), 1);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = p[k], to = p[(k + 1) % 3];
      if (from < to) edges_.push_back({instance, from, to, 1});
      if (from > to) edges_.push_back({instance, to, from, -1});
    }
  }

  /// Adds a triangle so many times; its area.
  static double add_to(OwnVolume& organ, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int times) {
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    organ.volume += times * six_volumes(a, b, c) / 6;
    organ.area += area;
    return area;
  }

  void keep_open_edges() {
    std::sort(edges_.begin(), edges_.end(), [](const OrganEdge& a, const OrganEdge& b) {
      return std::tie(a.instance, a.low, a.high) < std::tie(b.instance, b.low, b.high);
    });
    std::vector<OrganEdge> open;
    for (const OrganEdge& edge : edges_) {
      if (open.empty() || !open.back().is_at(edge)) {
        if (!open.empty() && open.back().times == 0) open.pop_back();
        open.push_back(edge);
      } else {
        open.back().times += edge.times;
      }
    }
    if (!open.empty() && open.back().times == 0) open.pop_back();
    edges_ = std::move(open);
  }

  /// Closes the holes of one organ, each by a fan around the middle of its rim.
  void close(std::span<const OrganEdge> edges) {
    std::map<std::uint32_t, std::uint32_t> number;
    for (const OrganEdge& edge : edges)
      for (const std::uint32_t p : {edge.low, edge.high})
        number.try_emplace(p, static_cast<std::uint32_t>(number.size()));
    DisjointSets rims(number.size());
    for (const OrganEdge& edge : edges) rims.join(number[edge.low], number[edge.high]);

    struct Rim {
      glm::dvec3 sum{0};
      double length = 0;
    };
    std::vector<Rim> rim(number.size());
    for (const OrganEdge& edge : edges) {
      Rim& own = rim[rims.root(number[edge.low])];
      const double length = glm::distance(at(edge.low), at(edge.high));
      own.sum += 0.5 * length * (at(edge.low) + at(edge.high));
      own.length += length;
    }
    for (const OrganEdge& edge : edges) {
      const Rim& own = rim[rims.root(number[edge.low])];
      if (!(own.length > 0)) continue;
      OwnVolume& organ = own_[edge.instance];
      organ.open += add_to(organ, at(edge.high), at(edge.low), own.sum / own.length, edge.times);
    }
  }

  const SolidMesh& mesh_;
  std::vector<std::uint32_t> first_;
  std::vector<OrganEdge> edges_;
  std::map<std::int32_t, OwnVolume> own_;
};

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
    own.push_back(piece.mesh.triangle.empty() ? std::map<std::int32_t, OwnVolume>() : OrganVolumes(piece.mesh).run());
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
