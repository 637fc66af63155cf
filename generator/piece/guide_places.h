// The places of a section at which guides of texture detail are wanted.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/cut/section/cross_section.h"
#include "generator/template/template.h"

namespace pomona {

/// A detail of cut faces, and the number of its share in a guide.
struct CutDetail {
  const DetailSketch* sketch = nullptr;
  int number = 0;
};

/// Those that count, in the template's order.
std::vector<CutDetail> cut_details(const Template& fruit);

/// Equal positions once: what is measured and diffused.
struct GuidePlaces {
  std::vector<glm::vec3> position;
  std::vector<std::uint32_t> of_vertex;
};
GuidePlaces guide_places(const std::vector<glm::vec3>& vertices);

/// For each place 1 where any of the details may count, by the parts that vertices have there; and up to three
/// triangles away, because pictures blend the guides of a triangle's corners, and those of triangles that meet in a
/// pixel.
std::vector<std::uint8_t> places_by_part(const CrossSection& section, const std::vector<CutDetail>& details,
                                         const GuidePlaces& places);

/// Likewise where one of the details has a share in a vertex's guide.
std::vector<std::uint8_t> places_by_share(const CrossSection& section, const std::vector<CutDetail>& details,
                                          const GuidePlaces& places);

/// Some of the places, and where each is found among all.
struct ChosenPlaces {
  std::vector<glm::vec3> position;
  std::vector<std::size_t> place;
};
ChosenPlaces chosen(const GuidePlaces& places, const std::vector<std::uint8_t>& counts);

}  // namespace pomona
