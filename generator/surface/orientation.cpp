#include "generator/surface/orientation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/enclosures.h"
#include "generator/surface/shell_geometry.h"
#include "generator/surface/touching_solids.h"
#include "generator/surface/turned_sets.h"

namespace pomona {

namespace {

class Orienter {
 public:
  Orienter(DiffusionSurfaces surfaces, const std::vector<std::uint8_t>& may_turn) : may_turn_(may_turn) {
    result_.surfaces = std::move(surfaces);
  }

  Oriented result() {
    if (std::none_of(may_turn_.begin(), may_turn_.end(), [](std::uint8_t may) { return may != 0; }))
      return std::move(result_);
    find_turnable();
    turn_alike();
    turn_touching();
    turn_shells();
    leave_out_twins();
    return std::move(result_);
  }

 private:
  DiffusionSurfaces& surfaces() { return result_.surfaces; }

  void turn(std::size_t triangle) {
    for (glm::uvec3* t : {&surfaces().triangle[triangle], &turnable_[triangle]}) std::swap(t->y, t->z);
  }

  glm::dvec3 place(std::size_t triangle) {
    glm::dvec3 sum(0);
    for (int k = 0; k < 3; ++k) sum += glm::dvec3(surfaces().position[surfaces().triangle[triangle][k]]);
    return sum / 3.0;
  }

  void find_turnable() {
    turnable_ = find_shells(surfaces()).air_facing;
    for (std::size_t i = 0; i < turnable_.size(); ++i)
      if (may_turn_[i] == 0 || !surfaces().is_boundary(i)) turnable_[i] = glm::uvec3(0);
  }

  // ---- Triangles of a shell ----

  /// Two triangles that run along their edge in the same direction face opposite ways; the smaller set turns.
  void turn_alike() {
    TurnedSets sets(turnable_.size());
    std::vector<std::uint32_t> one_sided;
    bool differ = false;
    for_each_edge(sorted_half_edges(turnable_), [&](std::span<const HalfEdge> edge) {
      if (edge.size() != 2) return;
      const bool against = edge[0].forward == edge[1].forward;
      differ = differ || against;
      if (!sets.join(edge[0].triangle, edge[1].triangle, against)) one_sided.push_back(edge[0].triangle);
    });
    if (!differ) return;
    if (!one_sided.empty()) {
      const std::uint32_t t = one_sided.front();
      result_.undecided.push_back({surfaces().surface[t], place(t), "it has one side only, like a Moebius strip"});
      return;
    }
    std::vector<std::int64_t> more_turned(turnable_.size(), 0);
    for (std::uint32_t i = 0; i < turnable_.size(); ++i) {
      const TurnedSets::Root root = sets.root(i);
      more_turned[root.root] += root.turned != 0 ? 1 : -1;
    }
    for (std::uint32_t i = 0; i < turnable_.size(); ++i) {
      const TurnedSets::Root root = sets.root(i);
      if ((root.turned != 0) != (more_turned[root.root] > 0)) turn(i);
    }
  }

  void turn_touching() {
    const std::vector<std::uint8_t> turns = turns_where_solids_touch(surfaces(), turnable_);
    for (std::size_t i = 0; i < turns.size(); ++i)
      if (turns[i] != 0) turn(i);
  }

  // ---- Shells ----

  void turn_shells() {
    const Shells shells = find_shells(surfaces());
    const std::vector<Shell> measured = measured_shells(surfaces(), shells);
    const Enclosures closed = closed_ones(measured);
    std::vector<std::vector<std::uint32_t>> triangles(measured.size());
    std::vector<std::uint8_t> may_turn(measured.size(), 1);
    is_twin_.assign(shells.of_triangle.size(), 0);
    for (std::uint32_t i = 0; i < shells.of_triangle.size(); ++i) {
      if (shells.of_triangle[i] == Shells::none) continue;
      const auto s = static_cast<std::size_t>(shells.of_triangle[i]);
      triangles[s].push_back(i);
      if (may_turn_[i] == 0) may_turn[s] = 0;
    }
    std::vector<std::string> faults(measured.size());
    is_twin_shell_.assign(measured.size(), 0);
    for (const std::size_t s : largest_first(measured)) {
      if (may_turn[s] == 0) continue;
      faults[s] = measured[s].closed ? turn_closed(s, measured, closed, triangles[s]) : fault_of_open(measured[s]);
    }
    for (std::size_t s = 0; s < measured.size(); ++s) {
      if (faults[s].empty()) continue;
      const std::uint32_t first = triangles[s].front();
      result_.undecided.push_back({surfaces().surface[first], place(first), faults[s]});
    }
  }

  /// What lies around a shell comes before it.
  static std::vector<std::size_t> largest_first(const std::vector<Shell>& measured) {
    std::vector<std::size_t> order(measured.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::fabs(measured[a].volume) > std::fabs(measured[b].volume);
    });
    return order;
  }

  Enclosures closed_ones(const std::vector<Shell>& measured) {
    std::vector<Enclosures::Triangle> triangles;
    for (std::uint32_t s = 0; s < measured.size(); ++s) {
      if (!measured[s].closed) continue;
      for (const glm::uvec3& t : measured[s].triangles) {
        Enclosures::Triangle triangle{.corner = {}, .mesh = s};
        for (int k = 0; k < 3; ++k)
          triangle.corner[static_cast<std::size_t>(k)] = glm::dvec3(surfaces().position[t[k]]);
        triangles.push_back(triangle);
      }
    }
    return Enclosures(std::move(triangles));
  }

  /// Turns the shell if necessary; returns why it cannot be decided, if so.
  std::string turn_closed(std::size_t s, const std::vector<Shell>& measured, const Enclosures& closed,
                          const std::vector<std::uint32_t>& triangles) {
    const Shell& shell = measured[s];
    if (shell.volume == 0) return {};
    const Samples inside = samples_of(s, measured, closed);
    const int all = inside.even + inside.odd;
    if (all > 0 && inside.in_twin == all) {
      is_twin_shell_[s] = 1;
      for (const std::uint32_t t : triangles) is_twin_[t] = 1;
      return {};
    }
    // Most of its points must agree, so that shells that touch others, or sink in a little, are decided.
    const bool is_odd = 4 * inside.odd >= 3 * all, is_even = 4 * inside.even >= 3 * all;
    if (!is_odd && !is_even) return shell.volume > 0 ? std::string() : "it faces inwards and crosses another shell";
    if (is_even == (shell.volume > 0)) return {};
    for (const std::uint32_t t : triangles) turn(t);
    return {};
  }

  /// Points just within a shell: how many lie in an even and in an odd number of other shells, and how many in air but
  /// for an equal shell at the same place.
  struct Samples {
    int even = 0, odd = 0, in_twin = 0;
  };
  Samples samples_of(std::size_t s, const std::vector<Shell>& measured, const Enclosures& closed) {
    const Shell& shell = measured[s];
    Samples count;
    const std::size_t samples = std::min<std::size_t>(16, shell.triangles.size());
    for (std::size_t k = 0; k < samples; ++k) {
      const glm::uvec3& t = shell.triangles[k * shell.triangles.size() / samples];
      const glm::dvec3 a(surfaces().position[t.x]), b(surfaces().position[t.y]), c(surfaces().position[t.z]);
      const glm::dvec3 area = glm::cross(b - a, c - a);
      const double twice = glm::length(area);
      if (!(twice > 0)) continue;
      constexpr double depth = 1e-4;  // depth of the points, as a share of the triangle's size
      const glm::dvec3 inwards = (shell.volume > 0 ? -depth : depth) * area / std::sqrt(twice);
      int others = 0;
      bool has_wall = false;
      for (const auto& [mesh, times] : closed.around((a + b + c) / 3.0 + inwards)) {
        if (mesh == s || times == 0 || is_twin_shell_[mesh] != 0) continue;
        const Size size = size_beside(measured[mesh], shell);
        if (size == Size::larger) ++others;
        if (size == Size::equal && comes_first(mesh, s, measured)) has_wall = true;
      }
      // Of equal shells within a solid the first is the wall of a hollow, and the others fill it.
      if (has_wall && others % 2 == 0) ++count.in_twin;
      if (has_wall && others % 2 == 1) ++others;
      ++(others % 2 == 0 ? count.even : count.odd);
    }
    return count;
  }

  /// A shell that the file has twice is there once.
  void leave_out_twins() {
    if (std::none_of(is_twin_.begin(), is_twin_.end(), [](std::uint8_t twin) { return twin != 0; })) return;
    DiffusionSurfaces& all = surfaces();
    const auto leave_out = [&](auto& values) {
      std::size_t i = 0;
      std::erase_if(values, [&](const auto&) { return is_twin_[i++] != 0; });
    };
    leave_out(all.triangle);
    for (auto* indices : {&all.surface, &all.front_part, &all.back_part, &all.instance})
      if (!indices->empty()) leave_out(*indices);
  }

  /// What lies around a shell encloses more than it.
  enum class Size { smaller, equal, larger };
  static Size size_beside(const Shell& shell, const Shell& other) {
    const double size = std::fabs(shell.volume), own = std::fabs(other.volume);
    if (std::fabs(size - own) <= 1e-9 * own) return Size::equal;
    return size < own ? Size::smaller : Size::larger;
  }

  /// Walls that face inwards in the file come before others.
  static bool comes_first(std::size_t a, std::size_t b, const std::vector<Shell>& measured) {
    return std::pair(measured[a].volume > 0, a) < std::pair(measured[b].volume > 0, b);
  }

  /// A sheet may face either way. A shell that fills much of its box and faces inwards may be an inside-out skin with a
  /// hole.
  static std::string fault_of_open(const Shell& shell) {
    const glm::dvec3 size = shell.bounds.size();
    constexpr double good_part = 0.05;
    return shell.volume < -good_part * size.x * size.y * size.z ? "it is open, and seems to face inwards" : "";
  }

  const std::vector<std::uint8_t>& may_turn_;
  std::vector<glm::uvec3> turnable_;  ///< welded, facing air; those that may not turn collapsed
  std::vector<std::uint8_t> is_twin_shell_;
  std::vector<std::uint8_t> is_twin_;  ///< per triangle: of a shell that is there already
  Oriented result_;
};

}  // namespace

Oriented oriented(DiffusionSurfaces surfaces, const std::vector<std::uint8_t>& may_turn) {
  return Orienter(std::move(surfaces), may_turn).result();
}

}  // namespace pomona
