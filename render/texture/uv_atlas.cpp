#include "render/texture/uv_atlas.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "generator/base/cross.h"
#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "render/texture/chart_outline.h"

namespace pomona {

namespace {

/// Rows of blocks are bits of words.
using Word = std::uint64_t;

/// ORs a row of `words`, shifted down by `shift` bits, into `to`. Bits beyond its end are 0.
void or_moved(Word* to, const Word* row, std::size_t words, int shift) {
  const auto skip = static_cast<std::size_t>(shift / 64);
  const int bits = shift % 64;
  for (std::size_t w = 0; w + skip < words; ++w) {
    Word word = row[w + skip] >> bits;
    if (bits != 0 && w + skip + 1 < words) word |= row[w + skip + 1] << (64 - bits);
    to[w] |= word;
  }
}

/// A mask's rows as runs of blocks side by side.
struct BlockRun {
  int row = 0, begin = 0, length = 0;
};
std::vector<BlockRun> runs_of(const BlockMask& mask) {
  std::vector<BlockRun> runs;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (!mask.has(x, y)) continue;
      const int begin = x;
      while (x < mask.width && mask.has(x, y)) ++x;
      runs.push_back({y, begin, x - begin});
    }
  }
  return runs;
}

/// The blocks of a chart in one rotation. Shapes of one kind need the same blocks.
struct Shape {
  BlockMask mask;
  std::vector<BlockRun> runs;
  std::size_t kind = 0;
  Shape(BlockMask of, std::size_t number) : mask(std::move(of)), runs(runs_of(mask)), kind(number) {}
};

/// Numbers masks; equal masks have the same number.
class Kinds {
 public:
  std::size_t of(const BlockMask& mask) {
    return kinds_.try_emplace({mask.width, mask.height, mask.bits}, kinds_.size()).first->second;
  }
  std::size_t count() const { return kinds_.size(); }

 private:
  std::map<std::tuple<int, int, std::vector<std::uint64_t>>, std::size_t> kinds_;
};

/// Occupied blocks. For each k, a row also marks every block with an occupied one among the 2^k blocks that begin with
/// it, so one look-up tells for a whole row of places whether a run is free.
class Field {
 public:
  Field(const glm::ivec2& blocks, std::size_t kinds)
      : blocks_(blocks),
        words_(static_cast<std::size_t>(blocks.x + 63) / 64),
        levels_(static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(blocks.x)))),
        rows_(static_cast<std::size_t>(blocks.y) * levels_ * words_, 0),
        first_row_(kinds, 0) {}

  /// The first free place for the shape, row by row and before row `end`. Blocks are never freed, so shapes of its kind
  /// need not be tried in earlier rows again.
  std::optional<glm::ivec2> place(const Shape& shape, double end) {
    const int last = blocks_.x - shape.mask.width;
    int& y = first_row_[shape.kind];
    for (; y < end && y + shape.mask.height <= blocks_.y && last >= 0; ++y) {
      looks_ += 2 * words_ * shape.runs.size();
      if (const std::optional<int> x = first_free(shape, y, last)) return glm::ivec2(*x, y);
    }
    return std::nullopt;
  }

  void take(const Shape& shape, const glm::ivec2& at) {
    for (const BlockRun& run : shape.runs) {
      Word* const row = &rows_[place_of(at.y + run.row, 0)];
      for (int x = at.x + run.begin; x < at.x + run.begin + run.length; ++x)
        row[static_cast<std::size_t>(x) / 64] |= Word{1} << (x % 64);
      for (std::size_t level = 1; level < levels_; ++level) {
        Word* const wider = row + level * words_;
        std::copy_n(wider - words_, words_, wider);
        or_moved(wider, wider - words_, words_, 1 << (level - 1));
      }
    }
  }

  std::size_t looks() const { return looks_; }  ///< the work so far: words of the rows that were tried

 private:
  std::size_t place_of(int row, std::size_t level) const {
    return (static_cast<std::size_t>(row) * levels_ + level) * words_;
  }
  /// A row that marks 2^k blocks at once: the run is free where those from its begin and those up to its end are.
  struct Cover {
    const Word* row;
    int second;  ///< where the last 2^k blocks begin
  };
  Cover cover_of(const BlockRun& run, int y) const {
    const int level = std::bit_width(static_cast<unsigned>(run.length)) - 1;
    return {&rows_[place_of(y + run.row, static_cast<std::size_t>(level))], run.begin + run.length - (1 << level)};
  }

  /// Word by word of places; nothing more is read of a word in which no place is left.
  std::optional<int> first_free(const Shape& shape, int y, int last) const {
    for (int begin = 0; begin <= last; begin += 64) {
      Word free = last - begin >= 63 ? ~Word{0} : (Word{2} << (last - begin)) - 1;
      for (const BlockRun& run : shape.runs) {
        const auto [row, second] = cover_of(run, y);
        free &= ~(bits_from(row, begin + run.begin) | bits_from(row, begin + second));
        if (free == 0) break;
      }
      if (free != 0) return begin + std::countr_zero(free);
    }
    return std::nullopt;
  }

  /// 64 blocks of a row, from one on; beyond its end 0.
  Word bits_from(const Word* row, int first) const {
    const auto word = static_cast<std::size_t>(first / 64);
    const int bits = first % 64;
    const Word low = row[word] >> bits;
    return bits != 0 && word + 1 < words_ ? low | row[word + 1] << (64 - bits) : low;
  }

  glm::ivec2 blocks_;
  std::size_t words_, levels_;
  std::vector<Word> rows_;      // per row, per k
  std::vector<int> first_row_;  // per kind: first row that may have a place for it
  std::size_t looks_ = 0;
};

double area_of(const std::vector<ChartOutline>& charts) {
  double area = 0;
  for (const ChartOutline& chart : charts) area += chart.area();
  return area;
}

constexpr double longest_speck = 16, largest_speck = 6;  // texels, and square texels

/// Charts at one scale, in all rotations.
struct Shapes {
  double texels_per_metre = 0;
  int mip_levels = 0;
  std::vector<std::vector<Shape>> of_chart;
  std::vector<std::uint8_t> speck;
  std::size_t kinds = 0;  ///< number of kinds of shapes
  std::int64_t min = 0;   ///< blocks
};

/// A chart of a few blocks needs about the same number in every rotation.
constexpr double few_blocks = 3;
constexpr std::size_t turns_of_small_ones = 1;

/// Specks: hairs and crumbs, which would show only their edges.
bool is_speck(const Chart& chart, double area, double scale) {
  const double longest = std::max(chart.size.x, chart.size.y) * scale;
  return longest < 1 || (longest < longest_speck && area * scale * scale < largest_speck);
}

/// The order in which charts are placed, and the preferred rotations.
struct PackingOrder {
  std::vector<std::size_t> charts;
  double height = 1;  ///< weight of a shape's own height beside that of its place
};

struct ChartPlaces {
  std::vector<glm::ivec2> at;       ///< blocks
  std::vector<std::size_t> turned;  ///< which of its shapes
};

/// Finds places for charts on a texture.
class Packer {
 public:
  Packer(const std::vector<Chart>& charts, int mip_levels) : charts_(charts), mip_levels_(mip_levels) {
    for (const Chart& chart : charts) outlines_.emplace_back(chart);
  }

  double area() const { return area_of(outlines_); }

  Shapes shapes_at(double texels_per_metre) const {
    Shapes shapes{.texels_per_metre = texels_per_metre, .mip_levels = mip_levels_, .of_chart = {}, .speck = {}};
    Kinds kinds;
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      std::vector<Shape> orientations;
      const bool speck = is_speck(charts_[c], outlines_[c].area(), texels_per_metre);
      const auto add = [&](BlockMask mask) {
        const std::size_t kind = kinds.of(mask);
        orientations.emplace_back(std::move(mask), kind);
      };
      if (speck) add(speck_mask());
      const double blocks_per_metre = texels_per_metre / (1 << mip_levels_);
      const bool small = std::max(charts_[c].size.x, charts_[c].size.y) * blocks_per_metre < few_blocks;
      const std::vector<Turn>& turns = outlines_[c].turns();
      const std::size_t count = small ? std::min(turns_of_small_ones, turns.size()) : turns.size();
      for (std::size_t i = 0; i < count && !speck; ++i) add(outlines_[c].mask(turns[i], blocks_per_metre));
      std::int64_t min = orientations.front().mask.count;
      for (const Shape& shape : orientations) min = std::min(min, shape.mask.count);
      shapes.min += min;
      shapes.of_chart.push_back(std::move(orientations));
      shapes.speck.push_back(speck ? 1 : 0);
    }
    shapes.kinds = kinds.count();
    return shapes;
  }

  /// Sorts charts, the largest first.
  PackingOrder first_order(const Shapes& shapes) const {
    PackingOrder order;
    order.charts.resize(charts_.size());
    std::iota(order.charts.begin(), order.charts.end(), std::size_t{0});
    std::stable_sort(order.charts.begin(), order.charts.end(), [&](std::size_t a, std::size_t b) {
      return shapes.of_chart[a].front().mask.count > shapes.of_chart[b].front().mask.count;
    });
    return order;
  }

  /// Sorts charts roughly, the largest first; one that is half as large may come earlier.
  PackingOrder other_order(const Shapes& shapes, std::uint64_t number) const {
    const RandomStream random({number, 0}, "atlas");
    std::vector<double> size;
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      const double blocks = static_cast<double>(shapes.of_chart[c].front().mask.count);
      size.push_back(blocks * reproducible::exp(1.4 * random.uniform(c + 1)));
    }
    PackingOrder order = first_order(shapes);
    std::stable_sort(order.charts.begin(), order.charts.end(),
                     [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
    order.height = random.uniform(0);
    return order;
  }

  std::optional<ChartPlaces> placed(const Shapes& shapes, const glm::ivec2& size, const PackingOrder& order) {
    // Skips sizes with too few blocks.
    const glm::ivec2 blocks = size >> mip_levels_;
    if (shapes.min > static_cast<std::int64_t>(blocks.x) * blocks.y) return std::nullopt;
    ChartPlaces found{std::vector<glm::ivec2>(charts_.size()), std::vector<std::size_t>(charts_.size(), 0)};
    Field field(blocks, shapes.kinds);
    for (const std::size_t c : order.charts) {
      const std::vector<Shape>& orientations = shapes.of_chart[c];
      double lowest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < orientations.size(); ++i) {
        const double own = order.height * orientations[i].mask.height;
        const std::optional<glm::ivec2> at = field.place(orientations[i], lowest - own);
        if (!at) continue;
        lowest = at->y + own;
        found.at[c] = *at, found.turned[c] = i;
      }
      if (lowest == std::numeric_limits<double>::infinity()) break;
      field.take(orientations[found.turned[c]], found.at[c]);
      if (c == order.charts.back()) {
        looks_ += field.looks();
        return found;
      }
    }
    looks_ += field.looks();
    if (order.charts.empty()) return found;
    return std::nullopt;
  }

  PackedCharts packed(const Shapes& shapes, const glm::ivec2& size, const ChartPlaces& placed) const {
    PackedCharts result;
    Atlas& atlas = result.atlas;
    atlas.size = size, atlas.mip_levels = mip_levels_, atlas.texels_per_metre = shapes.texels_per_metre;
    atlas.speck = shapes.speck;
    atlas.owner.assign(static_cast<std::size_t>(atlas.blocks().x) * atlas.blocks().y, -1);
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      const std::size_t packing = placed.turned[c];
      const BlockMask& mask = shapes.of_chart[c][packing].mask;
      for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
          const std::size_t block =
              static_cast<std::size_t>(placed.at[c].y + y) * atlas.blocks().x + placed.at[c].x + x;
          if (mask.has(x, y)) atlas.owner[block] = static_cast<std::int32_t>(c);
        }
      }
      atlas.corner.push_back((glm::dvec2(placed.at[c]) + 0.5) * static_cast<double>(atlas.block()));
      const bool turns = !charts_[c].frame && shapes.speck[c] == 0;
      result.charts.push_back(turns ? turned(charts_[c], outlines_[c].turns()[packing]) : charts_[c]);
    }
    return result;
  }

  std::size_t looks() const { return looks_; }

 private:
  const std::vector<Chart>& charts_;
  int mip_levels_;
  std::vector<ChartOutline> outlines_;
  std::size_t looks_ = 0;
};

/// Limit of the search for better places, in words that are read: a share of the cost of texels.
std::size_t looks_for(const glm::ivec2& size) { return static_cast<std::size_t>(size.x) * size.y * 24; }
constexpr std::uint64_t max_orders = 2000, orders_at_a_scale = 24;

/// Charts at a scale, and where they are.
struct AtlasFit {
  Shapes shapes;
  ChartPlaces places;
};

/// Bisects between a scale that fits and one that does not, placing the largest charts first.
std::optional<AtlasFit> fit_of(Packer& packer, const glm::ivec2& size) {
  const double area = packer.area();
  double fits = 0, too_large = area > 0 ? size.x / std::sqrt(area) : size.x;
  Shapes shapes = packer.shapes_at(fits);
  std::optional<ChartPlaces> places = packer.placed(shapes, size, packer.first_order(shapes));
  if (!places) return std::nullopt;
  AtlasFit best{std::move(shapes), std::move(*places)};
  constexpr int halvings = 8;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (fits + too_large);
    shapes = packer.shapes_at(middle);
    places = packer.placed(shapes, size, packer.first_order(shapes));
    (places ? fits : too_large) = middle;
    if (places) best = {std::move(shapes), std::move(*places)};
  }
  return best;
}

/// Tries other orders that let the charts be a little larger.
AtlasFit enlarged(Packer& packer, const glm::ivec2& size, AtlasFit best) {
  const std::size_t enough = packer.looks() + looks_for(size);
  double step = 0.08;
  std::uint64_t tried = 0, number = 0;
  Shapes larger = packer.shapes_at(best.shapes.texels_per_metre * (1 + step));
  while (step > 0.002 && number < max_orders && packer.looks() < enough) {
    std::optional<ChartPlaces> found = packer.placed(larger, size, packer.other_order(larger, ++number));
    ++tried;
    if (!found && tried < orders_at_a_scale) continue;
    if (found)
      best = {std::move(larger), std::move(*found)};
    else
      step *= 0.6;
    tried = 0;
    larger = packer.shapes_at(best.shapes.texels_per_metre * (1 + step));
  }
  return best;
}

}  // namespace

PackedCharts packed_to_side(const std::vector<Chart>& charts, int side, int mip_levels) {
  // Gives up a mip level for charts that are half as large again.
  constexpr double worth = 1.5;
  const glm::ivec2 size(side);
  std::optional<Packer> chosen;
  std::optional<AtlasFit> best;
  for (int levels = mip_levels; levels >= 0; --levels) {
    if (side % (1 << levels) != 0) continue;
    Packer packer(charts, levels);
    std::optional<AtlasFit> fit = fit_of(packer, size);
    if (fit && best && fit->shapes.texels_per_metre < worth * best->shapes.texels_per_metre) break;
    if (fit) best = std::move(fit), chosen.emplace(std::move(packer));
  }
  if (!best) {
    throw Error(ExitStatus::usage, "--texture " + std::to_string(side) + ": too few texels for this piece",
                "its surface falls into " + std::to_string(charts.size()) + " charts; take a larger texture");
  }
  const AtlasFit fit = enlarged(*chosen, size, std::move(*best));
  return chosen->packed(fit.shapes, size, fit.places);
}

PackedCharts packed_at_texel(const std::vector<Chart>& charts, double texel, int mip_levels) {
  const auto too_many = [&] {
    return Error(ExitStatus::usage,
                 "--texel: this piece would need a texture of more than " + std::to_string(max_texture_side) + " x " +
                     std::to_string(max_texture_side) + " texels",
                 "take larger texels, or smaller pieces");
  };
  // Reported before anything of that size is made.
  const double scale = 1 / texel;
  constexpr double max = static_cast<double>(max_texture_side) * max_texture_side;
  Packer packer(charts, mip_levels);
  if (!(packer.area() * scale * scale <= max)) throw too_many();
  for (const Chart& chart : charts) {
    if (!(std::max(chart.size.x, chart.size.y) * scale < max_texture_side)) throw too_many();
  }

  const Shapes shapes = packer.shapes_at(scale);
  for (int side = 64; side <= max_texture_side; side *= 2) {
    for (const glm::ivec2 size : {glm::ivec2(side, side), {2 * side, side}}) {
      if (size.x > max_texture_side) continue;
      std::optional<ChartPlaces> placed = packer.placed(shapes, size, packer.first_order(shapes));
      for (std::uint64_t number = 1; !placed && number <= orders_at_a_scale; ++number)
        placed = packer.placed(shapes, size, packer.other_order(shapes, number));
      if (placed) return packer.packed(shapes, size, *placed);
    }
  }
  throw too_many();
}

double filled_share(const std::vector<Chart>& charts, const Atlas& atlas) {
  double area = 0;
  for (const Chart& chart : charts) {
    for (const glm::uvec3& t : chart.corners)
      area += 0.5 * std::abs(cross(chart.flat[t.y] - chart.flat[t.x], chart.flat[t.z] - chart.flat[t.x]));
  }
  const double texels = area * atlas.texels_per_metre * atlas.texels_per_metre;
  return texels / (static_cast<double>(atlas.size.x) * atlas.size.y);
}

}  // namespace pomona
