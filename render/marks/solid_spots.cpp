#include "render/marks/solid_spots.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

#include "generator/mesh/disjoint_sets.h"
#include "render/marks/blur.h"

namespace pomona {

namespace {

constexpr double fewest = 6;  // pixels; less is a speckle

/// Pixels of a row, from the first to the one after the last.
struct DarkRun {
  int row = 0, first = 0, end = 0;
};

/// The runs of all rows, from the top.
std::vector<DarkRun> dark_runs(const ToneMap& tones, const SpotOptions& options) {
  const std::vector<float> around = blurred(tones.darkness, tones.width, tones.height, options.around);
  const auto is_dark = [&](int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y) * tones.width + x;
    return tones.darkness[i] >= options.dark && tones.darkness[i] - around[i] >= options.contrast;
  };
  std::vector<DarkRun> runs;
  for (int y = 0; y < tones.height; ++y) {
    for (int x = 0; x < tones.width; ++x) {
      if (!is_dark(x, y)) continue;
      DarkRun run{y, x, x};
      while (x < tones.width && is_dark(x, y)) ++x;
      run.end = x;
      runs.push_back(run);
    }
  }
  return runs;
}

/// Which runs touch, each one of the row above.
DisjointSets touching(const std::vector<DarkRun>& runs) {
  DisjointSets joined(runs.size());
  std::size_t above = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    while (runs[above].row < runs[i].row - 1) ++above;
    for (std::size_t k = above; k < i && runs[k].row < runs[i].row; ++k)
      if (runs[k].first < runs[i].end && runs[i].first < runs[k].end)
        joined.join(static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i));
  }
  return joined;
}

struct Extent {
  int left = 0, right = 0, top = 0, bottom = 0;
  double area = 0;
};

std::map<std::uint32_t, Extent> extents_of(const std::vector<DarkRun>& runs, DisjointSets& joined) {
  std::map<std::uint32_t, Extent> extents;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const DarkRun& run = runs[i];
    const Extent own{run.first, run.end, run.row, run.row + 1, 0};
    Extent& extent = extents.try_emplace(joined.root(static_cast<std::uint32_t>(i)), own).first->second;
    extent.left = std::min(extent.left, run.first);
    extent.right = std::max(extent.right, run.end);
    extent.bottom = run.row + 1;
    extent.area += run.end - run.first;
  }
  return extents;
}

}  // namespace

std::vector<Mark> solid_spots(const ToneMap& tones, const SpotOptions& options) {
  const std::vector<DarkRun> runs = dark_runs(tones, options);
  DisjointSets joined = touching(runs);
  const std::map<std::uint32_t, Extent> extents = extents_of(runs, joined);
  std::vector<Mark> lines;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::uint32_t spot = joined.root(static_cast<std::uint32_t>(i));
    const Extent& extent = extents.at(spot);
    const int longer = std::max(extent.right - extent.left, extent.bottom - extent.top);
    if (extent.area < fewest || longer > options.longest) continue;
    const double y = runs[i].row + 0.5;
    lines.push_back({{{runs[i].first + 0.5, y}, 0.7}, {{runs[i].end - 0.5, y}, 0.7}});
  }
  return lines;
}

}  // namespace pomona
