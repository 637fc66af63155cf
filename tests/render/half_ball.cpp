#include "tests/render/half_ball.h"

#include <utility>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona::named {

namespace {

class Builder {
 public:
  std::uint32_t add(const glm::vec3& p, const glm::vec3& n, const Color& c) {
    solid_.mesh.position.push_back(p);
    solid_.mesh.normal.push_back(n);
    solid_.mesh.color.push_back(c);
    solid_.mesh.part.push_back(0);
    return static_cast<std::uint32_t>(solid_.mesh.position.size() - 1);
  }

  void triangle(const glm::uvec3& t, int cut_face) {
    solid_.mesh.triangle.push_back(t);
    solid_.mesh.cut_face.push_back(cut_face);
    solid_.mesh.surface.push_back(cut_face < 0 ? 0 : -1);
  }

  /// Adds a cap from the latitude `from` (quarter turns) to the north pole; returns the first vertex of the first ring.
  void cap(int around, int up, double from, double sign) {
    const auto ring = [&](int i, int j) {
      const double a = 2 * pi * i / around, e = from + (0.5 * pi - from) * j / up;
      return glm::vec3(reproducible::cos(a) * reproducible::cos(e), sign * reproducible::sin(e),
                       -reproducible::sin(a) * reproducible::cos(e));
    };
    const auto first = static_cast<std::uint32_t>(solid_.mesh.position.size());
    for (int j = 0; j < up; ++j) {
      for (int i = 0; i < around; ++i) add(ring(i, j), ring(i, j), {0, 1, 0});
    }
    const auto pole = add({0, sign, 0}, {0, sign, 0}, {0, 1, 0});
    const auto id = [&](int i, int j) { return first + static_cast<std::uint32_t>(j * around + i % around); };
    const auto outward = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangle(sign > 0 ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b), -1);
    };
    for (int j = 0; j < up; ++j) {
      for (int i = 0; i < around; ++i) {
        if (j + 1 < up) {
          outward(id(i, j), id(i + 1, j), id(i + 1, j + 1));
          outward(id(i, j), id(i + 1, j + 1), id(i, j + 1));
        } else {
          outward(id(i, j), id(i + 1, j), pole);
        }
      }
    }
  }

  Solid take() {
    solid_.own_look().part_names = {"all"};
    return std::move(solid_);
  }

 private:
  Solid solid_;
};

}  // namespace

Solid half_ball(int around, int up) {
  Builder builder;
  builder.cap(around, up, 0, 1);
  const auto center = builder.add({0, 0, 0}, {0, -1, 0}, {0.5f, 0, 0});
  const std::uint32_t first = center + 1;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * pi * i / around;
    const glm::vec3 p(reproducible::cos(a), 0, -reproducible::sin(a));
    builder.add(p, {0, -1, 0}, {0.5f + 0.5f * p.x, 0, 0});
  }
  for (int i = 0; i < around; ++i) {
    const auto next = static_cast<std::uint32_t>((i + 1) % around);
    builder.triangle({center, first + next, first + static_cast<std::uint32_t>(i)}, 0);
  }
  return builder.take();
}

Solid ball(int around, int up) {
  Builder builder;
  builder.cap(around, up, 0, 1);
  builder.cap(around, up, 0, -1);
  return builder.take();
}

Solid split_plate() {
  Builder builder;
  for (const float side : {-1.0f, 1.0f}) {
    const Color color = side < 0 ? Color(0, 0, 1) : Color(1, 0, 0);
    const auto a = builder.add({side, 0, -0.5f}, {0, -1, 0}, color), b = builder.add({0, 0, -0.5f}, {0, -1, 0}, color),
               c = builder.add({0, 0, 0.5f}, {0, -1, 0}, color), d = builder.add({side, 0, 0.5f}, {0, -1, 0}, color);
    builder.triangle(side < 0 ? glm::uvec3(a, b, c) : glm::uvec3(a, c, b), 0);
    builder.triangle(side < 0 ? glm::uvec3(a, c, d) : glm::uvec3(a, d, c), 0);
  }
  return builder.take();
}

Solid without_cut_faces(const Solid& solid) {
  Solid skin = solid;
  skin.mesh.triangle.clear(), skin.mesh.cut_face.clear(), skin.mesh.surface.clear();
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    if (solid.mesh.cut_face[t] >= 0) continue;
    skin.mesh.triangle.push_back(solid.mesh.triangle[t]);
    skin.mesh.cut_face.push_back(-1);
    skin.mesh.surface.push_back(solid.mesh.surface[t]);
  }
  return skin;
}

}  // namespace pomona::named
