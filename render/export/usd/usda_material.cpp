#include "render/export/usd/usda_material.h"

#include <cmath>

namespace pomona::usd {

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
      line("            }");
    }
    line("        }");
    line("    }");
  }
  line("}");
}

namespace {

/// The indentation is that of a prim within the scope of looks.
std::string material_text(const std::string& name, const PbrMaterial& look, float opacity) {
  std::string text = "    def Material \"" + name + "\"\n    {\n";
  text += "        token outputs:surface.connect = <surface.outputs:surface>\n\n";
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
  text += "            float3 outputs:result\n        }\n    }\n";
  return text;
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
