#include "render/export/pov_hairs.h"

#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "render/export/pov_text.h"
#include "render/style/hairs.h"

namespace pomona::pov {

namespace {

constexpr std::size_t most_hairs = 20000;  // about 2 MB of text
constexpr double width = 8e-5;             // metres, at the root
constexpr int hair_steps = 15;             // of sRGB

std::array<int, 3> rounded(const Color& color) {
  std::array<int, 3> steps{};
  for (int k = 0; k < 3; ++k) steps[k] = static_cast<int>(std::lround(srgb_from_linear(color[k]) * hair_steps));
  return steps;
}

std::string texture_text(const std::array<int, 3>& color) {
  std::string text = ",\ntexture{pigment{rgb<";
  for (int k = 0; k < 3; ++k) {
    const double linear = linear_from_srgb(static_cast<double>(color[k]) / hair_steps);
    text += (k > 0 ? "," : "") + number_text(std::round(linear * 10000) / 10000);
  }
  return text + ">}finish{ambient 0.4 diffuse 0.7}}";
}

/// To the side of the hair, along the skin.
glm::dvec3 aside(const Hair& hair) {
  const glm::dvec3 side = glm::cross(glm::dvec3(hair.tip - hair.root), glm::dvec3(hair.normal));
  const double length = glm::length(side);
  return length > 1e-15 ? side / length : glm::dvec3(1, 0, 0);
}

/// Two points at the root, two in the middle, one at the tip.
void append_vertices(std::string& text, const Hair& hair) {
  const glm::dvec3 side = 0.5 * width * aside(hair), root(hair.root), middle(hair.middle), tip(hair.tip);
  for (const glm::dvec3& p : {root - side, root + side, middle - 0.7 * side, middle + 0.7 * side, tip}) {
    text += ",\n";
    append_integers(text, std::llround(p.x * 1e6), std::llround(p.y * 1e6), std::llround(p.z * 1e6));
  }
}

void append_faces(std::string& text, std::int64_t first, int texture) {
  for (const std::array<int, 3>& corner : {std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{2, 3, 4}}) {
    text += ",\n";
    append_integers(text, first + corner[0], first + corner[1], first + corner[2]);
    text += ',';
    append_integer(text, texture);
  }
}

}  // namespace

std::string hairs_text(const Solid& solid, std::size_t index, int unit_exponent) {
  const std::vector<Hair> hairs = hairs_of(solid, most_hairs);
  if (hairs.empty()) return {};
  std::map<std::array<int, 3>, int> texture_of;
  std::string vertices, textures, faces;
  for (std::size_t i = 0; i < hairs.size(); ++i) {
    const std::array<int, 3> color = rounded(hairs[i].color);
    const auto [texture, is_new] = texture_of.try_emplace(color, static_cast<int>(texture_of.size()));
    if (is_new) textures += texture_text(color);
    append_vertices(vertices, hairs[i]);
    append_faces(faces, static_cast<std::int64_t>(5 * i), texture->second);
  }
  std::string text = "\n#declare Fuzz_" + std::to_string(index) + " = mesh2 {\n";
  text += "vertex_vectors{" + std::to_string(5 * hairs.size()) + vertices + "}\n";
  text += "texture_list{" + std::to_string(texture_of.size()) + textures + "}\n";
  text += "face_indices{" + std::to_string(3 * hairs.size()) + faces + "}\n";
  return text + "scale 1e" + std::to_string(-6 - unit_exponent) + "\n}\n";
}

}  // namespace pomona::pov
