// Levels of detail have as few triangles as asked for, and never deviate more than stated.
#include "generator/piece/lod/levels_of_detail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/lod/vertex_fans.h"
#include "generator/piece/piece_facts.h"
#include "generator/piece/slice.h"
#include "generator/template/read/read_template.h"
#include "tests/piece/level_deviation.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Place = std::array<float, 3>;

Place place_of(const glm::vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }

/// Number of edges, by position, that triangles do not pass equally often in both directions.
std::size_t open_edges(const Solid& solid) {
  std::map<std::pair<Place, Place>, int> balance;
  for (const glm::uvec3& t : solid.mesh.triangle) {
    for (int i = 0; i < 3; ++i) {
      const Place a = place_of(solid.mesh.position[t[i]]), b = place_of(solid.mesh.position[t[(i + 1) % 3]]);
      if (a != b) balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

double size_of(const Solid& solid) {
  const PieceFacts facts = facts_of(solid);
  return glm::length(facts.high - facts.low);
}

double area_of(const Solid& solid) {
  double area = 0;
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const glm::dvec3 a(solid.mesh.position[t.x]);
    area += 0.5 *
            glm::length(glm::cross(glm::dvec3(solid.mesh.position[t.y]) - a, glm::dvec3(solid.mesh.position[t.z]) - a));
  }
  return area;
}

/// All attributes of a vertex, to find whether another solid has it.
using VertexKey = std::tuple<Place, Place, Place, std::int32_t>;

std::set<VertexKey> vertices_of(const Solid& solid) {
  std::set<VertexKey> all;
  for (std::size_t v = 0; v < solid.mesh.position.size(); ++v)
    all.emplace(place_of(solid.mesh.position[v]), place_of(solid.mesh.normal[v]), place_of(solid.mesh.color[v]),
                solid.mesh.part[v]);
  return all;
}

/// The largest piece of a real fruit, as users get it; the whole fruit without a knife.
Solid piece_of(const std::string& name, const std::string& knife) {
  const Template fruit = read_template(std::string(POMONA_SOURCE_DIR) + "/templates/" + name + ".toml");
  const GrownFruit grown = grow(fruit, {.seed = 0});
  std::vector<Knife> knives;
  if (!knife.empty()) knives.push_back(parse_knife(knife));
  const auto diffuser = make_pmvc_diffuser({.quality = Quality::draft, .threads = {}});
  return slice({grown, fruit, knives, "x"}, diffuser.get()).pieces.front();
}

/// A shape of one body, as a solid.
Solid solid_of(const DiffusionSurfaces& surfaces) {
  const Cut whole = cut(surfaces, {});
  return solids(whole.pieces, whole.section, {}, "x").front();
}

struct RealPiece {
  std::string fruit;
  std::string knife;
  bool twice = false;  ///< whether its levels are made twice, and compared: of every third, because each takes seconds
};
void PrintTo(const RealPiece& piece, std::ostream* out) { *out << piece.fruit << ' ' << piece.knife; }

/// Hundreds of dark seeds are cut in bright flesh, or dark layers are a few millimetres apart, and all their outlines
/// may move within the bound.
bool has_dark_outlines(const std::string& fruit) {
  return fruit == "dragon_fruit" || fruit == "passion_fruit" || fruit == "swiss_roll";
}

/// Hundreds of kernels or flat seeds, of several thin layers each: half of the triangles are in bodies so small that
/// one more collapse would turn over what is left of them.
bool is_all_small_bodies(const std::string& fruit) { return fruit == "maize" || fruit == "pumpkin"; }

using Levels = std::vector<Solid>;

/// The largest shares of the solid's triangles that the first two levels may have.
std::array<double, 2> most_triangles(const std::string& fruit) {
  if (is_all_small_bodies(fruit)) return {0.53, 0.5};
  // An onion has dozens of roots and wisps, and each keeps at least the triangles that a closed body needs.
  // So has a papaya hundreds of seeds, and a broccoli hundreds of florets of a few hundred triangles.
  if (fruit == "papaya") return {0.5, 0.35};
  if (fruit == "broccoli") return {0.5, 0.38};
  return {0.5, 1.0 / 3};
}

void expect_as_few_as_asked_for(const Solid& solid, const Levels& levels, const std::array<double, 2>& most) {
  ASSERT_EQ(levels.size(), 3u);
  const auto all = static_cast<double>(solid.mesh.triangle.size());
  EXPECT_LE(static_cast<double>(levels[0].mesh.triangle.size()), all * most[0]);
  EXPECT_LE(static_cast<double>(levels[1].mesh.triangle.size()), all * most[1]);
  EXPECT_LT(levels[2].mesh.triangle.size(), levels[1].mesh.triangle.size());
}

void expect_closed(const Solid& solid, const Levels& levels) {
  ASSERT_EQ(open_edges(solid), 0u);
  for (const Solid& level : levels) EXPECT_EQ(open_edges(level), 0u) << level.name;
}

/// \param color_bound of the first level, of 255. Compares surface by surface, and only the same side, because both
/// sides of a thin leaf are near any place on it.
void expect_within_the_error(const Solid& solid, const Levels& levels, double color_bound) {
  double bound = LodOptions{}.error * size_of(solid);
  for (const Solid& level : levels) {
    const LevelDeviation off = deviation(level, solid, size_of(solid) / 80);
    EXPECT_LE(off.distance, bound) << level.name;
    EXPECT_LE(off.color_rms, color_bound) << level.name;
    EXPECT_LE(std::abs(level.volume - solid.volume), bound * area_of(solid)) << level.name;
    bound *= std::sqrt(2.0), color_bound *= 2;
  }
}

void expect_only_known_vertices(const Solid& solid, const Levels& levels) {
  const std::set<VertexKey> known = vertices_of(solid);
  for (const Solid& level : levels) {
    for (const VertexKey& vertex : vertices_of(level)) ASSERT_TRUE(known.contains(vertex)) << level.name;
  }
}

/// Except needles of a few square micrometres, which rounding has already turned in the solid: floats of a fruit of
/// 20 cm are 15 nm apart, and edges a millimetre long.
void expect_cut_faces_to_face_as_they_did(const Levels& levels) {
  for (const Solid& level : levels) {
    for (std::size_t t = 0; t < level.mesh.triangle.size(); ++t) {
      if (level.mesh.cut_face[t] < 0) continue;
      const glm::uvec3& v = level.mesh.triangle[t];
      const glm::dvec3 a(level.mesh.position[v.x]), b(level.mesh.position[v.y]), c(level.mesh.position[v.z]);
      EXPECT_GT(glm::dot(glm::cross(b - a, c - a), glm::dvec3(level.mesh.normal[v.x])), -1.5e-11) << level.name;
    }
  }
}

/// Number of turned triangles, except needles. The solid itself may have some.
std::size_t turned_triangles(const SolidMesh& mesh) {
  std::size_t turned = 0;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const auto [a, b, c] = mesh.corners(t);
    const glm::dvec3 across = mesh.area_vector(t);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    glm::dvec3 normal(0);
    for (int i = 0; i < 3; ++i) normal += glm::dvec3(mesh.normal[mesh.triangle[t][i]]);
    if (glm::length(across) > 1e-3 * longest * longest && glm::dot(across, normal) < 0) ++turned;
  }
  return turned;
}

/// Five of ten thousand may be turned: seams of united bodies have slivers, whose normals rounding has turned.
void expect_hardly_more_to_be_turned(const Solid& solid, const Levels& levels) {
  for (const Solid& level : levels)
    EXPECT_LE(turned_triangles(level.mesh), turned_triangles(solid.mesh) + level.mesh.triangle.size() / 2000)
        << level.name;
}

void expect_the_same(const Levels& levels, const Levels& others) {
  ASSERT_EQ(others.size(), levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    EXPECT_EQ(others[k].mesh.position, levels[k].mesh.position);
    EXPECT_EQ(others[k].mesh.triangle, levels[k].mesh.triangle);
  }
}

/// The levels of one solid, made several times on two threads.
std::vector<Levels> made(const Solid& solid, std::size_t times) {
  return all_levels_of_detail(std::vector<Solid>(times, solid), {.levels = 3, .threads = {2}});
}

class RealLevels : public testing::TestWithParam<RealPiece> {};

TEST_P(RealLevels, HoldWhatIsPromised) {
  const Solid solid = piece_of(GetParam().fruit, GetParam().knife);
  const std::vector<Levels> all = made(solid, GetParam().twice ? 2 : 1);
  const Levels& levels = all.front();
  expect_as_few_as_asked_for(solid, levels, most_triangles(GetParam().fruit));
  expect_closed(solid, levels);
  expect_within_the_error(solid, levels, has_dark_outlines(GetParam().fruit) ? 6 : 4);
  expect_only_known_vertices(solid, levels);
  expect_cut_faces_to_face_as_they_did(levels);
  expect_hardly_more_to_be_turned(solid, levels);
  expect_the_same(levels, all.back());
}

/// Half of every template, and a whole fruit. Under a sanitizer only one piece, because each takes minutes and all use
/// memory in the same way.
std::vector<RealPiece> real_pieces() {
#ifdef __SANITIZE_ADDRESS__
  return {{"apple", "half", true}};
#else
  std::vector<RealPiece> pieces{{"kiwi", ""}};
  for (const auto& entry : std::filesystem::directory_iterator(std::string(POMONA_SOURCE_DIR) + "/templates"))
    if (entry.path().extension() == ".toml") pieces.push_back({entry.path().stem().string(), "half"});
  std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.fruit < b.fruit; });
  for (std::size_t i = 0; i < pieces.size(); i += 3) pieces[i].twice = true;
  return pieces;
#endif
}

INSTANTIATE_TEST_SUITE_P(Fruits, RealLevels, testing::ValuesIn(real_pieces()));

/// FNV-1a over the choices of all levels.
std::uint64_t hash_of(const Levels& levels) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto eat = [&](const auto& values) {
    for (const std::byte byte : std::as_bytes(std::span(values)))
      hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3u;
  };
  for (const Solid& level : levels) eat(level.mesh.position), eat(level.mesh.triangle);
  return hash;
}

Solid ball() { return solid_of(shapes::sphere(0.03, 24, shapes::skin_paint())); }

TEST(LevelsOfDetail, AreTheSameAloneAndOnTwoThreads) {
  const Levels alone = levels_of_detail(ball(), {.levels = 3});
  for (const Levels& levels : made(ball(), 2)) expect_the_same(alone, levels);
}

TEST(LevelsOfDetail, AreNamedAndKnowTheirVolume) {
  const std::vector<Solid> levels = levels_of_detail(ball(), {.levels = 2});
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].name, "x_LOD1");
  EXPECT_EQ(levels[1].name, "x_LOD2");
  double six = 0;
  for (const glm::uvec3& t : levels[1].mesh.triangle) {
    six += glm::dot(glm::dvec3(levels[1].mesh.position[t.x]),
                    glm::cross(glm::dvec3(levels[1].mesh.position[t.y]), glm::dvec3(levels[1].mesh.position[t.z])));
  }
  EXPECT_NEAR(levels[1].volume, six / 6, 1e-12);
  EXPECT_LT(levels[1].volume, ball().volume) << "corners of a ball's mesh lie on the ball";
}

TEST(LevelsOfDetail, EndWhereNothingMayGo) {
  const Solid box = solid_of(shapes::box({-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}, 1, shapes::skin_paint()));
  EXPECT_THAT(levels_of_detail(box, {.levels = 3}), IsEmpty());
  EXPECT_THAT(levels_of_detail(Solid{}, {.levels = 3}), IsEmpty());
}

TEST(LevelsOfDetail, KeepTheRimOfWhatIsOpen) {
  const Solid sheet = [] {
    Solid solid = ball();
    std::erase_if(solid.mesh.triangle, [&](const glm::uvec3& t) { return solid.mesh.position[t.x].y > 0.0151f; });
    solid.mesh.cut_face.resize(solid.mesh.triangle.size());
    solid.mesh.surface.resize(solid.mesh.triangle.size());
    return solid;
  }();
  ASSERT_GT(open_edges(sheet), 0u);
  for (const Solid& level : levels_of_detail(sheet, {.levels = 2}))
    EXPECT_LE(deviation(level, sheet, 0.0005).distance, 0.005 * std::sqrt(2.0) * size_of(sheet)) << level.name;
}

TEST(LevelsOfDetail, KeepAColorBorderWithinTheBound) {
  // A ball, its upper half of another colour: vertices on the border are there twice.
  Solid two = ball();
  const auto vertices = static_cast<std::uint32_t>(two.mesh.position.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    two.mesh.position.push_back(two.mesh.position[v]);
    two.mesh.normal.push_back(two.mesh.normal[v]);
    two.mesh.color.emplace_back(0.1f, 0.7f, 0.1f);
    two.mesh.part.push_back(two.mesh.part[v]);
  }
  for (glm::uvec3& t : two.mesh.triangle) {
    if (two.mesh.position[t.x].y + two.mesh.position[t.y].y + two.mesh.position[t.z].y > 0) t += glm::uvec3(vertices);
  }
  for (const Solid& level : levels_of_detail(two, {.levels = 3})) {
    for (const glm::uvec3& t : level.mesh.triangle) {
      const bool upper = level.mesh.color[t.x].g > 0.5f;
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(level.mesh.color[t[i]].g > 0.5f, upper) << "a triangle of two colours";
        EXPECT_GE((upper ? 1 : -1) * level.mesh.position[t[i]].y, -1e-9f) << "beyond the border";
      }
    }
  }
}

/// A ball of three parts in one colour: two quarters and the half beside them, which all meet at the poles.
Solid ball_of_three_parts() {
  Solid three = solid_of(shapes::sphere(0.03, 48, shapes::skin_paint()));
  const auto vertices = static_cast<std::uint32_t>(three.mesh.position.size());
  for (const int part : {1, 2}) {
    for (std::size_t v = 0; v < vertices; ++v) {
      three.mesh.position.push_back(three.mesh.position[v]);
      three.mesh.normal.push_back(three.mesh.normal[v]);
      three.mesh.color.push_back(three.mesh.color[v]);
      three.mesh.part.push_back(part);
    }
  }
  std::fill_n(three.mesh.part.begin(), vertices, 0);
  for (glm::uvec3& t : three.mesh.triangle) {
    const glm::vec3 sum = three.mesh.position[t.x] + three.mesh.position[t.y] + three.mesh.position[t.z];
    t += glm::uvec3((sum.z < 0 ? 0u : sum.x < 0 ? 1u : 2u) * vertices);
  }
  return three;
}

/// The number is the same from every compiler. It may change only if the choice of collapses is changed on purpose.
TEST(LevelsOfDetail, HaveTheSameBytesEverywhere) {
  EXPECT_EQ(hash_of(levels_of_detail(ball_of_three_parts(), {.levels = 6})), 2380572424917338935u);
}

TEST(LevelsOfDetail, KeepPartsApartWhereThreeMeet) {
  const Solid three = ball_of_three_parts();
  const std::vector<Solid> levels = levels_of_detail(three, {.levels = 3});
  ASSERT_EQ(levels.size(), 3u);
  for (const Solid& level : levels) {
    std::set<std::int32_t> at_the_top;
    for (const glm::uvec3& t : level.mesh.triangle) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(level.mesh.part[t[i]], level.mesh.part[t.x]) << "a triangle of two parts";
        if (level.mesh.position[t[i]].y > 0.03f - 1e-6f) at_the_top.insert(level.mesh.part[t[i]]);
      }
    }
    EXPECT_THAT(at_the_top, ElementsAre(0, 1, 2)) << level.name;
  }
}

TEST(LevelsOfDetail, RefuseNumbersThatAreNone) {
  EXPECT_THROW(levels_of_detail(ball(), {.levels = 0}), Error);
  EXPECT_THROW(levels_of_detail(ball(), {.levels = 7}), Error);
  EXPECT_THROW(levels_of_detail(ball(), {.levels = 1, .error = 0}), Error);
}

/// Two tetrahedra with an edge in common: four triangles meet there.
Solid touching_tetrahedra() {
  Solid solid;
  solid.mesh.position = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5f}, {1, 1, 0.5f}, {-1, 0, 0.5f}, {-1, -1, 0.5f}};
  solid.mesh.triangle = {{0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 2, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}, {0, 4, 1}};
  solid.mesh.normal.assign(6, {0, 1, 0});
  solid.mesh.color.assign(6, Color(0.5f));
  solid.mesh.part.assign(6, 0);
  solid.mesh.cut_face.assign(8, -1);
  solid.mesh.surface.assign(8, 0);
  return solid;
}

TEST(VertexFans, FreezeWhatMeetsAtAnEdgeOfFour) {
  const VertexFans fans = vertex_fans(touching_tetrahedra());
  EXPECT_THAT(fans.frozen, ElementsAre(0u, 3u, 4u, 7u)) << "those at the edge from 0 to 1";
  EXPECT_THAT(fans.source, ElementsAre(1u, 2u, 5u, 6u));
  EXPECT_THAT(fans.is_locked, testing::Each(1)) << "all are corners of frozen triangles";
}

TEST(VertexFans, PartBodiesThatTouchInAPoint) {
  Solid two = touching_tetrahedra();
  // The second tetrahedron gets its own vertices; only one of them lies on the first, at its vertex 0.
  two.mesh.position.insert(two.mesh.position.end(), {{-0.5f, 0, 1}, {0, 0, 0}});
  two.mesh.triangle = {{0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 2, 1}, {7, 6, 5}, {7, 5, 4}, {6, 4, 5}, {7, 4, 6}};
  for (auto* values : {&two.mesh.normal, &two.mesh.color}) values->resize(8, glm::vec3(0.5f));
  two.mesh.part.resize(8, 0);
  const VertexFans fans = vertex_fans(two);
  EXPECT_THAT(fans.frozen, IsEmpty());
  ASSERT_EQ(fans.vertex.size(), 8u) << "two fans where they touch";
  EXPECT_EQ(std::count(fans.is_locked.begin(), fans.is_locked.end(), 1), 2);
}

}  // namespace
}  // namespace pomona
