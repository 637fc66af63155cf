#include "generator/cut/section/size_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

glm::dvec2 closest_point(const glm::dvec2& p, const SizeSource& s) {
  const glm::dvec2 along = s.b - s.a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? glm::clamp(glm::dot(p - s.a, along) / square, 0.0, 1.0) : 0.0;
  return s.a + t * along;
}

/// Gaps below this many finest lengths get no points: they would cost more than all others together.
constexpr double narrow_gap = 2.2;

/// Gaps below this many finest lengths, and those whose edges may be longer than this share of them, get one row.
constexpr double single_row_gap = 4, single_row_share = 0.45;

/// Points of such a row keep this share of the gap apart.
constexpr double row_spacing = 0.8;

/// The colour of the source's side that faces p.
const Color& facing_color(const SizeSource& s, const glm::dvec2& p) {
  const glm::dvec2 along = s.b - s.a, to = p - s.a;
  return along.x * to.y - along.y * to.x > 0 ? s.left : s.right;
}

double difference(const Color& a, const Color& b) {
  const Color d = glm::abs(a - b);
  return static_cast<double>(std::max({d.x, d.y, d.z}));
}

double distance_to_segment(const glm::dvec2& p, const SizeSource& s) { return glm::distance(p, closest_point(p, s)); }

/// Calls visit(point) at steps of at most `step` along the segment, ends included.
template <typename Visit>
void walk(const SizeSource& s, double step, const Visit& visit) {
  const int count = 1 + static_cast<int>(glm::length(s.b - s.a) / step);
  for (int i = 0; i <= count; ++i) visit(glm::mix(s.a, s.b, double(i) / count));
}

}  // namespace

SizeField::SizeField(std::span<const SizeSource> sources, const SizeLimits& limits, int across)
    : sources_(sources.begin(), sources.end()), limits_(limits) {
  if (sources_.empty()) return;
  glm::dvec2 high = low_ = sources_.front().a;
  for (const SizeSource& s : sources_) {
    low_ = glm::min(low_, glm::min(s.a, s.b));
    high = glm::max(high, glm::max(s.a, s.b));
  }
  cell_ = std::max({high.x - low_.x, high.y - low_.y, limits_.finest}) / across;
  width_ = 1 + static_cast<int>((high.x - low_.x) / cell_);
  height_ = 1 + static_cast<int>((high.y - low_.y) / cell_);
  draw_sources();
  find_nearest();
  find_gaps();
  spread();
  bucket_sources();
}

int SizeField::column(double x) const {
  return static_cast<int>(std::clamp((x - low_.x) / cell_, 0.0, static_cast<double>(width_ - 1)));
}
int SizeField::row(double y) const {
  return static_cast<int>(std::clamp((y - low_.y) / cell_, 0.0, static_cast<double>(height_ - 1)));
}

double SizeField::at(const glm::dvec2& p) const {
  return sources_.empty() ? limits_.coarsest : size_[index(column(p.x), row(p.y))];
}

void SizeField::draw_sources() {
  // Begin with cells without sizes and sources.
  const std::size_t cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  size_.assign(cells, limits_.coarsest);
  gap_size_.assign(cells, limits_.coarsest);
  on_source_.assign(cells, 0);
  distance_.assign(cells, 1e300);
  nearest_.assign(cells, -1);

  // Every cell that a source passes through takes its size, and the nearest source with colours.
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    const double size = std::clamp(sources_[s].size, limits_.finest, limits_.coarsest);
    has_lines_ = has_lines_ || !sources_[s].has_color;
    walk(sources_[s], 0.5 * cell_, [&](const glm::dvec2& p) {
      const int x = column(p.x), y = row(p.y);
      const std::size_t i = index(x, y);
      size_[i] = std::min(size_[i], size);
      if (!sources_[s].has_color) return;
      on_source_[i] = 1;
      const double distance = distance_to_segment(center(x, y), sources_[s]);
      if (distance >= distance_[i]) return;
      distance_[i] = distance;
      nearest_[i] = static_cast<std::int32_t>(s);
    });
  }
}

namespace {

/// Visits every cell of a grid after four of its neighbours, then again after the other four: calls
/// pull(x, y, cell, neighbour, is_beside), the last false where they touch at a corner only.
template <typename Pull>
void sweep(int width, int height, const Pull& pull) {
  const auto row = static_cast<std::size_t>(width);

  // From below and from the left.
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x);
      if (x > 0) pull(x, y, i, i - 1, true);
      if (y == 0) continue;
      if (x > 0) pull(x, y, i, i - row - 1, false);
      pull(x, y, i, i - row, true);
      if (x + 1 < width) pull(x, y, i, i - row + 1, false);
    }
  }

  // From above and from the right.
  for (int y = height - 1; y >= 0; --y) {
    for (int x = width - 1; x >= 0; --x) {
      const std::size_t i = static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x);
      if (x + 1 < width) pull(x, y, i, i + 1, true);
      if (y + 1 == height) continue;
      if (x + 1 < width) pull(x, y, i, i + row + 1, false);
      pull(x, y, i, i + row, true);
      if (x > 0) pull(x, y, i, i + row - 1, false);
    }
  }
}

}  // namespace

/// Passes the nearest source on from cell to cell [Danielsson 1980].
void SizeField::find_nearest() {
  sweep(width_, height_, [&](int x, int y, std::size_t to, std::size_t from, bool) {
    if (nearest_[from] < 0 || nearest_[from] == nearest_[to]) return;
    const double distance = distance_to_segment(center(x, y), sources_[static_cast<std::size_t>(nearest_[from])]);
    if (distance >= distance_[to]) return;
    distance_[to] = distance;
    nearest_[to] = nearest_[from];
  });
}

/// Finds gaps: two neighbouring cells with different nearest sources lie midway between these.
void SizeField::find_gaps() {
  const auto compare = [&](int x, int y, int other_x, int other_y) {
    const std::size_t i = index(x, y), j = index(other_x, other_y);
    if (nearest_[i] == nearest_[j] || nearest_[i] < 0 || nearest_[j] < 0) return;
    measure_gap(center(x, y), i, center(other_x, other_y), j);
  };
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (x + 1 < width_) compare(x, y, x + 1, y);
      if (y + 1 < height_) compare(x, y, x, y + 1);
    }
  }
}

void SizeField::measure_gap(const glm::dvec2& center, std::size_t cell, const glm::dvec2& other_center,
                            std::size_t other) {
  const SizeSource &here = sources_[static_cast<std::size_t>(nearest_[cell])],
                   &there = sources_[static_cast<std::size_t>(nearest_[other])];
  const double apart = difference(facing_color(here, center), facing_color(there, other_center));
  if (apart <= limits_.contrast) return;
  const double share = std::sqrt(limits_.contrast / apart);

  // At a bend the distance of the colours is the way to both.
  const glm::dvec2 p = closest_point(center, here), q = closest_point(other_center, there);
  const double gap = std::max(glm::distance(p, q), distance_[cell] + distance_[other]);
  if (gap < narrow_gap * limits_.finest) return;
  double size = std::max(share * gap, limits_.finest);
  if (share > single_row_share || gap < single_row_gap * limits_.finest) {
    size = std::max(share, row_spacing) * gap;
    mid_gap_.push_back({0.5 * (p + q), size});
  }
  gap_size_[cell] = std::min(gap_size_[cell], size);
  gap_size_[other] = std::min(gap_size_[other], size);
}

/// Spreads sizes from cell to cell; those of gaps only within the gap. (Lines of cells that touch at corners separate
/// its sides.)
void SizeField::spread() {
  const double straight = limits_.grading * cell_, diagonal = std::sqrt(2.0) * straight;
  sweep(width_, height_, [&](int, int, std::size_t to, std::size_t from, bool is_beside) {
    size_[to] = std::min(size_[to], size_[from] + (is_beside ? straight : diagonal));
    if (on_source_[from] || !is_beside) return;
    gap_size_[to] = std::min(gap_size_[to], gap_size_[from] + straight);
  });
  for (std::size_t i = 0; i < size_.size(); ++i) size_[i] = std::min(size_[i], gap_size_[i]);
}

void SizeField::bucket_sources() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> passes;  // cell, source
  for (std::uint32_t s = 0; s < sources_.size(); ++s) {
    walk(sources_[s], 0.5 * cell_, [&](const glm::dvec2& p) {
      passes.emplace_back(static_cast<std::uint32_t>(index(column(p.x), row(p.y))), s);
    });
  }
  std::sort(passes.begin(), passes.end());
  passes.erase(std::unique(passes.begin(), passes.end()), passes.end());

  bucket_start_.assign(size_.size() + 1, 0);
  for (const auto& [cell, source] : passes) {
    ++bucket_start_[cell + 1];
    bucket_.push_back(source);
  }
  for (std::size_t i = 1; i < bucket_start_.size(); ++i) bucket_start_[i] += bucket_start_[i - 1];
}

bool SizeField::is_clear_of_sources(const glm::dvec2& p, double size) const {
  const double clearance = 0.55 * size;
  if (!has_lines_ && distance_[index(column(p.x), row(p.y))] > 1.1 * clearance + 3 * cell_) return true;
  const double reach = clearance + 0.5 * cell_;
  for (int y = row(p.y - reach); y <= row(p.y + reach); ++y) {
    for (int x = column(p.x - reach); x <= column(p.x + reach); ++x) {
      const std::size_t i = index(x, y);
      for (std::uint32_t k = bucket_start_[i]; k < bucket_start_[i + 1]; ++k) {
        const SizeSource& s = sources_[bucket_[k]];
        if (distance_to_segment(p, s) < clearance) return false;

        // Lines cannot be divided any more: an edge with a point in its circle may be no Delaunay edge.
        if (!s.has_color && glm::dot(p - s.a, p - s.b) < 0) return false;
      }
    }
  }
  return true;
}

std::vector<glm::dvec2> SizeField::samples() const {
  std::vector<glm::dvec2> accepted;
  if (sources_.empty()) return accepted;
  std::vector<std::uint32_t> last(size_.size(), 0);  // per cell: one more than its latest accepted point
  std::vector<std::uint32_t> before;                 // per accepted point: the one before it in its cell, likewise

  const auto is_clear_of_accepted = [&](const glm::dvec2& p, double size) {
    const double clearance = 0.75 * size;
    for (int y = row(p.y - clearance); y <= row(p.y + clearance); ++y) {
      for (int x = column(p.x - clearance); x <= column(p.x + clearance); ++x) {
        for (std::uint32_t k = last[index(x, y)]; k != 0; k = before[k - 1]) {
          if (glm::distance(accepted[k - 1], p) < clearance) return false;
        }
      }
    }
    return true;
  };

  const auto accept = [&](const glm::dvec2& p) {
    const std::size_t i = index(column(p.x), row(p.y));
    accepted.push_back(p);
    before.push_back(last[i]);
    last[i] = static_cast<std::uint32_t>(accepted.size());
  };

  // Rows come first. They lie midway between sources, so another source is near only where two gaps meet.
  for (const MidGap& m : mid_gap_) {
    if (distance_[index(column(m.place.x), row(m.place.y))] < 0.2 * m.size) continue;
    if (is_clear_of_accepted(m.place, m.size / 0.8)) accept(m.place);
  }

  // In every cell, take the lattice of the spacing just below its size; spacings are powers of sqrt(1/2), so that
  // wide areas share one lattice.
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const double size = size_[index(x, y)];
      double spacing = limits_.coarsest;
      while (spacing > 1.05 * size) spacing *= std::sqrt(0.5);
      const double rise = spacing * std::sqrt(0.75);
      const glm::dvec2 from = low_ + cell_ * glm::dvec2(x, y), to = from + glm::dvec2(cell_);
      for (double r = std::ceil(from.y / rise); r * rise < to.y; ++r) {
        const double shift = std::fmod(std::fabs(r), 2.0) == 0 ? 0.0 : 0.5;
        for (double c = std::ceil(from.x / spacing - shift); (c + shift) * spacing < to.x; ++c) {
          const glm::dvec2 p((c + shift) * spacing, r * rise);
          if (is_clear_of_accepted(p, spacing) && is_clear_of_sources(p, size)) accept(p);
        }
      }
    }
  }
  return accepted;
}

}  // namespace pomona
