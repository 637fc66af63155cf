#include "render/export/pov.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/base/number_text.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/piece/solid.h"
#include "generator/scene/scene.h"
#include "render/export/pov_finish.h"
#include "render/export/pov_mesh.h"
#include "render/export/pov_text.h"
#include "render/picture/light_direction.h"
#include "render/picture/view_frame.h"
#include "render/style/hairs.h"
#include "render/style/style.h"

namespace pomona {

using namespace pov;

namespace {

constexpr std::size_t max_hairs = 20000;  // about 2 MB of text
constexpr double width = 8e-5;            // width of a hair at the root, metres
constexpr int hair_steps = 15;            // steps of the hairs' sRGB colours

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

/// A direction to the side of the hair, along the skin.
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

/// "#declare Fuzz_<index> = mesh2 { ... }" in units of 10^unit_exponent metres; empty for a solid without fuzz.
std::string hairs_text(const Solid& solid, std::size_t index, int unit_exponent) {
  const std::vector<Hair> hairs = hairs_of(solid, max_hairs);
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

/// The light of a scene as a style has it, in units of `unit` metres.
class Lighting {
 public:
  Lighting(const View& view, const Style& style, double unit);

  /// Light sources: the style's key light, whose width gives the softness of shadows; a part of it without shadows, if
  /// the style weakens these; and a weak fill light from the other side without shadows.
  std::string sources() const;

  /// The ambient light, for global_settings.
  std::string ambient() const;

  /// Texture of the ground: the paper's colour where it is lit, with the style's wash in full shadow.
  std::string ground() const;

 private:
  glm::dvec3 target_, to_key_, to_fill_;
  double distance_;
  glm::dvec3 key_, fill_;  // colours
  double width_;           // width of the key light, 0 = a point
  double shadow_;          // share of the key light that casts shadows
  glm::dvec3 wash_;        // colour of the shadow's wash
  double from_all_sides_;
};

/// Warm light and cool sky, as in shaders/lit.glsl; together they are white. With the finishes' shares a white object
/// that faces the light is white.
const glm::dvec3 sun = 0.8 / 0.70 * glm::dvec3(0.74, 0.70, 0.62);
const glm::dvec3 sky = 1 / 0.50 * glm::dvec3(0.47, 0.50, 0.54);

/// The distance of light sources, times the eye's distance: far enough for nearly one direction everywhere.
constexpr double far_off = 16;
/// A source's width per unit of distance and of softness.
constexpr double width_of_softness = 0.7;
constexpr double fill_elevation = 30;  // degrees

std::string four_digits(const glm::dvec3& v) { return vector_text(glm::round(v * 1e4) / 1e4); }

std::string rgb(const glm::dvec3& color) { return "rgb " + four_digits(color); }

std::string source(const glm::dvec3& place, const glm::dvec3& color, const std::string& more) {
  return "light_source {\n  " + vector_text(place) + ", " + rgb(color) + more + "\n}\n";
}

Lighting::Lighting(const View& view, const Style& style, double unit)
    : target_(view.target / unit),
      to_key_(light_direction(view, style.light)),
      to_fill_(light_direction(view_frame(view), -style.light.azimuth, radians(fill_elevation))),
      distance_(far_off * view_frame(view).distance / unit),
      key_(style.light.strength * sun),
      fill_(0.25 * style.light.ambient),
      width_(width_of_softness * style.light.softness * distance_),
      shadow_(style.shadow.strength),
      wash_(glm::mix(glm::dvec3(1), glm::dvec3(style.shadow.color), style.shadow.strength)),
      from_all_sides_(style.light.ambient) {}

std::string Lighting::sources() const {
  const glm::dvec3 key = target_ + distance_ * to_key_;
  const std::string side = number_text(std::round(1000 * width_) / 1000);
  const std::string wide = "\n  area_light x * " + side + ", z * " + side + ", 7, 7 adaptive 1 circular orient";
  std::string text;
  if (shadow_ > 0) text += source(key, shadow_ * key_, width_ > 0 ? wide : "");
  if (shadow_ < 1) text += source(key, (1 - shadow_) * key_, " shadowless");
  return text + source(target_ + distance_ * to_fill_, fill_, " shadowless");
}

std::string Lighting::ambient() const { return "ambient_light " + rgb(from_all_sides_ * sky); }

std::string Lighting::ground() const {
  // Per channel: pigment p, diffuse share d, emission e, with k and f the light from key and fill. Lit ground is paper,
  // p (d (k + f) + e) = paper; shadow leaves the wash, p d k shadow = paper (1 - wash).
  const glm::dvec3 k = to_key_.y * key_, f = to_fill_.y * fill_;
  const double max = std::max({k.r, k.g, k.b});
  const bool dark = !(shadow_ * max > 1e-3);
  const double d = dark ? 0 : 1 / max;
  glm::dvec3 pigment(1), emission(1);  // times the paper
  for (int c = 0; !dark && c < 3; ++c) {
    pigment[c] = std::max(1 - wash_[c], 0.02) / (d * k[c] * shadow_);
    emission[c] = 1 / pigment[c] - d * (k[c] + f[c]);
    // The wash cannot be darker than the ground in the fill light.
    if (emission[c] < 0) pigment[c] = 1 / (d * (k[c] + f[c])), emission[c] = 0;
  }
  return "texture { pigment { color Paper * " + four_digits(pigment) + " } finish { ambient 0 diffuse " +
         number_text(std::round(d * 1e4) / 1e4) + " emission " + rgb(emission) + " } }";
}

/// POV-Ray copies a mesh's textures with every instance, about 1 KB each; this number of copies takes some 2 GB.
constexpr std::size_t max_texture_copies = 2'000'000;
/// The limit for any mesh, however few instances there are.
constexpr std::size_t max_textures = 4096;

/// The number of textures of a mesh that keeps all copies in bounds: fewer in a heap of thousands.
std::size_t textures_of_a_mesh(const Scene& scene) {
  const std::size_t copies = scene.solids.size() + scene.instances.size();
  return std::clamp(max_texture_copies / std::max<std::size_t>(copies, 1), std::size_t{64}, max_textures);
}

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

/// The name of the file that holds the meshes. POV-Ray 3.7 reads other letters than those of ASCII as blanks, and a
/// backslash as the beginning of a folder: such bytes are spelt out, "p_c3_aache_meshes.inc" beside "pêche.pov".
std::string include_name(const std::string& stem) {
  std::string name;
  for (const char c : stem) {
    if (c >= ' ' && c <= '~' && c != '\\') {
      name += c;
    } else {
      constexpr const char* digits = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      name += {'_', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return name + "_meshes.inc";
}

/// POV-Ray looks for includes in the folder where it was started, not beside the scene.
std::string include_text(const std::string& name) {
  const std::string beside = quoted(name), in_out = quoted("out/" + name);
  return "#if (file_exists(" + beside + "))\n  #include " + beside + "\n#else #if (file_exists(" + in_out +
         "))\n  #include " + in_out +
         "\n#else\n  #error \"start POV-Ray in the folder of this file, or name that folder with +L\"\n#end #end\n";
}

std::string placed_text(const char* what, const Instance& instance, double unit) {
  const glm::dmat3 m = glm::mat3_cast(glm::normalize(instance.pose.rotation));
  const glm::dvec3 t = instance.pose.translation / unit;
  std::string text = std::string("object { ") + what + std::to_string(instance.solid) + " matrix <";
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) text += number_text(m[column][row]) + ", ";
  return text + number_text(t.x) + ", " + number_text(t.y) + ", " + number_text(t.z) + "> } // " +
         commentable(instance.name) + "\n";
}

/// Subsurface light takes hundreds of times as long, so it is optional: Declare=Subsurface=1.
std::string settings_text(const Scene& scene, const Lighting& lighting, double unit) {
  // Each transparent surface takes a step of a ray; POV-Ray allows five by default.
  const bool see_through =
      std::any_of(scene.solids.begin(), scene.solids.end(), [](const Solid& solid) { return solid.opacity < 1; });
  std::string text;
  if (std::any_of(scene.solids.begin(), scene.solids.end(), is_translucent)) {
    text += "// 1: light goes into flesh, for pictures that may take minutes (povray +A Declare=Subsurface=1 ...).\n";
    text += "#ifndef (Subsurface) #declare Subsurface = 0; #end\n#if (Subsurface)\n  global_settings { mm_per_unit " +
            number_text(std::round(1e6 * unit) / 1e3) + " subsurface { samples 16, 8 } }\n#end\n";
  }
  return text + "global_settings { assumed_gamma 1.0 " + lighting.ambient() +
         (see_through ? " max_trace_level 100" : "") + " }\n";
}

std::string scene_text(const Scene& scene, const Finishes& finishes, const std::string& include,
                       const ExportOptions& options) {
  const ViewFrame frame = view_frame(scene.view);
  const int exponent = unit_exponent_for(frame);
  const double unit = power_of_ten(exponent);
  std::string text = "// Made by Pomona. " + commentable(options.provenance) + "\n#version 3.7;\n";
  text += "// Right-handed, +Y up; a unit is 1e" + std::to_string(exponent) + " metres. Colours are linear.\n";
  const Lighting lighting(scene.view, options.style, unit);
  text += settings_text(scene, lighting, unit) + "#declare Paper = rgb " + vector_text(glm::dvec3(scene.paper)) +
          ";\nbackground { Paper }\n\n";
  text += camera_text(scene.view, frame, unit) + lighting.sources();
  text += "\n" + finishes.declarations() + "#declare Ground = " + lighting.ground() + "\n\n";
  if (scene.ground) text += "plane { y, 0 texture { Ground } }\n\n";
  return text + include_text(include) + "\n";
}

}  // namespace

std::vector<NamedFile> write_pov(const Scene& scene, const std::string& stem, const ExportOptions& options,
                                 const SceneInk& ink) {
  const std::vector<StyledMesh> styled = styled_meshes(scene, options);
  const int exponent = unit_exponent_for(view_frame(scene.view));

  const Finishes finishes(scene, options.style.gloss);
  const std::size_t textures = textures_of_a_mesh(scene);

  // Writes the meshes, each by itself, and joins them in order.
  std::vector<std::string> texts(styled.size()), hairs(styled.size());
  parallel_for(texts.size(), options.threads, [&](std::size_t i) {
    hairs[i] = hairs_text(scene.solids[i], i, exponent);
    if (!styled[i].triangle.empty()) texts[i] = mesh_text(styled[i], scene.solids[i], finishes, i, exponent, textures);
  });
  std::string meshes = "// Meshes of " + commentable(stem) + ".pov, made by Pomona.\n";
  for (std::size_t i = 0; i < texts.size(); ++i) meshes += texts[i] + hairs[i];
  if (!ink.strokes.empty()) meshes += ink_text(scene, ink, exponent);

  // Places them.
  const std::string include = include_name(stem);
  std::string main = scene_text(scene, finishes, include, options);
  const double unit = power_of_ten(exponent);
  for (const Instance& instance : scene.instances) {
    if (!styled.at(instance.solid).triangle.empty()) main += placed_text("Mesh_", instance, unit);
    if (!hairs.at(instance.solid).empty()) main += placed_text("Fuzz_", instance, unit);
  }
  if (!ink.strokes.empty())
    main += "\n// Right for this camera alone: leave it out when you move it.\nobject { Ink }\n";
  return {{stem + ".pov", std::move(main)}, {include, std::move(meshes)}};
}

}  // namespace pomona
