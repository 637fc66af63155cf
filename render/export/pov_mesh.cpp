#include "render/export/pov_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "generator/base/number_text.h"
#include "render/export/pov_palette.h"
#include "render/export/pov_text.h"

namespace pomona::pov {
namespace {

/// Steps of sRGB from 0 to 1, unless there would be too many colours: an error of 2 in 255.
constexpr int color_steps = 63;
constexpr int finer = 4;  ///< middles of colours are resolved to this many parts of a step

/// The textures of a mesh, and which one each corner of each triangle has.
struct Textures {
  std::map<FinishedColor, int> number;
  std::vector<glm::ivec3> of_triangle;
};

/// The finish of each part, on skin and on cut faces.
using FinishesOfParts = std::vector<std::array<int, 2>>;

FinishesOfParts finishes_of_parts(const Solid& solid, const Finishes& finishes) {
  FinishesOfParts of_part(std::max<std::size_t>(solid.look->part_names.size(), 1));
  for (std::size_t part = 0; part < of_part.size(); ++part)
    for (const int on_cut : {0, 1})
      of_part[part][on_cut] = finishes.number(solid, static_cast<std::int32_t>(part), on_cut == 1);
  return of_part;
}

/// Each corner's colour in steps, and its finish.
std::vector<FinishedColor> corner_colors(const StyledMesh& mesh, const FinishesOfParts& finishes) {
  // Quantise each vertex once; its curve costs more than the look-up.
  std::vector<FinishedColor> quantised(mesh.color.size());
  for (std::size_t v = 0; v < quantised.size(); ++v) {
    for (int k = 0; k < 3; ++k) {
      const long step = std::lround(srgb_from_linear(mesh.color[v][k]) * color_steps);
      quantised[v][static_cast<std::size_t>(k)] = finer * static_cast<int>(step);
    }
  }
  std::vector<FinishedColor> of_corner;
  of_corner.reserve(3 * mesh.triangle.size());
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      FinishedColor color = quantised[mesh.triangle[t][k]];
      color[3] = finishes.at(mesh.part[mesh.triangle[t][k]])[mesh.cut_face[t] >= 0 ? 1 : 0];
      of_corner.push_back(color);
    }
  }
  return of_corner;
}

Textures textures_of(const StyledMesh& mesh, const FinishesOfParts& finishes, std::size_t max) {
  const std::vector<FinishedColor> of_corner = few_colors(corner_colors(mesh, finishes), max);
  Textures textures;
  textures.of_triangle.resize(mesh.triangle.size());
  for (std::size_t c = 0; c < of_corner.size(); ++c) {
    const int next = static_cast<int>(textures.number.size());
    textures.of_triangle[c / 3][static_cast<int>(c % 3)] =
        textures.number.try_emplace(of_corner[c], next).first->second;
  }
  return textures;
}

void append_texture_list(std::string& text, const Textures& textures, float opacity) {
  std::vector<FinishedColor> in_order(textures.number.size());
  for (const auto& [key, number] : textures.number) in_order[number] = key;
  text += "texture_list{" + std::to_string(in_order.size());
  for (const FinishedColor& key : in_order) {
    text += ",\ntexture{pigment{rgbt<";
    for (int k = 0; k < 3; ++k) {
      // Four digits: a tenth of a step of eight bits, even in the darks.
      const double linear =
          linear_from_srgb(static_cast<double>(key[static_cast<std::size_t>(k)]) / (finer * color_steps));
      text += number_text(std::round(linear * 10000) / 10000) + ",";
    }
    text += number_text(static_cast<double>(1.0f - opacity));
    text += ">}finish{" + Finishes::name(key[3]) + "}}";
  }
  text += "}\n";
}

double largest_coordinate(const StyledMesh& mesh) {
  double largest = 0;
  for (const glm::vec3& p : mesh.position)
    largest = std::max({largest, std::fabs(static_cast<double>(p.x)), std::fabs(static_cast<double>(p.y)),
                        std::fabs(static_cast<double>(p.z))});
  return largest;
}

void append_points(std::string& text, const char* keyword, const std::vector<glm::vec3>& points, double step) {
  text += keyword;
  text += '{';
  text += std::to_string(points.size());
  for (const glm::vec3& p : points) {
    const glm::dvec3 scaled = glm::dvec3(p) / step;
    text += ",\n";
    append_integers(text, std::llround(scaled.x), std::llround(scaled.y), std::llround(scaled.z));
  }
  text += "}\n";
}

void append_faces(std::string& text, const StyledMesh& mesh, const Textures& textures) {
  text += "face_indices{" + std::to_string(mesh.triangle.size());
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    text += ",\n";
    append_integers(text, mesh.triangle[t].x, mesh.triangle[t].y, mesh.triangle[t].z);
    for (int k = 0; k < 3; ++k) {
      text += ',';
      append_integer(text, textures.of_triangle[t][k]);
    }
  }
  text += "}\n";
}

}  // namespace

std::string mesh_text(const StyledMesh& mesh, const Solid& solid, const Finishes& finishes, std::size_t index,
                      int unit_exponent, std::size_t max_textures) {
  const int step_exponent = exponent_for(largest_coordinate(mesh), 5);
  const Textures textures = textures_of(mesh, finishes_of_parts(solid, finishes), max_textures);
  std::string text = "\n// " + commentable(solid.name) + "\n#declare Mesh_" + std::to_string(index) + " = mesh2 {\n";
  append_points(text, "vertex_vectors", mesh.position, power_of_ten(step_exponent));
  append_points(text, "normal_vectors", mesh.normal, 0.001);
  append_texture_list(text, textures, solid.opacity);
  append_faces(text, mesh, textures);
  if (is_translucent(solid)) text += "interior { ior 1.35 }\n";
  return text + "scale 1e" + std::to_string(step_exponent - unit_exponent) + "\n}\n";
}

}  // namespace pomona::pov
