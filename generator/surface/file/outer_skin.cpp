#include "generator/surface/file/outer_skin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "generator/surface/shell_geometry.h"

namespace pomona {

namespace {

bool any_hidden(const std::vector<std::uint8_t>& hidden) {
  return std::any_of(hidden.begin(), hidden.end(), [](std::uint8_t h) { return h != 0; });
}

/// For each closed shell, 1 if it lies in no larger one.
std::vector<std::uint8_t> outermost(const DiffusionSurfaces& surfaces, const std::vector<Shell>& shells) {
  std::vector<std::size_t> order(shells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) {
    return std::fabs(shells[l].volume) > std::fabs(shells[r].volume);
  });

  constexpr std::size_t max_skins = 1024;
  Containment containment(surfaces);
  std::vector<std::size_t> skins;
  std::vector<std::uint8_t> is_skin(shells.size(), 0);
  for (const std::size_t s : order) {
    if (!shells[s].closed || shells[s].volume == 0 || skins.size() == max_skins) continue;
    const bool inside = std::any_of(skins.begin(), skins.end(),
                                    [&](std::size_t skin) { return containment.contains(shells[skin], shells[s]); });
    if (inside) continue;
    skins.push_back(s);
    is_skin[s] = 1;
  }
  return is_skin;
}

}  // namespace

DiffusionSurfaces with_outer_skin(DiffusionSurfaces surfaces) {
  if (any_hidden(surfaces.front_hidden) || any_hidden(surfaces.back_hidden)) return surfaces;

  // Treat every triangle as boundary with its front to air, and find the outermost shells.
  DiffusionSurfaces all_boundary = surfaces;
  all_boundary.front_hidden.assign(surfaces.vertex_count(), 1);
  const Shells shells = find_shells(all_boundary);
  const std::vector<Shell> measured = measured_shells(all_boundary, shells);
  const std::vector<std::uint8_t> is_skin = outermost(all_boundary, measured);
  const auto skin_of = [&](std::size_t triangle) -> const Shell* {
    const std::int32_t s = shells.of_triangle[triangle];
    if (s == Shells::none || is_skin[static_cast<std::size_t>(s)] == 0) return nullptr;
    return &measured[static_cast<std::size_t>(s)];
  };

  // Duplicate vertices that skins share with others, then hide the skins' outer sides.
  std::vector<std::uint8_t> inner(surfaces.vertex_count(), 0);
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    for (int k = 0; k < 3 && !skin_of(i); ++k) inner[surfaces.triangle[i][k]] = 1;
  }
  std::vector<std::uint32_t> own(surfaces.vertex_count());
  std::iota(own.begin(), own.end(), 0u);
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    const Shell* skin = skin_of(i);
    for (int k = 0; k < 3 && skin; ++k) {
      std::uint32_t& vertex = surfaces.triangle[i][k];
      if (inner[vertex] != 0 && own[vertex] == vertex) own[vertex] = doubled_vertex(surfaces, vertex);
      vertex = own[vertex];
      (skin->volume > 0 ? surfaces.front_hidden : surfaces.back_hidden)[vertex] = 1;
    }
  }
  return surfaces;
}

}  // namespace pomona
