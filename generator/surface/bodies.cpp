#include "generator/surface/bodies.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/surface/shell_geometry.h"

namespace pomona {

namespace {

class BodyFinder {
 public:
  explicit BodyFinder(const DiffusionSurfaces& surfaces)
      : surfaces_(surfaces),
        shells_(find_shells(surfaces)),
        shell_(measured_shells(surfaces, shells_)),
        lone_(shell_.size(), 0) {}

  Bodies find() {
    const std::vector<std::size_t> outer = outer_shells();
    number_bodies(outer);
    add_warnings();
    return std::move(bodies_);
  }

 private:
  /// For each shell its outer shell: itself, or for a cavity wall the smallest shell around it.
  std::vector<std::size_t> outer_shells() {
    std::vector<std::size_t> outer(shell_.size()), solids, walls;
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      outer[s] = s;
      if (shell_[s].volume > 0) solids.push_back(s);
      if (shell_[s].volume < 0) walls.push_back(s);
    }
    if (walls.empty()) return outer;
    Containment containment(surfaces_, shell_, solids);
    for (const std::size_t wall : walls) {
      const std::optional<std::size_t> around = containment.smallest_around(wall);
      outer[wall] = around.value_or(wall);
      lone_[wall] = around ? 0 : 1;
    }
    return outer;
  }

  void number_bodies(const std::vector<std::size_t>& outer) {
    std::vector<std::int32_t> body(shell_.size(), Bodies::none);
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      if (body[outer[s]] == Bodies::none) {
        body[outer[s]] = static_cast<std::int32_t>(bodies_.bodies.size());
        bodies_.bodies.emplace_back();
      }
      body[s] = body[outer[s]];
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
  }

  void add_warnings() {
    bodies_.warnings = surfaces_.notes;
    for (const std::int32_t s : shells_.open_surfaces) {
      const std::string& name = surfaces_.surface_names[static_cast<std::size_t>(s)];
      bodies_.warnings.push_back("surface \"" + name + "\" is open: pieces will be open there");
    }
    bool has_boundary = false;
    for (std::size_t t = 0; t < surfaces_.triangle.size() && !has_boundary; ++t)
      has_boundary = surfaces_.is_boundary(t);
    if (!has_boundary)
      bodies_.warnings.push_back(
          "no surface has a hidden side: nothing faces air, and there is no skin to show or to cut");
    const std::vector<std::int32_t> lone = surfaces_of_lone_walls();
    if (lone.empty() && encloses_nothing())
      bodies_.warnings.push_back("its closed surfaces enclose no volume: nothing of it is solid");
    for (const std::int32_t s : lone)
      bodies_.warnings.push_back("surface \"" + surfaces_.surface_names[static_cast<std::size_t>(s)] +
                                 "\": a cavity wall lies in no skin, so nothing of it is solid: its hidden side faces "
                                 "inwards. Hide its other side, or turn it (a [[mesh]] by flip)");
  }

  /// True of closed surfaces that are flat, or as good as flat for their size.
  bool encloses_nothing() const {
    double volume = 0;
    for (const Bodies::Body& b : bodies_.bodies) {
      if (!b.closed) return false;
      volume += b.volume;
    }
    const double size = glm::length(glm::dvec3(bounds_of(surfaces_).size()));
    return !bodies_.bodies.empty() && volume <= 1e-9 * size * size * size;
  }

  /// The surfaces of the first triangles of these shells, in the order of shells, each once.
  std::vector<std::int32_t> surfaces_of_lone_walls() const {
    std::vector<std::int32_t> lone;
    std::vector<std::uint8_t> seen(shell_.size(), 0);
    for (std::size_t t = 0; t < surfaces_.triangle_count(); ++t) {
      if (shells_.of_triangle[t] == Shells::none) continue;
      const auto s = static_cast<std::size_t>(shells_.of_triangle[t]);
      if (std::exchange(seen[s], std::uint8_t{1}) != 0 || lone_[s] == 0) continue;
      if (std::find(lone.begin(), lone.end(), surfaces_.surface[t]) == lone.end()) lone.push_back(surfaces_.surface[t]);
    }
    return lone;
  }

  const DiffusionSurfaces& surfaces_;
  Shells shells_;
  std::vector<Shell> shell_;
  std::vector<std::uint8_t> lone_;  ///< per shell: a cavity wall in no skin
  Bodies bodies_;
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
