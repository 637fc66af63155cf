#include "tests/cut/carve/carving_stages.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/cut/carve/knife_face.h"
#include "generator/cut/carve/labels.h"
#include "generator/cut/cut.h"
#include "generator/cut/cut_observer.h"
#include "generator/knife/closed_knives.h"
#include "generator/knife/knife_mesh.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/weld.h"
#include "tests/cut/carve/arranged_shapes.h"
#include "tests/cut/solid_shapes.h"
#include "tests/cut/without_overlaps.h"
#include "tests/shapes/shapes.h"

namespace pomona::shapes {

namespace {

constexpr double pi = 3.14159265358979323846;

/// The distance of the knife where it touches the fruit, metres along x, y and z: less than the width of triangles.
const glm::dvec3 step(1e-9, 1e-11, 1e-13);

/// Keeps the results of all stages of a cut.
class CuttingsSeen : public CutObserver {
 public:
  void sees(const CutPlanes& /*planes*/, const Cutting& cutting) override { all.push_back(cutting); }
  std::vector<Cutting> all;
};

/// Coarse, so that there are few triangles to test.
const CutOptions coarse{.coarsest = 0.2, .finest = 0.1, .threads = {1}};

CutPlanes planes_before(const CarvingCase& of) {
  std::vector<Knife> knives = of.before;
  return cut_planes(knives, bounds_of(of.surfaces));
}

/// The fruit before a closed knife: the result of the earlier knives, with points of equal position joined.
CutFruit fruit_before(const CarvingCase& of) {
  std::vector<Knife> knives = of.before;
  knives.push_back(solid_knife(of.knife));
  CuttingsSeen seen;
  cut(of.surfaces, knives, coarse, &seen);
  CutFruit fruit = with_faces(seen.all.at(seen.all.size() - 2), of.surfaces, {1});
  const std::vector<std::uint32_t> first = weld(fruit.mesh.point);
  for (std::uint32_t& p : fruit.mesh.point_of) p = first[p];
  for (Cap& cap : fruit.section.cap) {
    for (std::uint32_t& p : cap.point) p = first[p];
  }
  return fruit;
}

std::vector<std::vector<Corners>> boundaries_of(const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  std::vector<std::vector<Corners>> all(bodies.bodies.size());
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t)) continue;
    const glm::uvec3& v = surfaces.triangle[t];
    Corners corners{surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]};
    if (surfaces.is_hidden(t, SideOf::back)) std::swap(corners[1], corners[2]);
    all[static_cast<std::size_t>(bodies.of_triangle[t])].push_back(corners);
  }
  return all;
}

DiffusionSurfaces colored(DiffusionSurfaces surfaces) {
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    surfaces.front_color[v] = front_color_at(surfaces.position[v]);
    surfaces.back_color[v] = back_color_at(surfaces.position[v]);
  }
  return surfaces;
}

ClosedSurface together(ClosedSurface first, const ClosedSurface& second) {
  const auto offset = static_cast<std::uint32_t>(first.point.size());
  first.point.insert(first.point.end(), second.point.begin(), second.point.end());
  for (const glm::uvec3& t : second.triangle) first.triangle.push_back(t + offset);
  return first;
}

}  // namespace

Color front_color_at(const glm::dvec3& place) {
  return Color(glm::dvec3(0.5, 0.4, 0.3) + 3.0 * place + glm::dvec3(place.y, place.z, place.x));
}

Color back_color_at(const glm::dvec3& place) { return Color(glm::dvec3(0.2, 0.3, 0.7) - 2.0 * place); }

std::vector<CarvingCase> carving_cases() {
  const DiffusionSurfaces ball_of_flesh = sphere(0.05, 4, skin_paint());
  const ClosedSurface scoop = ball({0.045, 0.003, 0.002}, 0.02, 4);
  std::vector<CarvingCase> all{
      {"bowl", ball_of_flesh, {}, scoop},
      {"hollow", ball_of_flesh, {}, ball({0.003, 0.002, 0.001}, 0.02, 3)},
      {"tube", nested_spheres(0.05, 0.02, 4), {parse_knife("half")}, rod({0.0063, -0.1, 0.0031}, 0.012, 0.2, 12)},
      {"cavity", hollow_ball(0.05, 0.03, 4), {parse_knife("slices:3")}, ball({0.03, 0.01, 0.004}, 0.025, 4)},
      {"two bodies",
       joined(ball_of_flesh, moved(sphere(0.04, 3, skin_paint()), {0.03, 0.01, 0.005})),
       {parse_knife("half")},
       ball({0.02, 0.03, 0.004}, 0.025, 4)},
      {"second bowl", ball_of_flesh, {solid_knife(scoop)}, ball({0.04, 0.02, 0.004}, 0.022, 4)},
      {"quarters",
       nested_spheres(0.05, 0.02, 4),
       {parse_knife("wedges:4")},
       tilted(block({0, 0, 0}, {0.05, 0.05, 0.05}))},
      {"common wall",
       joined(box({-0.04, -0.03, -0.03}, {0, 0.03, 0.03}, 2, skin_paint()),
              box({0, -0.02, -0.025}, {0.03, 0.02, 0.025}, 1, skin_paint())),
       {},
       ball({0.002, 0.003, 0.001}, 0.015, 4)},
      {"two parts", ball_of_flesh, {}, together(scoop, ball({-0.02, 0.003, 0.001}, 0.013, 3))},
      {"face in face",
       box({-0.03125, -0.03125, -0.03125}, {0.03125, 0.03125, 0.03125}, 2, skin_paint()),
       {},
       block({0.0078125, -0.015625, -0.0234375}, {0.03125, 0.015625, 0.015625})},
  };
  for (CarvingCase& of : all) of.surfaces = without_overlaps(colored(std::move(of.surfaces)));
  return all;
}

CarvingCase carving_case(const std::string& name) {
  for (CarvingCase& of : carving_cases()) {
    if (of.name == name) return std::move(of);
  }
  throw std::invalid_argument("no carving is called " + name);
}

CarvingStages::CarvingStages(const CarvingCase& of)
    : surfaces(of.surfaces),
      bodies(find_bodies(of.surfaces)),
      fruit(fruit_before(of)),
      split{fruit, {}},
      before_(of.before),
      planes_(planes_before(of)),
      body_(boundaries_of(surfaces, bodies)) {
  knife.mesh = knife_mesh(of.knife, of.name);
  knife.number = static_cast<int>(before_.size());
  knife.plane = planes_.count() + knife.number;
  arrange();
  winding = windings_of_knife(all, places);
  CutFruit with_places = fruit;
  for (std::size_t p = fruit.mesh.point.size(); p < places.count(); ++p) {
    with_places.mesh.add_point(places.at(static_cast<std::uint32_t>(p)), 0);
  }
  split = split_surfaces(std::move(with_places), {all, winding, surface, cap, knife.stride}, surfaces, bodies);
  face = knife_face(all, knife, split.traces, split.fruit.mesh);
}

void CarvingStages::arrange() {
  // The fruit's triangles by its points, without collapsed ones.
  std::vector<PlaceTriangle> of_fruit, of_knife;
  const auto take = [&](const PlaceTriangle& t, std::uint32_t number, std::vector<std::uint32_t>& numbers) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    of_fruit.push_back(t);
    numbers.push_back(number);
  };
  const std::vector<std::uint32_t>& point_of = fruit.mesh.point_of;
  for (std::uint32_t t = 0; t < fruit.surface.size(); ++t) {
    const std::array<std::uint32_t, 3>& v = fruit.surface[t].vertex;
    take({point_of[v[0]], point_of[v[1]], point_of[v[2]]}, t, surface);
  }
  for (std::uint32_t t = 0; t < fruit.section.cap.size(); ++t) take(fruit.section.cap[t].point, t, cap);

  // The fruit's points keep their numbers; the knife's follow.
  std::vector<std::uint8_t> known(fruit.mesh.point.size(), 0);
  for (const PlaceTriangle& t : of_fruit) {
    for (const std::uint32_t p : t) known[p] = 1;
  }
  for (std::size_t p = 0; p < known.size(); ++p) places.append(fruit.mesh.point[p], known[p] != 0);
  for (const KnifeMesh::Triangle& t : knife.mesh.triangle) {
    PlaceTriangle place{};
    for (std::size_t i = 0; i < 3; ++i) place[i] = places.number_of(knife.mesh.point[t.corner[i]]);
    of_knife.push_back(place);
  }
  all = arranged(of_fruit, of_knife, places);
}

Regions CarvingStages::regions() {
  return knife_regions(face, split.traces, knife.stride, surfaces, bodies, [&](std::uint32_t triangle) {
    ++first_calls;
    return KnownWindings{triangle, inside_at(middle(triangle))};
  });
}

std::vector<CellBoundary> CarvingStages::inside_at(const glm::dvec3& place) const {
  const glm::dvec3 moved = place + step;
  std::vector<CellBoundary> inside;
  for (std::size_t b = 0; b < body_.size(); ++b) {
    const int times = winding_around(body_[b], moved);
    if (times != 0) inside.push_back({cell_at(moved), static_cast<std::int32_t>(b), times});
  }
  return inside;
}

int CarvingStages::winding_of_knife_at(const glm::dvec3& place) const {
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < knife.mesh.triangle.size(); ++t) triangles.push_back(knife.mesh.corners(t));
  return winding_around(triangles, place - step);
}

/// Knife by knife, the first knife's cells slowest; the knife at work has the last two.
std::uint32_t CarvingStages::cell_at(const glm::dvec3& place) const {
  std::uint32_t cell = 0;
  for (std::size_t k = 0; k < before_.size(); ++k) {
    const KnifePlanes& laid = planes_.knives[k];
    KnifeSides sides;
    for (std::size_t i = 0; i < laid.planes.size(); ++i) {
      sides = laid.seen(sides, i, signed_distance(laid.planes[i], place) > 0);
    }
    int own = laid.cell(sides);
    if (before_[k].is_closed()) {
      own = winding_around(corners_of(surface_of(std::get<ClosedCut>(before_[k].cut), surfaces)), place) > 0 ? 1 : 0;
    }
    cell = cell * static_cast<std::uint32_t>(laid.cell_count()) + static_cast<std::uint32_t>(own);
  }
  return 2 * cell;
}

glm::dvec3 CarvingStages::middle(std::size_t triangle) const {
  const glm::uvec3& t = face.triangle[triangle];
  return (face.place[t.x] + face.place[t.y] + face.place[t.z]) / 3.0;
}

/// By solid angles [Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983].
int winding_around(std::span<const Corners> triangles, const glm::dvec3& place) {
  double angle = 0;
  for (const Corners& t : triangles) {
    const glm::dvec3 a = t[0] - place, b = t[1] - place, c = t[2] - place;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    angle += 2 * reproducible::atan2(glm::dot(a, glm::cross(b, c)),
                                     la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return static_cast<int>(std::lround(angle / (4 * pi)));
}

glm::dvec3 area_of(const Corners& triangle) {
  return 0.5 * glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

bool is_collapsed(const Corners& triangle) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, glm::distance(triangle[i], triangle[(i + 1) % 3]));
  return 2 * glm::length(area_of(triangle)) < 1e-14 * longest;
}

}  // namespace pomona::shapes
