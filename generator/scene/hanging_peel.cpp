#include "generator/scene/hanging_peel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/box.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr double fewest_turns = 1.5;
constexpr int half_planes = 8;                                  // number of half-planes that are tried
constexpr double free_gap = 0.25, held_gap = 1.0, swing = 0.3;  // shares of the strip's width, and of the peel's

/// The parts of a strip that a half-plane from the axis leaves: one for each turn, joined to the next across the
/// half-plane. A part that is joined to itself goes around the axis: there, at an end of the strip, turns are
/// connected.
struct Turns {
  std::vector<double> azimuth;      ///< per vertex: azimuth from the half-plane, in turns, from 0 to 1
  std::vector<std::uint32_t> part;  ///< per vertex: index of its part along the strip, or none
  std::size_t first = 0, last = 0;  ///< the free turns; last is beyond them
  std::size_t free() const { return last - first; }

  /// How often the free turns wind about the axis. A chamber or a sepal that a half-plane only divides winds less than
  /// once: one part ends at the half-plane, where the other begins.
  double wound() const {
    double low = std::numeric_limits<double>::max(), high = 0;
    for (std::size_t v = 0; v < part.size(); ++v) {
      if (part[v] == none || part[v] < first || part[v] >= last) continue;
      low = std::min(low, part[v] + azimuth[v]);
      high = std::max(high, part[v] + azimuth[v]);
    }
    return std::max(high - low, 0.0);
  }
};

/// A link from each part to the one after it; nothing if the parts make no chain.
class TurnChain {
 public:
  explicit TurnChain(std::size_t count) : next_(count, none), previous_(count, none), closed_(count, 0) {}

  void link(std::uint32_t from, std::uint32_t to) {
    if (from == to) {
      closed_[from] = 1;
      return;
    }
    if ((next_[from] != none && next_[from] != to) || (previous_[to] != none && previous_[to] != from))
      branches_ = true;
    next_[from] = to;
    previous_[to] = from;
  }

  /// The parts of the longest chain, in order; none if parts branch or form a ring.
  std::vector<std::uint32_t> longest() const {
    std::vector<std::uint32_t> best;
    for (std::uint32_t start = 0; start < next_.size() && !branches_; ++start) {
      if (previous_[start] != none) continue;
      std::vector<std::uint32_t> chain;
      for (std::uint32_t part = start; part != none; part = next_[part]) chain.push_back(part);
      if (chain.size() > best.size()) best = std::move(chain);
    }
    return best;
  }

  bool is_closed(std::uint32_t part) const { return closed_[part] != 0; }

 private:
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint8_t> closed_;
  bool branches_ = false;
};

/// \param azimuth of each vertex, turns.
/// \param half_plane its azimuth, turns.
Turns turns_of(std::span<const double> azimuth, std::span<const glm::uvec3> triangles, double half_plane) {
  Turns turns;
  for (const double turn : azimuth) turns.azimuth.push_back(turn - half_plane - std::floor(turn - half_plane));

  // Joins vertices that the half-plane does not separate.
  DisjointSets sets(azimuth.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> across;
  for (const glm::uvec3& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      const double step = turns.azimuth[b] - turns.azimuth[a];
      if (std::fabs(step) <= 0.5)
        sets.join(a, b);
      else
        across.emplace_back(step < 0 ? a : b, step < 0 ? b : a);
    }
  }

  // Orders the parts into a chain.
  TurnChain links(azimuth.size());
  for (const auto& [before, after] : across) links.link(sets.root(before), sets.root(after));
  const std::vector<std::uint32_t> chain = links.longest();
  std::vector<std::uint32_t> place(azimuth.size(), none);
  for (std::size_t i = 0; i < chain.size(); ++i) place[chain[i]] = static_cast<std::uint32_t>(i);
  for (std::uint32_t v = 0; v < azimuth.size(); ++v) turns.part.push_back(place[sets.root(v)]);
  turns.last = chain.size();
  while (turns.first < turns.last && links.is_closed(chain[turns.first])) ++turns.first;
  while (turns.first < turns.last && links.is_closed(chain[turns.last - 1])) --turns.last;
  for (std::size_t i = turns.first; i < turns.last; ++i)
    if (links.is_closed(chain[i])) turns.last = turns.first;
  return turns;
}

/// Whether the piece has vertices on all sides of the axis.
bool surrounds_axis(std::span<const double> azimuth) {
  std::array<bool, 8> octant{};
  for (const double turn : azimuth) octant[static_cast<std::size_t>(8 * (turn - std::floor(turn))) % 8] = true;
  return std::all_of(octant.begin(), octant.end(), [](bool there) { return there; });
}

/// Uses the half-plane that leaves most free turns; nothing if they do not wind about the axis.
Turns max_turns(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangles) {
  std::vector<double> azimuth;
  for (const glm::vec3& p : position) azimuth.push_back(reproducible::atan2(p.z, p.x) / (2 * pi));
  Turns best;
  if (!surrounds_axis(azimuth)) return best;
  for (int i = 0; i < half_planes; ++i) {
    Turns turns = turns_of(azimuth, triangles, static_cast<double>(i) / half_planes);
    if (turns.free() > best.free() && turns.wound() >= fewest_turns) best = std::move(turns);
  }
  return best;
}

/// The position of each vertex along the strip, in free turns, clamped to their ends. Vertices that are not joined to
/// the strip follow their nearest vertex.
/// \param first the vertex that represents all at its place; others have no position along the strip.
std::vector<double> places_along(const Turns& turns, std::span<const glm::vec3> position,
                                 std::span<const std::uint32_t> first) {
  std::vector<double> along(position.size(), -1);
  std::vector<std::uint32_t> strip, strays;
  for (std::uint32_t v = 0; v < position.size(); ++v) {
    if (turns.part[v] == none) {
      if (first[v] == v) strays.push_back(v);
      continue;
    }
    strip.push_back(v);
    const double turn = turns.part[v] + turns.azimuth[v] - static_cast<double>(turns.first);
    along[v] = std::clamp(turn, 0.0, static_cast<double>(turns.free()));
  }
  for (const std::uint32_t v : strays) {
    const auto distance = [&](std::uint32_t w) { return glm::distance(position[w], position[v]); };
    const auto nearer = [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); };
    along[v] = along[*std::min_element(strip.begin(), strip.end(), nearer)];
  }
  return along;
}

/// The displacement along the strip, for each turn and fraction of one.
class Hang {
 public:
  Hang(double turns, double width, double radius) : turns_(turns), width_(width), radius_(radius) {}

  /// \param turn from the free end.
  glm::dvec3 way(double turn) const {
    const double share = turn / turns_, out = 1 - share;
    const double height = width_ * turns_ * (free_gap * share + 0.5 * (held_gap - free_gap) * share * share);
    return {swing * radius_ * out * out, height, 0.5 * swing * radius_ * out * out * out};
  }

  /// Its slope, metres per turn.
  glm::dvec3 slope(double turn) const {
    const double share = turn / turns_, out = 1 - share;
    const double height = width_ * (free_gap + (held_gap - free_gap) * share);
    return {-2 * swing * radius_ * out / turns_, height, -1.5 * swing * radius_ * out * out / turns_};
  }

 private:
  double turns_, width_, radius_;
};

/// Whether the strip rises as its azimuth grows.
bool is_rising(std::span<const glm::vec3> position, std::span<const double> along, double middle) {
  double low = 0, high = 0, low_count = 0, high_count = 0;
  for (std::size_t v = 0; v < position.size(); ++v) {
    (along[v] < middle ? low : high) += position[v].y;
    (along[v] < middle ? low_count : high_count) += 1;
  }
  return high * low_count > low * high_count;
}

/// The normal of a sheared surface: places move by `slope` for each turn about the axis.
glm::vec3 sheared(const glm::vec3& normal, const glm::vec3& at, const glm::dvec3& slope) {
  const double squared = glm::dot(glm::dvec2(at.x, at.z), glm::dvec2(at.x, at.z));
  if (!(squared > 0)) return normal;
  const glm::dvec3 turning = glm::dvec3(-at.z, 0, at.x) / (2 * pi * squared);
  const double stretched = std::max(0.2, 1 + glm::dot(turning, slope));
  const glm::dvec3 turned = glm::dvec3(normal) - turning * (glm::dot(slope, glm::dvec3(normal)) / stretched);
  const double length = glm::length(turned);
  return length > 0 ? glm::vec3(turned / length) : normal;
}

}  // namespace

std::optional<Solid> hanging_peel(const Solid& solid) {
  // A piece without a cut is not a peel.
  if (std::all_of(solid.mesh.cut_face.begin(), solid.mesh.cut_face.end(), [](std::int32_t face) { return face < 0; }))
    return std::nullopt;
  const std::vector<std::uint32_t> first = weld(solid.mesh.position);
  const std::vector<glm::uvec3> triangles = welded_triangles(first, solid.mesh.triangle);
  const Turns turns = max_turns(solid.mesh.position, triangles);
  if (turns.free() == 0) return std::nullopt;

  // Vertices at one place move alike, as the first of them.
  const double count = static_cast<double>(turns.free());
  const std::vector<double> of_welded = places_along(turns, solid.mesh.position, first);
  std::vector<double> along;
  for (const std::uint32_t v : first) along.push_back(of_welded[v]);
  const bool rises = is_rising(solid.mesh.position, along, 0.5 * count);

  Box<float> box;
  for (const glm::vec3& p : solid.mesh.position) box.add(p);
  const glm::dvec3 size(box.size());
  const Hang hang(count, size.y / count, 0.25 * (size.x + size.z));
  Solid hung = solid;
  for (std::size_t v = 0; v < along.size(); ++v) {
    const double turn = rises ? along[v] : count - along[v];
    hung.mesh.position[v] = glm::vec3(glm::dvec3(solid.mesh.position[v]) + hang.way(turn));
    if (turn <= 0 || turn >= count) continue;
    hung.mesh.normal[v] =
        sheared(solid.mesh.normal[v], solid.mesh.position[v], (rises ? 1.0 : -1.0) * hang.slope(turn));
  }
  hung.weighed.reset();
  hung.section_colors.reset();
  return hung;
}

}  // namespace pomona
