#include "generator/cut/stray_bits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/triangle_tree.h"

namespace pomona {

namespace {

std::vector<std::uint32_t> own_homes(std::size_t count) {
  std::vector<std::uint32_t> home(count);
  std::iota(home.begin(), home.end(), 0u);
  return home;
}

bool is_empty(const CutPiece& piece) { return piece.triangle.empty() && piece.caps.empty(); }

/// The corners of skin and cut faces, some more than once.
std::vector<glm::vec3> corners(const CutPiece& piece, const CrossSection& section) {
  std::vector<glm::vec3> all = piece.position;
  for (const CutPiece::CapTriangle& cap : piece.caps) {
    const glm::uvec3& t = section.triangle[cap.triangle];
    for (int k = 0; k < 3; ++k) all.push_back(section.position[t[k]]);
  }
  return all;
}

/// Square of the least distance between two corners; infinite if it is more than `reach`.
double nearest(const std::vector<glm::vec3>& bit, const std::vector<glm::vec3>& home, double reach) {
  Box<double> near;
  for (const glm::vec3& p : bit) near.add(glm::dvec3(p));
  near.low -= reach;
  near.high += reach;
  double min = reach * reach;
  bool found = false;
  for (const glm::vec3& q : home) {
    const glm::dvec3 place(q);
    if (!glm::all(glm::greaterThanEqual(place, near.low)) || !glm::all(glm::lessThanEqual(place, near.high))) continue;
    for (const glm::vec3& p : bit) {
      const glm::dvec3 way = glm::dvec3(p) - place;
      const double square = glm::dot(way, way);
      if (square <= min) min = square, found = true;
    }
  }
  return found ? min : std::numeric_limits<double>::infinity();
}

/// Works on the pieces of one cell, the largest first.
void find_homes(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                const CrossSection& section, double largest_bit, double reach, std::vector<std::uint32_t>& home) {
  std::size_t homes = 1;
  while (homes < here.size() && pieces[here[homes]].volume > largest_bit) ++homes;
  if (homes == here.size()) return;
  std::vector<std::vector<glm::vec3>> places;
  for (std::size_t h = 0; h < homes; ++h) places.push_back(corners(pieces[here[h]], section));
  for (std::size_t b = homes; b < here.size(); ++b) {
    const std::vector<glm::vec3> bit = corners(pieces[here[b]], section);
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t h = 0; h < homes; ++h) {
      const double square = nearest(bit, places[h], reach);
      if (square < min) min = square, home[here[b]] = here[h];
    }
  }
}

bool is_held(const CutPiece& piece, std::span<const int> held_parts) {
  const auto is_of_these = [&](std::int32_t part) {
    return std::binary_search(held_parts.begin(), held_parts.end(), part);
  };
  return !piece.part.empty() && std::all_of(piece.part.begin(), piece.part.end(), is_of_these);
}

/// Two pieces of a cell, by their place in it.
struct NearPieces {
  double distance = 0;
  std::uint32_t a = 0, b = 0;
};

/// Skin and cut faces.
TriangleTree tree_of(const CutPiece& piece, const CrossSection& section) {
  std::vector<glm::vec3> position = piece.position;
  std::vector<glm::uvec3> triangle = piece.triangle;
  for (const CutPiece::CapTriangle& cap : piece.caps) {
    const glm::uvec3& t = section.triangle[cap.triangle];
    const auto first = static_cast<std::uint32_t>(position.size());
    for (int k = 0; k < 3; ++k) position.push_back(section.position[t[k]]);
    triangle.emplace_back(first, first + 1, first + 2);
  }
  return {position, triangle};
}

/// All pairs of pieces within reach of which one is held, the nearest first.
std::vector<NearPieces> near_held(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                                  const CrossSection& section, const std::vector<std::uint8_t>& held, double reach) {
  // Leaves are thin and their triangles large, so distances between corners would be far too long.
  std::vector<TriangleTree> trees;
  for (const std::uint32_t piece : here) trees.push_back(tree_of(pieces[piece], section));
  std::vector<NearPieces> near;
  for (std::uint32_t a = 0; a < here.size(); ++a) {
    for (std::uint32_t b = a + 1; b < here.size(); ++b) {
      if (held[a] == 0 && held[b] == 0) continue;
      const ClosestPair pair = closest(trees[a], trees[b], glm::dvec3(0), reach);
      if (std::isfinite(pair.distance)) near.push_back({pair.distance, a, b});
    }
  }
  std::sort(near.begin(), near.end(), [](const NearPieces& l, const NearPieces& r) {
    return std::tuple(l.distance, l.a, l.b) < std::tuple(r.distance, r.a, r.b);
  });
  return near;
}

/// Sets of pieces with corners in one cell of a grid whose cells are narrower than the reach: those are within reach.
/// Most leaves of a head are found so, without looking for their distance.
DisjointSets joined_by_corners(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                               const CrossSection& section, double reach) {
  const double width = 0.5 * reach;  // across its corners a cell measures 0.87 of the reach
  DisjointSets sets(here.size());
  using GridCell = std::array<double, 3>;
  std::map<GridCell, std::uint32_t> first;  // with a corner there
  for (std::uint32_t i = 0; i < here.size(); ++i) {
    std::optional<GridCell> last;  // the next corner lies in the same one in most cases
    const auto see = [&](const glm::vec3& p) {
      const glm::dvec3 at = glm::floor(glm::dvec3(p) / width);
      const GridCell cell{at.x, at.y, at.z};
      if (last == cell) return;
      last = cell;
      sets.join(first.try_emplace(cell, i).first->second, i);
    };
    const CutPiece& piece = pieces[here[i]];
    for (const glm::uvec3& t : piece.triangle)
      for (int k = 0; k < 3; ++k) see(piece.position[t[k]]);
    for (const CutPiece::CapTriangle& cap : piece.caps)
      for (int k = 0; k < 3; ++k) see(section.position[section.triangle[cap.triangle][k]]);
  }
  return sets;
}

/// Sets of pieces that lie against each other, directly or by others.
DisjointSets joined_within(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                           const CrossSection& section, double reach) {
  DisjointSets sets = joined_by_corners(pieces, here, section, reach);
  std::vector<std::optional<TriangleTree>> trees(here.size());
  const auto tree = [&](std::uint32_t i) -> const TriangleTree& {
    if (!trees[i]) trees[i] = tree_of(pieces[here[i]], section);
    return *trees[i];
  };
  for (std::uint32_t a = 0; a < here.size(); ++a) {
    for (std::uint32_t b = a + 1; b < here.size(); ++b) {
      if (sets.root(a) == sets.root(b)) continue;
      if (std::isfinite(closest(tree(a), tree(b), glm::dvec3(0), reach).distance)) sets.join(a, b);
    }
  }
  return sets;
}

/// Per piece of one cell, the home: several pieces that are not held take the held ones nearest to them.
std::vector<std::uint32_t> nearest_homes(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                                         const CrossSection& section, const std::vector<std::uint8_t>& held,
                                         double reach) {
  DisjointSets sets(here.size());
  std::vector<std::uint32_t> home_of_set = own_homes(here.size());  // the largest, or the one that is not held
  for (const NearPieces& pair : near_held(pieces, here, section, held, reach)) {
    const std::uint32_t a = home_of_set[sets.root(pair.a)], b = home_of_set[sets.root(pair.b)];
    if (a == b || (held[a] == 0 && held[b] == 0)) continue;
    sets.join(a, b);
    home_of_set[sets.root(a)] = held[a] != held[b] ? (held[a] == 0 ? a : b) : std::min(a, b);
  }
  std::vector<std::uint32_t> home(here.size());
  for (std::uint32_t i = 0; i < here.size(); ++i) home[i] = home_of_set[sets.root(i)];
  return home;
}

/// The same where at most one piece is not held: it takes all that hangs together with it, whatever is nearest.
std::vector<std::uint32_t> joint_homes(DisjointSets sets, const std::vector<std::uint8_t>& held) {
  std::vector<std::uint32_t> home(held.size());
  for (std::uint32_t i = 0; i < home.size(); ++i) home[i] = sets.root(i);
  const auto loose = std::find(held.begin(), held.end(), 0);
  if (loose == held.end()) return home;
  const auto taker = static_cast<std::uint32_t>(loose - held.begin());
  const std::uint32_t of_taker = home[taker];
  std::replace(home.begin(), home.end(), of_taker, taker);
  return home;
}

/// Works on the pieces of one cell, the largest first.
void hold_together(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                   const CrossSection& section, std::span<const int> held_parts, double reach,
                   std::vector<std::uint32_t>& home) {
  std::vector<std::uint8_t> held;
  for (const std::uint32_t piece : here) held.push_back(is_held(pieces[piece], held_parts) ? 1 : 0);
  if (std::find(held.begin(), held.end(), 1) == held.end()) return;
  const std::vector<std::uint32_t> found = std::count(held.begin(), held.end(), 0) > 1
                                               ? nearest_homes(pieces, here, section, held, reach)
                                               : joint_homes(joined_within(pieces, here, section, reach), held);
  for (std::uint32_t i = 0; i < here.size(); ++i) home[here[i]] = here[found[i]];
}

/// The pieces that are not empty, cell by cell, the largest first.
std::vector<std::vector<std::uint32_t>> by_cell(const std::vector<CutPiece>& pieces,
                                                const std::vector<std::uint32_t>& cell) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    if (!is_empty(pieces[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cell[a] != cell[b] ? cell[a] < cell[b] : pieces[a].volume > pieces[b].volume;
  });
  std::vector<std::vector<std::uint32_t>> cells;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || cell[order[i]] != cell[order[i - 1]]) cells.emplace_back();
    cells.back().push_back(order[i]);
  }
  return cells;
}

double volume_of_all(const std::vector<CutPiece>& pieces) {
  double whole = 0;
  for (const CutPiece& piece : pieces) whole += piece.volume;
  return whole;
}

}  // namespace

std::vector<std::uint32_t> homes_of_bits(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& cell,
                                         const CrossSection& section, const StrayBitOptions& options) {
  std::vector<std::uint32_t> home = own_homes(pieces.size());
  const double whole = volume_of_all(pieces);
  if (!(whole > 0)) return home;
  for (const std::vector<std::uint32_t>& here : by_cell(pieces, cell))
    find_homes(pieces, here, section, options.largest * whole, options.reach * reproducible::cbrt(whole), home);
  return home;
}

std::vector<std::uint32_t> homes_of_held(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& cell,
                                         const CrossSection& section, std::span<const int> held_parts, double reach) {
  std::vector<std::uint32_t> home = own_homes(pieces.size());
  const double whole = volume_of_all(pieces);
  if (!(whole > 0) || held_parts.empty()) return home;
  for (const std::vector<std::uint32_t>& here : by_cell(pieces, cell))
    hold_together(pieces, here, section, held_parts, reach * reproducible::cbrt(whole), home);
  return home;
}

}  // namespace pomona
