#include "render/style/example.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "generator/base/luminance.h"

namespace pomona {

namespace {

constexpr std::array<glm::dvec3, 3> turn = {glm::dvec3(0.68575450, -0.49219656, 0.53617471),
                                            glm::dvec3(0.72195463, 0.36655826, -0.58687014),
                                            glm::dvec3(0.09231620, 0.78954265, 0.60671256)};

/// Two neighbouring texels along an axis, and the second one's weight.
struct Neighbors {
  int first = 0, second = 0;
  double share = 0;
};

Neighbors neighbors_at(double place, int side) {
  const double texel = (place - std::floor(place)) * side - 0.5, low = std::floor(texel);
  const int first = (static_cast<int>(low) + side) % side;
  return {first, (first + 1) % side, texel - low};
}

glm::dvec3 blended(const glm::dvec3& first, const glm::dvec3& second, double share) {
  return first + share * (second - first);
}

glm::dvec3 level_color(const TileLevel& level, const glm::dvec3& place) {
  const Neighbors x = neighbors_at(place.x, level.side), y = neighbors_at(place.y, level.side),
                  z = neighbors_at(place.z, level.side);
  const auto along_x = [&](int row, int slice) {
    const Color* const texels = level.color.data() + static_cast<std::ptrdiff_t>(slice * level.side + row) * level.side;
    return blended(glm::dvec3(texels[x.first]), glm::dvec3(texels[x.second]), x.share);
  };
  const auto along_y = [&](int slice) { return blended(along_x(y.first, slice), along_x(y.second, slice), y.share); };
  return blended(along_y(z.first), along_y(z.second), z.share);
}

}  // namespace

glm::dvec3 turned_for_tile(const glm::dvec3& place) {
  return {glm::dot(turn[0], place), glm::dot(turn[1], place), glm::dot(turn[2], place)};
}

Color tile_color(const ExampleTile& tile, const glm::dvec3& place, double texels) {
  std::size_t level = 0;
  for (; texels >= 2 && level + 1 < tile.levels.size(); ++level) texels /= 2;
  const glm::dvec3 finer = level_color(tile.levels[level], place);
  const double coarser = std::clamp(texels - 1, 0.0, 1.0);
  if (coarser == 0 || level + 1 == tile.levels.size()) return Color(finer);
  return Color(blended(finer, level_color(tile.levels[level + 1], place), coarser));
}

double luminance_share(const ExampleTile& tile, const Color& color) {
  const double range = std::max(tile.brightest - tile.darkest, 1e-6);
  return (luminance(color) - tile.darkest) / range;
}

Color with_example(const Color& color, const ExampleTile& tile, const Color& shown, double weight) {
  Color result = color;
  for (int k = 0; k < 3; ++k) {
    const auto mean = static_cast<double>(tile.mean()[k]), here = static_cast<double>(color[k]);
    const double below = weight * (mean - static_cast<double>(tile.lowest[k]));
    const double above = weight * (static_cast<double>(tile.highest[k]) - mean);
    double room = 1;
    if (below > here) room = std::max(here, 0.0) / below;
    if (above * room > 1 - here) room = std::max(1 - here, 0.0) / above;
    const double changed = here + room * weight * (static_cast<double>(shown[k]) - mean);
    result[k] = static_cast<float>(std::clamp(changed, std::min(here, 0.0), std::max(here, 1.0)));
  }
  return result;
}

}  // namespace pomona
