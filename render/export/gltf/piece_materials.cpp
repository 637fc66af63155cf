#include "render/export/gltf/piece_materials.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pomona::gltf {

namespace {

const char* const palette_name = "looks";

constexpr int linear = 9729, linear_mipmap_linear = 9987, clamp_to_edge = 33071;

/// \param texture the name of the texture, if there is one.
std::string name_of(const Solid& solid, const MaterialGroup& group, const std::string& texture) {
  const std::string& fruit = solid.origin.fruit;
  std::string name = !texture.empty() ? texture : fruit.empty() ? solid.name : fruit;
  if (!group.name.empty()) name += " " + group.name;
  if (solid.opacity < 1) name += " (see-through)";
  if (!solid.closed) name += " (open)";
  return name;
}

/// The inverse of what look_of() makes of a depth, metres.
double depth_of_transmission(double transmission) { return 1e-3 * transmission / std::max(0.45 - transmission, 0.01); }

bool lets_light_through(const Solid& solid) {
  return std::any_of(solid.look->materials.begin(), solid.look->materials.end(),
                     [](const MaterialSketch& material) { return material.translucency.depth > 0; });
}

bool has_coat(const TransparentImage& coat) {
  const std::vector<glm::u8vec3>& pixels = coat.image.pixels;
  return std::any_of(pixels.begin(), pixels.end(), [](const glm::u8vec3& pixel) { return pixel.r > 0; });
}

bool has_dull_places(const TransparentImage& coat) {
  return std::any_of(coat.opacity.begin(), coat.opacity.end(), [](std::uint8_t specular) { return specular < 255; });
}

/// True if the film of juice, in red, thins out anywhere.
bool ends_somewhere(const Image& thickness) {
  return std::any_of(thickness.pixels.begin(), thickness.pixels.end(),
                     [](const glm::u8vec3& pixel) { return pixel.r < 255; });
}

}  // namespace

int PieceMaterials::material(const Solid& solid, const MaterialGroup& group,
                             const std::optional<PieceTextures>& textures) {
  std::string picture;
  if (textures && textures->color) picture = document_.at("textures", *textures->color)["name"];
  if (textures && textures->is_palette && textures->are_shared) picture = palette_name;
  const std::string name = name_of(solid, group, picture);
  const auto known = known_.find({name, solid.closed, solid.opacity, group.look, textures});
  if (known != known_.end()) return known->second;

  // White if vertices have colours, so that only these count. Open meshes show both sides.
  Json metal = {{"metallicFactor", 0.0}, {"roughnessFactor", group.look.roughness}};
  if (solid.opacity < 1) metal["baseColorFactor"] = {1.0, 1.0, 1.0, static_cast<double>(solid.opacity)};
  if (textures && textures->color) metal["baseColorTexture"] = {{"index", *textures->color}};
  Json material = {{"name", name}, {"pbrMetallicRoughness", std::move(metal)}};
  if (solid.opacity < 1) material["alphaMode"] = "BLEND";
  if (!solid.closed) material["doubleSided"] = true;
  add_extensions(material, group.look);
  if (textures) add_maps(material, group.look, *textures);
  if (group.look.inside.weight > 0) {
    material["extras"]["subsurface"] = {{"weight", group.look.inside.weight}, {"radius", group.look.inside.radius}};
  }
  const int index = document_.add("materials", std::move(material));
  if (textures && textures->is_palette) on_palette_.push_back(index);
  known_[{name, solid.closed, solid.opacity, group.look, textures}] = index;
  return index;
}

/// Adds extensions for properties beyond glTF's core; viewers may ignore them.
void PieceMaterials::add_extensions(Json& material, const PbrMaterial& look) {
  const auto add = [&](const char* name, Json factors) {
    material["extensions"][name] = std::move(factors);
    document_.use_extension(name);
  };
  if (look.specular < 1) add("KHR_materials_specular", {{"specularFactor", look.specular}});
  if (look.clearcoat > 0) {
    add("KHR_materials_clearcoat",
        {{"clearcoatFactor", look.clearcoat}, {"clearcoatRoughnessFactor", look.clearcoat_roughness}});
  }
  if (look.sheen_roughness > 0) {
    add("KHR_materials_sheen", {{"sheenColorFactor", look.sheen}, {"sheenRoughnessFactor", look.sheen_roughness}});
  }
  if (look.clearness > 0) add("KHR_materials_transmission", {{"transmissionFactor", look.clearness}});
  if (look.transmission > 0) {
    add("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", look.transmission},
                                               {"diffuseTransmissionColorFactor", look.transmission_color}});
  }
}

/// Adds maps of roughness and of the film on cut faces. Transmitted light decreases with its path through the part: 1/e
/// is left after the material's depth, which follows from its share of transmission.
void PieceMaterials::add_maps(Json& material, const PbrMaterial& look, const PieceTextures& textures) {
  if (textures.normal) material["normalTexture"] = {{"index", *textures.normal}};
  if (textures.orm) {
    material["pbrMetallicRoughness"]["roughnessFactor"] = 1.0;
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", *textures.orm}};
    material["occlusionTexture"] = {{"index", *textures.orm}};
  }
  add_look_maps(material, textures);
  if (textures.film && look.clearcoat > 0)
    material["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"] = {{"index", *textures.film}};
  if (!textures.thickness || !(look.transmission > 0)) return;
  material["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", max_thickness},
                                                    {"thicknessTexture", {{"index", *textures.thickness}}},
                                                    {"attenuationDistance", depth_of_transmission(look.transmission)},
                                                    {"attenuationColor", look.transmission_color}};
  document_.use_extension("KHR_materials_volume");
}

/// Adds maps of what else tells the looks of parts apart.
void PieceMaterials::add_look_maps(Json& material, const PieceTextures& textures) {
  const auto add = [&](const char* name, Json extension) {
    material["extensions"][name] = std::move(extension);
    document_.use_extension(name);
  };
  const auto slot = [](const std::optional<int>& texture) { return Json{{"index", *texture}}; };
  if (textures.coat) {
    add("KHR_materials_clearcoat", {{"clearcoatFactor", 1.0},
                                    {"clearcoatTexture", slot(textures.coat)},
                                    {"clearcoatRoughnessFactor", 1.0},
                                    {"clearcoatRoughnessTexture", slot(textures.coat)}});
  }
  if (textures.specular) add("KHR_materials_specular", {{"specularTexture", slot(textures.specular)}});
  if (textures.sheen) {
    add("KHR_materials_sheen", {{"sheenColorFactor", {1.0, 1.0, 1.0}},
                                {"sheenColorTexture", slot(textures.sheen)},
                                {"sheenRoughnessFactor", 1.0},
                                {"sheenRoughnessTexture", slot(textures.sheen)}});
  }
  if (textures.light) {
    add("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 1.0},
                                               {"diffuseTransmissionTexture", slot(textures.light)},
                                               {"diffuseTransmissionColorTexture", slot(textures.light)}});
  }
}

PieceTextures PieceMaterials::add_textures(const BakedSolid& baked, const std::string& variant) {
  if (!baked.page)
    return add_all(baked.solid.name + variant, baked.texture, baked.maps, lets_light_through(baked.solid));
  const auto [known, is_new] = pages_.try_emplace(baked.page.get());
  if (is_new) {
    known->second = add_all(baked.page->name + variant, baked.page->texture, baked.page->maps, false);
    known->second.are_shared = true;
  }
  return known->second;
}

/// \param is_thin the solid lets light through somewhere.
PieceTextures PieceMaterials::add_all(const std::string& name, const Image& color, const SurfaceMaps& maps,
                                      bool is_thin) {
  const auto png = [](const auto& picture, PngValues values) { return write_png(picture, PngPacking::fast, values); };
  PieceTextures textures{.color = add_texture(name, png(color, PngValues::srgb))};
  if (maps.empty()) return textures;
  textures.normal = add_texture(name + " normal", png(maps.normal, PngValues::shares));
  textures.orm = add_texture(name + " orm", png(maps.orm, PngValues::shares));
  const bool has_ends = !maps.tell_looks && ends_somewhere(maps.thickness);
  if (is_thin || has_ends) {
    const int both = add_texture(name + " thickness", png(maps.thickness, PngValues::shares));
    if (is_thin) textures.thickness = both;
    if (has_ends) textures.film = both;
  }
  add_look_textures(name, maps, textures);
  return textures;
}

void PieceMaterials::add_look_textures(const std::string& name, const SurfaceMaps& maps, PieceTextures& textures) {
  const auto png = [](const auto& picture, PngValues values) { return write_png(picture, PngPacking::fast, values); };
  textures.tell_looks = maps.tell_looks;
  if (!maps.coat.opacity.empty()) {
    const int both = add_texture(name + " coat", png(maps.coat, PngValues::shares));
    if (has_coat(maps.coat)) textures.coat = both;
    if (has_dull_places(maps.coat)) textures.specular = both;
  }
  if (!maps.sheen.opacity.empty()) textures.sheen = add_texture(name + " sheen", png(maps.sheen, PngValues::srgb));
  if (!maps.light.opacity.empty()) textures.light = add_texture(name + " light", png(maps.light, PngValues::srgb));
}

void PieceMaterials::finish() {
  if (on_palette_.empty()) return;
  const SurfaceMaps maps = palette_.maps();
  PieceTextures textures;
  const std::string name = palette_name;
  const int roughness = add_texture(name + " orm", write_png(maps.orm, PngPacking::fast, PngValues::shares));
  add_look_textures(name, maps, textures);
  for (const int index : on_palette_) {
    Json& material = document_.at("materials", index);
    material["pbrMetallicRoughness"]["roughnessFactor"] = 1.0;
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", roughness}};
    add_look_maps(material, textures);
  }
}

/// One trilinear sampler without repetition for all textures; charts are separate.
int PieceMaterials::smooth_sampler() {
  if (!sampler_) {
    sampler_ = document_.add("samplers", {{"magFilter", linear},
                                          {"minFilter", linear_mipmap_linear},
                                          {"wrapS", clamp_to_edge},
                                          {"wrapT", clamp_to_edge}});
  }
  return *sampler_;
}

/// Adds a picture in the buffer, sampled trilinearly.
int PieceMaterials::add_texture(const std::string& name, const std::string& png) {
  const int view = document_.add_view(png.data(), png.size(), Target::none);
  const int image = document_.add("images", {{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
  return document_.add("textures", {{"name", name}, {"sampler", smooth_sampler()}, {"source", image}});
}

}  // namespace pomona::gltf
