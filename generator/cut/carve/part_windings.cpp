#include "generator/cut/carve/part_windings.h"

#include <array>
#include <utility>

namespace pomona {

namespace {

/// The edge of the facet that begins with this step, or -1.
int beginning(const Arrangement::Facet& facet, std::uint32_t from, std::uint32_t to) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (facet.corner[i] != from) continue;
    const std::uint32_t second = facet.is_whole() ? facet.corner[(i + 1) % 3] : facet.mesh.chain[i][1];
    return second == to ? static_cast<int>(i) : -1;
  }
  return -1;
}

}  // namespace

PartWindings::PartWindings(const Arrangement& all, const ExactPoints& places, const Face& face, Boundaries boundaries)
    : all_(all), places_(places), face_(face), boundaries_(std::move(boundaries)), part_of_(all.edge.size()) {
  for (std::size_t f = all.fruit_count; f < all.facet.size(); ++f) {
    const std::array<std::uint32_t, 3>& e = all.facet[f].edge;
    part_of_.join(e[0], e[1]);
    part_of_.join(e[1], e[2]);
  }
  for (std::uint32_t f = static_cast<std::uint32_t>(all.fruit_count); f < all.facet.size(); ++f) {
    facet_of_.insert(facet_of_.end(), all.facet[f].mesh.triangle.size(), f);
  }
}

KnownWindings PartWindings::near(std::uint32_t triangle) {
  const std::uint32_t part = part_of_.root(all_.facet[facet_of_[triangle]].edge[0]);
  KnownWindings fallback;
  bool has_fallback = false;
  for (std::uint32_t t = 0; t < facet_of_.size(); ++t) {
    const Arrangement::Facet& facet = all_.facet[facet_of_[t]];
    if (part_of_.root(facet.edge[0]) != part) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = face_.point[face_.triangle[t][static_cast<int>(i)]];
      const std::uint32_t to = face_.point[face_.triangle[t][static_cast<int>((i + 1) % 3)]];
      const int edge = beginning(facet, from, to);
      if (edge < 0) continue;
      if (!face_.constrained[t][i]) return {t, at(from, all_.edge[facet.edge[static_cast<std::size_t>(edge)]])};
      if (!has_fallback) fallback = {t, at(from, all_.edge[facet.edge[static_cast<std::size_t>(edge)]])};
      has_fallback = true;
    }
  }
  return fallback;
}

std::vector<CellBoundary> PartWindings::at(std::uint32_t place, const Arrangement::Edge& edge) const {
  std::vector<CellBoundary> inside;
  for (std::size_t i = 0; i < boundaries_.triangle.size(); ++i) {
    const int by = winding_of_fruit(boundaries_.triangle[i], places_.at(place));
    if (by != 0) cross(inside, boundaries_.boundary[i], by);
  }
  for (const Arrangement::Crossing& c : edge.crossings) {
    if (c.place == place) cross(inside, boundaries_.boundary_of_facet[c.facet], place == edge.low ? c.sense : -c.sense);
  }
  return inside;
}

}  // namespace pomona
