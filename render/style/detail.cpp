#include "render/style/detail.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "generator/base/cell_noise.h"
#include "generator/base/gradient_noise.h"
#include "generator/base/many_values.h"
#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "render/style/example.h"

namespace pomona {

namespace {

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

constexpr double offset = 0.37;      // keeps the lattice's zeros off the axis
constexpr double deviation = 0.27;   // standard deviation of gradient noise, measured
constexpr double min_radius = 1e-9;  // metres

/// A rotation after which no lattice plane lies in a usual cut.
glm::dvec3 turned(const glm::dvec3& p) {
  return {(2 * p.x - p.y + 2 * p.z) / 3 + offset, (2 * p.x + 2 * p.y - p.z) / 3 + offset,
          (2 * p.y + 2 * p.z - p.x) / 3 + offset};
}

double radius_of(const glm::dvec3& p) { return std::sqrt(p.x * p.x + p.z * p.z); }

/// The approximate length of the skin from the fruit's middle up to a place: heights on flanks, radii on ends.
double way_up(const DetailSketch& detail, const glm::dvec3& foot) {
  const double height = foot.y - detail.middle;
  return height + std::clamp(height / detail.middle, -1.0, 1.0) * (detail.reach - radius_of(foot));
}

PatternPlace place_to_skin(const DetailSketch& detail, const glm::dvec3& position, const glm::dvec3& to_skin) {
  const double radius = std::max(radius_of(position), min_radius);
  return {position / detail.size + to_skin * (1 / detail.size - 1 / detail.length),
          std::max(1.0, radius_of(position + to_skin) / radius)};
}

PatternPlace place_in_layer(const DetailSketch& detail, const glm::dvec3& position, const DetailGuide& guide) {
  const double radius = std::max(radius_of(position), min_radius);
  const double cosine = position.x / radius, sine = position.z / radius;
  const double layer = static_cast<double>(guide.layer);
  const double up = way_up(detail, position + glm::dvec3(guide.to_skin));
  if (detail.run == DetailRun::around) {
    const double circle = detail.reach / detail.length;
    return {{layer / detail.size + circle * cosine, up / detail.size, circle * sine}, 1};
  }
  const double out = detail.reach - layer;
  return {{out / detail.size * cosine, up / detail.length, out / detail.size * sine},
          std::max(1.0, std::fabs(out) / radius)};
}

/// Dots near the middle of unit cells, at most one in each.
double dots(const DetailSketch& detail, const glm::dvec3& point, double pitch, std::uint32_t seed) {
  const glm::dvec3 low(std::floor(point.x), std::floor(point.y), std::floor(point.z));
  const std::uint32_t hash = lattice_hash(lattice_cell(low.x), lattice_cell(low.y), lattice_cell(low.z), seed);
  const double chance =
      static_cast<double>(lattice_hash(static_cast<std::int32_t>(hash & 0x7fffffffu), 1, 0, seed) >> 8) / 16777216.0;
  if (chance >= detail.density) return 0;
  // Rare dots are small; every dot lies within its cell.
  const double widest = 0.5 * pitch;
  const double min = widest * detail.smallest / detail.size;
  const double radius = min + (widest - min) * chance / detail.density;
  const glm::dvec3 share(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u);
  const glm::dvec3 away = point - low - radius - share * ((1 - 2 * radius) / 1023.0);
  const double distance = std::sqrt(away.x * away.x + away.y * away.y + away.z * away.z) / radius;
  return 1 - smoothstep(0.9 * (1 - detail.softness), 1.0, distance);
}

/// The noise of one lattice at scale * points + aside.
std::vector<double> noise_at(std::span<const glm::dvec3> points, double scale, double aside, std::uint32_t seed) {
  NoisePlaces places;
  places.reserve(points.size());
  for (const glm::dvec3& point : points) places.add(scale * point + aside, seed);
  return gradient_noise(places);
}

/// A place in the tile, by chance.
glm::dvec3 tile_offset(std::uint32_t seed) {
  const std::uint32_t hash = lattice_hash(0, 0, 0, seed);
  return glm::dvec3(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u) / 1024.0;
}

/// Whether two details of one seed have the same pattern, apart from its place in space.
bool have_one_shape(const DetailSketch& one, const DetailSketch& other) {
  const auto all = [](const DetailSketch& d) {
    return std::tuple(d.kind, d.size, d.smallest, d.width, d.density, d.softness, d.wander, d.variety);
  };
  return all(one) == all(other);
}

}  // namespace

PatternPlace pattern_place(const DetailSketch& detail, const glm::dvec3& position, const DetailGuide& guide) {
  if (detail.run == DetailRun::none) return {position / detail.size, 1};
  if (detail.run == DetailRun::to_skin) return place_to_skin(detail, position, glm::dvec3(guide.to_skin));
  return place_in_layer(detail, position, guide);
}

Pattern::Pattern(const DetailSketch& detail, std::uint32_t seed, const Pattern* like) : detail_(detail) {
  shape_.seed = detail.pattern + 4096 + 16 * seed;
  if (like != nullptr && !detail.tile && like->shape_.seed == shape_.seed && have_one_shape(like->detail_, detail)) {
    shape_ = like->shape_;
    return;
  }
  if (detail.tile) {
    shape_.aside = tile_offset(shape_.seed);
    shape_.mean = of_example(glm::dvec3(0), 1e9);
    return;
  }
  // Noise is nearly normal, and the normal distribution is nearly the logistic one.
  const double spread = detail.kind == DetailKind::streaks ? 1.3 * deviation : 1.15 * deviation;
  shape_.threshold = spread * reproducible::log((1 - detail.density) / detail.density) / 1.702;
  shape_.ramp = spread * (0.12 + 1.3 * detail.softness);
  shape_.pitch = 0.62;

  // The mean over many places.
  constexpr int places = 1024;
  const RandomStream stream({0, seed}, "detail/mean");
  std::vector<glm::dvec3> points;
  for (int i = 0; i < places; ++i)
    points.push_back(64.0 * glm::dvec3(stream.uniform(3 * i), stream.uniform(3 * i + 1), stream.uniform(3 * i + 2)));
  for (const PatternValue& value : at(points, std::vector<double>(places, 1))) {
    shape_.mean.share += value.share / places;
    shape_.mean.tone += value.tone / places;
  }
}

PatternValue Pattern::operator()(const glm::dvec3& position, const DetailGuide& guide, double footprint) const {
  const PatternSpot spot{position, guide, footprint};
  return (*this)({&spot, 1}).front();
}

std::vector<PatternValue> Pattern::operator()(std::span<const PatternSpot> spots) const {
  std::vector<PatternValue> values(spots.size(), shape_.mean);
  std::vector<std::size_t> shown_at;
  std::vector<glm::dvec3> points;
  std::vector<double> shown, fine;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const PatternPlace place = pattern_place(detail_, spots[i].position, spots[i].guide);
    const double cycles = spots[i].footprint * place.squeeze / detail_.size;
    if (detail_.tile) {
      values[i] = of_example(place.point, cycles);
      continue;
    }
    const double share = 1 - smoothstep(0.25, 0.5, cycles);
    if (share == 0) continue;
    shown_at.push_back(i), points.push_back(place.point), shown.push_back(share);
    fine.push_back(1 - smoothstep(0.125, 0.25, cycles));
  }
  const std::vector<PatternValue> found = at(std::move(points), fine);
  const PatternValue& mean = shape_.mean;
  for (std::size_t i = 0; i < found.size(); ++i) {
    values[shown_at[i]] = {mean.share + shown[i] * (found[i].share - mean.share),
                           mean.tone + shown[i] * (found[i].tone - mean.tone)};
  }
  return values;
}

/// The share is that of the way from the tile's least luminance to its largest.
PatternValue Pattern::of_example(const glm::dvec3& point, double cycles) const {
  const ExampleTile& tile = *detail_.tile;
  const Color shown = tile_color(tile, turned_for_tile(point) + shape_.aside, cycles * tile.side());
  return {std::clamp(luminance_share(tile, shown), 0.0, 1.0), 0, shown};
}

/// \param fine how much of features finer than the size is shown at each point, 0..1.
std::vector<PatternValue> Pattern::at(std::vector<glm::dvec3> points, std::span<const double> fine) const {
  if (points.empty()) return {};
  for (glm::dvec3& point : points) point = turned(point);

  // Noise moves places, so that the pattern wanders.
  const std::uint32_t seed = shape_.seed;
  if (detail_.wander > 0) {
    const std::vector<double> a = noise_at(points, 0.45, 0, seed + 1), b = noise_at(points, 0.45, 7.3, seed + 2);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += 1.6 * detail_.wander * glm::dvec3(a[i], b[i], -a[i]);
  }

  // Fibres and streaks lie where noise exceeds a threshold; the other kinds are dots, or borders of cells.
  if (detail_.kind == DetailKind::fibres || detail_.kind == DetailKind::streaks) return of_lines(points, fine);
  std::vector<PatternValue> values;
  values.reserve(points.size());
  for (const glm::dvec3& point : points) values.push_back(of_cells(point));
  return values;
}

std::vector<PatternValue> Pattern::of_lines(std::span<const glm::dvec3> points, std::span<const double> fine) const {
  const std::uint32_t seed = shape_.seed;
  std::vector<double> noise = noise_at(points, 1, 0, seed);
  if (std::any_of(fine.begin(), fine.end(), [](double f) { return f > 0; })) {
    const std::vector<double> finer = noise_at(points, 2.0, 3.1, seed + 3);
    for (std::size_t i = 0; i < noise.size(); ++i)
      if (fine[i] > 0) noise[i] += 0.5 * fine[i] * finer[i];
  }
  if (detail_.kind == DetailKind::streaks) {
    const std::vector<double> coarser = noise_at(points, 0.23, 5.7, seed + 4);
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] += 0.6 * coarser[i];
  }
  std::vector<PatternValue> values(points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i].share = smoothstep(shape_.threshold - shape_.ramp, shape_.threshold + shape_.ramp, noise[i]);
  return values;
}

PatternValue Pattern::of_cells(const glm::dvec3& point) const {
  const std::uint32_t seed = shape_.seed;
  switch (detail_.kind) {
    case DetailKind::speckles: {
      const double first = dots(detail_, shape_.pitch * point, shape_.pitch, seed);
      const double second = dots(detail_, shape_.pitch * point + 0.5, shape_.pitch, seed + 5);
      return {std::max(first, second), 0};
    }
    case DetailKind::cells: {
      const CellPlace cell = cell_place(point, seed);
      const double border = cell.second - cell.nearest;
      const double line =
          1 - smoothstep(0.3 * detail_.width, 0.3 * detail_.width + 0.05 + 0.45 * detail_.softness, border);
      const double own = static_cast<double>(cell.hash >> 8) / 16777216.0 - 0.5;
      return {line, 2 * detail_.variety * own * (1 - line)};
    }
    case DetailKind::net: {
      const CellPlace cell = cell_place(point, seed);
      const double border = cell.second - cell.nearest;
      const double rim = 0.3 * detail_.width, soft = 0.04 + 0.25 * detail_.softness;
      const double line = 1 - smoothstep(rim, rim + soft, border);
      const double shade = smoothstep(rim, rim + soft, border) * (1 - smoothstep(rim + soft, rim + 3 * soft, border));
      return {line, -detail_.variety * shade};
    }
    case DetailKind::fibres:
    case DetailKind::streaks:
      break;  // of_lines()
    case DetailKind::example:
      break;  // without a tile there is nothing to show
  }
  return {};
}

}  // namespace pomona
