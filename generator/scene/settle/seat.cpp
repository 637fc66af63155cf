#include "generator/scene/settle/seat.h"

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
  const auto grown = [](const PlacedMesh& placed) { return placed.mesh.box().moved(placed.at); };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j <= pieces.size(); ++j) {
      const PlacedMesh& other = j < pieces.size() ? pieces[j] : stand;
      const double reach = 0.1 * pieces[i].size;
      if (squared_distance(grown(pieces[i]), grown(other)) <= reach * reach) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Pushes pieces apart, round by round; looks again only at pairs that have moved enough to have met.
class Parting {
 public:
  Parting(std::vector<PlacedMesh>& pieces, const PlacedMesh& stand, std::span<const Pair> pairs, Threads threads)
      : pieces_(pieces), stand_(stand), pairs_(pairs), threads_(threads), slack_(pairs.size(), 0) {}

  /// Every overlap moves its two pieces apart by a good half of it each, or one piece away from the stand. Returns the
  /// largest overlap as a share of the smaller piece.
  double round() {
    std::vector<std::optional<Overlap>> overlaps(pairs_.size());
    parallel_for(pairs_.size(), threads_, [&](std::size_t k) {
      if (slack_[k] > 0) return;
      const auto [i, j] = pairs_[k];
      overlaps[k] = overlap(pieces_[i], other(j));
      const double look = 0.02 * pieces_[i].size;
      if (!overlaps[k]) slack_[k] = std::min(look, distance(pieces_[i], other(j), look));
    });

    constexpr double push = 0.6;  // a little more than half: pieces have other neighbours, which push back
    double worst = 0;
    std::vector<glm::dvec3> moves(pieces_.size() + 1, glm::dvec3(0));
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (!overlaps[k]) continue;
      const auto [i, j] = pairs_[k];
      const bool fixed = j == pieces_.size();
      const double size = fixed ? pieces_[i].size : std::min(pieces_[i].size, pieces_[j].size);
      worst = std::max(worst, overlaps[k]->depth / size);
      const glm::dvec3 move = overlaps[k]->away * (overlaps[k]->depth * (fixed ? 1.0 : push));
      moves[i] += move;
      if (!fixed) moves[j] -= move;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) pieces_[i].at += moves[i];
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      slack_[k] -= glm::length(moves[pairs_[k].first]) + glm::length(moves[pairs_[k].second]);
    return worst;
  }

 private:
  const PlacedMesh& other(std::size_t j) const { return j < pieces_.size() ? pieces_[j] : stand_; }

  std::vector<PlacedMesh>& pieces_;
  const PlacedMesh& stand_;
  std::span<const Pair> pairs_;
  Threads threads_;
  std::vector<double> slack_;  ///< by how much a pair may move before it could overlap
};

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
  Parting parting(pieces, stand, pairs, threads);
  for (int round = 0; round < options.rounds; ++round)
    if (parting.round() <= options.overlap) break;

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
