#include "render/export/collision/hulls_apart.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/knife/knife.h"
#include "generator/mesh/box.h"
#include "render/export/collision/hull_bulge.h"
#include "render/export/collision/hull_cut.h"

namespace pomona {

namespace {

constexpr double tolerated = 5e-5;  // metres: two parts that overlap by no more stay as they are
constexpr double least_left = 0.3;  // share of a part: rather than less, it overlaps
constexpr std::size_t corners = 64;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A part where it stands.
struct StandingPart {
  std::size_t body = 0, number = 0;
  std::vector<glm::dvec3> position;
  const ConvexHull* hull = nullptr;
  std::vector<glm::dvec3> normals;  ///< of its faces, outward
  double volume = 0;
  Box<double> box;
  bool gives_way = true;
};

/// How far points reach along a direction: the least and the most.
struct Reach {
  double low = unbounded, high = -unbounded;
};

Reach reach_of(const StandingPart& part, const glm::dvec3& along) {
  Reach reach;
  for (const glm::dvec3& p : part.position) {
    const double at = glm::dot(p, along);
    reach = {std::min(reach.low, at), std::max(reach.high, at)};
  }
  return reach;
}

StandingPart standing(const StandingHulls& body, std::size_t number) {
  StandingPart part;
  part.hull = body.parts[number];
  for (const glm::vec3& p : part.hull->position) {
    part.position.push_back(body.rotation * glm::dvec3(p) + body.place);
    part.box.add(part.position.back());
  }
  for (const collision::FacePlane& face : collision::faces_of(*part.hull))
    part.normals.push_back(body.rotation * face.normal);
  part.volume = volume_of(*part.hull);
  part.number = number;
  part.gives_way = body.gives_way;
  return part;
}

std::vector<StandingPart> all_standing(std::span<const StandingHulls> bodies) {
  std::vector<StandingPart> parts;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    for (std::size_t number = 0; number < bodies[body].parts.size(); ++number) {
      parts.push_back(standing(bodies[body], number));
      parts.back().body = body;
    }
  }
  return parts;
}

using Pair = std::array<std::size_t, 2>;

/// Parts of two bodies, one of which gives way, whose boxes meet; in the order of their numbers.
std::vector<Pair> pairs_that_meet(const std::vector<StandingPart>& parts) {
  std::vector<std::size_t> order(parts.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return parts[a].box.low.x < parts[b].box.low.x; });
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const StandingPart& one = parts[order[i]];
    for (std::size_t j = i + 1; j < order.size() && parts[order[j]].box.low.x <= one.box.high.x; ++j) {
      const StandingPart& other = parts[order[j]];
      if (one.body == other.body || !(one.gives_way || other.gives_way) || !one.box.meets(other.box)) continue;
      pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// A direction from the first part to the second, with how deep they overlap along it.
struct OverlapAlong {
  glm::dvec3 along{0};
  double low = 0, high = 0;  ///< where the second begins, where the first ends
  double depth() const { return high - low; }
};

/// The directions of least overlap: across faces, and from middle to middle. Empty where a plane lies between the two.
std::vector<OverlapAlong> directions_between(const StandingPart& first, const StandingPart& second) {
  std::vector<OverlapAlong> found;
  bool apart = false;
  const auto add = [&](const glm::dvec3& along) {
    found.push_back({along, reach_of(second, along).low, reach_of(first, along).high});
    apart = found.back().depth() <= tolerated;
  };
  const glm::dvec3 way = second.box.center() - first.box.center();
  if (glm::length(way) > 0) add(way / glm::length(way));
  for (std::size_t i = 0; i < first.normals.size() && !apart; ++i) add(first.normals[i]);
  for (std::size_t i = 0; i < second.normals.size() && !apart; ++i) add(-second.normals[i]);
  if (apart) return {};
  constexpr std::size_t some = 48;
  std::stable_sort(found.begin(), found.end(),
                   [](const OverlapAlong& a, const OverlapAlong& b) { return a.depth() < b.depth(); });
  if (found.size() > some) found.resize(some);
  return found;
}

/// Where the first part is to end and the second to begin.
struct Parting {
  glm::dvec3 along{0};
  double offset = 0;
  double loss = unbounded;  ///< shares of the two, added up
};

/// The loss at an offset; unbounded where it takes too much of either.
double loss_at(const StandingPart& first, const StandingPart& second, const glm::dvec3& along, double offset) {
  double loss = 0;
  if (first.gives_way) loss += volume_before(first.position, first.hull->triangle, {along, offset}) / first.volume;
  const double before = loss;
  if (second.gives_way)
    loss += volume_before(second.position, second.hull->triangle, {-along, -offset}) / second.volume;
  return std::max(before, loss - before) <= 1 - least_left ? loss : unbounded;
}

/// Nothing for parts that do not overlap, and where a plane would leave too little.
std::optional<Parting> parting_of(const StandingPart& first, const StandingPart& second) {
  Parting best;
  for (const OverlapAlong& direction : directions_between(first, second)) {
    constexpr int steps = 4;
    for (int step = 0; step <= steps; ++step) {
      // A part that stands fast is not cut.
      if ((!first.gives_way && step < steps) || (!second.gives_way && step > 0)) continue;
      const double offset = direction.low + direction.depth() * step / steps;
      const double loss = loss_at(first, second, direction.along, offset);
      if (loss < best.loss) best = {direction.along, offset, loss};
    }
  }
  return best.loss < unbounded ? std::optional(best) : std::nullopt;
}

/// The plane in the body's own frame.
CuttingPlane in_frame_of(const StandingHulls& body, const glm::dvec3& along, double offset) {
  return {glm::conjugate(body.rotation) * along, offset - glm::dot(along, body.place)};
}

}  // namespace

std::vector<TrimmedHulls> hulls_apart(std::span<const StandingHulls> bodies, Threads threads) {
  const std::vector<StandingPart> parts = all_standing(bodies);
  const std::vector<Pair> pairs = pairs_that_meet(parts);
  std::vector<std::optional<Parting>> partings(pairs.size());
  parallel_for(pairs.size(), threads,
               [&](std::size_t i) { partings[i] = parting_of(parts[pairs[i][0]], parts[pairs[i][1]]); });

  std::vector<std::vector<CuttingPlane>> planes(parts.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!partings[i]) continue;
    const auto [along, offset, loss] = *partings[i];
    const std::size_t first = pairs[i][0], second = pairs[i][1];
    if (parts[first].gives_way) planes[first].push_back(in_frame_of(bodies[parts[first].body], along, offset));
    if (parts[second].gives_way) planes[second].push_back(in_frame_of(bodies[parts[second].body], -along, -offset));
  }

  std::vector<TrimmedHulls> trimmed(bodies.size());
  for (std::size_t i = 0; i < parts.size(); ++i) trimmed[parts[i].body].changed |= !planes[i].empty();
  std::vector<ConvexHull> left(parts.size());
  parallel_for(parts.size(), threads, [&](std::size_t i) {
    if (!trimmed[parts[i].body].changed) return;
    left[i] = *parts[i].hull;
    for (const CuttingPlane& plane : planes[i]) {
      ConvexHull less = behind(left[i], plane, corners);
      if (volume_of(less) > 0) left[i] = std::move(less);
    }
  });
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (trimmed[parts[i].body].changed) trimmed[parts[i].body].parts.push_back(std::move(left[i]));
  return trimmed;
}

std::vector<std::array<std::size_t, 2>> bodies_that_overlap(std::span<const StandingHulls> bodies, Threads threads) {
  const std::vector<StandingPart> parts = all_standing(bodies);
  const std::vector<Pair> pairs = pairs_that_meet(parts);
  std::vector<char> overlap(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) {
    overlap[i] = directions_between(parts[pairs[i][0]], parts[pairs[i][1]]).empty() ? 0 : 1;
  });
  std::vector<Pair> found;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (overlap[i]) found.push_back({parts[pairs[i][0]].body, parts[pairs[i][1]].body});
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace pomona
