#include "generator/scene/settle/piece_shape.h"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// A mesh in which every place is one vertex.
struct WeldedMesh {
  std::vector<glm::dvec3> position;
  std::vector<glm::uvec3> triangle;
};

WeldedMesh welded(const Solid& solid) {
  const std::vector<std::uint32_t> first = weld(solid.mesh.position);
  WeldedMesh mesh;
  std::vector<std::uint32_t> number(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      number[i] = static_cast<std::uint32_t>(mesh.position.size());
      mesh.position.emplace_back(solid.mesh.position[i]);
    } else {
      number[i] = number[first[i]];
    }
  }
  mesh.triangle = welded_triangles(number, solid.mesh.triangle);
  return mesh;
}

/// Mass, centre and inertia of what the mesh bounds: tetrahedra to the middle of its box, summed with their signs.
void weigh(PieceShape& shape, const WeldedMesh& mesh, const glm::dvec3& middle) {
  double six_volumes = 0;
  glm::dvec3 moment(0);
  glm::dmat3 second(0);  // the sum of x x^T
  for (const glm::uvec3& t : mesh.triangle) {
    const glm::dvec3 a = mesh.position[t.x] - middle, b = mesh.position[t.y] - middle, c = mesh.position[t.z] - middle;
    const double v = glm::dot(a, glm::cross(b, c));
    const glm::dvec3 sum = a + b + c;
    six_volumes += v;
    moment += sum * (0.25 * v);
    second +=
        (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum)) *
        (v / 120);
  }

  // A mesh without volume counts as a light ball.
  const double cube = shape.size * shape.size * shape.size, volume = six_volumes / 6;
  if (volume <= 1e-4 * cube) {
    shape.center = middle;
    shape.mass = 1e-3 * cube;
    shape.inverse_inertia = glm::dmat3(1 / (0.05 * shape.mass * shape.size * shape.size));
    return;
  }
  const glm::dvec3 away = moment / six_volumes;
  shape.center = middle + away;
  shape.mass = volume;
  second -= volume * glm::outerProduct(away, away);
  const double trace = second[0][0] + second[1][1] + second[2][2];
  const double min = 1e-3 * volume * shape.size * shape.size;  // thin things do not spin for nothing
  shape.inverse_inertia = glm::inverse(glm::dmat3(trace + min) - second);
}

/// Weighs by the parts inside, as far as their density differs from that of the rest, which counts as 1.
void take_weight(PieceShape& shape, const RigidMass& weighed, double density) {
  shape.center = weighed.center;
  shape.mass = weighed.mass / density;
  const double min = 1e-3 * shape.mass * shape.size * shape.size;
  shape.inverse_inertia = glm::inverse(weighed.inertia / density + glm::dmat3(min));
}

double area_of(const WeldedMesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangle)
    area +=
        0.5 * glm::length(glm::cross(mesh.position[t.y] - mesh.position[t.x], mesh.position[t.z] - mesh.position[t.x]));
  return area;
}

/// A cut face: twice its area, and twice the area that it shows where it shows most.
struct FaceAreas {
  double whole = 0;
  glm::dvec3 shown{0};

  bool is_flat() const { return glm::length(shown) > 0.97 * whole; }
};

/// The direction that the largest flat cut face looks, or the largest where none is flat; zero where there is none. The
/// round side of what was peeled is a cut face, too, but not the one to be seen.
glm::dvec3 face_to_show(const Solid& solid) {
  std::map<std::int32_t, FaceAreas> faces;
  for (std::size_t i = 0; i < solid.mesh.triangle.size(); ++i) {
    if (i >= solid.mesh.cut_face.size() || solid.mesh.cut_face[i] < 0) continue;
    const glm::dvec3 area = solid.mesh.area_vector(i);
    FaceAreas& face = faces[solid.mesh.cut_face[i]];
    face.whole += glm::length(area), face.shown += area;
  }
  FaceAreas best;
  const auto rank = [](const FaceAreas& face) { return std::pair(face.is_flat(), glm::dot(face.shown, face.shown)); };
  for (const auto& [number, face] : faces)
    if (rank(face) > rank(best)) best = face;
  return best.shown == glm::dvec3(0) ? best.shown : glm::normalize(best.shown);
}

Box<double> box_of(const Solid& solid) {
  Box<double> box;
  for (const glm::uvec3& t : solid.mesh.triangle)
    for (int k = 0; k < 3; ++k) box.add(glm::dvec3(solid.mesh.position[t[k]]));
  return box;
}

}  // namespace

double size_of(const Solid& solid) { return solid.mesh.triangle.empty() ? 0 : glm::length(box_of(solid).size()); }

PieceShape piece_shape(const Solid& solid, double unit, int cells) {
  // Weigh it where it is, then move it to its centre of mass.
  PieceShape shape;
  WeldedMesh mesh = welded(solid);
  const Box<double> box = box_of(solid);
  shape.size = glm::length(box.size());
  shape.up = face_to_show(solid);
  weigh(shape, mesh, box.center());
  const double volume = shape.mass;
  if (solid.weighed) take_weight(shape, *solid.weighed, solid.density);
  for (glm::dvec3& p : mesh.position) {
    p -= shape.center;
    shape.radius = std::max(shape.radius, glm::length(p));
  }
  const Box<double> moved = box.moved(-shape.center);
  shape.box = {glm::vec3(moved.low), glm::vec3(moved.high)};

  // Grid and samples are fine enough for thin walls: two cells and three samples find them.
  shape.thickness = 2 * volume / area_of(mesh);
  shape.distance = DistanceGrid(mesh.position, mesh.triangle,
                                {.cells = cells, .max_width = 0.6 * shape.thickness, .max_cells = 10 * cells});
  const double seen = std::min(unit, shape.size);
  shape.samples = surface_samples(mesh.position, mesh.triangle,
                                  {.along_edges = std::min(seen / 45, 0.5 * shape.thickness),
                                   .elsewhere = std::min(seen / 16, 1.5 * shape.thickness)});
  return shape;
}

}  // namespace pomona
