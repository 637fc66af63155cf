// Materials as glTF can say them.
#pragma once

#include <array>
#include <compare>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/export/styled_mesh.h"

namespace pomona {

/// The factors of a glTF material and of its extensions. The defaults are those of parts of which nothing is said:
/// dull like flesh, without extensions.
struct PbrLook {
  double roughness = 0.6;
  double specular = 1;                            ///< KHR_materials_specular
  double clearcoat = 0, clearcoat_roughness = 0;  ///< KHR_materials_clearcoat
  std::array<double, 3> sheen{};                  ///< KHR_materials_sheen: colour, linear
  double sheen_roughness = 0;
  double transmission = 0;  ///< KHR_materials_diffuse_transmission
  std::array<double, 3> transmission_color{1, 1, 1};

  auto operator<=>(const PbrLook&) const = default;
};

/// Smooth and wet parts have a clear coat, hairs and bloom are a sheen, translucent parts let diffuse light through.
PbrLook look_of(const MaterialSketch& material, bool on_cut_face);

/// A mesh's triangles by the look they have, in the order in which the looks first come. One group, where the solid's
/// template says nothing of materials.
struct LookGroup {
  PbrLook look;
  std::string name;                  ///< what looks so: "skin", "gel", "inside"; empty where all looks alike
  std::vector<std::int32_t> face;    ///< numbers of its triangles in the mesh, ascending
  std::vector<glm::uvec3> triangle;  ///< these
};
std::vector<LookGroup> groups_by_look(const Solid& solid, const StyledMesh& mesh);

}  // namespace pomona
