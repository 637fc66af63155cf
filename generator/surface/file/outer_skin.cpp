#include "generator/surface/file/outer_skin.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "generator/mesh/weld.h"
#include "generator/surface/shell_geometry.h"
#include "generator/surface/touching_solids.h"

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

/// What a triangle does: it lies inside, or its front or back faces air.
enum class Use : std::uint8_t { inner, front, back };

/// Vertices that triangles of several uses share are duplicated: the first use keeps the vertex.
DiffusionSurfaces with_hidden_sides(DiffusionSurfaces surfaces, const std::vector<Use>& uses) {
  std::vector<Use> first(surfaces.vertex_count(), Use::back);
  for (std::size_t i = 0; i < uses.size(); ++i)
    for (int k = 0; k < 3; ++k) first[surfaces.triangle[i][k]] = std::min(first[surfaces.triangle[i][k]], uses[i]);
  std::array<std::vector<std::uint32_t>, 3> own;  // per use
  for (std::vector<std::uint32_t>& of_use : own) {
    of_use.resize(first.size());
    std::iota(of_use.begin(), of_use.end(), 0u);
  }
  for (std::size_t i = 0; i < uses.size(); ++i) {
    for (int k = 0; k < 3 && uses[i] != Use::inner; ++k) {
      const std::uint32_t vertex = surfaces.triangle[i][k];
      std::uint32_t& mine = own[static_cast<std::size_t>(uses[i])][vertex];
      if (first[vertex] != uses[i] && mine == vertex) {
        mine = doubled_vertex(surfaces, vertex);
        surfaces.front_hidden[mine] = surfaces.back_hidden[mine] = 0;
      }
      surfaces.triangle[i][k] = mine;
      (uses[i] == Use::front ? surfaces.front_hidden : surfaces.back_hidden)[mine] = 1;
    }
  }
  return surfaces;
}

}  // namespace

DiffusionSurfaces with_outer_skin(DiffusionSurfaces surfaces) {
  if (any_hidden(surfaces.front_hidden) || any_hidden(surfaces.back_hidden)) return surfaces;

  // Treat every triangle as boundary with its front to air, and find the outermost shells.
  DiffusionSurfaces all_boundary = surfaces;
  all_boundary.front_hidden.assign(surfaces.vertex_count(), 1);
  const std::vector<std::uint8_t> turned =
      turns_where_solids_touch(all_boundary, welded_triangles(weld(surfaces.position), surfaces.triangle));
  for (std::size_t i = 0; i < turned.size(); ++i)
    if (turned[i] != 0) std::swap(all_boundary.triangle[i].y, all_boundary.triangle[i].z);
  const Shells shells = find_shells(all_boundary);
  const std::vector<Shell> measured = measured_shells(all_boundary, shells);
  const std::vector<std::uint8_t> is_skin = outermost(all_boundary, measured);
  std::vector<Use> uses;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    const std::int32_t s = shells.of_triangle[i];
    if (s == Shells::none || is_skin[static_cast<std::size_t>(s)] == 0)
      uses.push_back(Use::inner);
    else
      uses.push_back((measured[static_cast<std::size_t>(s)].volume > 0) != (turned[i] != 0) ? Use::front : Use::back);
  }
  return with_hidden_sides(std::move(surfaces), uses);
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
