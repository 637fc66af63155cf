#include "render/page/page_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/little_endian.h"
#include "generator/mesh/box.h"
#include "generator/piece/piece_facts.h"
#include "render/gl/scene_materials.h"
#include "render/gl/scene_upload.h"
#include "render/page/byte_planes.h"
#include "render/page/deflate.h"

namespace pomona {

namespace {

using nlohmann::ordered_json;

constexpr std::string_view scene_magic("pomona\0\2", 8);

/// Data of a fruit that the page needs before it unpacks the asset, or of a dish, which has none.
struct FruitOfPage {
  std::string title = {}, latin = {};
  int asset = -1;
  glm::dvec3 origin{0};
  double spacing = 1;
  std::array<int, 3> count{2, 2, 2};
  int units = 1;
  std::vector<std::string> parts = {};
  Color ink{0};
  double ink_width = 1;
  std::vector<glm::vec4> noise = {}, materials = {};
};

FruitOfPage of_asset(const Asset& asset, int number) {
  return {.title = asset.title,
          .latin = asset.latin,
          .asset = number,
          .origin = asset.origin,
          .spacing = asset.spacing,
          .count = asset.count,
          .units = asset.units,
          .parts = asset.parts,
          .ink = asset.ink,
          .ink_width = asset.ink_width,
          .noise = asset.noise,
          .materials = asset.materials};
}

/// A solid without a fruit has a lattice of its own, as fine as a fruit's.
FruitOfPage of_solid(const Solid& solid) {
  constexpr int cells = 64;
  Box<double> bounds;
  for (const glm::vec3& p : solid.mesh.position) bounds.add(glm::dvec3(p));
  const glm::dvec3 size = solid.mesh.position.empty() ? glm::dvec3(1) : bounds.size();
  FruitOfPage fruit{.title = solid.name,
                    .parts = solid.look->part_names,
                    .ink = solid.look->ink.color,
                    .ink_width = solid.look->ink.width};
  fruit.origin = solid.mesh.position.empty() ? glm::dvec3(0) : bounds.low;
  fruit.spacing = std::max({size.x, size.y, size.z, 1e-6}) / cells;
  fruit.count = {cells + 1, cells + 1, cells + 1};
  fruit.units = 65535 / (cells + 1);
  if (fruit.parts.empty()) fruit.parts.push_back(solid.name);
  fruit.noise = noise_texels(solid.look->noise);
  for (std::size_t part = 0; part < fruit.parts.size(); ++part) {
    const std::vector<glm::vec4> texels = material_texels(material_of(solid, static_cast<std::int32_t>(part)));
    fruit.materials.insert(fruit.materials.end(), texels.begin(), texels.end());
  }
  return fruit;
}

/// A direction as two whole numbers up to 1023: unfolded from an octahedron [Meyer et al. 2010].
std::array<std::uint32_t, 2> octahedral(const glm::vec3& n) {
  const float sum = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
  if (!(sum > 0)) return {512, 512};
  float x = n.x / sum, y = n.y / sum;
  if (n.z < 0) {
    const float folded = (1 - std::fabs(y)) * (x < 0 ? -1.0f : 1.0f);
    y = (1 - std::fabs(x)) * (y < 0 ? -1.0f : 1.0f);
    x = folded;
  }
  const auto whole = [](float v) {
    return static_cast<std::uint32_t>(std::clamp(std::floor((v * 0.5f + 0.5f) * 1023.0f + 0.5f), 0.0f, 1023.0f));
  };
  return {whole(x), whole(y)};
}

/// Per vertex: its part among the fruit's, plus 128 on a cut face.
std::vector<std::uint32_t> tags_of(const Solid& solid, const FruitOfPage& fruit) {
  std::vector<std::uint32_t> part_of(std::max<std::size_t>(solid.look->part_names.size(), 1), 0);
  for (std::size_t k = 0; k < solid.look->part_names.size(); ++k) {
    const auto found = std::find(fruit.parts.begin(), fruit.parts.end(), solid.look->part_names[k]);
    if (found != fruit.parts.end()) part_of[k] = static_cast<std::uint32_t>(found - fruit.parts.begin());
  }
  std::vector<std::uint32_t> tags(solid.mesh.position.size(), 0);
  for (std::size_t v = 0; v < tags.size() && v < solid.mesh.part.size(); ++v) {
    const auto part = static_cast<std::size_t>(std::max(solid.mesh.part[v], 0));
    tags[v] = part < part_of.size() ? std::min(part_of[part], 127u) : 0;
  }
  for (std::size_t t = 0; t < solid.mesh.triangle.size() && t < solid.mesh.cut_face.size(); ++t) {
    if (solid.mesh.cut_face[t] < 0) continue;
    for (int k = 0; k < 3; ++k) tags[solid.mesh.triangle[t][k]] |= 128u;
  }
  return tags;
}

std::string mesh_of(const Solid& solid, const FruitOfPage& fruit) {
  const std::size_t vertices = solid.mesh.position.size(), triangles = solid.mesh.triangle.size();
  const double per_metre = fruit.units / fruit.spacing;
  std::string bytes;
  for (int k = 0; k < 3; ++k) {
    bytes += planes_of(vertices, 1, 2, [&](std::size_t v) {
      const double place = (static_cast<double>(solid.mesh.position[v][k]) - fruit.origin[k]) * per_metre;
      return std::clamp(std::floor(place), 0.0, 65535.0);
    });
  }
  std::vector<std::array<std::uint32_t, 2>> normal;
  for (const glm::vec3& n : solid.mesh.normal) normal.push_back(octahedral(n));
  for (std::size_t k = 0; k < 2; ++k) bytes += planes_of(vertices, 1, 2, [&](std::size_t v) { return normal[v][k]; });
  std::vector<glm::u8vec3> color;
  for (const Color& c : solid.mesh.color) color.push_back(to_srgb8(c));
  for (int k = 0; k < 3; ++k) bytes += planes_of(vertices, 1, 1, [&](std::size_t v) { return color[v][k]; });
  bytes += as_planes(tags_of(solid, fruit), 1, 1);
  for (int k = 0; k < 3; ++k)
    bytes += planes_of(triangles, 2, 3, [&](std::size_t t) { return solid.mesh.triangle[t][k]; });
  return bytes;
}

/// The facts that a click on a piece shows.
ordered_json facts_for(const Solid& solid, const std::string& command) {
  const PieceFacts facts = facts_of(solid);
  ordered_json told = {{"mass", facts.mass}, {"volume", facts.volume}, {"density", facts.density}};
  const PieceOrigin& origin = solid.origin;
  if (origin.source.empty()) return told;
  told["template"] = origin.source;
  told["seed"] = origin.key.seed;
  told["index"] = origin.key.index;
  told["knife"] = knives_text(origin);
  told["piece"] = origin.number;
  told["pieces"] = origin.pieces;
  if (!command.empty()) told["command"] = command;
  return told;
}

ordered_json three(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

ordered_json entry_for(const FruitOfPage& fruit) {
  return {{"title", fruit.title},
          {"latin", fruit.latin},
          {"asset", fruit.asset},
          {"origin", three(fruit.origin)},
          {"spacing", fruit.spacing},
          {"count", fruit.count},
          {"units", fruit.units},
          {"parts", fruit.parts},
          {"ink", to_hex(fruit.ink)},
          {"ink_width", fruit.ink_width},
          {"texels", {fruit.noise.size(), fruit.materials.size()}}};
}

ordered_json place_of(const Instance& instance) {
  const glm::dquat& q = instance.pose.rotation;
  return {{"name", instance.name},
          {"solid", instance.solid},
          {"rotation", {q.w, q.x, q.y, q.z}},
          {"translation", three(instance.pose.translation)}};
}

}  // namespace

void check_fits_a_page(const Scene& scene, std::size_t fruits) {
  std::size_t triangles = 0;
  for (const Solid& solid : scene.solids) triangles += solid.mesh.triangle.size();
  const auto refuse = [](const std::string& what, std::size_t there, std::size_t max, const char* hint) {
    if (there <= max) return;
    throw Error(
        ExitStatus::usage,
        "a page of a scene takes " + std::to_string(max) + " " + what + "; this one has " + std::to_string(there),
        hint);
  };
  refuse("fruits", fruits, max_page_fruits, "fewer variants, each placed more often: `copies` or `total` for `count`");
  refuse("pieces", scene.instances.size(), max_page_instances, "write a .glb with --instances, or a smaller scene");
  refuse("triangles", triangles, max_scene_triangles, "--detail 0.5");
}

std::string packed_scene(const PageScene& page) {
  std::vector<FruitOfPage> fruits;
  for (std::size_t k = 0; k < page.fruits.size(); ++k) fruits.push_back(of_asset(page.fruits[k], static_cast<int>(k)));
  std::vector<std::size_t> fruit_of;
  for (std::size_t s = 0; s < page.scene.solids.size(); ++s) {
    const int known = page.fruit_of[s];
    fruit_of.push_back(known >= 0 ? static_cast<std::size_t>(known) : fruits.size());
    if (known < 0) fruits.push_back(of_solid(page.scene.solids[s]));
  }

  const View& view = page.scene.view;
  ordered_json header = {
      {"format", 1}, {"name", page.name}, {"view", {{"eye", three(view.eye)}, {"target", three(view.target)}}}};
  header["fruits"] = ordered_json::array();
  std::string arrays;
  for (const FruitOfPage& fruit : fruits) {
    header["fruits"].push_back(entry_for(fruit));
    arrays += texel_bytes(fruit.noise) + texel_bytes(fruit.materials);
  }
  header["solids"] = ordered_json::array();
  for (std::size_t s = 0; s < page.scene.solids.size(); ++s) {
    const Solid& solid = page.scene.solids[s];
    header["solids"].push_back({{"name", solid.name},
                                {"fruit", fruit_of[s]},
                                {"vertices", solid.mesh.position.size()},
                                {"triangles", solid.mesh.triangle.size()},
                                {"facts", facts_for(solid, page.command[s])}});
    arrays += mesh_of(solid, fruits[fruit_of[s]]);
  }
  header["instances"] = ordered_json::array();
  for (const Instance& instance : page.scene.instances) header["instances"].push_back(place_of(instance));

  const std::string text = json_text(header);
  return std::string(scene_magic) + deflated(word_bytes(text.size()) + text + arrays);
}

}  // namespace pomona
