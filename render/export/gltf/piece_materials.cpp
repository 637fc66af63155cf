#include "render/export/gltf/piece_materials.h"

#include <algorithm>
#include <utility>

namespace pomona::gltf {

namespace {

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

/// True if the film of juice, in red, thins out anywhere.
bool ends_somewhere(const Image& thickness) {
  return std::any_of(thickness.pixels.begin(), thickness.pixels.end(),
                     [](const glm::u8vec3& pixel) { return pixel.r < 255; });
}

}  // namespace

int PieceMaterials::material(const Solid& solid, const MaterialGroup& group,
                             const std::optional<PieceTextures>& textures) {
  const std::string picture =
      textures ? document_.at("textures", textures->color)["name"].get<std::string>() : std::string();
  const std::string name = name_of(solid, group, picture);
  const auto known = known_.find({name, solid.closed, solid.opacity, group.look, textures});
  if (known != known_.end()) return known->second;

  // White if vertices have colours, so that only these count. Open meshes show both sides.
  Json metal = {{"metallicFactor", 0.0}, {"roughnessFactor", group.look.roughness}};
  if (solid.opacity < 1) metal["baseColorFactor"] = {1.0, 1.0, 1.0, static_cast<double>(solid.opacity)};
  if (textures) metal["baseColorTexture"] = {{"index", textures->color}};
  Json material = {{"name", name}, {"pbrMetallicRoughness", std::move(metal)}};
  if (solid.opacity < 1) material["alphaMode"] = "BLEND";
  if (!solid.closed) material["doubleSided"] = true;
  add_extensions(material, group.look);
  if (textures) add_maps(material, group.look, *textures);
  if (group.look.inside.weight > 0) {
    material["extras"]["subsurface"] = {{"weight", group.look.inside.weight}, {"radius", group.look.inside.radius}};
  }
  const int index = document_.add("materials", std::move(material));
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
  if (textures.film && look.clearcoat > 0)
    material["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"] = {{"index", *textures.film}};
  if (!textures.thickness || !(look.transmission > 0)) return;
  material["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", max_thickness},
                                                    {"thicknessTexture", {{"index", *textures.thickness}}},
                                                    {"attenuationDistance", depth_of_transmission(look.transmission)},
                                                    {"attenuationColor", look.transmission_color}};
  document_.use_extension("KHR_materials_volume");
}

PieceTextures PieceMaterials::add_textures(const BakedSolid& baked) {
  const std::string& name = baked.solid.name;
  PieceTextures textures{.color = add_texture(name, baked.texture)};
  if (baked.maps.empty()) return textures;
  textures.normal = add_texture(name + " normal", baked.maps.normal, PngValues::shares);
  textures.orm = add_texture(name + " orm", baked.maps.orm, PngValues::shares);
  const bool is_thin = lets_light_through(baked.solid), has_ends = ends_somewhere(baked.maps.thickness);
  if (is_thin || has_ends) {
    const int both = add_texture(name + " thickness", baked.maps.thickness, PngValues::shares);
    if (is_thin) textures.thickness = both;
    if (has_ends) textures.film = both;
  }
  return textures;
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

int PieceMaterials::add_texture(const std::string& name, const Image& picture, PngValues values) {
  const std::string png = write_png(picture, PngPacking::fast, values);
  const int view = document_.add_view(png.data(), png.size(), Target::none);
  const int image = document_.add("images", {{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
  return document_.add("textures", {{"name", name}, {"sampler", smooth_sampler()}, {"source", image}});
}

}  // namespace pomona::gltf
