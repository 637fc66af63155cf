#include "generator/surface/file/outer_skin.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "generator/surface/shell_geometry.h"

namespace pomona {

namespace {

bool any_hidden(const std::vector<std::uint8_t>& hidden) {
  return std::any_of(hidden.begin(), hidden.end(), [](std::uint8_t h) { return h != 0; });
}

/// For each closed shell, 1 if it lies in no larger one.
std::vector<std::uint8_t> outermost(const DiffusionSurfaces& surfaces, const std::vector<Shell>& shells) {
  std::vector<std::size_t> closed;
  for (std::size_t s = 0; s < shells.size(); ++s)
    if (shells[s].closed && shells[s].volume != 0) closed.push_back(s);
  Containment containment(surfaces, shells, closed);
  std::vector<std::uint8_t> is_skin(shells.size(), 0);
  for (const std::size_t s : closed) is_skin[s] = containment.smallest_around(s) ? 0 : 1;
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

std::optional<std::size_t> shell_inside_out(const DiffusionSurfaces& surfaces) {
  const Shells shells = find_shells(surfaces);
  const std::vector<Shell> measured = measured_shells(surfaces, shells);
  std::vector<std::size_t> solids, walls;
  for (std::size_t s = 0; s < measured.size(); ++s) {
    if (measured[s].volume > 0) solids.push_back(s);
    if (measured[s].volume < 0 && measured[s].closed) walls.push_back(s);
  }
  if (walls.empty()) return std::nullopt;
  Containment containment(surfaces, measured, solids);
  const auto lone =
      std::find_if(walls.begin(), walls.end(), [&](std::size_t wall) { return !containment.smallest_around(wall); });
  if (lone == walls.end()) return std::nullopt;
  const auto& of = shells.of_triangle;
  return static_cast<std::size_t>(std::find(of.begin(), of.end(), static_cast<std::int32_t>(*lone)) - of.begin());
}

}  // namespace pomona
