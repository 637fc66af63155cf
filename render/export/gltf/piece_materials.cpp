#include "render/export/gltf/piece_materials.h"

#include <utility>

#include "render/image/png.h"

namespace pomona::gltf {

namespace {

constexpr int linear = 9729, linear_mipmap_linear = 9987, clamp_to_edge = 33071;

/// \param texture the name of the texture, if there is one.
std::string name_of(const Solid& solid, const LookGroup& group, const std::string& texture) {
  const std::string& fruit = solid.origin.fruit;
  std::string name = !texture.empty() ? texture : fruit.empty() ? solid.name : fruit;
  if (!group.name.empty()) name += " " + group.name;
  if (solid.opacity < 1) name += " (see-through)";
  if (!solid.closed) name += " (open)";
  return name;
}

}  // namespace

int PieceMaterials::material(const Solid& solid, const LookGroup& group, std::optional<int> texture) {
  const std::string picture = texture ? document_.at("textures", *texture)["name"].get<std::string>() : "";
  const std::string name = name_of(solid, group, picture);
  const auto known = known_.find({name, solid.closed, solid.opacity, group.look, texture});
  if (known != known_.end()) return known->second;

  // White where vertices have colours, so that those speak. Open meshes show both sides.
  Json metal = {{"metallicFactor", 0.0}, {"roughnessFactor", group.look.roughness}};
  if (solid.opacity < 1) metal["baseColorFactor"] = {1.0, 1.0, 1.0, static_cast<double>(solid.opacity)};
  if (texture) metal["baseColorTexture"] = {{"index", *texture}};
  Json material = {{"name", name}, {"pbrMetallicRoughness", std::move(metal)}};
  if (solid.opacity < 1) material["alphaMode"] = "BLEND";
  if (!solid.closed) material["doubleSided"] = true;
  add_extensions(material, group.look);
  const int index = document_.add("materials", std::move(material));
  known_[{name, solid.closed, solid.opacity, group.look, texture}] = index;
  return index;
}

/// What glTF itself cannot say. No viewer needs to understand it.
void PieceMaterials::add_extensions(Json& material, const PbrLook& look) {
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
  if (look.transmission > 0) {
    add("KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", look.transmission},
                                               {"diffuseTransmissionColorFactor", look.transmission_color}});
  }
}

/// Trilinear; one for all textures. Charts lie apart, and nothing repeats.
int PieceMaterials::smooth_sampler() {
  if (!sampler_) {
    sampler_ = document_.add("samplers", {{"magFilter", linear},
                                          {"minFilter", linear_mipmap_linear},
                                          {"wrapS", clamp_to_edge},
                                          {"wrapT", clamp_to_edge}});
  }
  return *sampler_;
}

int PieceMaterials::add_texture(const std::string& name, const Image& picture) {
  const std::string png = write_png(picture, PngPacking::fast);
  const int view = document_.add_view(png.data(), png.size(), Target::none);
  const int image = document_.add("images", {{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
  return document_.add("textures", {{"name", name}, {"sampler", smooth_sampler()}, {"source", image}});
}

}  // namespace pomona::gltf
