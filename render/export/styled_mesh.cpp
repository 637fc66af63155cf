#include "render/export/styled_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "render/style/look.h"
#include "render/style/paint.h"

namespace pomona {
namespace {

/// All attributes of a vertex, bit by bit: position, normal, colour, texture coordinates, part, kind of face.
using VertexBits = std::array<std::uint32_t, 13>;

std::size_t hash_of(const VertexBits& bits) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a, a word at a time
  for (const std::uint32_t word : bits) hash = (hash ^ word) * 0x100000001b3u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

/// Numbers distinct vertices in the order of their first occurrence, by a hash table with linear probing and at least
/// twice as many places.
class VertexNumbers {
 public:
  /// \param max largest number of distinct vertices
  explicit VertexNumbers(std::size_t max) : table_(std::bit_ceil(2 * max + 1), free) { known_.reserve(max / 2); }

  /// The vertex's number, and whether it is new.
  std::pair<std::uint32_t, bool> number_of(const VertexBits& bits) {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = hash_of(bits) & mask;
    while (table_[at] != free && known_[table_[at]] != bits) at = (at + 1) & mask;
    const bool is_new = table_[at] == free;
    if (is_new) {
      table_[at] = static_cast<std::uint32_t>(known_.size());
      known_.push_back(bits);
    }
    return {table_[at], is_new};
  }

 private:
  static constexpr std::uint32_t free = 0xffffffffu;
  std::vector<std::uint32_t> table_;
  std::vector<VertexBits> known_;
};

/// Area-weighted normals of triangles, for vertices without a normal.
std::vector<glm::vec3> normals_from_triangles(const Solid& solid) {
  std::vector<glm::vec3> normals(solid.mesh.position.size(), glm::vec3(0));
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const glm::vec3 a = solid.mesh.position[t.x];
    const glm::vec3 area = glm::cross(solid.mesh.position[t.y] - a, solid.mesh.position[t.z] - a);
    for (int k = 0; k < 3; ++k) normals[t[k]] += area;
  }
  return normals;
}

/// A unit normal in any case; up if nothing is known.
std::vector<glm::vec3> unit_normals(const Solid& solid) {
  const std::vector<glm::vec3> fallback = normals_from_triangles(solid);
  std::vector<glm::vec3> normals(solid.mesh.position.size());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    normals[v] = {0, 1, 0};
    for (const glm::vec3& candidate : {solid.mesh.normal[v], fallback[v]}) {
      const double length = glm::length(glm::dvec3(candidate));
      if (!(length > 1e-30) || !std::isfinite(length)) continue;
      normals[v] = glm::vec3(glm::dvec3(candidate) / length);
      break;
    }
  }
  return normals;
}

/// Mean length of the edges at each vertex; finer noise would only alias.
std::vector<double> footprints(const StyledMesh& mesh) {
  std::vector<double> sum(mesh.position.size(), 0.0);
  std::vector<int> edges(mesh.position.size(), 0);
  for (const glm::uvec3& t : mesh.triangle) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double length = glm::length(glm::dvec3(mesh.position[a]) - glm::dvec3(mesh.position[b]));
      sum[a] += length, sum[b] += length;
      ++edges[a], ++edges[b];
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= edges[v];
  return sum;
}

std::vector<Color> styled_colors(const StyledMesh& mesh, const Look& look, const Paint& paint) {
  std::vector<Color> colors = mesh.color;
  if (!look.is_plain()) {
    const std::vector<double> footprint = footprints(mesh);
    constexpr std::size_t at_once = 1024;  // they fit the processor's caches
    for (std::size_t first = 0; first < colors.size(); first += at_once) {
      std::vector<LookPlace> places;
      for (std::size_t v = first; v < std::min(colors.size(), first + at_once); ++v) {
        places.push_back({.position = glm::dvec3(mesh.position[v]), .footprint = footprint[v], .face = mesh.face[v]});
        if (!mesh.guide.empty()) places.back().guide = mesh.guide[v];
      }
      const std::vector<Color> seen = look({&mesh.color[first], places.size()}, places);
      std::copy(seen.begin(), seen.end(), &colors[first]);
    }
  }
  for (Color& color : colors) color = glm::clamp(paint(color), Color(0), Color(1));
  return colors;
}

/// Adding zero makes -0 and 0 the same.
std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); }

VertexBits vertex_bits(const Solid& solid, const glm::vec3& normal, const glm::vec2& uv, std::uint32_t v, bool cut) {
  VertexBits bits{};
  for (int k = 0; k < 3; ++k) {
    bits[k] = bits_of(solid.mesh.position[v][k]);
    bits[3 + k] = bits_of(normal[k]);
    bits[6 + k] = bits_of(solid.mesh.color[v][k]);
  }
  bits[9] = bits_of(uv.x);
  bits[10] = bits_of(uv.y);
  bits[11] = static_cast<std::uint32_t>(solid.mesh.part[v]);
  bits[12] = cut ? 1 : 0;
  return bits;
}

/// The solid's distinct vertices, in the order in which triangles first use them. `uv` and `tangent` may be empty.
StyledMesh welded(const Solid& solid, const std::vector<glm::vec2>& uv, const std::vector<glm::vec4>& tangent) {
  const std::vector<glm::vec3> normals = unit_normals(solid);
  StyledMesh mesh;

  // A vertex is new unless all its bits are known; cut faces and skin share no vertices.
  VertexNumbers known(2 * solid.mesh.position.size());
  const auto number_of = [&](std::uint32_t v, bool cut) {
    const VertexBits bits = vertex_bits(solid, normals[v], uv.empty() ? glm::vec2(0) : uv[v], v, cut);
    const auto [number, is_new] = known.number_of(bits);
    if (is_new) {
      mesh.position.push_back(solid.mesh.position[v]);
      mesh.normal.push_back(normals[v]);
      mesh.color.push_back(solid.mesh.color[v]);
      mesh.part.push_back(solid.mesh.part[v]);
      mesh.face.push_back(cut ? DetailFace::cut : DetailFace::skin);
      if (!solid.mesh.guide.empty()) mesh.guide.push_back(solid.mesh.guide[v]);
      if (!uv.empty()) mesh.uv.push_back(uv[v]);
      if (!tangent.empty()) mesh.tangent.push_back(tangent[v]);
    }
    return number;
  };

  // Leaves out triangles with two corners at one place.
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const glm::uvec3& old = solid.mesh.triangle[t];
    const glm::vec3 &p = solid.mesh.position[old.x], &q = solid.mesh.position[old.y], &r = solid.mesh.position[old.z];
    if (p == q || q == r || r == p) continue;
    const bool cut = solid.mesh.cut_face[t] >= 0;
    const std::uint32_t a = number_of(old.x, cut), b = number_of(old.y, cut), c = number_of(old.z, cut);
    mesh.triangle.push_back({a, b, c});
    mesh.cut_face.push_back(solid.mesh.cut_face[t]);
  }
  return mesh;
}

}  // namespace

std::vector<StyledMesh> styled_meshes(std::span<const Solid> solids, const ExportOptions& options) {
  // Pieces of one fruit share the look of the first.
  const auto look_of = [&](const Solid& solid, const Look* like) {
    return options.style.noise ? Look(solid.look->noise, solid.look->details, like) : Look();
  };
  const Look first = solids.empty() ? Look() : look_of(solids.front(), nullptr);
  std::vector<StyledMesh> meshes(solids.size());
  parallel_for(meshes.size(), options.threads, [&](std::size_t i) {
    meshes[i] = welded(solids[i], {}, {});
    meshes[i].color = styled_colors(meshes[i], look_of(solids[i], &first), Paint(options.style));
  });
  return meshes;
}

std::vector<StyledMesh> styled_meshes(const Scene& scene, const ExportOptions& options) {
  return styled_meshes(scene.solids, options);
}

StyledMesh textured_mesh(const BakedSolid& baked) { return welded(baked.solid, baked.uv, baked.maps.tangent); }

}  // namespace pomona
