#include "generator/surface/bodies.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/shells.h"

namespace pomona {

namespace {

/// One shell by itself, its triangles facing air.
struct Shell {
  std::vector<glm::uvec3> triangles;
  Bounds bounds;
  double volume = 0;  ///< signed: negative for a cavity wall
  bool closed = true;
};

class BodyFinder {
 public:
  explicit BodyFinder(const DiffusionSurfaces& surfaces) : surfaces_(surfaces), shells_(find_shells(surfaces)) {}

  Bodies find() {
    gather_shells();
    const std::vector<std::int32_t> outer = outer_shells();
    number_bodies(outer);
    add_warnings();
    return std::move(bodies_);
  }

 private:
  void gather_shells() {
    shell_.resize(shells_.count());
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      if (shells_.of_triangle[i] == Shells::none) continue;
      shell_[static_cast<std::size_t>(shells_.of_triangle[i])].triangles.push_back(shells_.air_facing[i]);
    }
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      shell_[s].closed = shells_.closed[s] != 0;
      measure(shell_[s]);
    }
  }

  glm::dvec3 at(std::uint32_t vertex) const { return glm::dvec3(surfaces_.position[vertex]); }

  void measure(Shell& shell) const {
    shell.bounds.low = shell.bounds.high = at(shell.triangles.front().x);
    for (const glm::uvec3& t : shell.triangles) {
      for (int k = 0; k < 3; ++k) {
        shell.bounds.low = glm::min(shell.bounds.low, at(t[k]));
        shell.bounds.high = glm::max(shell.bounds.high, at(t[k]));
      }
    }
    const glm::dvec3 center = shell.bounds.center();
    for (const glm::uvec3& t : shell.triangles) {
      shell.volume += glm::dot(at(t.x) - center, glm::cross(at(t.y) - center, at(t.z) - center)) / 6;
    }
  }

  /// For each shell the outer shell it belongs to: itself, or for a cavity wall the smallest around it.
  std::vector<std::int32_t> outer_shells() {
    std::vector<std::int32_t> outer(shell_.size());
    std::size_t walls = 0;
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      outer[s] = static_cast<std::int32_t>(s);
      if (shell_[s].volume >= 0) continue;
      // Each wall is held against every shell around it.
      constexpr std::size_t most_walls = 4096;
      if (++walls > most_walls) throw Error(ExitStatus::bad_data, "more than 4096 cavities");
      outer[s] = smallest_around(s);
    }
    return outer;
  }

  std::int32_t smallest_around(std::size_t wall) const {
    std::size_t best = wall;
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      if (shell_[s].volume <= 0 || !(best == wall || shell_[s].volume < shell_[best].volume)) continue;
      if (contains(shell_[s], shell_[wall])) best = s;
    }
    return static_cast<std::int32_t>(best);
  }

  /// By the mean winding number of some of the wall's triangles, so that touching in places, and rims that do
  /// not close, change nothing.
  bool contains(const Shell& outer, const Shell& wall) const {
    const glm::dvec3 reach = 1e-6 * outer.bounds.size();
    if (glm::any(glm::lessThan(wall.bounds.low, outer.bounds.low - reach)) ||
        glm::any(glm::greaterThan(wall.bounds.high, outer.bounds.high + reach))) {
      return false;
    }
    const std::size_t samples = std::min<std::size_t>(8, wall.triangles.size());
    double sum = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      const glm::uvec3& t = wall.triangles[k * wall.triangles.size() / samples];
      sum += winding_number(outer, (at(t.x) + at(t.y) + at(t.z)) / 3.0);
    }
    return sum > 0.5 * static_cast<double>(samples);
  }

  /// Sum of solid angles [van Oosterom & Strackee 1983] over the full sphere's.
  double winding_number(const Shell& shell, const glm::dvec3& p) const {
    double sum = 0;
    for (const glm::uvec3& t : shell.triangles) {
      const glm::dvec3 a = at(t.x) - p, b = at(t.y) - p, c = at(t.z) - p;
      const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      const double y = glm::dot(a, glm::cross(b, c));
      const double x = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
      if (x != 0 || y != 0) sum += 2 * reproducible::atan2(y, x);
    }
    return sum / (4 * pi);
  }

  void number_bodies(const std::vector<std::int32_t>& outer) {
    std::vector<std::int32_t> body(shell_.size(), Bodies::none);
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      const auto o = static_cast<std::size_t>(outer[s]);
      if (body[o] == Bodies::none) {
        body[o] = static_cast<std::int32_t>(bodies_.bodies.size());
        bodies_.bodies.emplace_back();
      }
      body[s] = body[o];
      Bodies::Body& of = bodies_.bodies[static_cast<std::size_t>(body[s])];
      of.closed = of.closed && shell_[s].closed;
      of.volume += shell_[s].volume;
      ++of.shells;
    }
    for (Bodies::Body& b : bodies_.bodies) b.volume = b.closed ? std::max(0.0, b.volume) : 0;

    bodies_.of_triangle.assign(surfaces_.triangle_count(), Bodies::none);
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      const std::int32_t s = shells_.of_triangle[i];
      if (s != Shells::none) bodies_.of_triangle[i] = body[static_cast<std::size_t>(s)];
    }
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      if (shell_[s].volume < 0 && static_cast<std::size_t>(outer[s]) == s) lone_walls_ = true;
    }
  }

  void add_warnings() {
    for (const std::int32_t s : shells_.open_surfaces) {
      const std::string& name = surfaces_.surface_names[static_cast<std::size_t>(s)];
      bodies_.warnings.push_back("surface \"" + name + "\" is open: pieces will be open there");
    }
    if (lone_walls_) bodies_.warnings.push_back("a cavity wall lies in no skin: its hidden side faces inwards");
  }

  const DiffusionSurfaces& surfaces_;
  Shells shells_;
  std::vector<Shell> shell_;
  Bodies bodies_;
  bool lone_walls_ = false;
};

void check_sides(const DiffusionSurfaces& surfaces) {
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (!surfaces.is_hidden(i, SideOf::front) || !surfaces.is_hidden(i, SideOf::back)) continue;
    const std::string& name = surfaces.surface_names[static_cast<std::size_t>(surfaces.surface[i])];
    throw Error(ExitStatus::bad_data, "surface \"" + name + "\": triangle " + std::to_string(i) + " hides both sides",
                "hide only the side that faces air");
  }
}

}  // namespace

Bodies find_bodies(const DiffusionSurfaces& surfaces) {
  check_sides(surfaces);
  return BodyFinder(surfaces).find();
}

}  // namespace pomona
