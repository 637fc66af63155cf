// Cuts in files: pieces have equal colours and parts where they touched, and a hollow stays hollow.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/compose/grow.h"
#include "generator/cut/unite/united_bodies.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/scene/scene.h"
#include "generator/surface/bodies.h"
#include "generator/surface/shell_geometry.h"
#include "generator/template/read/read_template.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/ply.h"
#include "tests/render/export/read_glb.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

using Place = std::tuple<float, float, float>;
using Look = std::tuple<std::string, int>;  // bytes of the colour, part

Place place_of(const glm::vec3& p) { return {p.x, p.y, p.z}; }

std::string bytes_of(const glm::vec3& v) { return {reinterpret_cast<const char*>(&v), sizeof v}; }

struct Sample {
  DiffusionSurfaces surfaces;
  Template fruit;

  Slices sliced_by(const std::vector<std::string>& words) const {
    std::vector<Knife> knives;
    for (const std::string& word : words) knives.push_back(parse_knife(word));
    const auto diffuser = make_pmvc_diffuser({.quality = Quality::draft, .threads = {}});
    return shapes::sliced(surfaces, knives, fruit, diffuser.get());
  }
  /// Without an origin, so that files keep the fruit's frame, to the bit.
  Scene pieces(const std::vector<std::string>& words) const {
    Scene scene = gathered(sliced_by(words).pieces);
    for (Solid& solid : scene.solids) solid.origin = {};
    return scene;
  }
};

/// The sample with noise in its colours, as in a picture.
Sample seeded() {
  Sample sample{shapes::seeded_fruit(), {}};
  sample.fruit.parts = sample.surfaces.part_names;
  sample.fruit.noise.base_frequency = 100;
  sample.fruit.noise.keys.push_back({.color = {0.5f, 0.5f, 0.2f}, .weights = {0.05, 0.04}, .axis = {1, 0, 0}});
  return sample;
}

/// The looks of vertices by place, on the cut face that faces `normal`.
using Looks = std::map<Place, std::set<Look>>;

struct Vertex {
  glm::vec3 position, normal;
  Look look;
};

void see(Looks& looks, const Vertex& vertex, const glm::vec3& normal, int axis) {
  if (vertex.normal == normal && vertex.position[axis] == 0) looks[place_of(vertex.position)].insert(vertex.look);
}

/// Both sides of the cut along the plane through the origin across `axis`.
void expect_same_on_both_sides(const std::vector<Vertex>& vertices, int axis) {
  glm::vec3 up(0);
  up[axis] = 1;
  Looks above, below;
  for (const Vertex& v : vertices) {
    see(below, v, up, axis);
    see(above, v, -up, axis);
  }
  EXPECT_GT(below.size(), 300u);
  EXPECT_EQ(below.size(), above.size());
  EXPECT_TRUE(below == above) << "colours or parts differ where pieces touched";
}

TEST(CutFiles, PiecesThatTouchedLookTheSameThereInGlb) {
  const named::Glb glb = named::read_glb(write_glb(seeded().pieces({"half", "plane:0,1,0,0"})));
  ASSERT_EQ(glb.meshes.size(), 4u);
  std::vector<Vertex> vertices;
  for (const named::GlbMesh& mesh : glb.meshes) {
    ASSERT_EQ(mesh.part.size(), mesh.position.size());
    for (std::size_t v = 0; v < mesh.position.size(); ++v) {
      vertices.push_back({mesh.position[v], mesh.normal[v], {bytes_of(mesh.color[v]), mesh.part[v]}});
    }
  }
  expect_same_on_both_sides(vertices, 1);
  expect_same_on_both_sides(vertices, 2);
}

/// Vertices of a .ply of pieces: position, normal, colour, part (docs/reference/formats.md).
std::vector<Vertex> vertices_of(const std::string& ply) {
  constexpr std::size_t bytes = 6 * 4 + 3 + 4;
  const std::string count_before = "element vertex ", end = "end_header\n";
  const std::size_t count = std::stoul(ply.substr(ply.find(count_before) + count_before.size()));
  std::size_t at = ply.find(end) + end.size();
  std::vector<Vertex> vertices(count);
  for (Vertex& v : vertices) {
    std::int32_t part = 0;
    std::memcpy(&v.position, &ply[at], 12);
    std::memcpy(&v.normal, &ply[at + 12], 12);
    std::memcpy(&part, &ply[at + 27], 4);
    v.look = {ply.substr(at + 24, 3), part};
    at += bytes;
  }
  return vertices;
}

TEST(CutFiles, PiecesThatTouchedLookTheSameThereInPly) {
  const std::vector<Vertex> vertices = vertices_of(write_solids(seeded().pieces({"half", "plane:0,1,0,0"})));
  expect_same_on_both_sides(vertices, 1);
  expect_same_on_both_sides(vertices, 2);
}

/// Colours of the section's vertices with y = z = 0, the line in which both faces meet.
std::map<Place, std::set<Look>> line_of(const CrossSection& section, int face) {
  std::map<Place, std::set<Look>> line;
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    if (section.cut[t] != face) continue;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = section.triangle[t][i];
      const glm::vec3& p = section.position[v];
      if (p.y == 0 && p.z == 0 && section.interior[v] != 0) {
        line[place_of(p)].insert({bytes_of(section.color[v]), section.part[v]});
      }
    }
  }
  return line;
}

TEST(CutFiles, FacesOfTwoKnivesAgreeToTheBitWhereTheyMeet) {
  const Sample sample = seeded();
  const CrossSection section = sample.sliced_by({"half", "plane:0,1,0,0"}).section;
  Looks by_half, by_across;
  for (std::size_t f = 0; f < section.faces.size(); ++f) {
    (section.faces[f].knife == 0 ? by_half : by_across).merge(line_of(section, static_cast<int>(f)));
  }
  EXPECT_GT(by_half.size(), 20u);
  EXPECT_TRUE(by_half == by_across);
}

/// The same place with and without another cut. Only some vertices are at the same place; their colours are summed
/// together with other neighbours, so the last bits differ: by 0.0004 of 255 when this was written.
TEST(CutFiles, ASecondKnifeHardlyChangesAColourOfTheFirst) {
  const Sample sample = seeded();
  const CrossSection alone = sample.sliced_by({"half"}).section;
  const CrossSection both = sample.sliced_by({"half", "plane:0,1,0,0"}).section;
  std::map<Place, Color> known;
  for (std::size_t v = 0; v < alone.position.size(); ++v) {
    if (alone.interior[v] != 0) known[place_of(alone.position[v])] = alone.color[v];
  }
  int shared = 0;
  float worst = 0;
  for (std::size_t v = 0; v < both.position.size(); ++v) {
    const auto found = known.find(place_of(both.position[v]));
    if (both.interior[v] == 0 || found == known.end()) continue;
    ++shared;
    for (int i = 0; i < 3; ++i) worst = std::max(worst, std::fabs(found->second[i] - both.color[v][i]));
  }
  EXPECT_GT(shared, 100);
  EXPECT_LT(worst, 1e-5f) << "of 1";
}

/// The pepper's cavity: the volume of its shell minus the cavity is the volume of all pieces.
TEST(CutFiles, APeppersHollowStaysHollow) {
  const Template pepper = read_template(std::filesystem::path(POMONA_SOURCE_DIR) / "templates/pepper.toml");
  GrowOptions how;
  how.as_drawn = true;
  how.detail = 0.4;
  const Sample sample{grow(pepper, {}, how).sheets, pepper};
  double solid = 0, hollow = 0;
  const std::optional<UnitedBodies> united = united_bodies(sample.surfaces, find_bodies(sample.surfaces));
  ASSERT_TRUE(united) << "the stem stands in the flesh";
  for (const Bodies::Body& body : find_bodies(united->surfaces).bodies) solid += body.volume;
  for (const Shell& shell : measured_shells(sample.surfaces, find_shells(sample.surfaces))) {
    if (shell.closed && shell.volume < 0) hollow -= shell.volume;
  }
  EXPECT_GT(hollow, 0.5 * solid);

  const named::Glb glb = named::read_glb(write_glb(sample.pieces({"half", "across"})));
  double volume = 0;
  int with_wall = 0;
  for (const named::GlbMesh& mesh : glb.meshes) {
    volume += mesh.volume;
    const auto flesh = std::find(mesh.part_names.begin(), mesh.part_names.end(), "flesh") - mesh.part_names.begin();

    // The cavity's wall is flesh and faces the hollow, towards the axis.
    int wall = 0;
    for (std::size_t v = 0; v < mesh.position.size(); ++v) {
      const glm::vec2 out(mesh.position[v].x, mesh.position[v].z), way(mesh.normal[v].x, mesh.normal[v].z);
      wall +=
          mesh.part[v] == flesh && glm::length(out) > 0.02f && glm::dot(way, out) < -0.7f * glm::length(out) ? 1 : 0;
    }
    with_wall += wall > 30 ? 1 : 0;
  }
  EXPECT_NEAR(volume, solid, 1e-6 * solid);
  EXPECT_GE(with_wall, 4);
}

/// Every vertex of a section and of a skin has its part, the same in all files.
TEST(CutFiles, VerticesSayTheirPart) {
  const Scene scene = seeded().pieces({"half"});
  const named::Glb glb = named::read_glb(write_glb(scene));
  const std::string ply = write_solids(scene);
  const auto skin_part = [&](const std::vector<std::string>& names) {
    return static_cast<int>(std::find(names.begin(), names.end(), "skin") - names.begin());
  };
  std::set<std::string> in_glb, in_ply;
  for (const named::GlbMesh& mesh : glb.meshes) {
    for (std::size_t v = 0; v < mesh.position.size(); ++v) {
      in_glb.insert(mesh.part_names.at(static_cast<std::size_t>(mesh.part[v])));
      // The skin is bumpy and farther out than everything else.
      if (glm::length(mesh.position[v]) <= 0.043f) continue;
      EXPECT_EQ(mesh.part[v], skin_part(mesh.part_names));
    }
  }
  const std::vector<Vertex> vertices = vertices_of(ply);
  for (const Vertex& v : vertices) {
    const std::string line = "comment part " + std::to_string(std::get<int>(v.look)) + " ";
    const std::size_t at = ply.find(line);
    ASSERT_NE(at, std::string::npos);
    in_ply.insert(ply.substr(at + line.size(), ply.find('\n', at) - at - line.size()));
  }
  EXPECT_EQ(in_glb, in_ply);
  EXPECT_GE(in_ply.size(), 3u) << "skin, and several parts of the cut face";
}

}  // namespace
}  // namespace pomona
