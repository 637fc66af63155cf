#include "tests/shapes/shapes.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona::shapes {

namespace {

/// Gives equal points of the grid one common vertex.
class Vertices {
 public:
  std::uint32_t at(const glm::ivec3& key, const glm::dvec3& position) {
    const std::array<int, 3> k{key.x, key.y, key.z};
    const auto [found, is_new] = index_.try_emplace(k, static_cast<std::uint32_t>(positions.size()));
    if (is_new) positions.emplace_back(position);
    return found->second;
  }

  std::vector<glm::vec3> positions;

 private:
  std::map<std::array<int, 3>, std::uint32_t> index_;
};

}  // namespace

Paint skin_paint() {
  Paint paint;
  paint.name = "skin";
  paint.front_hidden = true;
  return paint;
}

DiffusionSurfaces painted(std::vector<glm::vec3> position, std::vector<glm::uvec3> triangle, const Paint& paint) {
  DiffusionSurfaces shape;
  const std::size_t vertices = position.size();
  const std::size_t triangles = triangle.size();
  shape.position = std::move(position);
  shape.front_color.assign(vertices, paint.front);
  shape.back_color.assign(vertices, paint.back);
  shape.blur.assign(vertices, paint.blur);
  shape.front_hidden.assign(vertices, paint.front_hidden ? 1 : 0);
  shape.back_hidden.assign(vertices, paint.back_hidden ? 1 : 0);
  shape.triangle = std::move(triangle);
  shape.surface.assign(triangles, 0);
  shape.front_part.assign(triangles, 0);
  shape.surface_names = {paint.name};
  shape.part_names = {paint.front_part};
  if (paint.back_part != paint.front_part) shape.part_names.push_back(paint.back_part);
  shape.back_part.assign(triangles, static_cast<std::int32_t>(shape.part_names.size()) - 1);
  return shape;
}

DiffusionSurfaces sphere(double radius, int n, const Paint& paint) {
  Vertices vertices;
  std::vector<glm::uvec3> triangles;
  for (int octant = 0; octant < 8; ++octant) {
    const glm::ivec3 sign((octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1, (octant & 4) != 0 ? -1 : 1);
    const bool mirrored = sign.x * sign.y * sign.z < 0;
    const auto vertex = [&](int i, int j) {
      const glm::ivec3 key = sign * glm::ivec3(i, j, n - i - j);
      return vertices.at(key, glm::normalize(glm::dvec3(key)) * radius);
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangles.push_back(mirrored ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        // One statement for each, because vertices are numbered in the order of the calls, and compilers evaluate
        // arguments in different orders.
        const std::uint32_t a = vertex(i, j);
        const std::uint32_t b = vertex(i + 1, j);
        const std::uint32_t c = vertex(i, j + 1);
        add(a, b, c);
        if (i + j < n - 1) add(b, vertex(i + 1, j + 1), c);
      }
    }
  }
  return painted(std::move(vertices.positions), std::move(triangles), paint);
}

DiffusionSurfaces box(const glm::dvec3& low, const glm::dvec3& high, int n, const Paint& paint) {
  Vertices vertices;
  std::vector<glm::uvec3> triangles;
  const auto vertex = [&](const glm::ivec3& key) {
    return vertices.at(key, low + (high - low) * (glm::dvec3(key) / static_cast<double>(n)));
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool positive : {false, true}) {
      const auto corner = [&](int i, int j) {
        glm::ivec3 key(0);
        key[axis] = positive ? n : 0;
        key[(axis + 1) % 3] = positive ? i : j;
        key[(axis + 2) % 3] = positive ? j : i;
        return vertex(key);
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const std::uint32_t a = corner(i, j);
          const std::uint32_t b = corner(i + 1, j);
          const std::uint32_t c = corner(i + 1, j + 1);
          const std::uint32_t d = corner(i, j + 1);
          triangles.emplace_back(a, b, c);
          triangles.emplace_back(a, c, d);
        }
      }
    }
  }
  return painted(std::move(vertices.positions), std::move(triangles), paint);
}

DiffusionSurfaces open_sheet(double size, double height, int n, const Paint& paint) {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      positions.emplace_back(size * (static_cast<double>(j) / n - 0.5), height,
                             size * (0.5 - static_cast<double>(i) / n));
    }
  }
  const auto vertex = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      triangles.emplace_back(vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1));
      triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j));
    }
  }
  return painted(std::move(positions), std::move(triangles), paint);
}

DiffusionSurfaces two_plates(double size, double gap, const Paint& lower, const Paint& upper, int n) {
  return joined(open_sheet(size, -gap / 2, n, lower), open_sheet(size, gap / 2, n, upper));
}

DiffusionSurfaces nested_spheres(double outer, double inner, int n, Paint skin, Paint core) {
  return joined(sphere(outer, n, skin), sphere(inner, n, core));
}

DiffusionSurfaces hollow_ball(double outer, double inner, int n) {
  Paint wall;
  wall.name = "wall";
  wall.front = Color(0.9f, 0.8f, 0.5f);
  wall.back = Color(0.95f, 0.9f, 0.8f);
  wall.front_part = "flesh";
  wall.back_part = "hollow";
  wall.back_hidden = true;
  return joined(sphere(outer, n, skin_paint()), sphere(inner, n, wall));
}

DiffusionSurfaces torus(double major, double minor, int around, int along, const Paint& paint) {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * pi * i / around;
    for (int j = 0; j < along; ++j) {
      const double b = 2 * pi * j / along;
      const double r = major + minor * reproducible::cos(b);
      positions.emplace_back(r * reproducible::cos(a), minor * reproducible::sin(b), -r * reproducible::sin(a));
    }
  }
  const auto vertex = [=](int i, int j) { return static_cast<std::uint32_t>(i % around * along + j % along); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < along; ++j) {
      triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return painted(std::move(positions), std::move(triangles), paint);
}

DiffusionSurfaces moved(DiffusionSurfaces surfaces, const glm::dvec3& by) {
  for (glm::vec3& p : surfaces.position) p = glm::vec3(glm::dvec3(p) + by);
  return surfaces;
}

DiffusionSurfaces tilted(DiffusionSurfaces surfaces) {
  // An orthonormal frame from two vectors in generic directions.
  const glm::dvec3 u = glm::normalize(glm::dvec3(0.61, 0.37, -0.53));
  const glm::dvec3 w = glm::normalize(glm::cross(u, glm::dvec3(0.21, -0.83, 0.47)));
  const glm::dmat3 turn(u, glm::cross(w, u), w);
  for (glm::vec3& p : surfaces.position) p = glm::vec3(turn * glm::dvec3(p));
  return surfaces;
}

DiffusionSurfaces turned_inside_out(DiffusionSurfaces surfaces) {
  for (glm::uvec3& t : surfaces.triangle) std::swap(t.y, t.z);
  std::swap(surfaces.front_color, surfaces.back_color);
  std::swap(surfaces.front_hidden, surfaces.back_hidden);
  std::swap(surfaces.front_part, surfaces.back_part);
  return surfaces;
}

double signed_volume(const DiffusionSurfaces& surfaces) {
  double volume = 0;
  for (const glm::uvec3& t : surfaces.triangle) {
    const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

double area(const DiffusionSurfaces& surfaces) {
  double sum = 0;
  for (const glm::uvec3& t : surfaces.triangle) {
    const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum;
}

}  // namespace pomona::shapes
