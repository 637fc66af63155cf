#include "render/page/make_asset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "generator/base/error.h"
#include "generator/cut/spared.h"
#include "generator/diffusion/harmonic/node_colors.h"
#include "generator/mesh/box.h"
#include "generator/mesh/enclosures.h"
#include "generator/surface/bodies.h"
#include "render/gl/detail_texels.h"
#include "render/gl/scene_materials.h"
#include "render/gl/scene_upload.h"
#include "render/page/asset_guide.h"
#include "render/page/windings.h"
#include "render/style/look.h"

namespace pomona {

namespace {

constexpr int sixteen_bits = 65536;

void require_closed(const AssetTask& task) {
  const DiffusionSurfaces& surfaces = task.grown.sheets;
  const auto refuse = [&](const std::string& why) {
    throw Error(ExitStatus::bad_data, {{{task.name, 0, 0, {}}, why, "`pomona cut` makes pieces of it as it is"}});
  };
  const Bodies bodies = find_bodies(surfaces);
  if (bodies.bodies.empty()) refuse("none of its surfaces faces air: a page and an asset have to know what is inside");
  for (const Bodies::Body& body : bodies.bodies) {
    if (body.closed) continue;
    refuse("its boundary is open" + (bodies.warnings.empty() ? std::string() : " (" + bodies.warnings.front() + ")") +
           ": a page and an asset have to know what is inside");
  }
  if (surfaces.part_names.size() > max_asset_parts)
    refuse("it has " + std::to_string(surfaces.part_names.size()) + " parts; a page and an asset hold at most " +
           std::to_string(max_asset_parts));
}

/// Rounds vertices to whole units.
void add_surfaces(const DiffusionSurfaces& surfaces, Asset& asset) {
  const double units_per_metre = asset.units / asset.spacing;
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    const glm::dvec3 place = (glm::dvec3(surfaces.position[v]) - asset.origin) * units_per_metre;
    asset.position.emplace_back(glm::clamp(glm::floor(place), glm::dvec3(0), glm::dvec3(sixteen_bits - 1)));
    asset.front_color.push_back(to_srgb8(surfaces.front_color[v]));
    asset.back_color.push_back(to_srgb8(surfaces.back_color[v]));
  }
  asset.triangle = surfaces.triangle;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    const bool boundary = surfaces.is_boundary(t);
    asset.hidden.push_back(!boundary ? 0 : surfaces.is_hidden(t, SideOf::front) ? 1 : 2);
    asset.front_part.push_back(static_cast<std::uint16_t>(std::max(surfaces.front_part[t], 0)));
    asset.back_part.push_back(static_cast<std::uint16_t>(std::max(surfaces.back_part[t], 0)));
  }
  asset.parts = surfaces.part_names;
}

/// The closed shells that cross another or leave the fruit, judged at nodes inside; knives go through them.
std::set<std::uint32_t> crossed_shells(const DiffusionSurfaces& surfaces, std::span<const std::uint32_t> shell,
                                       const Asset& asset) {
  std::vector<Enclosures::Triangle> triangles;
  Box<float> box;
  for (std::size_t t = 0; t < shell.size(); ++t) {
    if (shell[t] == 0) continue;
    Enclosures::Triangle one{{}, shell[t]};
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& corner = surfaces.position[surfaces.triangle[t][k]];
      one.corner[static_cast<std::size_t>(k)] = corner;
      box.add(corner);
    }
    triangles.push_back(one);
  }
  std::set<std::uint32_t> crossed;
  if (triangles.empty()) return crossed;
  const Enclosures shells(std::move(triangles));
  const glm::dvec3 low = (glm::dvec3(box.low) - asset.origin) / asset.spacing;
  const glm::dvec3 high = (glm::dvec3(box.high) - asset.origin) / asset.spacing;
  const glm::ivec3 first = glm::max(glm::ivec3(glm::ceil(low)), 0);
  const glm::ivec3 last =
      glm::min(glm::ivec3(glm::floor(high)), glm::ivec3(asset.count[0], asset.count[1], asset.count[2]) - 1);
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        const auto around = shells.around(asset.origin + asset.spacing * glm::dvec3(x, y, z));
        const auto node = static_cast<std::size_t>((z * asset.count[1] + y) * asset.count[0] + x);
        for (const auto& [number, winding] : around)
          if (around.size() > 1 || winding != 1 || asset.winding[node] != 1) crossed.insert(number);
      }
    }
  }
  return crossed;
}

/// Parts of the template come first among the surfaces' own. Needs the windings.
void add_spared(const DiffusionSurfaces& surfaces, const Template& fruit, Asset& asset) {
  for (const int part : fruit.spared) {
    if (part < static_cast<int>(asset.parts.size())) asset.spared.push_back(part);
  }
  if (asset.spared.empty()) return;
  std::vector<std::uint32_t> shell = closed_shells(surfaces, asset.spared);
  const std::set<std::uint32_t> crossed = crossed_shells(surfaces, shell, asset);
  std::map<std::uint32_t, std::uint16_t> number;
  for (std::uint32_t& one : shell) {
    const bool is_kept = one != 0 && one <= max_asset_shells && !crossed.contains(one);
    one = is_kept ? number.try_emplace(one, static_cast<std::uint16_t>(number.size() + 1)).first->second : 0;
  }
  if (!number.empty()) asset.shell.assign(shell.begin(), shell.end());
}

/// Nodes within the rounded boundary that the solver left out get the colours of known neighbours, inside or outside of
/// it.
void fill_unknown(const NodeColors& nodes, Asset& asset) {
  const auto nx = static_cast<std::ptrdiff_t>(asset.count[0]), plane = nx * asset.count[1];
  const auto size = static_cast<std::ptrdiff_t>(asset.winding.size());
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    const auto node = static_cast<std::size_t>(i);
    if (nodes.known[node] != 0 || asset.winding[node] == 0) continue;
    glm::ivec3 sum(0);
    int count = 0;
    for (const std::ptrdiff_t step : {std::ptrdiff_t{1}, std::ptrdiff_t{-1}, nx, -nx, plane, -plane}) {
      const std::ptrdiff_t beside = i + step;
      if (beside < 0 || beside >= size || nodes.known[static_cast<std::size_t>(beside)] == 0) continue;
      sum += glm::ivec3(to_srgb8(nodes.color[static_cast<std::size_t>(beside)]));
      ++count;
    }
    if (count > 0) asset.node_color[node] = glm::u8vec3((2 * sum + count) / (2 * count));
  }
}

/// Colours the nodes inside by another diffuser.
void recolor(const DiffusionSurfaces& surfaces, const Diffuser& diffuser, const Asset& asset, NodeColors& nodes) {
  std::vector<std::size_t> inside;
  std::vector<glm::vec3> place;
  for (std::size_t i = 0; i < nodes.color.size(); ++i) {
    if (asset.winding[i] == 0) continue;
    const auto nx = static_cast<std::size_t>(asset.count[0]), ny = static_cast<std::size_t>(asset.count[1]);
    inside.push_back(i);
    place.emplace_back(asset.origin + asset.spacing * glm::dvec3(i % nx, i / nx % ny, i / (nx * ny)));
  }
  const std::vector<Color> color = diffuser.field(surfaces)->at(place).color;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    nodes.color[inside[i]] = color[i];
    nodes.known[inside[i]] = 1;
  }
}

void add_nodes(const NodeColors& nodes, Asset& asset) {
  asset.node_color.assign(nodes.color.size(), glm::u8vec3(0));
  for (std::size_t i = 0; i < nodes.color.size(); ++i) {
    if (nodes.known[i] != 0 && asset.winding[i] != 0) asset.node_color[i] = to_srgb8(nodes.color[i]);
  }
  fill_unknown(nodes, asset);
}

/// Colours by number, from the smallest bytes.
AssetTile asset_tile(const ExampleTile& tile) {
  const auto number_of = [](const glm::u8vec3& t) { return t.r << 16 | t.g << 8 | t.b; };
  std::map<int, std::size_t> known;
  for (const glm::u8vec3& texel : tile.texel) known.try_emplace(number_of(texel), 0);
  AssetTile packed{.side = tile.side(), .palette = {}, .texel = {}};
  for (auto& [color, number] : known) {
    number = packed.palette.size();
    packed.palette.emplace_back(color >> 16, color >> 8 & 255, color & 255);
  }
  for (const glm::u8vec3& texel : tile.texel)
    packed.texel.push_back(static_cast<std::uint8_t>(known.at(number_of(texel))));
  return packed;
}

void add_look(const AssetTask& task, Asset& asset) {
  const Template& fruit = task.variant;
  asset.noise = noise_texels(fruit.noise);
  DetailTexels details = detail_texels(std::array{Look(NoiseStyle{}, fruit.details)});
  asset.details = std::move(details.styles);
  for (const auto& tile : details.tiles) asset.tiles.push_back(asset_tile(*tile));
  std::vector<MaterialSketch> materials = look_of(fruit, asset.parts).materials;
  materials.resize(asset.parts.size());
  for (const MaterialSketch& material : materials) {
    const std::vector<glm::vec4> texels = material_texels(material);
    asset.materials.insert(asset.materials.end(), texels.begin(), texels.end());
  }
  asset.ink = fruit.ink.color;
  asset.ink_width = fruit.ink.width;
}

}  // namespace

Asset make_asset(const AssetTask& task, const MakeAssetOptions& options) {
  require_closed(task);
  const DiffusionSurfaces& surfaces = task.grown.sheets;
  NodeColors nodes = solved_nodes(surfaces, {.quality = options.quality, .threads = options.threads});

  Asset asset;
  asset.name = task.name;
  asset.title = task.variant.title;
  asset.latin = task.variant.latin;
  asset.seed = task.seed;
  asset.diffuser = options.diffuser == nullptr ? "harmonic" : options.diffuser->name();
  asset.origin = nodes.lattice.origin;
  asset.spacing = nodes.lattice.spacing;
  asset.count = nodes.lattice.count;
  asset.units = sixteen_bits / (*std::max_element(asset.count.begin(), asset.count.end()) - 1);
  add_surfaces(surfaces, asset);
  asset.winding = windings(asset);
  add_spared(surfaces, task.variant, asset);
  if (options.diffuser != nullptr) recolor(surfaces, *options.diffuser, asset, nodes);
  add_nodes(nodes, asset);
  add_look(task, asset);
  add_guide(task.grown, task.variant, options.threads, asset);
  return asset;
}

}  // namespace pomona
