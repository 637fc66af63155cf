#include "generator/diffusion/used_parts.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr std::size_t max_parts = 1024;

std::vector<std::int32_t> parts_in_use(const DiffusionSurfaces& surfaces) {
  // Neighbours mostly have the same part: drop them before sorting.
  std::vector<std::int32_t> used;
  for (const std::vector<std::int32_t>* parts : {&surfaces.front_part, &surfaces.back_part}) {
    std::unique_copy(parts->begin(), parts->end(), std::back_inserter(used));
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (used.size() > max_parts) {
    throw Error(ExitStatus::bad_data,
                "surfaces: " + std::to_string(used.size()) + " parts are used, more than " + std::to_string(max_parts),
                "give sides that belong together the same part");
  }
  return used;
}

std::vector<std::uint16_t> places_in(const std::vector<std::int32_t>& used, const std::vector<std::int32_t>& parts) {
  std::vector<std::uint16_t> places;
  places.reserve(parts.size());
  for (const std::int32_t part : parts) {
    places.push_back(static_cast<std::uint16_t>(std::lower_bound(used.begin(), used.end(), part) - used.begin()));
  }
  return places;
}

}  // namespace

UsedParts used_parts(const DiffusionSurfaces& surfaces) {
  const std::vector<std::int32_t> part = parts_in_use(surfaces);
  return {part, places_in(part, surfaces.front_part), places_in(part, surfaces.back_part)};
}

}  // namespace pomona
