#include "render/export/usd/usda_material.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/export/physics_surface.h"

namespace pomona::usd {

namespace {

/// How MaterialX reads a picture of colours.
const std::string srgb = " (colorSpace = \"srgb_texture\")";

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
  line("    def Shader \"texture\"");
  line("    {");
  line("        uniform token info:id = \"UsdUVTexture\"");
  if (!file.empty()) line("        asset inputs:file = " + asset(file));
  line("        token inputs:sourceColorSpace = \"sRGB\"");
  line("        token inputs:wrapS = \"clamp\"");
  line("        token inputs:wrapT = \"clamp\"");
  line("        float2 inputs:st.connect = <../places.outputs:result>");
  line("        float3 outputs:rgb");
  line("    }");
  line("    over \"light\"");
  line("    {");
  line("        color3f inputs:base_color.connect = <../picture.outputs:out>");
  line("        color3f inputs:subsurface_color.connect = <../picture.outputs:out>");
  line("    }");
  line("    def Shader \"picture\"");
  line("    {");
  line("        uniform token info:id = \"ND_image_color3\"");
  if (!file.empty()) line("        asset inputs:file = " + asset(file) + srgb);
  line("        string inputs:uaddressmode = \"clamp\"");
  line("        string inputs:vaddressmode = \"clamp\"");
  line("        float2 inputs:texcoord.connect = <../spot.outputs:out>");
  line("        color3f outputs:out");
  line("    }");
  line("    def Shader \"spot\"");
  line("    {");
  line("        uniform token info:id = \"ND_geompropvalue_vector2\"");
  line("        string inputs:geomprop = \"st\"");
  line("        float2 outputs:out");
  line("    }");
  line("    def Shader \"places\"");
  line("    {");
  line("        uniform token info:id = \"UsdPrimvarReader_float2\"");
  line("        string inputs:varname = \"st\"");
  line("        float2 outputs:result");
  line("    }");
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

}  // namespace

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
