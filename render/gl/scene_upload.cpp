#include "render/gl/scene_upload.h"

#include <algorithm>

#include "generator/base/parallel.h"
#include "render/gl/detail_texels.h"
#include "render/gl/lattice_texels.h"
#include "render/gl/scene_materials.h"
#include "render/style/face_relief.h"
#include "render/style/hairs.h"
#include "render/style/noise.h"
#include "render/style/skin_pits.h"

namespace pomona {

namespace {

/// Bits 0-10 of an id identify the surfaces at an edge, bit 11 marks cut faces.
std::uint16_t tag_of(const Solid& solid, std::size_t triangle) {
  const std::int32_t cut = solid.mesh.cut_face[triangle];
  if (cut >= 0) return static_cast<std::uint16_t>(0x800 | (cut & 0x7ff));
  return static_cast<std::uint16_t>((solid.mesh.surface[triangle] + 1) & 0x7ff);
}

/// The data of all solids, ready for upload.
struct Gathered {
  std::vector<UploadedSolids::Part> parts;
  std::vector<glm::vec3> position, normal, color;
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint16_t> tag;
  std::vector<glm::vec4> noise;
  std::vector<float> material;
  SceneMaterials materials;
  bool translucent = false;
  std::vector<glm::vec4> relief;  // change of the normal, and distance to the part's rim in metres
  bool any_relief = false;
  std::vector<std::vector<glm::vec4>> pit_grids;  // per solid
  std::vector<glm::vec3> hair_position, hair_along, hair_color;
  std::vector<glm::vec4> hair_normal;
};

/// Two lines: from the root to the middle, and on to the tip.
void append(const Hair& hair, Gathered& all) {
  const glm::vec3 points[3] = {hair.root, hair.middle, hair.tip};
  for (const int k : {0, 1, 1, 2}) {
    all.hair_position.push_back(points[k]);
    all.hair_along.push_back(k == 2 ? hair.tip - hair.middle : k == 1 ? hair.tip - hair.root : hair.middle - hair.root);
    all.hair_color.push_back(hair.color);
    all.hair_normal.emplace_back(hair.normal, 0.5f * static_cast<float>(k));
  }
}

/// Data of a solid that only its picture needs.
struct PictureParts {
  std::vector<Hair> hairs;
  std::vector<RimPlace> rims;   // per vertex; empty if no part needs it
  std::vector<glm::vec4> pits;  // a grid of them, or none
};

PictureParts picture_parts_of(const Solid& solid, const Style& style) {
  PictureParts parts;
  if (solid.opacity < 1) return parts;
  parts.hairs = hairs_of(solid);
  if (!style.noise) return parts;
  parts.pits = SkinPits(solid).texels();
  const FaceRelief relief(solid);
  if (!relief.empty()) parts.rims = relief.at_vertices();
  return parts;
}

void append(const Solid& solid, const PictureParts& made, bool with_noise, Gathered& all) {
  const auto& [hairs, rims, pits] = made;
  // The range of the solid in the shared buffers.
  UploadedSolids::Part part;
  part.indices = static_cast<GLsizei>(3 * solid.mesh.triangle.size());
  part.first_index = 3 * all.triangle.size();
  part.first_vertex = static_cast<GLint>(all.position.size());
  part.first_triangle = static_cast<GLint>(all.tag.size());
  part.first_hair_vertex = static_cast<GLint>(all.hair_position.size());
  part.hair_vertices = static_cast<GLsizei>(4 * hairs.size());

  // Appends vertices, triangles and hairs behind those of earlier solids.
  all.position.insert(all.position.end(), solid.mesh.position.begin(), solid.mesh.position.end());
  all.normal.insert(all.normal.end(), solid.mesh.normal.begin(), solid.mesh.normal.end());
  all.color.insert(all.color.end(), solid.mesh.color.begin(), solid.mesh.color.end());
  all.triangle.insert(all.triangle.end(), solid.mesh.triangle.begin(), solid.mesh.triangle.end());
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) all.tag.push_back(tag_of(solid, t));
  const std::vector<float> materials = all.materials.numbers_of(solid);
  all.material.insert(all.material.end(), materials.begin(), materials.end());
  all.translucent = all.translucent || lets_light_in(solid);
  all.relief.resize(all.position.size(), glm::vec4(0, 0, 0, 1));
  for (std::size_t v = 0; v < rims.size(); ++v) {
    all.relief[static_cast<std::size_t>(part.first_vertex) + v] =
        glm::vec4(-rims[v].slope, static_cast<float>(rims[v].rim));
  }
  all.any_relief = all.any_relief || !rims.empty();
  all.pit_grids.push_back(pits);
  for (const Hair& hair : hairs) append(hair, all);

  // The styles of its noise; they stay plain if the picture has none.
  const std::vector<glm::vec4> texels = noise_texels(with_noise ? solid.look->noise : NoiseStyle{});
  all.noise.insert(all.noise.end(), texels.begin(), texels.end());
  all.parts.push_back(part);
}

Gathered gathered_solids(const Scene& scene, const Style& style) {
  std::vector<PictureParts> made(scene.solids.size());
  parallel_for(scene.solids.size(), {}, [&](std::size_t i) { made[i] = picture_parts_of(scene.solids[i], style); });
  Gathered all;
  for (std::size_t i = 0; i < scene.solids.size(); ++i) append(scene.solids[i], made[i], style.noise, all);
  if (!all.any_relief) all.relief.clear();
  return all;
}

/// For each solid the start of its grid, or -1; then the grids (shaders/skin_pits.glsl).
std::vector<glm::vec4> pit_texels(const std::vector<std::vector<glm::vec4>>& grids) {
  std::vector<glm::vec4> texels(grids.size() + 1, glm::vec4(-1));
  for (std::size_t i = 0; i < grids.size(); ++i) {
    if (grids[i].empty()) continue;
    texels[i].x = static_cast<float>(texels.size());
    texels.insert(texels.end(), grids[i].begin(), grids[i].end());
  }
  return texels;
}

std::optional<UploadedSolids::Guides> uploaded_guides(const CurrentGl& gl, const Scene& scene, const Style& style) {
  const auto guided = [](const Solid& solid) { return !solid.mesh.guide.empty(); };
  if (!style.noise || std::none_of(scene.solids.begin(), scene.solids.end(), guided)) return {};
  std::vector<glm::vec4> share;
  std::vector<Look> looks;  // each like the one before, because pieces of one fruit have the same patterns
  for (const Solid& solid : scene.solids) {
    for (std::size_t v = 0; v < solid.mesh.position.size(); ++v)
      share.push_back(solid.mesh.guide.empty() ? glm::vec4(0) : solid.mesh.guide[v].share);
    looks.emplace_back(NoiseStyle{}, solid.look->details, looks.empty() ? nullptr : &looks.back());
  }
  const DetailTexels details = detail_texels(looks);
  return UploadedSolids::Guides{.share = GlBuffer(gl, GL_ARRAY_BUFFER, share),
                                .styles = GlTable(gl, GL_RGBA32F, all_texels(details), "details"),
                                .lattices = GlTable(gl, GL_RGBA32F, lattice_texels(scene.solids), "guides"),
                                .any_example = !details.tiles.empty()};
}

}  // namespace

std::vector<glm::vec4> noise_texels(const NoiseStyle& style) {
  const Modulation modulation(style);
  std::vector<glm::vec4> texels(2 + 4 * max_noise_keys, glm::vec4(0));
  texels[0] = {style.base_frequency, style.sigma, modulation.keys().size(), modulation.bands()};
  texels[1] = glm::vec4(style.stretch, style.pattern);
  for (std::size_t k = 0; k < modulation.keys().size(); ++k) {
    const Modulation::Key& key = modulation.keys()[k];
    const auto& w = key.weights;
    texels[2 + 4 * k] = glm::vec4(key.lab, 0);
    texels[3 + 4 * k] = glm::vec4(key.axis, 0);
    texels[4 + 4 * k] = {w[0], w[1], w[2], w[3]};
    texels[5 + 4 * k] = {w[4], w[5], w[6], w[7]};
  }
  return texels;
}

UploadedSolids uploaded(const CurrentGl& gl, const Scene& scene, const Style& style) {
  const Gathered all = gathered_solids(scene, style);
  UploadedSolids solids{
      .parts = all.parts,
      .position = GlBuffer(gl, GL_ARRAY_BUFFER, all.position),
      .normal = GlBuffer(gl, GL_ARRAY_BUFFER, all.normal),
      .color = GlBuffer(gl, GL_ARRAY_BUFFER, all.color),
      .material = GlBuffer(gl, GL_ARRAY_BUFFER, all.material),
      .relief = GlBuffer(gl, GL_ARRAY_BUFFER, all.relief),
      .index = GlBuffer(gl, GL_ARRAY_BUFFER, all.triangle),
      .hair_position = GlBuffer(gl, GL_ARRAY_BUFFER, all.hair_position),
      .hair_along = GlBuffer(gl, GL_ARRAY_BUFFER, all.hair_along),
      .hair_color = GlBuffer(gl, GL_ARRAY_BUFFER, all.hair_color),
      .hair_normal = GlBuffer(gl, GL_ARRAY_BUFFER, all.hair_normal),
      .triangle_tags = GlTable(gl, GL_R16UI, all.tag, "triangles in different solids"),
      .noise_styles = GlTable(gl, GL_RGBA32F, all.noise, "noise"),
      .materials = GlTable(gl, GL_RGBA32F, all.materials.texels(), "materials"),
      .pits = GlTable(gl, GL_RGBA32F, pit_texels(all.pit_grids), "pits"),
      .translucent = all.translucent,
      .solids = GlVertexArray(gl),
      .hairs = GlVertexArray(gl),
      .guides = uploaded_guides(gl, scene, style),
  };

  // Attaches vertex attributes at the indices that shaders use.
  solids.solids.attach(0, 3, solids.position);
  solids.solids.attach(1, 3, solids.normal);
  solids.solids.attach(2, 3, solids.color);
  solids.solids.attach(3, 1, solids.material);
  if (all.any_relief) solids.solids.attach(4, 4, solids.relief);  // else it is (0, 0, 0, 1): level, and far from rims
  if (solids.guides) solids.solids.attach(5, 4, solids.guides->share);
  gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, solids.index.id());
  solids.hairs.attach(0, 3, solids.hair_position);
  solids.hairs.attach(1, 3, solids.hair_along);
  solids.hairs.attach(2, 3, solids.hair_color);
  solids.hairs.attach(3, 4, solids.hair_normal);
  gl.check("handing over the solids");
  return solids;
}

}  // namespace pomona
