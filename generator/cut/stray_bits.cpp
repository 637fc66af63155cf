#include "generator/cut/stray_bits.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"

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

}  // namespace

std::vector<std::uint32_t> homes_of_bits(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& cell,
                                         const CrossSection& section, const StrayBitOptions& options) {
  std::vector<std::uint32_t> home(pieces.size());
  std::iota(home.begin(), home.end(), 0u);
  double whole = 0;
  for (const CutPiece& piece : pieces) whole += piece.volume;
  if (!(whole > 0)) return home;

  // Order pieces by cell, the largest first.
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    if (!is_empty(pieces[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cell[a] != cell[b] ? cell[a] < cell[b] : pieces[a].volume > pieces[b].volume;
  });
  for (std::size_t i = 0, end; i < order.size(); i = end) {
    for (end = i; end < order.size() && cell[order[end]] == cell[order[i]]; ++end) {
    }
    find_homes(pieces,
               {order.begin() + static_cast<std::ptrdiff_t>(i), order.begin() + static_cast<std::ptrdiff_t>(end)},
               section, options.largest * whole, options.reach * reproducible::cbrt(whole), home);
  }
  return home;
}

}  // namespace pomona
