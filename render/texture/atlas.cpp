#include "render/texture/atlas.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/error.h"

namespace pomona {

namespace {

/// Which blocks a chart needs, as rows of bits.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint64_t> bits;  // words() per row
  std::int64_t count = 0;

  Mask(int w, int h) : width(w), height(h), bits(static_cast<std::size_t>(words()) * h, 0) {}
  int words() const { return (width + 63) / 64; }
  void set(int x, int y) { bits[static_cast<std::size_t>(y) * words() + x / 64] |= std::uint64_t{1} << (x % 64); }
  bool has(int x, int y) const { return ((bits[static_cast<std::size_t>(y) * words() + x / 64] >> (x % 64)) & 1) != 0; }
  bool operator==(const Mask& o) const { return width == o.width && height == o.height && bits == o.bits; }
};

/// Whether a triangle comes within `slack` of the unit square at (x, y).
bool touches(const std::array<glm::dvec2, 3>& p, int x, int y, double slack) {
  const glm::dvec2 center(x + 0.5, y + 0.5);
  const double half = 0.5 + slack;
  const double turn = cross(p[1] - p[0], p[2] - p[0]) < 0 ? -1 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 e = turn * (p[(k + 1) % 3] - p[k]);
    if (cross(e, center - p[k]) < -half * (std::abs(e.x) + std::abs(e.y))) return false;
  }
  return true;  // within the triangle's box, as the caller sees to
}

/// The blocks whose texels a bilinear look-up reads, at the scale `blocks_per_metre`: with the chart's lower corner in
/// the middle of block (0, 0), a look-up at p reads block floor(p) and its right and lower neighbours.
Mask mask_of(const Chart& chart, double blocks_per_metre) {
  // The blocks in which a look-up may lie: those that a triangle touches.
  constexpr double slack = 1e-3;
  const glm::ivec2 cells(glm::floor(chart.size * blocks_per_metre + slack) + 1.0);
  Mask touched(cells.x, cells.y);
  for (const glm::uvec3& t : chart.corners) {
    const std::array<glm::dvec2, 3> p{chart.flat[t.x] * blocks_per_metre, chart.flat[t.y] * blocks_per_metre,
                                      chart.flat[t.z] * blocks_per_metre};
    const glm::ivec2 low(glm::floor(glm::min(p[0], glm::min(p[1], p[2])) - slack));
    const glm::ivec2 high(glm::floor(glm::max(p[0], glm::max(p[1], p[2])) + slack));
    for (int y = std::max(0, low.y); y <= std::min(high.y, cells.y - 1); ++y) {
      for (int x = std::max(0, low.x); x <= std::min(high.x, cells.x - 1); ++x) {
        if (!touched.has(x, y) && touches(p, x, y, slack)) touched.set(x, y);
      }
    }
  }

  // From each of them a look-up also reads the blocks to the right and below.
  Mask mask(cells.x + 1, cells.y + 1);
  for (int y = 0; y < cells.y; ++y) {
    for (int x = 0; x < cells.x; ++x) {
      if (!touched.has(x, y)) continue;
      for (const glm::ivec2 at : {glm::ivec2(x, y), {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) mask.set(at.x, at.y);
    }
  }
  for (const std::uint64_t word : mask.bits) mask.count += std::popcount(word);
  return mask;
}

Mask speck_mask() {
  Mask mask(1, 1);
  mask.set(0, 0);
  mask.count = 1;
  return mask;
}

/// Blocks that are taken, row by row, with room to read past a row's end.
class Field {
 public:
  explicit Field(const glm::ivec2& blocks)
      : blocks_(blocks), words_((blocks.x + 63) / 64 + 1), taken_(static_cast<std::size_t>(words_) * blocks.y, 0) {}

  /// The first place, row by row and not before `start`, where the mask meets nothing.
  std::optional<glm::ivec2> place(const Mask& mask, glm::ivec2 start) const {
    for (int y = start.y; y + mask.height <= blocks_.y; ++y) {
      for (int x = y == start.y ? start.x : 0; x + mask.width <= blocks_.x; ++x) {
        if (fits(mask, x, y)) return glm::ivec2(x, y);
      }
    }
    return std::nullopt;
  }

  void take(const Mask& mask, const glm::ivec2& at) {
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        if (mask.has(x, y)) word(at.x + x, at.y + y) |= std::uint64_t{1} << ((at.x + x) % 64);
      }
    }
  }

 private:
  std::uint64_t& word(int x, int y) { return taken_[static_cast<std::size_t>(y) * words_ + x / 64]; }

  bool fits(const Mask& mask, int x, int y) const {
    const int shift = x % 64, words = mask.words();
    for (int row = 0; row < mask.height; ++row) {
      const std::uint64_t* const taken = &taken_[static_cast<std::size_t>(y + row) * words_ + x / 64];
      const std::uint64_t* const wanted = &mask.bits[static_cast<std::size_t>(row) * words];
      for (int w = 0; w < words; ++w) {
        if ((taken[w] & (wanted[w] << shift)) != 0) return false;
        if (shift != 0 && x / 64 + w + 1 < words_ && (taken[w + 1] & (wanted[w] >> (64 - shift))) != 0) return false;
      }
    }
    return true;
  }

  glm::ivec2 blocks_;
  int words_;
  std::vector<std::uint64_t> taken_;
};

double area_of(const Chart& chart) {
  double area = 0;
  for (const glm::uvec3& t : chart.corners)
    area += 0.5 * std::abs(cross(chart.flat[t.y] - chart.flat[t.x], chart.flat[t.z] - chart.flat[t.x]));
  return area;
}

double area_of(const std::vector<Chart>& charts) {
  double area = 0;
  for (const Chart& chart : charts) area += area_of(chart);
  return area;
}

constexpr double longest_speck = 16, largest_speck = 6;  // texels, and square texels

/// All charts at one scale, the largest first; nothing if they do not fit.
class Packer {
 public:
  Packer(const std::vector<Chart>& charts, double texels_per_metre, int mip_levels)
      : charts_(charts), scale_(texels_per_metre), mip_levels_(mip_levels) {
    const double texels_per_block = 1 << mip_levels;
    masks_.reserve(charts.size());
    for (const Chart& chart : charts) areas_.push_back(area_of(chart));
    for (std::size_t c = 0; c < charts.size(); ++c)
      masks_.push_back(is_speck(c) ? speck_mask() : mask_of(charts[c], texels_per_metre / texels_per_block));
    order_.resize(charts.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return masks_[a].count > masks_[b].count; });
  }

  std::optional<Atlas> into(const glm::ivec2& size) const {
    // A size with fewer blocks than are wanted is not tried.
    const int block = 1 << mip_levels_;
    Atlas atlas{
        .size = size, .mip_levels = mip_levels_, .texels_per_metre = scale_, .corner = {}, .speck = {}, .owner = {}};
    const glm::ivec2 blocks = atlas.blocks();
    std::int64_t wanted = 0;
    for (const Mask& mask : masks_) wanted += mask.count;
    if (wanted > static_cast<std::int64_t>(blocks.x) * blocks.y) return std::nullopt;

    // Each mask at the first place where it fits; one like the mask before it can only come after that.
    Field field(blocks);
    atlas.corner.resize(charts_.size());
    atlas.speck.resize(charts_.size());
    atlas.owner.assign(static_cast<std::size_t>(blocks.x) * blocks.y, -1);
    const Mask* last = nullptr;
    glm::ivec2 start(0);
    for (const std::size_t c : order_) {
      const Mask& mask = masks_[c];
      if (last == nullptr || !(*last == mask)) start = glm::ivec2(0);
      const std::optional<glm::ivec2> at = field.place(mask, start);
      if (!at) return std::nullopt;
      field.take(mask, *at);
      own(atlas, mask, *at, static_cast<std::int32_t>(c));
      atlas.corner[c] = (glm::dvec2(*at) + 0.5) * static_cast<double>(block);
      atlas.speck[c] = is_speck(c) ? 1 : 0;
      last = &mask;
      start = *at;
    }
    return atlas;
  }

 private:
  /// Hairs and crumbs, which would show nothing but their edges.
  bool is_speck(std::size_t chart) const {
    const double longest = std::max(charts_[chart].size.x, charts_[chart].size.y) * scale_;
    return longest < 1 || (longest < longest_speck && areas_[chart] * scale_ * scale_ < largest_speck);
  }

  static void own(Atlas& atlas, const Mask& mask, const glm::ivec2& at, std::int32_t chart) {
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        if (mask.has(x, y)) atlas.owner[static_cast<std::size_t>(at.y + y) * atlas.blocks().x + at.x + x] = chart;
      }
    }
  }

  const std::vector<Chart>& charts_;
  double scale_;
  int mip_levels_;
  std::vector<double> areas_;
  std::vector<Mask> masks_;
  std::vector<std::size_t> order_;
};

/// Halves the interval between a scale that fits and one that cannot.
std::optional<Atlas> largest(const std::vector<Chart>& charts, int side, int mip_levels) {
  const double area = area_of(charts);
  double fits = 0, too_large = area > 0 ? side / std::sqrt(area) : side;
  std::optional<Atlas> best = Packer(charts, fits, mip_levels).into(glm::ivec2(side));
  constexpr int halvings = 10;
  for (int i = 0; best && i < halvings; ++i) {
    const double middle = 0.5 * (fits + too_large);
    std::optional<Atlas> at_middle = Packer(charts, middle, mip_levels).into(glm::ivec2(side));
    (at_middle ? fits : too_large) = middle;
    if (at_middle) best = std::move(at_middle);
  }
  return best;
}

}  // namespace

Atlas atlas_of_side(const std::vector<Chart>& charts, int side, int mip_levels) {
  constexpr double worth = 1.5;
  std::optional<Atlas> best;
  for (int levels = mip_levels; levels >= 0; --levels) {
    if (side % (1 << levels) != 0) continue;
    std::optional<Atlas> atlas = largest(charts, side, levels);
    if (atlas && best && atlas->texels_per_metre < worth * best->texels_per_metre) break;
    if (atlas) best = std::move(atlas);
  }
  if (!best) {
    throw Error(ExitStatus::usage, "--texture " + std::to_string(side) + ": too few texels for this piece",
                "its surface falls into " + std::to_string(charts.size()) + " charts; take a larger texture");
  }
  return *best;
}

Atlas atlas_of_texel(const std::vector<Chart>& charts, double texel, int mip_levels) {
  const auto too_many = [&] {
    return Error(ExitStatus::usage,
                 "--texel: this piece would need a texture of more than " + std::to_string(max_texture_side) + " x " +
                     std::to_string(max_texture_side) + " texels",
                 "take larger texels, or smaller pieces");
  };
  // Told before anything is made of that size.
  const double scale = 1 / texel;
  constexpr double most = static_cast<double>(max_texture_side) * max_texture_side;
  if (!(area_of(charts) * scale * scale <= most)) throw too_many();
  for (const Chart& chart : charts) {
    if (!(std::max(chart.size.x, chart.size.y) * scale < max_texture_side)) throw too_many();
  }

  const Packer packer(charts, scale, mip_levels);
  for (int side = 64; side <= max_texture_side; side *= 2) {
    for (const glm::ivec2 size : {glm::ivec2(side, side), {2 * side, side}}) {
      if (size.x > max_texture_side) continue;
      if (std::optional<Atlas> atlas = packer.into(size)) return *atlas;
    }
  }
  throw too_many();
}

double filled_share(const std::vector<Chart>& charts, const Atlas& atlas) {
  const double texels = area_of(charts) * atlas.texels_per_metre * atlas.texels_per_metre;
  return texels / (static_cast<double>(atlas.size.x) * atlas.size.y);
}

}  // namespace pomona
