#include "tests/shapes/seeded_fruit.h"

#include <cmath>
#include <functional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona::shapes {

namespace {

constexpr double radius = 0.04;  // metres; lengths below are in radii

double sine(double x) { return reproducible::sin(x); }
double cosine(double x) { return reproducible::cos(x); }

glm::dvec3 on_unit_sphere(double polar, double around) {
  return {sine(polar) * cosine(around), cosine(polar), -sine(polar) * sine(around)};
}

double skin_radius(const glm::dvec3& d) {
  const double ribs = sine(5 * reproducible::atan2(-d.z, d.x)) * (1 - d.y * d.y);
  return 1 + 0.03 * ribs + 0.015 * sine(9 * d.x + 4 * d.y) * cosine(7 * d.z);
}

/// The colours of one surface before they vary, and how much they vary.
struct Paint {
  Color front, back;
  float variation = 0;
};

class Builder {
 public:
  /// A closed surface over polar and azimuthal angles, front outside.
  void add_globe(int around, int rings, const Paint& paint, const std::function<glm::dvec3(double, double)>& place) {
    const std::uint32_t top = add_vertex(place(0, 0), paint);
    for (int i = 1; i < rings; ++i) {
      for (int j = 0; j < around; ++j) add_vertex(place(pi * i / rings, 2 * pi * j / around), paint);
    }
    const std::uint32_t bottom = add_vertex(place(pi, 0), paint);
    const auto at = [&](int i, int j) { return top + static_cast<std::uint32_t>(1 + (i - 1) * around + j % around); };
    for (int j = 0; j < around; ++j) {
      add_triangle(top, at(1, j), at(1, j + 1));
      add_triangle(bottom, at(rings - 1, j + 1), at(rings - 1, j));
      for (int i = 1; i + 1 < rings; ++i) {
        add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }

  /// An open sheet over the unit square.
  void add_sheet(int n, const Paint& paint, const std::function<glm::dvec3(double, double)>& place) {
    const auto first = static_cast<std::uint32_t>(surfaces_.vertex_count());
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) add_vertex(place(i / static_cast<double>(n), j / static_cast<double>(n)), paint);
    }
    const auto side = static_cast<std::uint32_t>(n + 1);
    for (std::uint32_t i = 0; i + 1 < side; ++i) {
      for (std::uint32_t j = 0; j + 1 < side; ++j) {
        const std::uint32_t corner = first + i * side + j;
        add_triangle(corner, corner + side, corner + side + 1);
        add_triangle(corner, corner + side + 1, corner + 1);
      }
    }
  }

  /// Triangles added from here on belong to this surface and these parts; to the skin, if its front faces air.
  void begin(const std::string& name, std::int32_t front_part, std::int32_t back_part, bool front_hidden = false) {
    front_hidden_ = front_hidden ? 1 : 0;
    surfaces_.surface_names.push_back(name);
    front_part_ = front_part;
    back_part_ = back_part;
  }

  DiffusionSurfaces finish(std::vector<std::string> part_names) {
    surfaces_.part_names = std::move(part_names);
    surfaces_.blur.assign(surfaces_.vertex_count(), 0);
    surfaces_.back_hidden.assign(surfaces_.vertex_count(), 0);
    return std::move(surfaces_);
  }

  double random() { return random_.uniform(drawn_++); }
  glm::dvec3 random_in_cube() { return {random() - 0.5, random() - 0.5, random() - 0.5}; }

 private:
  std::uint32_t add_vertex(const glm::dvec3& p, const Paint& paint) {
    const double s = sine(7 * p.x) * cosine(5 * p.y - 2 * p.z), t = sine(4 * p.z + 6 * p.y);
    const glm::vec3 grain(random_in_cube() * (16.0 / 255));
    const auto shade = [&](const Color& base, const glm::dvec3& wave) {
      return glm::clamp(base + paint.variation * glm::vec3(wave) + grain, 0.0f, 1.0f);
    };
    surfaces_.position.emplace_back(radius * p);
    surfaces_.front_color.push_back(shade(paint.front, {s, t, -s}));
    surfaces_.front_hidden.push_back(front_hidden_);
    surfaces_.back_color.push_back(shade(paint.back, {t, s, t}));
    return static_cast<std::uint32_t>(surfaces_.vertex_count()) - 1;
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    surfaces_.triangle.emplace_back(a, b, c);
    surfaces_.surface.push_back(static_cast<std::int32_t>(surfaces_.surface_names.size()) - 1);
    surfaces_.front_part.push_back(front_part_);
    surfaces_.back_part.push_back(back_part_);
  }

  DiffusionSurfaces surfaces_;
  std::int32_t front_part_ = 0, back_part_ = 0;
  std::uint8_t front_hidden_ = 0;
  RandomStream random_{{}, "shapes/seeded fruit"};
  std::uint64_t drawn_ = 0;
};

/// A chamber's frame: where it sits and which way it points.
struct Chamber {
  glm::dvec3 middle, outwards, sideways;
  glm::dvec3 place(const glm::dvec3& p) const {
    return middle + 0.24 * p.x * outwards + 0.24 * p.z * sideways + glm::dvec3(0, 0.45 * p.y, 0);
  }
};

/// Thirty places in a chamber, in its unit ball, that keep a distance from each other.
std::vector<glm::dvec3> places_for_seeds(Builder& builder, const Chamber& chamber) {
  std::vector<glm::dvec3> places;
  while (places.size() < 30) {
    const glm::dvec3 q = 2.0 * builder.random_in_cube();
    if (glm::dot(q, q) > 0.5) continue;
    const glm::dvec3 p = chamber.place(q);
    bool is_free = true;
    for (const glm::dvec3& other : places) is_free = is_free && glm::length(other - p) >= 0.085;
    if (is_free) places.push_back(p);
  }
  return places;
}

void add_seed(Builder& builder, const glm::dvec3& middle) {
  const glm::dvec3 axis = glm::normalize(builder.random_in_cube());
  const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.5, 0.8)));
  const glm::dvec3 other = glm::cross(side, axis);
  builder.add_globe(6, 4, {{0.90f, 0.84f, 0.55f}, {0.98f, 0.94f, 0.78f}, 0.06f}, [&](double polar, double around) {
    const glm::dvec3 d = on_unit_sphere(polar, around);
    return middle + 0.042 * d.y * axis + 0.03 * d.x * side + 0.022 * d.z * other;
  });
}

}  // namespace

DiffusionSurfaces seeded_fruit() {
  enum Part : std::int32_t { skin, flesh, gel, seed };
  Builder builder;
  builder.begin("skin", skin, flesh, true);
  builder.add_globe(64, 64, {{0.78f, 0.12f, 0.08f}, {0.90f, 0.35f, 0.24f}, 0.10f}, [](double polar, double around) {
    const glm::dvec3 d = on_unit_sphere(polar, around);
    return d * skin_radius(d);
  });
  builder.begin("wall", flesh, flesh);
  builder.add_globe(40, 30, {{0.92f, 0.47f, 0.31f}, {0.94f, 0.67f, 0.47f}, 0.08f}, [](double polar, double around) {
    const glm::dvec3 d = on_unit_sphere(polar, around);
    return d * (0.86 * (1 + 0.02 * cosine(5 * around) * (1 - d.y * d.y)));
  });

  for (int k = 0; k < 5; ++k) {
    const double angle = 2 * pi * k / 5 + 0.1;
    const glm::dvec3 outwards(cosine(angle), 0, -sine(angle)), sideways(sine(angle), 0, cosine(angle));
    const Chamber chamber{0.5 * outwards, outwards, sideways};
    builder.begin("chamber " + std::to_string(k), flesh, gel);
    builder.add_globe(24, 20, {{0.96f, 0.78f, 0.59f}, {0.47f, 0.71f, 0.24f}, 0.08f}, [&](double polar, double around) {
      const double bumps = 1 + 0.05 * sine(3 * around + k) * sine(polar);
      return chamber.place(on_unit_sphere(polar, around) * glm::dvec3(bumps, 1, bumps));
    });
    builder.begin("seeds " + std::to_string(k), gel, seed);
    for (const glm::dvec3& place : places_for_seeds(builder, chamber)) add_seed(builder, place);
  }

  for (int k = 0; k < 5; ++k) {
    builder.begin("septum " + std::to_string(k), flesh, flesh);
    builder.add_sheet(10, {{0.86f, 0.31f, 0.35f}, {0.71f, 0.24f, 0.16f}, 0}, [&](double s, double t) {
      const double r = 0.2 + 0.58 * s, y = -0.4 + 0.8 * t;
      const double angle = 2 * pi * (k + 0.5) / 5 + 0.1 + 0.05 * sine(6 * y + 3 * r);
      return glm::dvec3(r * cosine(angle), y, -r * sine(angle));
    });
  }
  return builder.finish({"skin", "flesh", "gel", "seed"});
}

std::vector<glm::vec3> points_on_section_of_seeded_fruit(int count) {
  const RandomStream random({}, "shapes/section of seeded fruit");
  const double step = std::sqrt(pi * 0.97 * 0.97 / count);
  const int n = static_cast<int>(1.1 / step) + 1;
  std::vector<glm::vec3> points;
  std::uint64_t drawn = 0;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      const double x = (i + 0.8 * (random.uniform(drawn) - 0.5)) * step;
      const double z = (j + 0.8 * (random.uniform(drawn + 1) - 0.5)) * step;
      drawn += 2;
      const glm::dvec3 p(x, 0.05 + 0.1 * x + 0.03 * z, z);
      if (glm::length(p) < 0.985 * skin_radius(glm::normalize(p))) points.emplace_back(radius * p);
    }
  }
  return points;
}

}  // namespace pomona::shapes
