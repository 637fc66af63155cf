// The points of a section at which guides of texture detail are needed.
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

/// The details that have an effect, in the template's order.
std::vector<CutDetail> cut_details(const Template& fruit);

/// Points to be measured and diffused; equal positions are stored once.
struct GuidePlaces {
  std::vector<glm::vec3> position;
  std::vector<std::uint32_t> of_vertex;
};
GuidePlaces guide_places(const std::vector<glm::vec3>& vertices);

/// For each point: 1 where any of the details may have an effect, by the parts of the vertices there; also up to three
/// triangles away, because pictures blend the guides of a triangle's corners, and those of all triangles in a pixel.
std::vector<std::uint8_t> places_by_part(const CrossSection& section, const std::vector<CutDetail>& details,
                                         const GuidePlaces& places);

/// The same where one of the details has a share in a vertex's guide.
std::vector<std::uint8_t> places_by_share(const CrossSection& section, const std::vector<CutDetail>& details,
                                          const GuidePlaces& places);

/// Some of the points, and the index of each among all.
struct ChosenPlaces {
  std::vector<glm::vec3> position;
  std::vector<std::size_t> place;
};
ChosenPlaces chosen(const GuidePlaces& places, const std::vector<std::uint8_t>& counts);

}  // namespace pomona
