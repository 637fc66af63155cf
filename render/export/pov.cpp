#include "render/export/pov.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/base/reproducible.h"
#include "render/export/view_frame.h"

namespace pomona {
namespace {

// ---- Text ------------------------------------------------------------------------------------------------------

/// The shortest decimals that read back as the same number; no locale has a say.
template <typename Number>
void append_number(std::string& text, Number number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

std::string number_text(double number) {
  std::string text;
  append_number(text, number);
  return text;
}

std::string vector_text(const glm::dvec3& v) {
  return "<" + number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + ">";
}

void append_integers(std::string& text, std::int64_t x, std::int64_t y, std::int64_t z) {
  text += '<';
  append_number(text, x);
  text += ',';
  append_number(text, y);
  text += ',';
  append_number(text, z);
  text += '>';
}

/// 10^exponent, correctly rounded.
double power_of_ten(int exponent) {
  const std::string text = "1e" + std::to_string(exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The exponent that brings `size` into [10^digits, 10^(digits + 1)) when divided by its power of ten.
int exponent_for(double size, int digits) {
  int exponent = -60;
  while (exponent < 60 && size / power_of_ten(exponent) >= power_of_ten(digits + 1)) ++exponent;
  return exponent;
}

/// What may stand in a comment that ends with the line.
std::string commentable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

/// What may stand between double quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

// ---- Meshes ----------------------------------------------------------------------------------------------------

/// A colour as a mesh's texture has it: sRGB in steps, on skin or on a cut face.
using TextureKey = std::array<int, 4>;

/// POV-Ray has no colours at vertices but textures, about 1.4 KB each; so many a mesh may have.
constexpr std::size_t most_textures = 4096;

/// The textures of a mesh, and which one each corner of each triangle has.
struct Textures {
  int steps = 0;  ///< of sRGB from 0 to 1
  std::map<TextureKey, int> number;
  std::vector<glm::ivec3> of_triangle;
};

Textures textures_in_steps(const StyledMesh& mesh, int steps) {
  // Quantise each vertex once; its curve costs more than the look-up.
  std::vector<glm::ivec3> quantised(mesh.color.size());
  for (std::size_t v = 0; v < quantised.size(); ++v)
    for (int k = 0; k < 3; ++k)
      quantised[v][k] = static_cast<int>(std::lround(srgb_from_linear(mesh.color[v][k]) * steps));

  Textures textures;
  textures.steps = steps;
  textures.of_triangle.resize(mesh.triangle.size());
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const glm::ivec3& c = quantised[mesh.triangle[t][k]];
      const TextureKey key{c.r, c.g, c.b, mesh.cut_face[t] >= 0 ? 1 : 0};
      textures.of_triangle[t][k] =
          textures.number.try_emplace(key, static_cast<int>(textures.number.size())).first->second;
    }
  }
  return textures;
}

/// Colours in 63 steps a channel (an error of 2 in 255), or coarser where that makes too many.
Textures textures_of(const StyledMesh& mesh) {
  for (int steps = 63; steps > 7; steps = steps / 2) {
    Textures textures = textures_in_steps(mesh, steps);
    if (textures.number.size() <= most_textures) return textures;
  }
  return textures_in_steps(mesh, 7);
}

void append_texture_list(std::string& text, const Textures& textures, float opacity) {
  std::vector<TextureKey> in_order(textures.number.size());
  for (const auto& [key, number] : textures.number) in_order[number] = key;
  text += "texture_list{" + std::to_string(in_order.size());
  for (const TextureKey& key : in_order) {
    text += ",\ntexture{pigment{rgbt<";
    for (int k = 0; k < 3; ++k) {
      // Four digits: a tenth of a step of eight bits, even in the darks.
      const double linear = linear_from_srgb(static_cast<double>(key[k]) / textures.steps);
      append_number(text, std::round(linear * 10000) / 10000);
      text += ',';
    }
    append_number(text, static_cast<double>(1.0f - opacity));
    text += key[3] == 1 ? ">}finish{Flesh}}" : ">}finish{Skin}}";
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
      append_number(text, textures.of_triangle[t][k]);
    }
  }
  text += "}\n";
}

/// Whole numbers parse fastest and are shortest: positions as multiples of a millionth of the mesh's size or
/// less, normals as thousandths. Equal positions stay equal, so the mesh stays closed.
std::string mesh_text(const StyledMesh& mesh, const Solid& solid, std::size_t index, int unit_exponent) {
  const int step_exponent = exponent_for(largest_coordinate(mesh), 5);
  const Textures textures = textures_of(mesh);
  std::string text = "\n// " + commentable(solid.name) + "\n#declare Mesh_" + std::to_string(index) + " = mesh2 {\n";
  append_points(text, "vertex_vectors", mesh.position, power_of_ten(step_exponent));
  append_points(text, "normal_vectors", mesh.normal, 0.001);
  append_texture_list(text, textures, solid.opacity);
  append_faces(text, mesh, textures);
  return text + "scale 1e" + std::to_string(step_exponent - unit_exponent) + "\n}\n";
}

// ---- The scene around them -------------------------------------------------------------------------------------

/// POV-Ray ignores what is nearer than 0.001 to where a ray starts, so a salad in metres would lose its
/// shadows. The unit is a power of ten of a metre that makes the view some hundred units deep: a centimetre.
int unit_exponent_for(const ViewFrame& frame) { return exponent_for(frame.distance, 1); }

std::string camera_text(const View& view, const ViewFrame& frame, double unit) {
  const double half = view.vertical_field / 2;
  const double height = 2 * reproducible::sin(half) / reproducible::cos(half);
  std::string text = "camera {\n  perspective\n  location " + vector_text(view.eye / unit) + "\n";
  text += "  direction z\n  up y * " + number_text(height) + "\n";
  text += "  right -x * " + number_text(height) + " * image_width / image_height // minus: right-handed\n";
  return text + "  sky " + vector_text(frame.up) + "\n  look_at " + vector_text(view.target / unit) + "\n}\n";
}

/// A wide light from the upper left, and a weak one from the right that throws no shadow. With the finishes'
/// ambient share, white paper lying flat comes out as white.
std::string lights_text(const View& view, const ViewFrame& frame, double unit) {
  const double d = frame.distance / unit;
  const glm::dvec3 target = view.target / unit;
  const glm::dvec3 forth = glm::normalize(glm::dvec3(frame.back.x, 1e-9, frame.back.z));
  const glm::dvec3 key = target + d * (-1.8 * frame.right + glm::dvec3(0, 3.4, 0) + 1.4 * forth);
  const glm::dvec3 fill = target + d * (2.8 * frame.right + glm::dvec3(0, 2.0, 0) + 2.0 * forth);
  std::string text = "light_source {\n  " + vector_text(key) + ", rgb 0.8\n";
  text += "  area_light x * " + number_text(d) + ", z * " + number_text(d) + ", 7, 7 adaptive 1\n}\n";
  return text + "light_source { " + vector_text(fill) + ", rgb 0.25 shadowless }\n";
}

/// POV-Ray looks for includes where it was started, not where the scene lies.
std::string include_text(const std::string& name) {
  const std::string beside = quoted(name), in_out = quoted("out/" + name);
  return "#if (file_exists(" + beside + "))\n  #include " + beside + "\n#else #if (file_exists(" + in_out +
         "))\n  #include " + in_out +
         "\n#else\n  #error \"start POV-Ray in the folder of this file, or name that folder with +L\"\n#end #end\n";
}

std::string placed_text(const Instance& instance, double unit) {
  const glm::dmat3 m = glm::mat3_cast(glm::normalize(instance.pose.rotation));
  const glm::dvec3 t = instance.pose.translation / unit;
  std::string text = "object { Mesh_" + std::to_string(instance.solid) + " matrix <";
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) text += number_text(m[column][row]) + ", ";
  return text + number_text(t.x) + ", " + number_text(t.y) + ", " + number_text(t.z) + "> } // " +
         commentable(instance.name) + "\n";
}

std::string scene_text(const Scene& scene, const std::string& include, const ExportOptions& options) {
  const ViewFrame frame = view_frame(scene.view);
  const int exponent = unit_exponent_for(frame);
  const double unit = power_of_ten(exponent);
  std::string text = "// Made by Pomona. " + commentable(options.provenance) + "\n#version 3.7;\n";
  text += "// Right-handed, +Y up; a unit is 1e" + std::to_string(exponent) + " metres. Colours are linear.\n";
  text += "global_settings { assumed_gamma 1.0 }\n";
  text += "#declare Paper = rgb " + vector_text(glm::dvec3(scene.paper)) + ";\nbackground { Paper }\n\n";
  text += camera_text(scene.view, frame, unit) + lights_text(scene.view, frame, unit);
  text += "\n#declare Skin = finish { ambient 0.38 diffuse 0.75 specular 0.22 roughness 0.02 }\n";
  text += "#declare Flesh = finish { ambient 0.42 diffuse 0.72 specular 0.06 roughness 0.05 }\n";
  text += "#declare Ground = finish { ambient 0.32 diffuse 0.75 }\n\n";
  if (scene.ground) text += "plane { y, 0 texture { pigment { Paper } finish { Ground } } }\n\n";
  return text + include_text(include) + "\n";
}

}  // namespace

std::vector<NamedFile> write_pov(const Scene& scene, const std::string& stem, const ExportOptions& options) {
  const std::vector<StyledMesh> styled = styled_meshes(scene, options);
  const int exponent = unit_exponent_for(view_frame(scene.view));

  // Write the meshes, each by itself, and join them in order.
  std::vector<std::string> texts(styled.size());
  parallel_for(texts.size(), options.threads, [&](std::size_t i) {
    if (!styled[i].triangle.empty()) texts[i] = mesh_text(styled[i], scene.solids[i], i, exponent);
  });
  std::string meshes = "// Meshes of " + commentable(stem) + ".pov, made by Pomona.\n";
  for (const std::string& text : texts) meshes += text;

  // Place them.
  const std::string include = stem + "_meshes.inc";
  std::string main = scene_text(scene, include, options);
  for (const Instance& instance : scene.instances)
    if (!styled.at(instance.solid).triangle.empty()) main += placed_text(instance, power_of_ten(exponent));
  return {{stem + ".pov", std::move(main)}, {include, std::move(meshes)}};
}

}  // namespace pomona
