#include "generator/cut/section/section_crumbs.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

constexpr std::uint32_t dropped = 0xffffffffu;

/// For every face the first one of its stroke; other faces are their own.
std::vector<std::size_t> whole_faces(const std::vector<CutFace>& faces) {
  std::map<std::pair<int, int>, std::size_t> first;
  std::vector<std::size_t> whole(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    whole[f] = faces[f].stroke < 0 ? f : first.try_emplace({faces[f].knife, faces[f].stroke}, f).first->second;
  return whole;
}

double area_of(const CrossSection& section, std::size_t t) {
  const glm::uvec3& corner = section.triangle[t];
  const glm::dvec3 a(section.position[corner.x]), b(section.position[corner.y]), c(section.position[corner.z]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

/// Per triangle, whether it belongs to a crumb.
std::vector<std::uint8_t> crumbs_of(const CrossSection& section) {
  // Faces that meet share vertices, so the triangles themselves are joined: on each face, by the first one at a place.
  const std::vector<std::uint32_t> place = weld(section.position);
  const std::vector<std::size_t> whole = whole_faces(section.faces);
  std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> elsewhere;
  std::vector<std::pair<std::size_t, std::uint32_t>> first_at(section.position.size(), {0, dropped});
  DisjointSets joined(section.triangle.size());
  std::vector<double> face_area(section.faces.size(), 0), area(section.triangle.size());
  for (std::uint32_t t = 0; t < section.triangle.size(); ++t) {
    const std::size_t face = whole[static_cast<std::size_t>(section.cut[t])];
    area[t] = area_of(section, t);
    face_area[face] += area[t];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t at = place[section.triangle[t][k]];
      if (first_at[at].second == dropped) first_at[at] = {face, t};
      const bool is_own = first_at[at].first == face;
      joined.join(t, is_own ? first_at[at].second : elsewhere.try_emplace({face, at}, t).first->second);
    }
  }
  std::vector<double> component(section.triangle.size(), 0);
  for (std::uint32_t t = 0; t < section.triangle.size(); ++t) component[joined.root(t)] += area[t];
  std::vector<std::uint8_t> crumb(section.triangle.size(), 0);
  for (std::uint32_t t = 0; t < section.triangle.size(); ++t) {
    const std::size_t face = whole[static_cast<std::size_t>(section.cut[t])];
    crumb[t] = component[joined.root(t)] < section_crumb * face_area[face] ? 1 : 0;
  }
  return crumb;
}

/// Only the entries whose flag is 0. An empty list stays empty.
template <class T>
void keep(std::vector<T>& all, const std::vector<std::uint8_t>& goes) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!goes[i]) all[next++] = all[i];
  all.resize(next);
}

}  // namespace

CrossSection without_crumbs(CrossSection section) {
  const std::vector<std::uint8_t> crumb = crumbs_of(section);
  if (std::find(crumb.begin(), crumb.end(), 1) == crumb.end()) return section;

  // Vertices go with the last triangle that has them; those of no triangle stay.
  std::vector<std::uint8_t> goes(section.position.size(), 0);
  for (const bool of_crumbs : {true, false}) {
    for (std::size_t t = 0; t < crumb.size(); ++t)
      for (int k = 0; (crumb[t] != 0) == of_crumbs && k < 3; ++k) goes[section.triangle[t][k]] = of_crumbs ? 1 : 0;
  }
  std::vector<std::uint32_t> number(goes.size(), dropped);
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < goes.size(); ++v)
    if (!goes[v]) number[v] = next++;

  keep(section.position, goes);
  keep(section.color, goes);
  keep(section.interior, goes);
  keep(section.part, goes);
  keep(section.guide, goes);
  keep(section.triangle, crumb);
  keep(section.cut, crumb);
  keep(section.normal, crumb);
  for (glm::uvec3& t : section.triangle) t = {number[t.x], number[t.y], number[t.z]};
  std::erase_if(section.segments, [&](const SectionSegment& s) { return goes[s.vertex[0]] || goes[s.vertex[1]]; });
  for (SectionSegment& s : section.segments) s.vertex = {number[s.vertex[0]], number[s.vertex[1]]};
  return section;
}

}  // namespace pomona
