#include "generator/surface/bodies.h"

#include <algorithm>

#include "generator/base/error.h"
#include "generator/surface/shell_geometry.h"

namespace pomona {

namespace {

class BodyFinder {
 public:
  explicit BodyFinder(const DiffusionSurfaces& surfaces)
      : surfaces_(surfaces), shells_(find_shells(surfaces)), shell_(measured_shells(surfaces, shells_)) {}

  Bodies find() {
    const std::vector<std::size_t> outer = outer_shells();
    number_bodies(outer);
    add_warnings();
    return std::move(bodies_);
  }

 private:
  /// For each shell the outer shell it belongs to: itself, or for a cavity wall the smallest around it.
  std::vector<std::size_t> outer_shells() {
    std::vector<std::size_t> solids;
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      if (shell_[s].volume > 0) solids.push_back(s);
    }
    std::stable_sort(solids.begin(), solids.end(),
                     [&](std::size_t l, std::size_t r) { return shell_[l].volume < shell_[r].volume; });

    std::vector<std::size_t> outer(shell_.size());
    std::size_t walls = 0;
    for (std::size_t s = 0; s < shell_.size(); ++s) {
      outer[s] = s;
      if (shell_[s].volume >= 0) continue;
      // Compares each wall with every solid.
      constexpr std::size_t max_walls = 4096;
      if (++walls > max_walls)
        throw Error(ExitStatus::bad_data, "more than 4096 cavities: surfaces that face inwards and are closed",
                    "flip the surfaces whose back faces air, or leave some out");
      const auto around = std::find_if(solids.begin(), solids.end(), [&](std::size_t solid) {
        return containment_.contains(shell_[solid], shell_[s]);
      });
      if (around != solids.end()) outer[s] = *around;
      if (around == solids.end()) add_lone_wall(s);
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
    for (const std::int32_t s : lone_walls_)
      bodies_.warnings.push_back("surface \"" + surfaces_.surface_names[static_cast<std::size_t>(s)] +
                                 "\": a cavity wall lies in no skin, so nothing of it is solid: its hidden side faces "
                                 "inwards. Hide its other side, or turn it (a [[mesh]] by flip)");
  }

  /// Stores the surface of the shell.
  void add_lone_wall(std::size_t shell) {
    const auto first =
        std::find(shells_.of_triangle.begin(), shells_.of_triangle.end(), static_cast<std::int32_t>(shell));
    const std::int32_t s = surfaces_.surface[static_cast<std::size_t>(first - shells_.of_triangle.begin())];
    if (std::find(lone_walls_.begin(), lone_walls_.end(), s) == lone_walls_.end()) lone_walls_.push_back(s);
  }

  const DiffusionSurfaces& surfaces_;
  Shells shells_;
  std::vector<Shell> shell_;
  Containment containment_{surfaces_};
  Bodies bodies_;
  std::vector<std::int32_t> lone_walls_;  ///< surfaces
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
