#include "generator/piece/lod/patch_cover.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {
namespace {

/// A share of the bound: far above rounding errors, far below visible differences.
constexpr double rounding = 1e-9;

}  // namespace

struct PatchCover::Frame {
  const CoverQuery& query;
  const BorderChains& chains;
  std::array<glm::dvec3, 3> inward;  ///< across the sides, of length 1
  glm::dvec3 up;                     ///< of length 1
  double slack = 0;                  ///< metres
  Seen center;                       ///< where sheets are counted

  bool is_beside(const Seen& a, const Seen& b) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (a.inside[i] <= slack && b.inside[i] <= slack) return true;
    return false;
  }
  bool is_beside(const std::array<Seen, 3>& c) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (c[0].inside[i] <= slack && c[1].inside[i] <= slack && c[2].inside[i] <= slack) return true;
    return false;
  }
};

PatchCover::Seen PatchCover::seen(const Frame& frame, std::uint32_t fan) const {
  const glm::dvec3& p = source_.position[fan];
  const TriangleCorners& c = frame.query.corner;
  return {
      {glm::dot(frame.inward[0], p - c[0]), glm::dot(frame.inward[1], p - c[1]), glm::dot(frame.inward[2], p - c[2])},
      glm::dot(frame.up, p - c[0])};
}

/// The max height of the part of a triangle that lies within the query's triangle [Sutherland & Hodgman 1974].
double PatchCover::height_within(const Frame& frame, const std::array<Seen, 3>& corner) {
  std::array<Seen, 9> polygon{corner[0], corner[1], corner[2]}, rest;
  std::size_t count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Seen &a = polygon[k], &b = polygon[(k + 1) % count];
      const double at_a = a.inside[i] - frame.slack, at_b = b.inside[i] - frame.slack;
      if (at_a >= 0) rest[kept++] = a;
      if ((at_a < 0) == (at_b < 0)) continue;
      const double share = at_a / (at_a - at_b);
      for (std::size_t j = 0; j < 3; ++j) rest[kept].inside[j] = a.inside[j] + share * (b.inside[j] - a.inside[j]);
      rest[kept++].height = a.height + share * (b.height - a.height);
    }
    polygon = rest, count = kept;
  }
  double height = 0;
  for (std::size_t k = 0; k < count; ++k) height = std::max(height, std::abs(polygon[k].height));
  return height;
}

/// 1 or -1, as it faces up or down, if the triangle lies above or below the place where sheets are counted; else 0.
int PatchCover::sheets_at_center(const Frame& frame, const std::array<Seen, 3>& corner) {
  // The distances from two sides are coordinates in the plane.
  std::array<std::array<double, 2>, 3> at;
  for (std::size_t i = 0; i < 3; ++i)
    at[i] = {corner[i].inside[0] - frame.center.inside[0], corner[i].inside[1] - frame.center.inside[1]};
  const auto turn = [&](std::size_t i, std::size_t j) { return at[i][0] * at[j][1] - at[i][1] * at[j][0]; };
  const double a = turn(0, 1), b = turn(1, 2), c = turn(2, 0);
  if (a > 0 && b > 0 && c > 0) return 1;
  return a < 0 && b < 0 && c < 0 ? -1 : 0;
}

/// Chains that stay on the outer side of the place where sheets are counted do not go around it.
bool PatchCover::is_out_of_the_way_of_chains(const Frame& frame) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (frame.query.chain[i] == none) continue;
    const double most = frame.center.inside[i] - frame.slack;
    for (std::uint32_t fan = frame.chains.first[frame.query.chain[i]]; fan != none; fan = frame.chains.next[fan])
      if (!(glm::dot(frame.inward[i], source_.position[fan] - frame.query.corner[i]) < most)) return false;
  }
  return true;
}

/// The number of sheets that the face adds at the place where they are counted. Nothing if it is too high, or ends
/// where it must not.
std::optional<int> PatchCover::enter(const Frame& frame, std::uint32_t face, const std::array<Seen, 3>& corner) {
  visit_[face] = walk_;
  int sheets = 0;
  if (!frame.is_beside(corner)) {
    const double bound = frame.query.bound - frame.slack;
    const auto is_low = [&](const Seen& seen) { return std::abs(seen.height) <= bound; };
    const bool is_all_low = is_low(corner[0]) && is_low(corner[1]) && is_low(corner[2]);
    if (!is_all_low && glm::dot(source_.normal[face], frame.up) > 0 && !(height_within(frame, corner) <= bound))
      return std::nullopt;
    sheets = sheets_at_center(frame, corner);
  }
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Seen &from = corner[k], &to = corner[(k + 1) % 3];
    if (frame.is_beside(from, to)) continue;
    const std::uint32_t twin = source_.mesh.twin[3 * face + k];
    if (twin == none || source_.patch[twin / 3] != frame.query.patch) {
      if (!may_end_at(frame, source_.mesh.corner[face][k], source_.mesh.corner[face][(k + 1) % 3])) return std::nullopt;
    } else if (visit_[twin / 3] != walk_) {
      steps_.push_back({twin, to, from});
    }
  }
  return sheets;
}

/// Whether the border between two fans is part of what a side of the triangle stands for.
bool PatchCover::may_end_at(const Frame& frame, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t of_a = frame.chains.of_fan[a], of_b = frame.chains.of_fan[b];
  const auto& chain = frame.query.chain;
  return std::any_of(chain.begin(), chain.end(),
                     [&](std::uint32_t c) { return c != none && (c == of_a || c == of_b); });
}

/// Sheets are counted in the middle, or, if one side lies on a border, far from it. The weights are not round, because
/// vertices of grids lie at round ones.
std::array<double, 3> PatchCover::weights_of_center(const CoverQuery& query) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (query.chain[i] == none || query.chain[(i + 1) % 3] != none || query.chain[(i + 2) % 3] != none) continue;
    std::array<double, 3> weight;
    weight[i] = 0.0972, weight[(i + 1) % 3] = 0.0891, weight[(i + 2) % 3] = 0.8137;
    return weight;
  }
  return {0.3137, 0.3391, 0.3472};
}

bool PatchCover::covers(const CoverQuery& query, const BorderChains& chains) {
  const TriangleCorners& c = query.corner;
  Frame frame{.query = query,
              .chains = chains,
              .inward = {},
              .up = glm::normalize(area_vector(c)),
              .slack = rounding * query.bound,
              .center = {}};
  for (std::size_t i = 0; i < 3; ++i) frame.inward[i] = glm::normalize(glm::cross(frame.up, c[(i + 1) % 3] - c[i]));
  const std::array<double, 3> weight = weights_of_center(query);
  for (std::size_t i = 0; i < 3; ++i)
    frame.center.inside[i] = weight[(i + 2) % 3] * glm::dot(frame.inward[i], c[(i + 2) % 3] - c[i]);
  if (!is_out_of_the_way_of_chains(frame)) return false;

  // Start at the faces around a corner that face up, so that thin bodies are not counted from both sides.
  ++walk_;
  steps_.clear();
  int sheets = 0;
  ring_ = ring_around(source_.mesh, query.fan, std::move(ring_));
  for (const Spoke& spoke : ring_) {
    if (spoke.face == none || source_.patch[spoke.face] != query.patch || visit_[spoke.face] == walk_) continue;
    if (!(glm::dot(source_.normal[spoke.face], frame.up) > 0)) continue;
    const auto& fan = source_.mesh.corner[spoke.face];
    const auto added = enter(frame, spoke.face, {seen(frame, fan[0]), seen(frame, fan[1]), seen(frame, fan[2])});
    if (!added) return false;
    sheets += *added;
  }
  while (!steps_.empty()) {
    const Step step = steps_.back();
    steps_.pop_back();
    const std::uint32_t face = step.half_edge / 3, k = step.half_edge % 3;
    if (visit_[face] == walk_) continue;
    std::array<Seen, 3> corner;
    corner[k] = step.from, corner[(k + 1) % 3] = step.to;
    corner[(k + 2) % 3] = seen(frame, source_.mesh.corner[face][(k + 2) % 3]);
    const std::optional<int> added = enter(frame, face, corner);
    if (!added) return false;
    sheets += *added;
  }
  return sheets > 0;
}

}  // namespace pomona
