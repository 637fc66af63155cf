#include "generator/template/read/read_material.h"

namespace pomona {

namespace {

constexpr Within share{0, 1};
constexpr Within strength{0, 4};
constexpr Within relief_height{-0.01, 0.01};  // metres
constexpr double dry_roughness = 0.45;        // parts at least this rough are dry unless `wet` is given
constexpr double usual_dry_wet = 0.15;

Bloom read_bloom(const TomlTable& table) {
  Bloom bloom;
  bloom.cover = table.need("cover").number(0, share);
  bloom.color = table.get("color").color(bloom.color);
  bloom.rubbed = table.get("rubbed").number(bloom.rubbed, share);
  bloom.patch_size = table.get("patch_size").length(bloom.patch_size, {5e-4, 1});
  return bloom;
}

Fuzz read_fuzz(const TomlTable& table) {
  Fuzz fuzz;
  fuzz.length = table.need("length").length(0, {0, 0.05});
  fuzz.density = table.get("density").number(fuzz.density, {0, 20});
  fuzz.color = table.get("color").color(fuzz.color);
  fuzz.lie = table.get("lie").number(fuzz.lie, share);
  return fuzz;
}

Translucency read_translucency(const TomlTable& table) {
  Translucency translucency;
  translucency.depth = table.need("depth").length(0, {0, 1});
  translucency.color = table.get("color").color(translucency.color);
  return translucency;
}

Subsurface read_subsurface(const TomlTable& table) {
  Subsurface subsurface;
  subsurface.radius = table.need("radius").length(0, {0, 0.1});
  subsurface.tint = table.get("tint").color(subsurface.tint);
  subsurface.weight = table.get("weight").number(subsurface.weight, share);
  return subsurface;
}

/// Reads the keys for path tracers.
void read_light_inside(const TomlTable& table, MaterialSketch& material) {
  if (table.has("tissue")) {
    material.tissue = static_cast<Tissue>(
        table.get("tissue").choice({"flesh", "gel", "pith", "skin", "leaf", "seed", "shell", "mineral"}));
  }
  if (table.has("subsurface")) material.subsurface = read_subsurface(table.get("subsurface").table());
  if (table.has("transmission")) material.transmission = table.get("transmission").number(0, share);
  if (table.has("coat")) material.coat = table.get("coat").number(0, share);
}

MaterialSketch read_material(const TomlTable& table) {
  MaterialSketch material;
  material.gloss = table.get("gloss").number(material.gloss, strength);
  material.roughness = table.get("roughness").number(material.roughness, {0.02, 1});
  const double usual_wet = material.roughness >= dry_roughness ? usual_dry_wet : material.wet;
  material.wet = table.get("wet").number(usual_wet, strength);
  material.relief = table.get("relief").length(0, relief_height);
  material.pit = table.get("pit").length(0, {0, relief_height.high});
  if (table.has("bloom")) material.bloom = read_bloom(table.get("bloom").table());
  if (table.has("fuzz")) material.fuzz = read_fuzz(table.get("fuzz").table());
  if (table.has("translucency")) material.translucency = read_translucency(table.get("translucency").table());
  read_light_inside(table, material);
  return material;
}

}  // namespace

std::vector<MaterialSketch> read_materials(const TomlTable& table, const std::vector<std::string>& parts) {
  std::vector<MaterialSketch> materials;
  for (const std::string& part : parts) {
    materials.push_back(table.has(part) ? read_material(table.get(part).table()) : MaterialSketch{});
  }
  return materials;
}

}  // namespace pomona
