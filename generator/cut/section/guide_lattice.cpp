#include "generator/cut/section/guide_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr int cells_along = 64;
constexpr double margin = 0.125;        // spacings around triangles
constexpr double least_spacing = 1e-7;  // metres

/// A cell is named by its lowest node, counted from the lattice's lowest.
class CellMarks {
 public:
  explicit CellMarks(const LatticeFrame& frame)
      : frame_(frame), marked_(static_cast<std::size_t>(frame.count.x) * frame.count.y * frame.count.z, 0) {}

  /// Halves a triangle until its pieces fit in two cells along each axis.
  void mark(const std::array<glm::dvec3, 3>& corner, int depth = 0) {
    constexpr int deepest = 24;
    const Box<double> box = box_around(corner[0], corner[1], corner[2]);
    const glm::ivec3 low = cell_of(box.low - margin * frame_.spacing),
                     high = cell_of(box.high + margin * frame_.spacing);
    const glm::ivec3 across = high - low;
    if (std::max({across.x, across.y, across.z}) <= 1 || depth == deepest) {
      mark(low, high);
      return;
    }
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (squared_edge(corner, k) > squared_edge(corner, longest)) longest = k;
    const glm::dvec3 &a = corner[longest], &b = corner[(longest + 1) % 3], &c = corner[(longest + 2) % 3];
    const glm::dvec3 middle = 0.5 * (a + b);
    mark({a, middle, c}, depth + 1);
    mark({middle, b, c}, depth + 1);
  }

  /// The corners of all marked cells.
  std::vector<glm::ivec3> nodes() const {
    std::vector<std::uint8_t> wanted(marked_.size(), 0);
    for (std::size_t i = 0; i < marked_.size(); ++i) {
      if (marked_[i] == 0) continue;
      for (int k = 0; k < 8; ++k) wanted[i + index({k & 1, k >> 1 & 1, k >> 2})] = 1;
    }
    std::vector<glm::ivec3> nodes;
    std::size_t i = 0;
    for (int z = 0; z < frame_.count.z; ++z)
      for (int y = 0; y < frame_.count.y; ++y)
        for (int x = 0; x < frame_.count.x; ++x, ++i)
          if (wanted[i] != 0) nodes.push_back(frame_.low + glm::ivec3(x, y, z));
    return nodes;
  }

 private:
  static double squared_edge(const std::array<glm::dvec3, 3>& corner, std::size_t k) {
    const glm::dvec3 d = corner[(k + 1) % 3] - corner[k];
    return glm::dot(d, d);
  }

  /// The cell of a place, or the nearest one of the lattice.
  glm::ivec3 cell_of(const glm::dvec3& place) const {
    const glm::dvec3 cell = glm::floor(place / frame_.spacing - 0.5) - glm::dvec3(frame_.low);
    return glm::ivec3(glm::clamp(cell, glm::dvec3(0), glm::dvec3(frame_.count - 2)));
  }

  std::size_t index(const glm::ivec3& n) const {
    return (static_cast<std::size_t>(n.z) * frame_.count.y + n.y) * frame_.count.x + n.x;
  }

  void mark(const glm::ivec3& low, const glm::ivec3& high) {
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) marked_[index({x, y, z})] = 1;
  }

  const LatticeFrame& frame_;
  std::vector<std::uint8_t> marked_;
};

glm::vec4 mixed(const glm::vec4& a, const glm::vec4& b, float t) { return a + t * (b - a); }

}  // namespace

LatticeFrame lattice_frame(const Box<double>& fruit) {
  LatticeFrame frame;
  const glm::dvec3 size = glm::max(fruit.size(), glm::dvec3(0));
  frame.spacing = std::max(std::max({size.x, size.y, size.z}) / cells_along, least_spacing);
  frame.low = glm::ivec3(glm::floor(fruit.low / frame.spacing - 0.5)) - 1;
  frame.count = glm::ivec3(glm::floor(fruit.high / frame.spacing - 0.5)) + 3 - frame.low;
  return frame;
}

std::vector<glm::ivec3> nodes_around(const LatticeFrame& frame, std::span<const std::array<glm::dvec3, 3>> triangles) {
  CellMarks marks(frame);
  for (const std::array<glm::dvec3, 3>& triangle : triangles) marks.mark(triangle);
  return marks.nodes();
}

GuideLattice::GuideLattice(const LatticeFrame& frame, std::span<const glm::ivec3> nodes,
                           std::span<const glm::vec4> value)
    : frame_(frame),
      blocks_((frame.count + (block_side - 1)) >> block_bits),
      start_(static_cast<std::size_t>(blocks_.x) * blocks_.y * blocks_.z, 0),
      value_(nodes_of_block, glm::vec4(std::numeric_limits<float>::quiet_NaN())) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const glm::ivec3 n = nodes[i] - frame_.low;
    std::uint32_t& start = start_[block_of(n)];
    if (start == 0) {
      start = static_cast<std::uint32_t>(value_.size());
      value_.resize(value_.size() + nodes_of_block, value_.front());
    }
    value_[start + within_block(n)] = value[i];
  }
}

std::size_t GuideLattice::block_of(const glm::ivec3& n) const {
  const glm::ivec3 block = n >> block_bits;
  return (static_cast<std::size_t>(block.z) * blocks_.y + block.y) * blocks_.x + block.x;
}

std::size_t GuideLattice::within_block(const glm::ivec3& n) {
  const glm::ivec3 own = n & (block_side - 1);
  return static_cast<std::size_t>((own.z * block_side + own.y) * block_side + own.x);
}

std::optional<glm::vec4> GuideLattice::at(const glm::dvec3& place) const {
  const glm::dvec3 node = place / frame_.spacing - 0.5, cell = glm::floor(node);
  const glm::dvec3 from_low = cell - glm::dvec3(frame_.low), last(frame_.count - 2);
  for (int k = 0; k < 3; ++k)
    if (!(from_low[k] >= 0 && from_low[k] <= last[k])) return std::nullopt;

  // Along x, then y, then z.
  const glm::ivec3 n(from_low);
  const glm::vec3 t(node - cell);
  const auto corner = [&](int x, int y, int z) -> const glm::vec4& {
    const glm::ivec3 at = n + glm::ivec3(x, y, z);
    return value_[start_[block_of(at)] + within_block(at)];
  };
  const auto row = [&](int y, int z) { return mixed(corner(0, y, z), corner(1, y, z), t.x); };
  const auto square = [&](int z) { return mixed(row(0, z), row(1, z), t.y); };
  const glm::vec4 found = mixed(square(0), square(1), t.z);
  return std::isnan(found.w) ? std::nullopt : std::optional(found);
}

DetailGuide guide_at(const GuideLattice* lattice, const glm::dvec3& place, const DetailGuide& between) {
  if (lattice == nullptr || between.share == glm::vec4(0)) return between;
  const std::optional<glm::vec4> found = lattice->at(place);
  if (!found) return between;
  return {.to_skin = glm::vec3(*found), .layer = found->w, .share = between.share};
}

}  // namespace pomona
