#include "render/export/look_palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "generator/base/error.h"
#include "render/texture/look_texels.h"

namespace pomona {

namespace {

/// A look has a square of 4 x 4 texels: its middle keeps its values at two mip levels, and in numbers of 16 bits.
constexpr int side = 128, block = 4, in_row = side / block;

std::uint8_t byte_of(float share) { return static_cast<std::uint8_t>(std::lround(255 * share)); }

glm::u8vec3 bytes_of(const Color& shares) { return {byte_of(shares.r), byte_of(shares.g), byte_of(shares.b)}; }

/// The looks as a map: value_of(PbrMaterial) of each, and `rest` where there is none.
template <typename ValueOf>
Image map_of(const std::vector<PbrMaterial>& looks, const glm::u8vec3& rest, const ValueOf& value_of) {
  Image map{side, side, std::vector<glm::u8vec3>(static_cast<std::size_t>(side) * side, rest)};
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const std::size_t left = i % in_row * block, top = i / in_row * block;
    for (std::size_t k = 0; k < block * block; ++k)
      map.pixels[(top + k / block) * side + left + k % block] = value_of(looks[i]);
  }
  return map;
}

/// The same of LookTexels, with opacity.
template <typename ValueOf, typename OpacityOf>
TransparentImage map_of(const std::vector<PbrMaterial>& looks, const glm::u8vec3& rest, std::uint8_t rest_opacity,
                        const ValueOf& value_of, const OpacityOf& opacity_of) {
  const auto value = [&](const PbrMaterial& look) { return value_of(look_texel(look)); };
  const auto opacity = [&](const PbrMaterial& look) { return glm::u8vec3(byte_of(opacity_of(look_texel(look)))); };
  TransparentImage map{map_of(looks, rest, value), {}};
  for (const glm::u8vec3& pixel : map_of(looks, glm::u8vec3(rest_opacity), opacity).pixels)
    map.opacity.push_back(pixel.r);
  return map;
}

}  // namespace

glm::vec2 LookPalette::place_of(const PbrMaterial& look) {
  PbrMaterial told = look;
  told.inside = {}, told.clearness = 0;  // no map tells these
  const auto [at, is_new] = known_.try_emplace(told, looks_.size());
  if (is_new) looks_.push_back(told);
  if (looks_.size() > static_cast<std::size_t>(in_row) * in_row)
    throw Error(ExitStatus::bad_data, "more looks than one palette holds", "--atlas none gives each a material");
  const auto middle = [](std::size_t number) {
    return (static_cast<float>(number) + 0.5f) * static_cast<float>(block) / static_cast<float>(side);
  };
  return {middle(at->second % in_row), middle(at->second / in_row)};
}

SurfaceMaps LookPalette::maps() const {
  const auto any = [&](auto has) {
    return std::any_of(looks_.begin(), looks_.end(), [&](const PbrMaterial& look) { return has(look_texel(look)); });
  };
  SurfaceMaps maps;
  maps.tell_looks = true;
  maps.orm = map_of(looks_, {255, 153, 0}, [](const PbrMaterial& look) {
    return bytes_of({1, static_cast<float>(look.roughness), 0});
  });
  if (any([](const LookTexel& look) { return look.has_coat(); })) {
    maps.coat = map_of(
        looks_, {0, 0, 0}, 255, [](const LookTexel& look) { return bytes_of(look.coat); },
        [](const LookTexel& look) { return look.specular; });
  }
  if (any([](const LookTexel& look) { return look.has_sheen(); })) {
    maps.sheen = map_of(
        looks_, {0, 0, 0}, 255, [](const LookTexel& look) { return to_srgb8(look.sheen); },
        [](const LookTexel& look) { return look.sheen_roughness; });
  }
  if (any([](const LookTexel& look) { return look.lets_light_through(); })) {
    maps.light = map_of(
        looks_, {255, 255, 255}, 0, [](const LookTexel& look) { return to_srgb8(look.light); },
        [](const LookTexel& look) { return look.light_share; });
  }
  return maps;
}

namespace {

/// A copy of a vertex, at the end. The number of the copy.
std::uint32_t add_copy(StyledMesh& mesh, std::uint32_t vertex) {
  const auto copy = [&](auto& values) {
    if (!values.empty()) values.push_back(values[vertex]);
  };
  const auto number = static_cast<std::uint32_t>(mesh.position.size());
  copy(mesh.position), copy(mesh.normal), copy(mesh.color), copy(mesh.part), copy(mesh.guide), copy(mesh.face);
  copy(mesh.uv), copy(mesh.tangent), copy(mesh.look_place);
  return number;
}

}  // namespace

MeshOnPalette on_palette(const StyledMesh& mesh, std::vector<MaterialGroup> groups, LookPalette& palette) {
  constexpr std::size_t nobody = SIZE_MAX;
  MeshOnPalette made{mesh, {}};
  made.mesh.look_place.assign(mesh.position.size(), glm::vec2(0));
  std::vector<std::size_t> group_of(mesh.position.size(), nobody);
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> copies;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const glm::vec2 place = palette.place_of(groups[group].look);
    for (std::size_t i = 0; i < groups[group].triangle.size(); ++i) {
      glm::uvec3& triangle = groups[group].triangle[i];
      for (int k = 0; k < 3; ++k) {
        std::uint32_t& vertex = triangle[k];
        if (group_of[vertex] == nobody) group_of[vertex] = group;
        if (group_of[vertex] != group) {
          const auto [copy, is_new] = copies.try_emplace({vertex, group});
          if (is_new) copy->second = add_copy(made.mesh, vertex);
          vertex = copy->second;
        }
        made.mesh.look_place[vertex] = place;
      }
      made.mesh.triangle[static_cast<std::size_t>(groups[group].face[i])] = triangle;
    }
  }
  made.groups = groups_in_maps(groups);
  return made;
}

}  // namespace pomona
