#include "generator/scene/seat.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;

/// All pairs of pieces, and each piece with the stand, whose boxes are nearer than they may move; the stand
/// has the index behind the last piece.
std::vector<Pair> near_pairs(std::span<const PlacedMesh> pieces, const PlacedMesh& stand) {
  std::vector<Pair> pairs;
  const auto grown = [](const PlacedMesh& placed) {
    Box box = placed.mesh.box();
    box.low += placed.at;
    box.high += placed.at;
    return box;
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j <= pieces.size(); ++j) {
      const PlacedMesh& other = j < pieces.size() ? pieces[j] : stand;
      const double reach = 0.1 * pieces[i].size;
      if (squared_distance(grown(pieces[i]), grown(other)) <= reach * reach) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// One round: every overlap moves its two pieces apart by half of it each, or one piece away from the stand.
/// Returns the largest overlap as a share of the smaller piece.
double push_apart(std::vector<PlacedMesh>& pieces, const PlacedMesh& stand, std::span<const Pair> pairs,
                  Threads threads) {
  std::vector<std::optional<Overlap>> overlaps(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t k) {
    const auto [i, j] = pairs[k];
    overlaps[k] = overlap(pieces[i], j < pieces.size() ? pieces[j] : stand);
  });

  double worst = 0;
  std::vector<glm::dvec3> moves(pieces.size(), glm::dvec3(0));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!overlaps[k]) continue;
    const auto [i, j] = pairs[k];
    const bool fixed = j == pieces.size();
    const double size = fixed ? pieces[i].size : std::min(pieces[i].size, pieces[j].size);
    worst = std::max(worst, overlaps[k]->depth / size);
    const glm::dvec3 move = overlaps[k]->away * (overlaps[k]->depth * (fixed ? 1.0 : 0.5));
    moves[i] += move;
    if (!fixed) moves[j] -= move;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].at += moves[i];
  return worst;
}

/// Sinks one piece until it touches or has gone as far as it may. A move by less than the distance to all
/// others cannot make it overlap.
void sink(std::vector<PlacedMesh>& pieces, std::size_t which, const PlacedMesh& stand, std::span<const Pair> pairs,
          const SeatOptions& options) {
  constexpr int most_moves = 30;
  PlacedMesh& piece = pieces[which];
  double left = options.farthest * piece.size;
  for (int move = 0; move < most_moves && left > 0; ++move) {
    double free = left;
    for (const auto& [i, j] : pairs) {
      if (i != which && j != which) continue;
      const std::size_t other = i == which ? j : i;
      free = std::min(free, distance(piece, other < pieces.size() ? pieces[other] : stand, free));
    }
    if (free <= options.touch * piece.size) return;
    piece.at.y -= 0.9 * free;
    left -= free;
  }
}

}  // namespace

std::vector<glm::dvec3> seat(std::vector<PlacedMesh> pieces, const PlacedMesh& stand, const SeatOptions& options,
                             Threads threads) {
  const std::vector<Pair> pairs = near_pairs(pieces, stand);
  for (int round = 0; round < options.rounds; ++round)
    if (push_apart(pieces, stand, pairs, threads) <= options.overlap) break;

  // From the lowest up, so that what carries a piece has come to its place before it.
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto low = [&](std::size_t i) { return pieces[i].at.y + pieces[i].mesh.box().low.y; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  for (const std::size_t i : order) sink(pieces, i, stand, pairs, options);

  std::vector<glm::dvec3> places;
  for (const PlacedMesh& piece : pieces) places.push_back(piece.at);
  return places;
}

}  // namespace pomona
