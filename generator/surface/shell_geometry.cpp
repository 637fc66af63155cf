#include "generator/surface/shell_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

glm::dvec3 at(const DiffusionSurfaces& surfaces, std::uint32_t vertex) { return glm::dvec3(surfaces.position[vertex]); }

void measure(const DiffusionSurfaces& surfaces, Shell& shell) {
  for (const glm::uvec3& t : shell.triangles) {
    for (int k = 0; k < 3; ++k) shell.bounds.add(at(surfaces, t[k]));
  }
  const glm::dvec3 center = shell.bounds.center();
  for (const glm::uvec3& t : shell.triangles) {
    const glm::dvec3 a = at(surfaces, t.x) - center, b = at(surfaces, t.y) - center, c = at(surfaces, t.z) - center;
    shell.volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
}

std::vector<Enclosures::Triangle> closed_ones(const DiffusionSurfaces& surfaces, const std::vector<Shell>& shells,
                                              const std::vector<std::size_t>& outer) {
  std::vector<Enclosures::Triangle> all;
  for (const std::size_t s : outer) {
    if (!shells[s].closed) continue;
    for (const glm::uvec3& t : shells[s].triangles)
      all.push_back({{at(surfaces, t.x), at(surfaces, t.y), at(surfaces, t.z)}, static_cast<std::uint32_t>(s)});
  }
  return all;
}

}  // namespace

std::vector<Shell> measured_shells(const DiffusionSurfaces& surfaces, const Shells& shells) {
  std::vector<Shell> measured(shells.count());
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (shells.of_triangle[i] == Shells::none) continue;
    measured[static_cast<std::size_t>(shells.of_triangle[i])].triangles.push_back(shells.air_facing[i]);
  }
  for (std::size_t s = 0; s < measured.size(); ++s) {
    measured[s].closed = shells.closed[s] != 0;
    measure(surfaces, measured[s]);
  }
  return measured;
}

Containment::Containment(const DiffusionSurfaces& surfaces, const std::vector<Shell>& shells,
                         const std::vector<std::size_t>& outer, double triangles)
    : surfaces_(surfaces), shells_(shells), triangles_left_(triangles), closed_(closed_ones(surfaces, shells, outer)) {
  for (const std::size_t s : outer)
    if (!shells[s].closed) open_.push_back(s);
  std::sort(open_.begin(), open_.end(), [&](std::size_t a, std::size_t b) { return is_smaller(a, b); });
}

std::optional<std::size_t> Containment::smallest_around(std::size_t shell) {
  const std::vector<glm::dvec3> samples = samples_of(shells_[shell]);
  const std::optional<std::size_t> closed = smallest_closed(shell, samples);
  for (const std::size_t open : open_) {
    if (closed && !is_smaller(open, *closed)) break;
    if (open != shell && is_in_bounds(open, shell) && is_in_open(open, samples)) return open;
  }
  return closed;
}

bool Containment::is_smaller(std::size_t a, std::size_t b) const {
  const double x = std::fabs(shells_[a].volume), y = std::fabs(shells_[b].volume);
  return x != y ? x < y : a < b;
}

/// The middles of up to eight triangles.
std::vector<glm::dvec3> Containment::samples_of(const Shell& shell) const {
  std::vector<glm::dvec3> samples(std::min<std::size_t>(8, shell.triangles.size()));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const glm::uvec3& t = shell.triangles[k * shell.triangles.size() / samples.size()];
    samples[k] = (at(surfaces_, t.x) + at(surfaces_, t.y) + at(surfaces_, t.z)) / 3.0;
  }
  return samples;
}

bool Containment::is_in_bounds(std::size_t outer, std::size_t inner) const {
  const Box<double>&around = shells_[outer].bounds, &box = shells_[inner].bounds;
  const glm::dvec3 reach = 1e-6 * around.size();
  return !glm::any(glm::lessThan(box.low, around.low - reach)) &&
         !glm::any(glm::greaterThan(box.high, around.high + reach));
}

std::optional<std::size_t> Containment::smallest_closed(std::size_t shell, const std::vector<glm::dvec3>& samples) {
  std::vector<std::pair<std::uint32_t, int>> around;  // shells, with their winding numbers
  for (const glm::dvec3& sample : samples) {
    spend(closed_.over(sample).size());
    const auto found = closed_.around(sample);
    around.insert(around.end(), found.begin(), found.end());
  }
  std::sort(around.begin(), around.end());
  std::optional<std::size_t> smallest;
  for (std::size_t i = 0; i < around.size();) {
    const std::size_t outer = around[i].first;
    int sum = 0;
    for (; i < around.size() && around[i].first == outer; ++i) sum += around[i].second;
    if (2 * static_cast<std::size_t>(std::abs(sum)) <= samples.size() || outer == shell) continue;
    if (!is_smaller(shell, outer) || !is_in_bounds(outer, shell)) continue;
    if (!smallest || is_smaller(outer, *smallest)) smallest = outer;
  }
  return smallest;
}

bool Containment::is_in_open(std::size_t open, const std::vector<glm::dvec3>& samples) {
  double sum = 0;
  for (const glm::dvec3& sample : samples) sum += winding_number(shells_[open], sample);
  return std::fabs(sum) > 0.5 * static_cast<double>(samples.size());
}

void Containment::spend(std::size_t triangles) {
  triangles_left_ -= static_cast<double>(triangles);
  if (triangles_left_ < 0) {
    throw Error(ExitStatus::bad_data, "too many shells inside each other to tell solid from hollow",
                "remove loose bits of boundary surfaces");
  }
}

/// Sum of solid angles [van Oosterom & Strackee 1983] over the full sphere's.
double Containment::winding_number(const Shell& shell, const glm::dvec3& point) {
  spend(shell.triangles.size());
  double sum = 0;
  for (const glm::uvec3& t : shell.triangles) {
    const glm::dvec3 a = at(surfaces_, t.x) - point, b = at(surfaces_, t.y) - point, c = at(surfaces_, t.z) - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double y = glm::dot(a, glm::cross(b, c));
    const double x = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    if (x != 0 || y != 0) sum += 2 * reproducible::atan2(y, x);
  }
  return sum / (4 * pi);
}

}  // namespace pomona
