#include "generator/cut/stray_bits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/triangle_tree.h"

namespace pomona {

namespace {

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

/// Works on the pieces of one cell, the largest first.
void hold_together(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& here,
                   const CrossSection& section, std::span<const int> held_parts, double reach,
                   std::vector<std::uint32_t>& home) {
  std::vector<std::uint8_t> held;
  for (const std::uint32_t piece : here) held.push_back(is_held(pieces[piece], held_parts) ? 1 : 0);
  if (std::find(held.begin(), held.end(), 1) == held.end()) return;
  DisjointSets sets(here.size());
  std::vector<std::uint32_t> home_of_set(here.size());  // the largest, or the one that is not held
  std::iota(home_of_set.begin(), home_of_set.end(), 0u);
  for (const NearPieces& pair : near_held(pieces, here, section, held, reach)) {
    const std::uint32_t a = home_of_set[sets.root(pair.a)], b = home_of_set[sets.root(pair.b)];
    if (a == b || (held[a] == 0 && held[b] == 0)) continue;
    sets.join(a, b);
    home_of_set[sets.root(a)] = held[a] != held[b] ? (held[a] == 0 ? a : b) : std::min(a, b);
  }
  for (std::uint32_t i = 0; i < here.size(); ++i) home[here[i]] = here[home_of_set[sets.root(i)]];
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

std::vector<std::uint32_t> own_homes(std::size_t count) {
  std::vector<std::uint32_t> home(count);
  std::iota(home.begin(), home.end(), 0u);
  return home;
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
