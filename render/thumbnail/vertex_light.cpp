#include "render/thumbnail/vertex_light.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "render/picture/light_direction.h"

namespace pomona {

namespace {

// The light of pictures that OpenGL draws (shaders/lit.glsl).
const Color sun(0.74f, 0.70f, 0.62f);
const Color sky(0.47f, 0.50f, 0.54f);
const Color bounce(0.40f, 0.36f, 0.31f);
constexpr double highlight = 0.20;  ///< of a skin of gloss 1

/// Sunlight on a face, soft and wrapped; flatter on cut faces, so that their colours are what one sees.
double key_light(double cosine, bool cut) {
  const double key = std::clamp((cosine + 0.35) / 1.35, 0.0, 1.0);
  return cut ? 0.55 * key + 0.45 * 0.8 : key;
}

/// x to the 32nd.
double to_32nd(double x) {
  for (int k = 0; k < 5; ++k) x *= x;
  return x;
}

}  // namespace

std::vector<Color> lit_colors(const StyledMesh& mesh, const Solid& solid, const Pose& pose, const ViewFrame& frame,
                              const LightStyle& light) {
  const glm::dvec3 to_light = light_direction(frame, light.azimuth, light.elevation);
  const glm::dvec3 between = glm::normalize(to_light + frame.back);
  std::vector<double> gloss;
  for (std::size_t part = 0; part < solid.part_names.size(); ++part)
    gloss.push_back(std::min(material_of(solid, static_cast<std::int32_t>(part)).gloss, 2.0));

  std::vector<Color> lit(mesh.color.size());
  for (std::size_t v = 0; v < lit.size(); ++v) {
    // The sky above, what the table throws back from below, and the sun.
    const glm::dvec3 normal = pose.rotation * glm::dvec3(mesh.normal[v]);
    const bool cut = mesh.face[v] == DetailFace::cut;
    const auto up = static_cast<float>(0.5 + 0.5 * normal.y);
    const Color around = static_cast<float>(light.ambient) * (bounce * (1 - up) + sky * up);
    const double key = light.strength * key_light(glm::dot(normal, to_light), cut);
    lit[v] = mesh.color[v] * (around + static_cast<float>(key) * sun);

    // What shines is skin.
    if (cut) continue;
    const auto part = static_cast<std::size_t>(std::max(mesh.part[v], 0));
    const double shine = part < gloss.size() ? gloss[part] : 1;
    const double mirrored = to_32nd(std::max(0.0, glm::dot(normal, between)));
    lit[v] += Color(static_cast<float>(light.strength * highlight * shine * mirrored));
  }
  return lit;
}

}  // namespace pomona
