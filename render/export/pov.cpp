#include "render/export/pov.h"

#include <algorithm>

#include <glm/gtc/quaternion.hpp>

#include "generator/base/reproducible.h"
#include "render/export/pov_finish.h"
#include "render/export/pov_hairs.h"
#include "render/export/pov_light.h"
#include "render/export/pov_mesh.h"
#include "render/export/pov_text.h"
#include "render/picture/view_frame.h"

namespace pomona {

using namespace pov;

namespace {

/// POV-Ray copies a mesh's textures with every instance, about 1 KB each; so many copies take some 2 GB.
constexpr std::size_t most_texture_copies = 2'000'000;
/// Of any mesh, however few instances there are.
constexpr std::size_t most_textures = 4096;

/// So many textures a mesh may have that all copies stay in bounds: in a heap of thousands colours are fewer.
std::size_t textures_of_a_mesh(const Scene& scene) {
  const std::size_t copies = scene.solids.size() + scene.instances.size();
  return std::clamp(most_texture_copies / std::max<std::size_t>(copies, 1), std::size_t{64}, most_textures);
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

/// POV-Ray looks for includes where it was started, not where the scene lies.
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

/// Subsurface light is dear: it takes hundreds of times as long. So it is asked for, with Declare=Subsurface=1.
std::string settings_text(const Scene& scene, const Lighting& lighting, double unit) {
  // Each surface that one sees through takes a step of a ray; POV-Ray allows five unless told.
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

  // Write the meshes, each by itself, and join them in order.
  std::vector<std::string> texts(styled.size()), hairs(styled.size());
  parallel_for(texts.size(), options.threads, [&](std::size_t i) {
    hairs[i] = hairs_text(scene.solids[i], i, exponent);
    if (!styled[i].triangle.empty()) texts[i] = mesh_text(styled[i], scene.solids[i], finishes, i, exponent, textures);
  });
  std::string meshes = "// Meshes of " + commentable(stem) + ".pov, made by Pomona.\n";
  for (std::size_t i = 0; i < texts.size(); ++i) meshes += texts[i] + hairs[i];
  if (!ink.strokes.empty()) meshes += ink_text(scene, ink, exponent);

  // Place them.
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
