#include "render/gl/detail_texels.h"

#include <cstddef>
#include <map>

#include "render/style/example.h"

namespace pomona {

namespace {

constexpr std::size_t texels_of_a_detail = 7;  // the same in shaders/detail.glsl
constexpr float no_detail = -1;

std::vector<glm::vec4> texels_of(const Look::Detail& detail) {
  const DetailSketch& sketch = detail.pattern.detail();
  const Pattern::Shape& shape = detail.pattern.shape();
  return {
      {static_cast<float>(sketch.kind), static_cast<float>(sketch.run), sketch.amount, sketch.color ? 1 : 0},
      {sketch.size, sketch.length, sketch.width, sketch.density},
      {sketch.softness, sketch.wander, sketch.variety, sketch.near ? sketch.near_within : 0},
      {glm::vec3(detail.target), sketch.smallest},
      {glm::vec3(detail.near), shape.pitch},
      {shape.threshold, shape.ramp, shape.mean.share, shape.mean.tone},
      {sketch.reach, sketch.middle, static_cast<float>(shape.seed), sketch.relief},
  };
}

/// \param first the number of the tile's first texel.
std::vector<glm::vec4> example_texels_of(const Look::Detail& detail, std::size_t first) {
  const DetailSketch& sketch = detail.pattern.detail();
  const glm::vec3 aside(detail.pattern.shape().aside);
  std::vector<glm::vec4> texels = texels_of(detail);
  texels[1] = {sketch.size, sketch.length, sketch.tile->side(), static_cast<float>(first)};
  texels[2] = {sketch.tile->highest, texels[2].w};
  texels[3] = {sketch.tile->mean(), aside.x};
  texels[4] = {glm::vec3(detail.near), aside.y};
  texels[5] = {sketch.tile->lowest, aside.z};
  return texels;
}

std::size_t texel_count(const ExampleTile& tile) {
  std::size_t count = 0;
  for (const TileLevel& level : tile.levels) count += level.color.size();
  return count;
}

}  // namespace

DetailTexels detail_texels(std::span<const Look> looks) {
  constexpr std::size_t of_a_face = max_details_of_a_face * texels_of_a_detail;
  DetailTexels all;
  std::map<const ExampleTile*, std::size_t> known;
  std::size_t next_tile = 2 * of_a_face * looks.size();
  for (const Look& look : looks) {
    for (const DetailFace face : {DetailFace::cut, DetailFace::skin}) {
      const std::size_t end = all.styles.size() + of_a_face;
      for (const Look::Detail& detail : look.details(face)) {
        const std::shared_ptr<const ExampleTile>& tile = detail.pattern.detail().tile;
        if (tile && known.try_emplace(tile.get(), next_tile).second) {
          all.tiles.push_back(tile);
          next_tile += texel_count(*tile);
        }
        const std::vector<glm::vec4> own = tile ? example_texels_of(detail, known[tile.get()]) : texels_of(detail);
        all.styles.insert(all.styles.end(), own.begin(), own.end());
      }
      while (all.styles.size() < end) all.styles.emplace_back(no_detail, 0, 0, 0);
    }
  }
  return all;
}

std::vector<glm::vec4> tile_texels(const ExampleTile& tile) {
  std::vector<glm::vec4> texels;
  for (const TileLevel& level : tile.levels)
    for (const Color& color : level.color) texels.emplace_back(color, static_cast<float>(luminance_share(tile, color)));
  return texels;
}

std::vector<glm::vec4> all_texels(const DetailTexels& details) {
  std::vector<glm::vec4> texels = details.styles;
  for (const auto& tile : details.tiles) {
    const std::vector<glm::vec4> own = tile_texels(*tile);
    texels.insert(texels.end(), own.begin(), own.end());
  }
  return texels;
}

}  // namespace pomona
