#include "render/export/usd/usda_material.h"

#include <cmath>

namespace pomona::usd {

namespace {

/// The indentation is that of a prim within the scope of looks.
std::string material_text(const std::string& name, const PbrLook& look, float opacity) {
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

std::string Looks::name_for(const Solid& solid, const LookGroup& group) {
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
