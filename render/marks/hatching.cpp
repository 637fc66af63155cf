#include "render/marks/hatching.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/gradient_noise.h"

namespace pomona {

namespace {

/// Points on a sheet in square cells, for queries that reach at most a cell.
class LineGrid {
 public:
  /// \param reach pixels: the largest distance for is_free().
  LineGrid(int width, int height, double reach);

  /// \param step index of the point along its line, from the seed; negative in the other direction.
  void add(const glm::dvec2& place, int line, int step);

  /// Whether no point lies nearer than `distance`, except those of the same line within `own` steps.
  bool is_free(const glm::dvec2& place, double distance, int line, int step, int own) const;

 private:
  struct Entry {
    glm::dvec2 place;
    int line, step;
  };
  std::size_t cell(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }

  double reach_;
  int columns_, rows_;
  std::vector<std::vector<Entry>> cells_;
};

LineGrid::LineGrid(int width, int height, double reach)
    : reach_(reach),
      columns_(static_cast<int>(width / reach) + 1),
      rows_(static_cast<int>(height / reach) + 1),
      cells_(static_cast<std::size_t>(columns_) * rows_) {}

void LineGrid::add(const glm::dvec2& place, int line, int step) {
  const int column = std::clamp(static_cast<int>(std::floor(place.x / reach_)), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(std::floor(place.y / reach_)), 0, rows_ - 1);
  cells_[cell(column, row)].push_back({place, line, step});
}

bool LineGrid::is_free(const glm::dvec2& place, double distance, int line, int step, int own) const {
  const int column = static_cast<int>(std::floor(place.x / reach_)),
            row = static_cast<int>(std::floor(place.y / reach_));
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x) {
      for (const Entry& entry : cells_[cell(x, y)]) {
        if (entry.line == line && std::abs(entry.step - step) <= own) continue;
        const glm::dvec2 away = entry.place - place;
        if (glm::dot(away, away) < distance * distance) return false;
      }
    }
  }
  return true;
}

constexpr int max_steps = 20000;
constexpr double min_bend = 0.75;  // cosine of the largest turn of a line over half a spacing, because a pen draws no
                                   // corners

/// One set of lines: along the flow, or crossing it.
class LineSet {
 public:
  LineSet(const ToneMap& tones, const FlowField& flow, const HatchOptions& options, double bare, glm::dvec2 turn)
      : tones_(tones),
        flow_(flow),
        options_(options),
        bare_(bare),
        turn_(turn),
        stride_(std::max(1.0, 0.1 * options.spacing)),
        grid_(tones.width, tones.height, options.spacing) {}

  std::vector<Mark> lines() {
    // Seeds lie all over the picture; seeds beside the last line come first, so that neighbours run side by side.
    std::vector<Mark> marks;
    const double d = options_.spacing;
    for (double y = 0.5 * d; y < tones_.height; y += d) {
      for (double x = 0.5 * d; x < tones_.width; x += d) {
        seeds_.push_back({x, y});
        while (!seeds_.empty()) {
          const glm::dvec2 seed = seeds_.front();
          seeds_.pop_front();
          Mark mark = line_through(seed);
          if (mark.size() > 1) marks.push_back(std::move(mark));
        }
      }
    }
    return marks;
  }

 private:
  /// The remaining darkness after the lighter set: 0..1.
  double tone(const glm::dvec2& place) const { return (tones_.at(place) - bare_) / (1 - bare_); }

  glm::dvec2 way(const glm::dvec2& place, const glm::dvec2& heading) const {
    const glm::dvec2 along = flow_.at(place, {1, 0});
    const glm::dvec2 turned(along.x * turn_.x - along.y * turn_.y, along.x * turn_.y + along.y * turn_.x);
    return glm::dot(turned, heading) < 0 ? -turned : turned;
  }

  bool holds(const glm::dvec2& place) const {
    return place.x >= 0 && place.y >= 0 && place.x < tones_.width && place.y < tones_.height &&
           tone(place) > options_.lightest;
  }

  /// Follows the flow from a place by the midpoint rule, until it is light, another line is near, or the flow turns a
  /// corner.
  std::vector<glm::dvec2> followed(glm::dvec2 place, glm::dvec2 heading, int line, int sense) {
    std::vector<glm::dvec2> points;
    std::deque<glm::dvec2> lately;  // headings over half a spacing
    const int own = static_cast<int>(std::ceil(3 * options_.spacing / stride_));
    for (int step = 1; step <= max_steps; ++step) {
      const glm::dvec2 first = way(place, heading);
      heading = way(place + first * (0.5 * stride_), first);
      place += heading * stride_;
      lately.push_back(heading);
      // The last one stays: in small pictures one step is longer than half a spacing.
      if (lately.size() > 1 && static_cast<double>(lately.size()) * stride_ > 0.5 * options_.spacing)
        lately.pop_front();
      if (glm::dot(lately.front(), heading) < min_bend) break;
      if (!holds(place) || !grid_.is_free(place, 0.55 * options_.spacing, line, sense * step, own)) break;
      grid_.add(place, line, sense * step);
      points.push_back(place);
    }
    return points;
  }

  /// A line in both directions from a seed that is far enough from all lines; empty if it would be too short.
  Mark line_through(const glm::dvec2& seed) {
    if (!holds(seed) || !grid_.is_free(seed, 0.95 * options_.spacing, -1, 0, 0)) return {};
    const int line = count_++;
    grid_.add(seed, line, 0);
    const glm::dvec2 heading = way(seed, {1, 0});
    std::vector<glm::dvec2> points = followed(seed, -heading, line, -1);
    std::reverse(points.begin(), points.end());
    points.push_back(seed);
    const std::vector<glm::dvec2> onwards = followed(seed, heading, line, 1);
    points.insert(points.end(), onwards.begin(), onwards.end());
    if (static_cast<double>(points.size()) * stride_ < 1.5 * options_.spacing) return {};

    sow_beside(points);
    return inked(points, line);
  }

  /// Seeds for the next lines, left and right of this one.
  void sow_beside(const std::vector<glm::dvec2>& points) {
    const auto every = static_cast<std::size_t>(std::max(1.0, options_.spacing / stride_));
    for (std::size_t i = 0; i + 1 < points.size(); i += every) {
      const glm::dvec2 along = (points[i + 1] - points[i]) / stride_, across(-along.y, along.x);
      seeds_.push_back(points[i] + across * options_.spacing);
      seeds_.push_back(points[i] - across * options_.spacing);
    }
  }

  /// The width follows the tone, with a tremble and thin ends.
  Mark inked(const std::vector<glm::dvec2>& points, int line) const {
    Mark mark;
    const double last = stride_ * static_cast<double>(points.size() - 1);
    const double taper = std::min(2 * options_.spacing, last / 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double step = stride_ * static_cast<double>(i);
      const double dark = std::clamp(tone(points[i]), 0.0, 1.0);
      const double hand = 1 + 0.25 * gradient_noise({step / (4 * options_.spacing), 3.7 * line + 0.5, 0.5}, 103);
      const double end = std::min({1.0, step / taper, (last - step) / taper});
      const double width = options_.width * (0.14 + 0.86 * dark) * hand * std::sqrt(std::max(end, 0.04));
      mark.push_back({points[i], 0.5 * width});
    }
    return mark;
  }

  const ToneMap& tones_;
  const FlowField& flow_;
  HatchOptions options_;
  double bare_;
  glm::dvec2 turn_;
  double stride_;  // pixels from point to point of a line
  LineGrid grid_;
  std::deque<glm::dvec2> seeds_;
  int count_ = 0;
};

}  // namespace

std::vector<Mark> hatched(const ToneMap& tones, const FlowField& flow, const HatchOptions& options) {
  std::vector<Mark> marks = LineSet(tones, flow, options, 0, {1, 0}).lines();

  // The second set crosses at about 60 degrees, (1, sqrt 3) / 2, and is finer.
  HatchOptions finer = options;
  finer.width *= 0.75;
  std::vector<Mark> crossing = LineSet(tones, flow, finer, options.crossing, {0.5, 0.8660254037844386}).lines();
  marks.insert(marks.end(), std::make_move_iterator(crossing.begin()), std::make_move_iterator(crossing.end()));
  return marks;
}

}  // namespace pomona
