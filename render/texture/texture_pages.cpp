#include "render/texture/texture_pages.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "render/texture/uv_atlas.h"

namespace pomona {

namespace {

/// Blocks of mip levels: pages keep the levels at which no texture gets colours of another.
constexpr int block = 8;

int up_to_blocks(int texels) { return (texels + block - 1) / block * block; }

/// Rows of rectangles on a page.
class PageRows {
 public:
  explicit PageRows(const glm::ivec2& page) : page_(page) {}

  /// The place of the next rectangle, which is not higher than the one before; none if the page is full.
  std::optional<glm::ivec2> place(const glm::ivec2& size) {
    if (next_.x + size.x > page_.x) next_ = {0, below_};
    if (next_.x + size.x > page_.x || next_.y + size.y > page_.y) return std::nullopt;
    const glm::ivec2 at = next_;
    below_ = std::max(below_, at.y + size.y);
    next_.x += size.x;
    return at;
  }

 private:
  glm::ivec2 page_, next_{0};
  int below_ = 0;
};

/// Places as many as fit of textures[first], ...; returns the first that does not.
std::size_t fill_page(std::span<const std::size_t> textures, std::size_t first, std::span<const glm::ivec2> sizes,
                      PageLayout& layout) {
  PageRows rows(layout.pages.back());
  for (std::size_t i = first; i < textures.size(); ++i) {
    const glm::ivec2& size = sizes[textures[i]];
    const std::optional<glm::ivec2> at = rows.place({up_to_blocks(size.x), up_to_blocks(size.y)});
    if (!at) return i;
    layout.of_texture[textures[i]] = {layout.pages.size() - 1, *at};
  }
  return textures.size();
}

void copy_rows(const auto& from, auto& to, const glm::ivec2& size, const glm::ivec2& corner, int to_width) {
  for (int y = 0; y < size.y; ++y) {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(y) * size.x;
    std::copy(begin, begin + size.x, to.begin() + static_cast<std::ptrdiff_t>(corner.y + y) * to_width + corner.x);
  }
}

/// Draws a texture's map at its place, onto a page that is `empty` elsewhere; nothing if it has no such map.
void place_map(const Image& map, Image& page, const glm::ivec2& page_size, const glm::ivec2& corner,
               const glm::u8vec3& empty) {
  if (map.pixels.empty()) return;
  if (page.pixels.empty())
    page = {page_size.x, page_size.y,
            std::vector<glm::u8vec3>(static_cast<std::size_t>(page_size.x) * page_size.y, empty)};
  copy_rows(map.pixels, page.pixels, {map.width, map.height}, corner, page_size.x);
}

void place_map(const TransparentImage& map, TransparentImage& page, const glm::ivec2& page_size,
               const glm::ivec2& corner, const glm::u8vec3& empty, std::uint8_t empty_opacity) {
  if (map.opacity.empty()) return;
  place_map(map.image, page.image, page_size, corner, empty);
  if (page.opacity.empty()) page.opacity.assign(page.image.pixels.size(), empty_opacity);
  copy_rows(map.opacity, page.opacity, {map.image.width, map.image.height}, corner, page_size.x);
}

void place_all(const BakedSolid& solid, const glm::ivec2& corner, const glm::ivec2& size, TexturePage& page) {
  place_map(solid.texture, page.texture, size, corner, {0, 0, 0});
  place_map(solid.maps.normal, page.maps.normal, size, corner, {128, 128, 255});
  place_map(solid.maps.orm, page.maps.orm, size, corner, {255, 153, 0});
  place_map(solid.maps.part, page.maps.part, size, corner, {255, 255, 255});
  place_map(solid.maps.coat, page.maps.coat, size, corner, {0, 0, 0}, 255);
  place_map(solid.maps.sheen, page.maps.sheen, size, corner, {0, 0, 0}, 255);
  place_map(solid.maps.light, page.maps.light, size, corner, {255, 255, 255}, 0);
  page.maps.tell_looks = page.maps.tell_looks || solid.maps.tell_looks;
}

}  // namespace

PageLayout page_layout(std::span<const glm::ivec2> sizes) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (sizes[i].x > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a].y != sizes[b].y ? sizes[a].y > sizes[b].y : sizes[a].x > sizes[b].x;
  });
  PageLayout layout{std::vector<PageLayout::Place>(sizes.size()), {}};
  for (std::size_t first = 0; first < order.size();) {
    layout.pages.emplace_back(0);
    std::size_t end = first;
    for (int side = 64; side <= max_texture_side && end < order.size(); side *= 2) {
      for (const glm::ivec2 size : {glm::ivec2(side, side), {2 * side, side}}) {
        if (size.x > max_texture_side || end == order.size()) continue;
        layout.pages.back() = size;
        end = fill_page(order, first, sizes, layout);
      }
    }
    first = end;
  }
  return layout;
}

std::vector<BakedSolid> on_pages(std::span<const BakedSolid* const> solids, const PageLayout& layout,
                                 const std::string& name) {
  std::vector<std::shared_ptr<TexturePage>> pages;
  for (std::size_t page = 0; page < layout.pages.size(); ++page) {
    pages.push_back(std::make_shared<TexturePage>());
    pages.back()->name = page == 0 ? name : name + "-" + std::to_string(page + 1);
  }
  std::vector<BakedSolid> result(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const BakedSolid& solid = *solids[i];
    const PageLayout::Place& place = layout.of_texture[i];
    BakedSolid& paged = result[i];
    paged.solid = solid.solid;
    if (solid.texture.pixels.empty()) continue;
    const glm::ivec2 size = layout.pages[place.page];
    place_all(solid, place.corner, size, *pages[place.page]);
    paged.page = pages[place.page];
    paged.maps.tangent = solid.maps.tangent;
    const glm::dvec2 own(solid.texture.width, solid.texture.height);
    for (const glm::vec2& uv : solid.uv)
      paged.uv.emplace_back((glm::dvec2(place.corner) + glm::dvec2(uv) * own) / glm::dvec2(size));
  }
  return result;
}

}  // namespace pomona
