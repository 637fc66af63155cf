#include "render/plate/part_map.h"

#include <algorithm>
#include <cmath>

namespace pomona {

namespace {

/// Smallest depth of a place to point at, as a share of the part's largest depth.
constexpr double deep_enough = 0.75;

/// The box of a part's pixels, and its pixels within: 1 where they are.
struct Cutout {
  int x0 = 0, y0 = 0, width = 0, height = 0;
  std::vector<std::uint8_t> inside;
  double area = 0;
};

Cutout cut_out(const PartMap& map, std::int32_t part) {
  int x0 = map.width, y0 = map.height, x1 = -1, y1 = -1;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (map.at(x, y) != part) continue;
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  }
  Cutout cutout;
  if (x1 < 0) return cutout;

  // One pixel of air around it, so that a part that reaches the picture's edge ends there.
  cutout.x0 = x0 - 1, cutout.y0 = y0 - 1, cutout.width = x1 - x0 + 3, cutout.height = y1 - y0 + 3;
  cutout.inside.assign(static_cast<std::size_t>(cutout.width) * cutout.height, 0);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (map.at(x, y) != part) continue;
      cutout.inside[static_cast<std::size_t>(y - cutout.y0) * cutout.width + x - cutout.x0] = 1;
      cutout.area += 1;
    }
  }
  return cutout;
}

/// Lower envelope of parabolas [Felzenszwalb & Huttenlocher 2012]: least of f[j] + (i - j)^2 for every i.
void spread(std::vector<double>& f) {
  const int count = static_cast<int>(f.size());
  std::vector<int> root(f.size());
  std::vector<double> from(f.size() + 1), old = f;
  int k = 0;
  from[0] = -1e30, from[1] = 1e30;
  for (int q = 1; q < count; ++q) {
    const auto meet = [&](int r) { return ((old[q] + double(q) * q) - (old[r] + double(r) * r)) / (2.0 * (q - r)); };
    double s = meet(root[k]);
    while (k > 0 && s <= from[k]) s = meet(root[--k]);
    root[++k] = q;
    from[k] = s, from[k + 1] = 1e30;
  }
  k = 0;
  for (int q = 0; q < count; ++q) {
    while (from[k + 1] < q) ++k;
    f[q] = double(q - root[k]) * (q - root[k]) + old[root[k]];
  }
}

/// Squared distance of every pixel to the nearest one that is not of the part.
std::vector<double> squared_depths(const Cutout& cutout) {
  std::vector<double> depth(cutout.inside.size());
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = cutout.inside[i] != 0 ? 1e12 : 0;
  std::vector<double> line(cutout.height);
  for (int x = 0; x < cutout.width; ++x) {
    for (int y = 0; y < cutout.height; ++y) line[y] = depth[static_cast<std::size_t>(y) * cutout.width + x];
    spread(line);
    for (int y = 0; y < cutout.height; ++y) depth[static_cast<std::size_t>(y) * cutout.width + x] = line[y];
  }
  line.resize(cutout.width);
  for (int y = 0; y < cutout.height; ++y) {
    double* row = depth.data() + static_cast<std::size_t>(y) * cutout.width;
    std::copy(row, row + cutout.width, line.begin());
    spread(line);
    std::copy(line.begin(), line.end(), row);
  }
  return depth;
}

/// A name of several parts stands for the first of them.
PartMap merged_names(PartMap map) {
  std::vector<std::int32_t> first(map.names.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    first[i] =
        static_cast<std::int32_t>(std::find(map.names.begin(), map.names.end(), map.names[i]) - map.names.begin());
  for (std::int32_t& part : map.part) part = part < 0 ? -1 : first.at(part);
  return map;
}

/// A few thousand places to choose from are enough.
std::vector<glm::dvec2> some_of(const std::vector<glm::dvec2>& places) {
  const std::size_t step = places.size() / 4096 + 1;
  std::vector<glm::dvec2> some;
  for (std::size_t i = 0; i < places.size(); i += step) some.push_back(places[i]);
  return some;
}

ShownPart shown(const Cutout& cutout, const std::vector<double>& depth, double deepest, std::int32_t part) {
  ShownPart result{part, cutout.area, {}};
  for (int x = 0; x < cutout.width; ++x) {
    for (int y = 0; y < cutout.height; ++y) {
      if (depth[static_cast<std::size_t>(y) * cutout.width + x] < deep_enough * deep_enough * deepest) continue;
      result.places.emplace_back(cutout.x0 + x + 0.5, cutout.y0 + y + 0.5);
    }
  }
  result.places = some_of(result.places);
  return result;
}

/// A part that is too thin may lie at the figure's rim: lines then point at it from outside, at pixels beside empty
/// ones.
std::vector<glm::dvec2> places_on_rim(const PartMap& map, std::int32_t part) {
  std::vector<glm::dvec2> places;
  for (int x = 1; x + 1 < map.width; ++x) {
    for (int y = 1; y + 1 < map.height; ++y) {
      if (map.at(x, y) != part) continue;
      const bool at_rim = map.at(x - 1, y) < 0 || map.at(x + 1, y) < 0 || map.at(x, y - 1) < 0 || map.at(x, y + 1) < 0;
      if (at_rim) places.emplace_back(x + 0.5, y + 0.5);
    }
  }
  return some_of(places);
}

}  // namespace

std::vector<ShownPart> shown_parts(const PartMap& given, double min_share, double min_depth) {
  const PartMap map = merged_names(given);
  const auto all = static_cast<double>(std::count_if(map.part.begin(), map.part.end(), [](auto p) { return p >= 0; }));
  std::vector<ShownPart> parts;
  for (std::int32_t part = 0; part < static_cast<std::int32_t>(map.names.size()); ++part) {
    const Cutout cutout = cut_out(map, part);
    if (cutout.area == 0 || cutout.area < min_share * all) continue;
    const std::vector<double> depth = squared_depths(cutout);
    const double deepest = *std::max_element(depth.begin(), depth.end());
    if (deepest >= min_depth * min_depth) {
      parts.push_back(shown(cutout, depth, deepest, part));
    } else if (std::vector<glm::dvec2> places = places_on_rim(map, part); !places.empty()) {
      parts.push_back({part, cutout.area, std::move(places)});
    }
  }
  return parts;
}

}  // namespace pomona
