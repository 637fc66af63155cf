#include "render/gl/scene_upload.h"

#include <algorithm>
#include <array>

#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "render/picture/inner_lines.h"
#include "render/style/noise.h"

namespace pomona {

namespace {

/// Offsets into a uniform buffer must be multiples of at most this, whatever the context.
constexpr GLsizeiptr block_stride = (noise_block_size + 255) / 256 * 256;

/// Bits 0-10 of an id tell what meets at an edge, bit 11 cut faces.
std::uint16_t tag_of(const Solid& solid, std::size_t triangle) {
  const std::int32_t cut = solid.cut_face[triangle];
  if (cut >= 0) return static_cast<std::uint16_t>(0x800 | (cut & 0x7ff));
  return static_cast<std::uint16_t>((solid.surface[triangle] + 1) & 0x7ff);
}

/// Everything in one piece, ready to be handed over.
struct Gathered {
  std::vector<UploadedSolids::Part> parts;
  std::vector<glm::vec3> position, normal, color, line_position;
  std::vector<float> line_strength;
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint16_t> tag;
  std::vector<float> noise;
};

void append(const Solid& solid, const std::vector<InnerLine>& lines, bool with_noise, Gathered& all) {
  UploadedSolids::Part part;
  part.indices = static_cast<GLsizei>(3 * solid.triangle.size());
  part.first_index = 3 * all.triangle.size();
  part.first_vertex = static_cast<GLint>(all.position.size());
  part.first_triangle = static_cast<GLint>(all.tag.size());
  part.first_line_vertex = static_cast<GLint>(all.line_position.size());
  part.line_vertices = static_cast<GLsizei>(2 * lines.size());
  part.noise_offset = static_cast<GLintptr>(all.noise.size() * sizeof(float));

  all.position.insert(all.position.end(), solid.position.begin(), solid.position.end());
  all.normal.insert(all.normal.end(), solid.normal.begin(), solid.normal.end());
  all.color.insert(all.color.end(), solid.color.begin(), solid.color.end());
  all.triangle.insert(all.triangle.end(), solid.triangle.begin(), solid.triangle.end());
  for (std::size_t t = 0; t < solid.triangle.size(); ++t) all.tag.push_back(tag_of(solid, t));
  for (const InnerLine& line : lines) {
    all.line_position.push_back(line.a);
    all.line_position.push_back(line.b);
    all.line_strength.insert(all.line_strength.end(), 2, line.opacity);
  }
  const std::vector<float> block = noise_block(with_noise ? solid.noise : NoiseStyle{});
  all.noise.insert(all.noise.end(), block.begin(), block.end());
  all.noise.resize(static_cast<std::size_t>(part.noise_offset + block_stride) / sizeof(float));
  all.parts.push_back(part);
}

Gathered gathered_solids(const Scene& scene, const Style& style) {
  std::vector<std::vector<InnerLine>> lines(scene.solids.size());
  if (style.ink) {
    parallel_for(scene.solids.size(), {}, [&](std::size_t i) { lines[i] = inner_lines(scene.solids[i]); });
  }
  Gathered all;
  for (std::size_t i = 0; i < scene.solids.size(); ++i) append(scene.solids[i], lines[i], style.noise, all);
  return all;
}

}  // namespace

std::vector<float> noise_block(const NoiseStyle& style) {
  const Modulation modulation(style);
  std::vector<float> block(noise_block_size / sizeof(float), 0.0f);
  const auto put = [&](std::size_t vec4_index, const std::array<double, 4>& values) {
    for (std::size_t i = 0; i < 4; ++i) block[4 * vec4_index + i] = static_cast<float>(values[i]);
  };
  const auto keys = modulation.keys().size();
  put(0, {style.base_frequency, style.sigma, static_cast<double>(keys), static_cast<double>(modulation.bands())});
  put(1, {style.stretch.x, style.stretch.y, style.stretch.z, 0});
  for (std::size_t k = 0; k < keys; ++k) {
    const Modulation::Key& key = modulation.keys()[k];
    const auto& w = key.weights;
    put(2 + k, {key.lab.x, key.lab.y, key.lab.z, 0});
    put(2 + max_noise_keys + k, {key.axis.x, key.axis.y, key.axis.z, 0});
    put(2 + 2 * max_noise_keys + 2 * k, {w[0], w[1], w[2], w[3]});
    put(3 + 2 * max_noise_keys + 2 * k, {w[4], w[5], w[6], w[7]});
  }
  return block;
}

UploadedSolids uploaded(const CurrentGl& gl, const Scene& scene, const Style& style) {
  const Gathered all = gathered_solids(scene, style);
  GLint most = 0;
  gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (all.tag.size() > static_cast<std::size_t>(most)) {
    throw Error(ExitStatus::bad_data, "the scene has " + std::to_string(all.tag.size()) +
                                          " triangles in different solids; this OpenGL draws at most " +
                                          std::to_string(most));
  }

  GlBuffer tag_buffer(gl, GL_TEXTURE_BUFFER, all.tag);
  GlTexture tags(gl, GL_R16UI, tag_buffer);
  UploadedSolids solids{
      .parts = all.parts,
      .position = GlBuffer(gl, GL_ARRAY_BUFFER, all.position),
      .normal = GlBuffer(gl, GL_ARRAY_BUFFER, all.normal),
      .color = GlBuffer(gl, GL_ARRAY_BUFFER, all.color),
      .index = GlBuffer(gl, GL_ARRAY_BUFFER, all.triangle),
      .line_position = GlBuffer(gl, GL_ARRAY_BUFFER, all.line_position),
      .line_strength = GlBuffer(gl, GL_ARRAY_BUFFER, all.line_strength),
      .tag_buffer = std::move(tag_buffer),
      .triangle_tags = std::move(tags),
      .noise_blocks = GlBuffer(gl, GL_UNIFORM_BUFFER, all.noise),
      .solids = GlVertexArray(gl),
      .lines = GlVertexArray(gl),
  };
  solids.solids.attach(0, 3, solids.position);
  solids.solids.attach(1, 3, solids.normal);
  solids.solids.attach(2, 3, solids.color);
  gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, solids.index.id());
  solids.lines.attach(0, 3, solids.line_position);
  solids.lines.attach(1, 1, solids.line_strength);
  gl.check("handing over the solids");
  return solids;
}

}  // namespace pomona
