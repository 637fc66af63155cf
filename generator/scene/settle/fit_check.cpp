#include "generator/scene/settle/fit_check.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/morton.h"
#include "generator/scene/settle/broad_phase.h"

namespace pomona {

namespace {

bool same(const Pose& a, const Pose& b) { return a.rotation == b.rotation && a.translation == b.translation; }

std::vector<std::size_t> sorted_once(std::vector<std::size_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::size_t place_in(const std::vector<std::size_t>& sorted, std::size_t number) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
}

}  // namespace

FitCheck::FitCheck(std::span<const Solid> solids, std::vector<std::size_t> solid_of, const PlacedMesh& stand,
                   Threads threads)
    : solids_(solids), solid_of_(std::move(solid_of)), stand_(stand), threads_(threads), boxes_(solids.size()) {
  for (const std::size_t i : sorted_once(solid_of_))
    for (const glm::uvec3& t : solids[i].mesh.triangle)
      for (int k = 0; k < 3; ++k) boxes_[i].add(glm::dvec3(solids[i].mesh.position[t[k]]));
}

/// The axis-aligned box around the rotated box of the solid.
Box<double> FitCheck::box_at(std::size_t piece, const Pose& pose) const {
  const Box<double>& box = boxes_[solid_of_[piece]];
  const glm::dmat3 turn = glm::mat3_cast(pose.rotation);
  const glm::dvec3 middle = turn * box.center() + pose.translation, half = 0.5 * box.size();
  const glm::dvec3 reach = glm::abs(turn[0]) * half.x + glm::abs(turn[1]) * half.y + glm::abs(turn[2]) * half.z;
  return {middle - reach, middle + reach};
}

/// All pairs that may be near, sorted. Each piece that is not absent also has a pair with the stand.
std::vector<FitCheck::Pair> FitCheck::near_pairs(std::span<const Pose> poses,
                                                 std::span<const std::size_t> absent) const {
  const auto is_absent = [&](std::size_t i) { return std::binary_search(absent.begin(), absent.end(), i); };
  std::vector<Box<double>> boxes;
  double widest = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    boxes.push_back(box_at(i, poses[i]));
    widest = std::max(widest, size(i));
  }
  BroadPhase near((1 + farthest_gap) * widest, poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (!is_absent(i)) near.add(i, boxes[i].center());

  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (is_absent(i)) continue;
    near.visit(boxes[i].center(), [&](std::size_t j) {
      const double reach = farthest_gap * std::max(size(i), size(j));
      if (j > i && squared_distance(boxes[i], boxes[j]) <= reach * reach) pairs.push_back({i, j, {}, {}});
    });
    pairs.push_back({i, poses.size(), {}, {}});
  }
  const auto key = [](const Pair& p) { return std::tie(p.first, p.second); };
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return key(a) < key(b); });
  return pairs;
}

/// Copies the results of pairs that have not moved since the last measurement.
void FitCheck::reuse_measured(std::span<const Pose> poses, std::vector<Pair>& pairs) const {
  if (measured_.size() != poses.size()) return;
  const auto stays = [&](std::size_t piece) { return piece == poses.size() || same(poses[piece], measured_[piece]); };
  auto known = measured_pairs_.begin();
  for (Pair& pair : pairs) {
    while (known != measured_pairs_.end() && std::tie(known->first, known->second) < std::tie(pair.first, pair.second))
      ++known;
    const bool is_same = known != measured_pairs_.end() && known->first == pair.first && known->second == pair.second;
    if (is_same && stays(pair.first) && stays(pair.second)) pair = *known;
  }
}

/// Measures pairs in chunks; the pieces of a chunk lie near each other.
void FitCheck::measure_pairs(Quantity quantity, std::span<const Pose> poses, std::vector<Pair*> pairs,
                             const Progress& progress) const {
  constexpr std::size_t chunk = 2000;  // pairs, of some two hundred pieces
  std::vector<glm::dvec3> centers;
  for (std::size_t i = 0; i < poses.size(); ++i) centers.push_back(box_at(i, poses[i]).center());
  const std::vector<std::uint32_t> order = morton_order(centers);
  std::vector<std::size_t> rank(poses.size() + 1, poses.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair* a, const Pair* b) {
    return std::min(rank[a->first], rank[a->second]) < std::min(rank[b->first], rank[b->second]);
  });
  for (std::size_t first = 0; first < pairs.size(); first += chunk) {
    const std::size_t count = std::min(chunk, pairs.size() - first);
    measure_chunk(quantity, poses, std::span(pairs).subspan(first, count));
    if (progress) progress((first + count) * poses.size() / pairs.size());
  }
}

void FitCheck::measure_chunk(Quantity quantity, std::span<const Pose> poses, std::span<Pair* const> pairs) const {
  // The rotated meshes of these pieces. The tree of each solid is built once.
  std::vector<std::size_t> pieces, solids;
  for (const Pair* pair : pairs)
    for (const std::size_t i : {pair->first, pair->second})
      if (i < poses.size()) pieces.push_back(i);
  pieces = sorted_once(std::move(pieces));
  for (const std::size_t i : pieces) solids.push_back(solid_of_[i]);
  solids = sorted_once(std::move(solids));
  std::vector<TriangleTree> trees(solids.size());
  parallel_for(solids.size(), threads_, [&](std::size_t s) {
    trees[s] = TriangleTree(solids_[solids[s]].mesh.position, solids_[solids[s]].mesh.triangle);
  });
  std::vector<PlacedMesh> placed(pieces.size());
  parallel_for(pieces.size(), threads_, [&](std::size_t p) {
    const Pose& pose = poses[pieces[p]];
    const TriangleTree& tree = trees[place_in(solids, solid_of_[pieces[p]])];
    placed[p] = {tree.rotated(pose.rotation), pose.translation, size(pieces[p])};
  });

  parallel_for(pairs.size(), threads_, [&](std::size_t k) {
    Pair& pair = *pairs[k];
    const PlacedMesh& a = placed[place_in(pieces, pair.first)];
    const PlacedMesh& b = pair.second == poses.size() ? stand_ : placed[place_in(pieces, pair.second)];
    if (quantity == Quantity::depth) {
      const auto inside = overlap(a, b);
      pair.depth = inside ? inside->depth : 0;
    } else {
      const double other_size = pair.second == poses.size() ? 0 : b.size;
      pair.distance = distance(a, b, farthest_gap * std::max(a.size, other_size));
    }
  });
}

std::vector<Fit> FitCheck::measure(std::span<const Pose> poses, std::span<const std::size_t> absent,
                                   const Progress& progress) {
  std::vector<Pair> pairs = near_pairs(poses, absent);
  reuse_measured(poses, pairs);
  std::vector<Pair*> unknown;
  for (Pair& pair : pairs)
    if (!pair.depth) unknown.push_back(&pair);
  measure_pairs(Quantity::depth, poses, unknown, progress);
  std::vector<Fit> fits(poses.size(), Fit{farthest_gap, 0});
  const auto each_piece = [&](const Pair& pair, const auto& visit) {
    visit(pair.first);
    if (pair.second < poses.size()) visit(pair.second);
  };
  for (const Pair& pair : pairs) {
    if (*pair.depth <= 0) continue;
    each_piece(pair, [&](std::size_t i) { fits[i] = {0, std::max(fits[i].penetration, *pair.depth / size(i))}; });
  }

  // Few pieces overlap nothing. Only for these the distance to the nearest mesh is measured.
  unknown.clear();
  for (Pair& pair : pairs) {
    bool is_wanted = false;
    each_piece(pair, [&](std::size_t i) { is_wanted |= fits[i].penetration <= 0; });
    if (is_wanted && *pair.depth <= 0 && !pair.distance) unknown.push_back(&pair);
  }
  measure_pairs(Quantity::distance, poses, unknown, {});
  for (const Pair& pair : pairs) {
    if (!pair.distance) continue;
    each_piece(pair, [&](std::size_t i) { fits[i].gap = std::min(fits[i].gap, *pair.distance / size(i)); });
  }
  measured_.assign(poses.begin(), poses.end());
  measured_pairs_ = std::move(pairs);
  return fits;
}

}  // namespace pomona
