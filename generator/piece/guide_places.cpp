#include "generator/piece/guide_places.h"

#include <algorithm>
#include <utility>

#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// The same places and those up to three triangles away.
std::vector<std::uint8_t> with_neighbours(std::vector<std::uint8_t> counts, const CrossSection& section,
                                          const GuidePlaces& places) {
  for (int ring = 0; ring < 3; ++ring) {
    std::vector<std::uint8_t> grown = counts;
    for (const glm::uvec3& t : section.triangle) {
      const std::uint32_t a = places.of_vertex[t.x], b = places.of_vertex[t.y], c = places.of_vertex[t.z];
      if ((counts[a] | counts[b] | counts[c]) != 0) grown[a] = grown[b] = grown[c] = 1;
    }
    counts = std::move(grown);
  }
  return counts;
}

}  // namespace

std::vector<CutDetail> cut_details(const Template& fruit) {
  std::vector<CutDetail> details;
  for (const DetailSketch& detail : fruit.details) {
    if (detail.face != DetailFace::cut || details.size() == static_cast<std::size_t>(most_details_of_a_face)) continue;
    details.push_back({&detail, static_cast<int>(details.size())});
  }
  return details;
}

GuidePlaces guide_places(const std::vector<glm::vec3>& vertices) {
  const std::vector<std::uint32_t> first = weld(vertices);
  GuidePlaces places{.position = {}, .of_vertex = std::vector<std::uint32_t>(vertices.size())};
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (first[v] == v) places.position.push_back(vertices[v]);
    places.of_vertex[v] =
        first[v] == v ? static_cast<std::uint32_t>(places.position.size() - 1) : places.of_vertex[first[v]];
  }
  return places;
}

std::vector<std::uint8_t> places_by_part(const CrossSection& section, const std::vector<CutDetail>& details,
                                         const GuidePlaces& places) {
  std::vector<std::uint8_t> counts(places.position.size(), 0);
  for (std::size_t v = 0; v < section.part.size(); ++v) {
    counts[places.of_vertex[v]] |=
        static_cast<std::uint8_t>(std::any_of(details.begin(), details.end(), [&](const CutDetail& detail) {
          const std::vector<int>& parts = detail.sketch->parts;
          return std::find(parts.begin(), parts.end(), section.part[v]) != parts.end();
        }));
  }
  return with_neighbours(std::move(counts), section, places);
}

std::vector<std::uint8_t> places_by_share(const CrossSection& section, const std::vector<CutDetail>& details,
                                          const GuidePlaces& places) {
  std::vector<std::uint8_t> counts(places.position.size(), 0);
  for (const CutDetail& detail : details) {
    for (std::size_t v = 0; v < section.guide.size(); ++v) {
      if (section.guide[v].share[detail.number] != 0) counts[places.of_vertex[v]] = 1;
    }
  }
  return with_neighbours(std::move(counts), section, places);
}

ChosenPlaces chosen(const GuidePlaces& places, const std::vector<std::uint8_t>& counts) {
  ChosenPlaces some;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    some.position.push_back(places.position[i]);
    some.place.push_back(i);
  }
  return some;
}

}  // namespace pomona
