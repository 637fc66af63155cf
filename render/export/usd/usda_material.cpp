#include "render/export/usd/usda_material.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/export/physics_surface.h"

namespace pomona::usd {

namespace {

/// How MaterialX reads a picture of colours.
const std::string srgb = " (colorSpace = \"srgb_texture\")";

void append_places(std::string& text, int indent) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("def Shader \"places\"");
  line("{");
  line("    uniform token info:id = \"UsdPrimvarReader_float2\"");
  line("    string inputs:varname = \"st\"");
  line("    float2 outputs:result");
  line("}");
}

/// The same for MaterialX.
void append_spot(std::string& text, int indent) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("def Shader \"spot\"");
  line("{");
  line("    uniform token info:id = \"ND_geompropvalue_vector2\"");
  line("    string inputs:geomprop = \"st\"");
  line("    float2 outputs:out");
  line("}");
}

/// \param file empty if variants name it. \param space "sRGB" or "raw". \param outputs one line each.
void append_texture(std::string& text, int indent, const std::string& name, const std::string& file, const char* space,
                    std::span<const char* const> outputs) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("def Shader " + quoted(name));
  line("{");
  line("    uniform token info:id = \"UsdUVTexture\"");
  if (!file.empty()) line("    asset inputs:file = " + asset(file));
  line(std::string("    token inputs:sourceColorSpace = \"") + space + "\"");
  line("    token inputs:wrapS = \"clamp\"");
  line("    token inputs:wrapT = \"clamp\"");
  line("    float2 inputs:st.connect = <../places.outputs:result>");
  for (const char* output : outputs) line(std::string("    ") + output);
  line("}");
}

/// The same for MaterialX. \param type "color3" or "color4".
void append_picture(std::string& text, int indent, const std::string& name, const std::string& type,
                    const std::string& file, bool is_srgb) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("def Shader " + quoted(name));
  line("{");
  line("    uniform token info:id = \"ND_image_" + type + "\"");
  if (!file.empty()) line("    asset inputs:file = " + asset(file) + (is_srgb ? srgb : ""));
  line("    string inputs:uaddressmode = \"clamp\"");
  line("    string inputs:vaddressmode = \"clamp\"");
  line("    float2 inputs:texcoord.connect = <../spot.outputs:out>");
  line("    " + type + "f outputs:out");
  line("}");
}

constexpr const char* rgb[] = {"float3 outputs:rgb"};
constexpr const char* channels[] = {"float outputs:r", "float outputs:g", "float outputs:b"};

}  // namespace

void append_textured_material(std::string& text, int indent, const std::string& name, const std::string& look,
                              const std::string& file) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("def Material \"" + name + "\" (prepend references = </Looks/" + look + ">)");
  line("{");
  line("    over \"surface\"");
  line("    {");
  line("        color3f inputs:diffuseColor.connect = <../texture.outputs:rgb>");
  line("    }");
  append_texture(text, indent + 1, "texture", file, "sRGB", rgb);
  line("    over \"light\"");
  line("    {");
  line("        color3f inputs:base_color.connect = <../picture.outputs:out>");
  line("        color3f inputs:subsurface_color.connect = <../picture.outputs:out>");
  line("    }");
  append_picture(text, indent + 1, "picture", "color3", file, true);
  append_spot(text, indent + 1);
  append_places(text, indent + 1);
  line("}");
}

void append_texture_choices(std::string& text, int indent, std::span<const TextureChoice> choices,
                            std::span<const std::string> materials) {
  const auto line = [&](const std::string& words) { append_line(text, indent, words); };
  line("variantSet \"ripeness\" = {");
  for (const TextureChoice& choice : choices) {
    line("    " + quoted(choice.name) + " {");
    line("        over \"Looks\"");
    line("        {");
    for (const std::string& material : materials) {
      line("            over " + quoted(material));
      line("            {");
      line("                over \"texture\"");
      line("                {");
      line("                    asset inputs:file = " + asset(choice.file));
      line("                }");
      line("                over \"picture\"");
      line("                {");
      line("                    asset inputs:file = " + asset(choice.file) + srgb);
      line("                }");
      line("            }");
    }
    line("        }");
    line("    }");
  }
  line("}");
}

namespace {

/// OpenPBR [Academy Software Foundation 2024] in MaterialX, for what the preview lacks, above all subsurface light. Its
/// lengths are in units of the stage, metres. The prim "light" and its colour.
std::string open_pbr_text(const PbrMaterial& look, float opacity) {
  std::string text = "        def Shader \"light\"\n        {\n";
  text += "            uniform token info:id = \"ND_open_pbr_surface_surfaceshader\"\n";
  text += "            color3f inputs:base_color.connect = <../hues.outputs:out>\n";
  const auto number = [&](const char* what, double value) {
    text += std::string("            float inputs:") + what + " = " + exact(value) + "\n";
  };
  const auto color = [&](const char* what, const std::array<double, 3>& c) {
    text += std::string("            color3f inputs:") + what + " = " + exact_tuple({c[0], c[1], c[2]}) + "\n";
  };
  number("specular_weight", look.specular);
  number("specular_roughness", look.roughness);
  if (look.clearcoat > 0) number("coat_weight", look.clearcoat), number("coat_roughness", look.clearcoat_roughness);
  if (look.sheen_roughness > 0) {
    number("fuzz_weight", 1), number("fuzz_roughness", look.sheen_roughness);
    color("fuzz_color", look.sheen);
  }
  if (look.inside.weight > 0) {
    const double widest = *std::max_element(look.inside.radius.begin(), look.inside.radius.end());
    const auto share = [&](std::size_t k) { return std::round(1000 * look.inside.radius[k] / widest) / 1000; };
    text += "            color3f inputs:subsurface_color.connect = <../hues.outputs:out>\n";
    number("subsurface_weight", look.inside.weight), number("subsurface_radius", widest);
    color("subsurface_radius_scale", {share(0), share(1), share(2)});
  }
  if (look.clearness > 0) number("transmission_weight", look.clearness);
  if (opacity < 1) number("geometry_opacity", std::round(1000 * static_cast<double>(opacity)) / 1000);
  text += "            token outputs:out\n        }\n\n";
  text += "        def Shader \"hues\"\n        {\n";
  text += "            uniform token info:id = \"ND_geompropvalue_color3\"\n";
  text += "            string inputs:geomprop = \"displayColor\"\n";
  return text + "            color3f outputs:out\n        }\n";
}

/// Indented for a prim in the scope of looks.
std::string material_text(const std::string& name, const PbrMaterial& look, float opacity) {
  std::string text = "    def Material \"" + name + "\" (prepend apiSchemas = [\"PhysicsMaterialAPI\"])\n    {\n";
  const PhysicsSurface surface = physics_surface_of(look);
  text += "        float physics:staticFriction = " + exact(surface.static_friction) + "\n";
  text += "        float physics:dynamicFriction = " + exact(surface.dynamic_friction) + "\n";
  text += "        float physics:restitution = " + exact(surface.restitution) + "\n";
  text += "        token outputs:surface.connect = <surface.outputs:surface>\n";
  text += "        token outputs:mtlx:surface.connect = <light.outputs:out>\n\n";
  text += "        def Shader \"surface\"\n        {\n";
  text += "            uniform token info:id = \"UsdPreviewSurface\"\n";
  text += "            color3f inputs:diffuseColor.connect = <../colors.outputs:result>\n";
  const auto input = [&](const char* what, double value) {
    text += std::string("            float inputs:") + what + " = " + exact(value) + "\n";
  };
  input("roughness", look.roughness);
  input("metallic", 0);
  if (look.clearcoat > 0) {
    input("clearcoat", look.clearcoat);
    input("clearcoatRoughness", look.clearcoat_roughness);
  }
  if (opacity < 1) input("opacity", std::round(1000 * static_cast<double>(opacity)) / 1000);
  text += "            token outputs:surface\n        }\n\n";
  text += "        def Shader \"colors\"\n        {\n";
  text += "            uniform token info:id = \"UsdPrimvarReader_float3\"\n";
  text += "            string inputs:varname = \"displayColor\"\n";
  text += "            float3 outputs:result\n        }\n\n";
  return text + open_pbr_text(look, opacity) + "    }\n";
}

/// The preview's surface and its pictures.
void append_preview_of_maps(std::string& text, float opacity, const MapFiles& files) {
  const auto line = [&](const std::string& words) { append_line(text, 2, words); };
  line("def Shader \"surface\"");
  line("{");
  line("    uniform token info:id = \"UsdPreviewSurface\"");
  line(std::string("    color3f inputs:diffuseColor.connect = <../") +
       (files.color.empty() ? "colors.outputs:result>" : "texture.outputs:rgb>"));
  line("    float inputs:roughness.connect = <../orm.outputs:g>");
  line("    float inputs:occlusion.connect = <../orm.outputs:r>");
  line("    float inputs:metallic = 0");
  if (!files.coat.empty()) {
    line("    float inputs:clearcoat.connect = <../coat.outputs:r>");
    line("    float inputs:clearcoatRoughness.connect = <../coat.outputs:g>");
  }
  if (!files.normal.empty()) line("    normal3f inputs:normal.connect = <../normal.outputs:rgb>");
  if (opacity < 1) line("    float inputs:opacity = " + exact(std::round(1000 * static_cast<double>(opacity)) / 1000));
  line("    token outputs:surface");
  line("}");
  if (!files.color.empty()) append_texture(text, 2, "texture", files.color, "sRGB", rgb);
  append_texture(text, 2, "orm", files.orm, "raw", channels);
  if (!files.coat.empty()) append_texture(text, 2, "coat", files.coat, "raw", channels);
  if (!files.normal.empty()) {
    constexpr const char* directions[] = {"float4 inputs:scale = (2, 2, 2, 1)", "float4 inputs:bias = (-1, -1, -1, 0)",
                                          "float3 outputs:rgb"};
    append_texture(text, 2, "normal", files.normal, "raw", directions);
  }
  append_places(text, 2);
}

/// A number from one channel of a picture.
void append_channels(std::string& text, const std::string& name, int count) {
  const std::string type = "color" + std::to_string(count);
  const auto line = [&](const std::string& words) { append_line(text, 2, words); };
  line("def Shader \"" + name + "_parts\"");
  line("{");
  line("    uniform token info:id = \"ND_separate" + std::to_string(count) + "_" + type + "\"");
  line("    " + type + "f inputs:in.connect = <../" + name + "_picture.outputs:out>");
  for (int k = 0; k < count; ++k) line(std::string("    float outputs:out") + "rgba"[k]);
  line("}");
}

/// OpenPBR of the same maps, but for relief.
void append_open_pbr_of_maps(std::string& text, double clearness, float opacity, const MapFiles& files) {
  const auto line = [&](const std::string& words) { append_line(text, 2, words); };
  line("def Shader \"light\"");
  line("{");
  line("    uniform token info:id = \"ND_open_pbr_surface_surfaceshader\"");
  line(std::string("    color3f inputs:base_color.connect = <../") +
       (files.color.empty() ? "hues.outputs:out>" : "picture.outputs:out>"));
  line("    float inputs:specular_roughness.connect = <../orm_parts.outputs:outg>");
  if (!files.coat.empty()) {
    line("    float inputs:specular_weight.connect = <../coat_parts.outputs:outa>");
    line("    float inputs:coat_weight.connect = <../coat_parts.outputs:outr>");
    line("    float inputs:coat_roughness.connect = <../coat_parts.outputs:outg>");
  }
  if (!files.sheen.empty()) {
    line("    float inputs:fuzz_weight = 1");
    line("    color3f inputs:fuzz_color.connect = <../sheen_color.outputs:out>");
    line("    float inputs:fuzz_roughness.connect = <../sheen_parts.outputs:outa>");
  }
  if (clearness > 0) line("    float inputs:transmission_weight = " + exact(clearness));
  if (opacity < 1)
    line("    float inputs:geometry_opacity = " + exact(std::round(1000 * static_cast<double>(opacity)) / 1000));
  line("    token outputs:out");
  line("}");
  if (files.color.empty()) {
    line("def Shader \"hues\"");
    line("{");
    line("    uniform token info:id = \"ND_geompropvalue_color3\"");
    line("    string inputs:geomprop = \"displayColor\"");
    line("    color3f outputs:out");
    line("}");
  } else {
    append_picture(text, 2, "picture", "color3", files.color, true);
  }
  append_picture(text, 2, "orm_picture", "color3", files.orm, false);
  append_channels(text, "orm", 3);
  if (!files.coat.empty()) {
    append_picture(text, 2, "coat_picture", "color4", files.coat, false);
    append_channels(text, "coat", 4);
  }
  if (!files.sheen.empty()) {
    append_picture(text, 2, "sheen_color", "color3", files.sheen, true);
    append_picture(text, 2, "sheen_picture", "color4", files.sheen, false);
    append_channels(text, "sheen", 4);
  }
  append_spot(text, 2);
}

std::string text_of_maps(const std::string& name, double clearness, float opacity, const MapFiles& files) {
  std::string text = "    def Material \"" + name + "\"\n    {\n";
  text += "        token outputs:surface.connect = <surface.outputs:surface>\n";
  text += "        token outputs:mtlx:surface.connect = <light.outputs:out>\n";
  append_preview_of_maps(text, opacity, files);
  if (files.color.empty()) {
    text += "        def Shader \"colors\"\n        {\n";
    text += "            uniform token info:id = \"UsdPrimvarReader_float3\"\n";
    text += "            string inputs:varname = \"displayColor\"\n";
    text += "            float3 outputs:result\n        }\n";
  }
  append_open_pbr_of_maps(text, clearness, opacity, files);
  return text + "    }\n";
}

}  // namespace

std::string Looks::name_for(const std::string& wanted, const MaterialGroup& group, float opacity,
                            const MapFiles& files) {
  const std::string called = group.name.empty() ? wanted : wanted + " " + group.name;
  std::string& name = known_in_maps_[{called, opacity, group.look.clearness}];
  if (!name.empty()) return name;
  name = names_.name_for(called);
  if (files.tell_looks())
    text_ += text_of_maps(name, group.look.clearness, opacity, files);
  else
    on_palette_.push_back({name, group.look.clearness, opacity});
  return name;
}

void Looks::finish(const MapFiles& of_palette) {
  for (const OnPalette& material : on_palette_)
    text_ += text_of_maps(material.name, material.clearness, material.opacity, of_palette);
}

std::string Looks::name_for(const Solid& solid, const MaterialGroup& group) {
  const std::string of = solid.origin.fruit.empty() ? solid.name : solid.origin.fruit;
  const std::string wanted = group.name.empty() ? of : of + " " + group.name;
  std::string& name = known_[{wanted, solid.opacity, group.look}];
  if (name.empty()) {
    name = names_.name_for(wanted);
    text_ += material_text(name, group.look, solid.opacity);
  }
  return name;
}

}  // namespace pomona::usd
