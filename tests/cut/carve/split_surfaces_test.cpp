#include "generator/cut/carve/split_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/cut/carve/carving_stages.h"
#include "tests/cut/solid_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::CarvingCase;
using shapes::CarvingStages;
using testing::UnorderedElementsAreArray;
using Way = std::pair<std::uint32_t, std::uint32_t>;

Corners corners_of(const SurfaceTriangle& t, const SplitMesh& mesh) {
  return {mesh.place_of(t.vertex[0]), mesh.place_of(t.vertex[1]), mesh.place_of(t.vertex[2])};
}

Corners corners_of(const Cap& cap, const SplitMesh& mesh) {
  return {mesh.point[cap.point[0]], mesh.point[cap.point[1]], mesh.point[cap.point[2]]};
}

std::vector<std::uint32_t> points_of(const SurfaceTriangle& t, const SplitMesh& mesh) {
  return {mesh.point_of[t.vertex[0]], mesh.point_of[t.vertex[1]], mesh.point_of[t.vertex[2]]};
}

double size_of(const glm::dvec3& area) { return glm::length(area); }

/// The cell without the present knife, which makes cells 2 n and 2 n + 1 of cell n.
std::uint32_t outside_of(std::uint32_t cell) { return cell - cell % 2; }

/// By input triangle and cell without the present knife: the sum of the areas of its parts, and the area of the vector
/// sum.
struct Areas {
  glm::dvec3 sum{0};
  double size = 0;
};

std::map<Way, Areas> areas_of_surface(const CutFruit& fruit) {
  std::map<Way, Areas> all;
  for (const SurfaceTriangle& t : fruit.surface) {
    Areas& areas = all[{t.source, outside_of(t.cell)}];
    const glm::dvec3 own = shapes::area_of(corners_of(t, fruit.mesh));
    areas.sum += own;
    areas.size += size_of(own);
  }
  return all;
}

/// Nothing is lost, doubled or turned over: areas of parts add up to that of the whole, as numbers and as vectors.
TEST(SplitSurfaces, AddUpToTheTrianglesTheyArePartsOf) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const std::map<Way, Areas> before = areas_of_surface(stages.fruit), after = areas_of_surface(stages.split.fruit);
    ASSERT_EQ(after.size(), before.size());
    for (const auto& [key, areas] : before) {
      EXPECT_LT(glm::distance(after.at(key).sum, areas.sum), 1e-15);
      EXPECT_NEAR(after.at(key).size, areas.size, 1e-15);
    }
  }
}

TEST(SplitSurfaces, SectionsAddUpToTheFacesTheyArePartsOf) {
  std::size_t faces = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);

    // Before and after, by face and the cells on both sides.
    std::array<std::map<std::tuple<std::int32_t, std::uint32_t, std::uint32_t>, Areas>, 2> all;
    for (const std::size_t i : {0u, 1u}) {
      const CutFruit& fruit = i == 0 ? stages.fruit : stages.split.fruit;
      ASSERT_EQ(fruit.section.cap.size(), fruit.section.mesh.triangle.size());
      ASSERT_EQ(fruit.section.mesh.cut.size(), fruit.section.mesh.triangle.size());
      for (std::size_t t = 0; t < fruit.section.cap.size(); ++t) {
        const std::array<std::uint32_t, 2>& cell = fruit.section.cap[t].closing.cell;
        EXPECT_EQ(cell[0] % 2, cell[1] % 2) << "both sides of an earlier face lie on one side of the knife";
        Areas& areas = all[i][{fruit.section.mesh.cut[t], outside_of(cell[0]), outside_of(cell[1])}];
        const glm::dvec3 own = shapes::area_of(corners_of(fruit.section.cap[t], fruit.mesh));
        areas.sum += own;
        areas.size += size_of(own);
      }
    }

    // Both are the same, up to rounding.
    ASSERT_EQ(all[0].size(), all[1].size());
    faces += all[0].size();
    for (const auto& [key, areas] : all[0]) {
      EXPECT_LT(glm::distance(all[1].at(key).sum, areas.sum), 1e-14);
      EXPECT_NEAR(all[1].at(key).size, areas.size, 1e-14);
    }
  }
  EXPECT_GT(faces, 8u);
}

/// Next to all three corners and in the middle the knife winds around all points, or around none.
void expect_on_one_side(const CarvingStages& stages, const Corners& corners, std::uint32_t cell) {
  if (shapes::is_collapsed(corners)) return;
  const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const int inside = static_cast<int>(cell % 2);
  EXPECT_EQ(stages.winding_of_knife_at(middle), inside);
  for (const glm::dvec3& corner : corners) EXPECT_EQ(stages.winding_of_knife_at(glm::mix(corner, middle, 0.1)), inside);
}

TEST(SplitSurfaces, LeaveNoTriangleOnBothSidesOfTheKnife) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;
    for (const SurfaceTriangle& t : fruit.surface) expect_on_one_side(stages, corners_of(t, fruit.mesh), t.cell);
    for (const Cap& cap : fruit.section.cap)
      expect_on_one_side(stages, corners_of(cap, fruit.mesh), cap.closing.cell[0]);
  }
}

/// The number of triangles that use an edge in each direction, less those that use it in the opposite one.
class Balance {
 public:
  template <typename Points>
  void add(const Points& points, int times) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = points[i], to = points[(i + 1) % 3];
      sum_[std::minmax(from, to)] += from < to ? times : -times;
    }
  }
  bool is_even() const {
    return std::all_of(sum_.begin(), sum_.end(), [](const auto& entry) { return entry.second == 0; });
  }

 private:
  std::map<Way, int> sum_;
};

/// The boundaries by boundary_of() of all skins and faces close around each body in each cell, by identity of points
/// and before the present knife adds its face.
TEST(SplitSurfaces, BoundariesCloseEveryPartOfABody) {
  std::size_t parts = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;

    // For each cell and body: its boundary, and the volume within.
    std::map<Way, Balance> balance;
    std::map<Way, double> volume;
    const auto add = [&](const auto& points, const Corners& corners, const std::vector<CellBoundary>& boundary) {
      for (const CellBoundary& b : boundary) {
        const Way part{outside_of(b.cell), b.body};
        balance[part].add(points, b.winding);
        volume[part] += b.winding * glm::dot(corners[0], shapes::area_of(corners)) / 3;
      }
    };
    for (const SurfaceTriangle& t : fruit.surface) {
      if (stages.surfaces.is_boundary(t.source))
        add(points_of(t, fruit.mesh), corners_of(t, fruit.mesh), boundary_of(t, stages.bodies));
    }
    for (const Cap& cap : fruit.section.cap) add(cap.point, corners_of(cap, fruit.mesh), boundary_of(cap));

    // All parts are closed, and add up to the whole.
    double whole = 0;
    for (const auto& [part, of_part] : balance) {
      EXPECT_TRUE(of_part.is_even()) << part.first << " " << part.second;
      EXPECT_GT(volume.at(part), 0);
      whole += volume.at(part);
      ++parts;
    }
    double wanted = 0;
    for (const Bodies::Body& body : stages.bodies.bodies) wanted += body.volume;
    EXPECT_NEAR(whole / wanted, 1, 1e-12);
  }
  EXPECT_GT(parts, 15u);
}

glm::dvec3 normal_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const glm::uvec3& v = surfaces.triangle[triangle];
  return shapes::area_of({surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]});
}

/// The normals of the knife's triangles with both points; 0 for collapsed ones.
std::vector<glm::dvec3> normals_at(const Face& face, std::uint32_t from, std::uint32_t to) {
  std::vector<glm::dvec3> all;
  for (const glm::uvec3& t : face.triangle) {
    const std::array<std::uint32_t, 3> at{face.point[t.x], face.point[t.y], face.point[t.z]};
    if (std::count(at.begin(), at.end(), from) + std::count(at.begin(), at.end(), to) != 2) continue;
    const Corners corners{face.place[t.x], face.place[t.y], face.place[t.z]};
    all.push_back(shapes::is_collapsed(corners) ? glm::dvec3(0) : glm::normalize(shapes::area_of(corners)));
  }
  return all;
}

/// Seen from outside the knife, the front of the surface lies left of a segment, and what is behind an edge lies to its
/// right.
TEST(SplitSurfaces, TracesLieOnBothAndKeepFrontsToTheirLeft) {
  std::size_t segments = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    if (of.name == "face in face") continue;  // in one plane only the tie rule gives a direction
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const SplitMesh& mesh = stages.split.fruit.mesh;
    for (const CutSegment& s : stages.split.traces.segments) {
      const glm::dvec3 way = mesh.point[s.to] - mesh.point[s.from];
      const glm::dvec3 front = glm::normalize(normal_of(stages.surfaces, s.source));
      const std::vector<glm::dvec3> knife = normals_at(stages.face, s.from, s.to);
      ASSERT_EQ(knife.size(), 2u) << "a side of two triangles of the knife";
      for (const glm::dvec3& normal : knife) EXPECT_GT(glm::dot(glm::cross(front, normal), way), -1e-12);
      if (knife[0] != glm::dvec3(0) || knife[1] != glm::dvec3(0)) {
        EXPECT_GT(glm::dot(glm::cross(front, knife[0] + knife[1]), way), 0);
      }
      EXPECT_EQ(mesh.point_of[s.from_vertex], s.from);
      EXPECT_EQ(mesh.point_of[s.to_vertex], s.to);
      const glm::dvec3 corner = stages.surfaces.position[stages.surfaces.triangle[s.source].x];
      EXPECT_NEAR(glm::dot(front, mesh.point[s.from] - corner), 0, 1e-9);
      ++segments;
    }
  }
  EXPECT_GT(segments, 300u);
}

/// Each side of each trace is a triangle of the surface that is cut, one inside the knife and one outside.
TEST(SplitSurfaces, PartInsideFromOutsideAlongTracesAlone) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    if (of.name == "face in face") continue;
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;

    // By edge and surface: how many triangles lie inside, and how many outside. Sections come after all surfaces.
    const auto sections = static_cast<std::int32_t>(stages.surfaces.surface_names.size());
    std::map<std::tuple<Way, std::int32_t>, std::array<int, 2>> sides;
    const auto add = [&](const auto& p, std::int32_t kind, std::uint32_t cell) {
      for (std::size_t i = 0; i < 3; ++i) ++sides[{std::minmax({p[i], p[(i + 1) % 3]}), kind}][cell % 2];
    };
    for (const SurfaceTriangle& t : fruit.surface)
      add(points_of(t, fruit.mesh), stages.surfaces.surface[t.source], t.cell);
    for (std::size_t t = 0; t < fruit.section.cap.size(); ++t) {
      const Cap& cap = fruit.section.cap[t];
      add(cap.point, sections + fruit.section.mesh.cut[t], cap.closing.cell[0]);
    }

    // Edges with triangles on both sides have equally many on each, and are those of the traces.
    std::set<Way> mixed, traced;
    for (const auto& [key, count] : sides) {
      if (count[0] == 0 || count[1] == 0) continue;
      EXPECT_EQ(count[0], count[1]);
      mixed.insert(std::get<0>(key));
    }
    for (const CutSegment& s : stages.split.traces.segments) traced.insert(std::minmax(s.from, s.to));
    for (const KnifeEdge& e : stages.split.traces.edges) traced.insert(std::minmax(e.from, e.to));
    EXPECT_THAT(mixed, testing::ContainerEq(traced));
  }
}

/// Seen from the front of what an edge of the knife bounds, the knife's inside lies left of the edge: so its direction
/// is that of the cut triangles inside. Skins and earlier faces have edges, inner surfaces none.
TEST(SplitSurfaces, GiveTheKnifeTheEdgesOfSkinsAndFacesInTheirWay) {
  std::size_t edges = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    if (of.name == "face in face") continue;
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;

    // Edges as triangles inside the knife use them, and against triangles outside.
    std::map<Way, int> inside, wanted, found;
    std::set<Way> outside;
    const auto add = [&](const auto& p, std::uint32_t cell) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Way way(p[i], p[(i + 1) % 3]);
        if (cell % 2 == 1) ++inside[way];
        if (cell % 2 == 0) outside.insert({way.second, way.first});
      }
    };
    for (const SurfaceTriangle& t : fruit.surface) {
      if (stages.surfaces.is_boundary(t.source)) add(points_of(t, fruit.mesh), t.cell);
    }
    for (const Cap& cap : fruit.section.cap) add(cap.point, cap.closing.cell[0]);

    // There is an edge where both meet.
    for (const auto& [way, count] : inside) {
      if (outside.contains(way)) wanted[way] = count;
    }
    for (const KnifeEdge& e : stages.split.traces.edges) ++found[{e.from, e.to}];
    EXPECT_EQ(found, wanted);
    edges += found.size();
  }
  EXPECT_GT(edges, 300u);
}

/// A ball that has been cut along a smooth wave, and a bowl for it.
CarvingCase waved_ball() {
  std::vector<glm::dvec2> wave;
  for (int i = -12; i <= 12; ++i) wave.emplace_back(0.005 * i, 0.003 * std::sin(0.5 * i));
  CarvingCase of = shapes::carving_case("bowl");
  of.before = {{PlaneCut(StrokeKnife{wave}), "wave"}};
  return of;
}

/// The normal of each face of the section at each point: the same for all its triangles there.
std::map<std::pair<std::int32_t, std::uint32_t>, glm::vec3> normals_by_place(const CutFruit& fruit) {
  std::map<std::pair<std::int32_t, std::uint32_t>, glm::vec3> all;
  for (std::size_t t = 0; t < fruit.section.cap.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair at(fruit.section.mesh.cut[t], fruit.section.cap[t].point[i]);
      const glm::vec3 normal = fruit.section.mesh.normal[t][i];
      EXPECT_LT(glm::distance(all.try_emplace(at, normal).first->second, normal), 1e-5f);
    }
  }
  return all;
}

/// A wave is shaded as if it were round, also where triangles have been split.
TEST(SplitSurfaces, SectionsKeepTheirNormalsAtEveryPlace) {
  const CarvingStages stages(waved_ball());
  ASSERT_FALSE(stages.fruit.section.mesh.normal.empty());
  const auto before = normals_by_place(stages.fruit), after = normals_by_place(stages.split.fruit);
  EXPECT_GT(after.size(), before.size() + 10);
  for (const auto& [at, normal] : before) EXPECT_LT(glm::distance(after.at(at), normal), 1e-5f);
}

std::vector<Way> ways_of_segments(const SplitFruit& split, bool turned) {
  std::vector<Way> ways;
  for (const SectionSegment& s : split.fruit.section.mesh.segments)
    ways.emplace_back(s.vertex[turned ? 1 : 0], s.vertex[turned ? 0 : 1]);
  return ways;
}

/// A segment may begin at either end.
TEST(SplitSurfaces, DivideSegmentsOfSectionsAlikeWhicheverWayTheyRun) {
  std::size_t added = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    CutFruit turned = stages.fruit;
    for (std::size_t p = turned.mesh.point.size(); p < stages.places.count(); ++p)
      turned.mesh.add_point(stages.places.at(static_cast<std::uint32_t>(p)), 0);
    for (SectionSegment& s : turned.section.mesh.segments) std::swap(s.vertex[0], s.vertex[1]);
    const FruitParts parts{stages.all, stages.winding, stages.surface, stages.cap, stages.knife.stride};
    const SplitFruit split = split_surfaces(std::move(turned), parts, stages.surfaces, stages.bodies);
    const std::vector<Way> ways = ways_of_segments(stages.split, false);
    EXPECT_THAT(ways_of_segments(split, true), UnorderedElementsAreArray(ways));
    added += ways.size() - stages.fruit.section.mesh.segments.size();
  }
  EXPECT_GT(added, 20u);
}

bool is_near(const Color& a, const Color& b) { return glm::distance(a, b) < 2e-6f; }

/// Colours that are linear over a triangle are right at a new vertex.
TEST(SplitSurfaces, MixColorsAndNormalsByPlace) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const SplitMesh& mesh = stages.split.fruit.mesh;
    for (const SurfaceTriangle& t : stages.split.fruit.surface) {
      for (const std::uint32_t v : t.vertex) {
        EXPECT_TRUE(is_near(mesh.front_color[v], shapes::front_color_at(mesh.place_of(v))));
        EXPECT_TRUE(is_near(mesh.back_color[v], shapes::back_color_at(mesh.place_of(v))));
        if (!stages.surfaces.is_boundary(t.source) || shapes::is_collapsed(corners_of(t, mesh))) continue;
        EXPECT_NEAR(glm::length(mesh.normal[v]), 1, 1e-5);
        EXPECT_GT(glm::dot(glm::dvec3(mesh.normal[v]), shapes::area_of(corners_of(t, mesh))), 0);
      }
    }
  }
}

TEST(SplitSurfaces, SectionsHaveTheColorsOfSurfacesWhereTheyFollowThem) {
  std::size_t added = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CrossSection& section = stages.split.fruit.section.mesh;
    const std::size_t before = stages.fruit.section.mesh.position.size();
    for (std::size_t v = before; v < section.position.size(); ++v) {
      if (section.interior[v]) continue;
      const glm::dvec3 place(section.position[v]);
      EXPECT_TRUE(is_near(section.color[v], shapes::front_color_at(place)) ||
                  is_near(section.color[v], shapes::back_color_at(place)));
      ++added;
    }
  }
  EXPECT_GT(added, 30u);
}

/// The caps of pieces are the triangles of the section.
TEST(SplitSurfaces, SectionsLieWhereTheirCapsDo) {
  for (const CarvingCase& of : shapes::carving_cases()) {
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;
    const CrossSection& section = fruit.section.mesh;
    ASSERT_EQ(section.color.size(), section.position.size());
    ASSERT_EQ(section.interior.size(), section.position.size());
    ASSERT_EQ(section.part.size(), section.position.size());
    for (std::size_t t = 0; t < section.triangle.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3& place = fruit.mesh.point[fruit.section.cap[t].point[static_cast<std::size_t>(i)]];
        EXPECT_EQ(section.position[section.triangle[t][i]], glm::vec3(place));
      }
    }
    if (section.normal.empty()) continue;
    ASSERT_EQ(section.normal.size(), section.triangle.size());
    for (std::size_t t = 0; t < section.triangle.size(); ++t) {
      const glm::dvec3 area = shapes::area_of(corners_of(fruit.section.cap[t], fruit.mesh));
      for (const glm::vec3& n : section.normal[t]) EXPECT_GT(glm::dot(glm::dvec3(n), area), 0);
    }
  }
}

/// Lines of ink are split with their triangles, and keep their length.
TEST(SplitSurfaces, SplitInkWithTheSection) {
  std::size_t added = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CrossSection &before = stages.fruit.section.mesh, &after = stages.split.fruit.section.mesh;
    std::set<Way> sides;
    for (const glm::uvec3& t : after.triangle) {
      for (int i = 0; i < 3; ++i) sides.insert(std::minmax({t[i], t[(i + 1) % 3]}));
    }
    const auto length = [](const CrossSection& section, const SectionSegment& s) {
      return glm::distance(glm::dvec3(section.position[s.vertex[0]]), glm::dvec3(section.position[s.vertex[1]]));
    };

    // Lengths by surface.
    std::map<std::pair<std::int32_t, bool>, double> was, is;
    for (const SectionSegment& s : before.segments) was[{s.surface, s.boundary}] += length(before, s);
    for (const SectionSegment& s : after.segments) {
      EXPECT_TRUE(sides.contains(std::minmax(s.vertex[0], s.vertex[1])));
      is[{s.surface, s.boundary}] += length(after, s);
    }
    ASSERT_EQ(is.size(), was.size());
    for (const auto& [kind, sum] : was) EXPECT_NEAR(is.at(kind), sum, 1e-6);
    added += after.segments.size() - before.segments.size();
  }
  EXPECT_GT(added, 15u);
}

/// Where faces meet, a vertex to be diffused exists once: the knife's face uses the vertices of earlier faces.
TEST(SplitSurfaces, ShareTheVerticesThatEarlierFacesHaveOnTheKnife) {
  std::size_t shared = 0;
  for (const CarvingCase& of : shapes::carving_cases()) {
    SCOPED_TRACE(of.name);
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;
    const std::set<std::uint32_t> on_knife(stages.face.point.begin(), stages.face.point.end());
    SharedVertices wanted;
    for (std::size_t t = 0; t < fruit.section.cap.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t v = fruit.section.mesh.triangle[t][i];
        const std::uint32_t place = fruit.section.cap[t].point[static_cast<std::size_t>(i)];
        if (fruit.section.mesh.interior[v] && on_knife.contains(place)) wanted[place] = v;
      }
    }
    EXPECT_EQ(stages.split.traces.shared, wanted);
    shared += wanted.size();
  }
  EXPECT_GT(shared, 20u);
}

TEST(SplitSurfaces, LeaveAFruitWholeThatTheKnifeDoesNotMeet) {
  for (const bool holds : {false, true}) {
    CarvingCase of = shapes::carving_case("tube");
    of.knife = shapes::ball({holds ? 0.0 : 1.0, 0, 0}, 0.2, 2);
    const CarvingStages stages(of);
    const CutFruit& fruit = stages.split.fruit;
    EXPECT_TRUE(stages.split.traces.segments.empty());
    EXPECT_TRUE(stages.split.traces.edges.empty());
    EXPECT_TRUE(stages.split.traces.shared.empty());
    ASSERT_EQ(fruit.surface.size(), stages.fruit.surface.size());
    for (std::size_t t = 0; t < fruit.surface.size(); ++t) {
      EXPECT_EQ(fruit.surface[t].vertex, stages.fruit.surface[t].vertex);
      EXPECT_EQ(fruit.surface[t].cell, stages.fruit.surface[t].cell + (holds ? 1 : 0));
    }
    ASSERT_EQ(fruit.section.cap.size(), stages.fruit.section.cap.size());
    for (std::size_t t = 0; t < fruit.section.cap.size(); ++t) {
      for (const std::size_t side : {0u, 1u}) {
        EXPECT_EQ(fruit.section.cap[t].closing.cell[side],
                  stages.fruit.section.cap[t].closing.cell[side] + (holds ? 1 : 0));
      }
    }
    EXPECT_EQ(fruit.section.mesh.triangle, stages.fruit.section.mesh.triangle);
  }
}

}  // namespace
}  // namespace pomona
