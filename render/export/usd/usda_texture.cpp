#include "render/export/usd/usda_texture.h"

#include "render/export/usd/usda_text.h"

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

}  // namespace pomona::usd
