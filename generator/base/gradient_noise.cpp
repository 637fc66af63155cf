#include "generator/base/gradient_noise.h"

#include <algorithm>
#include <cmath>

#include "generator/base/many_values.h"

namespace pomona {

namespace {

// What vectors of any width are made of is inlined into each of them.
#define POMONA_IN_VECTORS [[gnu::always_inline]] inline

/// Final mix of a 32-bit hash (Wellons' lowbias32).
POMONA_IN_VECTORS std::uint32_t mixed(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}

POMONA_IN_VECTORS std::uint32_t hash_of(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) {
  return mixed((static_cast<std::uint32_t>(x) * 0x8da6b343u) ^ (static_cast<std::uint32_t>(y) * 0xd8163841u) ^
               (static_cast<std::uint32_t>(z) * 0xcb1ab31fu) ^ (seed * 0x9e3779b9u));
}

/// Dot product with one of the twelve edge directions of a cube (four of them twice).
POMONA_IN_VECTORS double edge_gradient(std::uint32_t hash, double x, double y, double z) {
  const std::uint32_t h = hash & 15u;
  const double u = h < 8 ? x : y;
  const double across = (h & 13u) == 12 ? x : z;
  const double v = h < 4 ? y : across;
  return ((h & 1u) != 0 ? -u : u) + ((h & 2u) != 0 ? -v : v);
}

POMONA_IN_VECTORS double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

POMONA_IN_VECTORS double mix(double a, double b, double t) { return a + (b - a) * t; }

/// A coordinate's cell of the lattice, and the place in it.
struct InCell {
  std::int32_t cell = 0;
  double within = 0;
};

/// The noise of a place. \param mask which bits of the lattice's z count.
POMONA_IN_VECTORS double noise_in(InCell at_x, InCell at_y, InCell at_z, std::uint32_t seed, std::int32_t mask) {
  // The eight corners' gradients, blended along x, then y, then z.
  const double x = at_x.within, y = at_y.within, z = at_z.within;
  const auto corner = [&](std::int32_t dx, std::int32_t dy, std::int32_t dz) {
    return edge_gradient(hash_of(at_x.cell + dx, at_y.cell + dy, (at_z.cell + dz) & mask, seed), x - dx, y - dy,
                         z - dz);
  };
  const double u = fade(x), v = fade(y), w = fade(z);
  const double near = mix(mix(corner(0, 0, 0), corner(1, 0, 0), u), mix(corner(0, 1, 0), corner(1, 1, 0), u), v);
  const double far = mix(mix(corner(0, 0, 1), corner(1, 0, 1), u), mix(corner(0, 1, 1), corner(1, 1, 1), u), v);

  // The largest value of this form is about 1.04.
  return std::clamp(mix(near, far, w), -1.0, 1.0);
}

constexpr double largest_cell = 1e9;  // beyond, cells do not fit into 32 bits

/// std::floor, which is a call on the plainest x86-64, for coordinates within the largest cell.
POMONA_IN_VECTORS InCell cell_of_moderate(double x) {
  const auto whole = static_cast<std::int32_t>(x);
  const std::int32_t cell = whole - (static_cast<double>(whole) > x ? 1 : 0);
  return {cell, x - static_cast<double>(cell)};
}

InCell cell_of(double x) {
  if (std::fabs(x) < largest_cell) return cell_of_moderate(x);
  const double floored = std::floor(x);
  return {lattice_cell(floored), x - floored};
}

double lattice_noise(const glm::dvec3& point, std::uint32_t seed, std::int32_t mask) {
  return noise_in(cell_of(point.x), cell_of(point.y), cell_of(point.z), seed, mask);
}

/// All coordinates are moderate.
POMONA_IN_VECTORS void add_noise(const NoisePlaces& places, std::vector<double>& value) {
  const double *const __restrict x = places.x.data(), *const __restrict y = places.y.data(),
                      *const __restrict z = places.z.data();
  const std::uint32_t* const __restrict seed = places.seed.data();
  const std::int32_t* const __restrict mask = places.mask.data();
  double* const __restrict to = value.data();
  const std::size_t count = places.size();
  for (std::size_t i = 0; i < count; ++i)
    to[i] = noise_in(cell_of_moderate(x[i]), cell_of_moderate(y[i]), cell_of_moderate(z[i]), seed[i], mask[i]);
}

#ifdef __SSE2__
#ifdef __clang__
#define POMONA_EIGHT "avx512f,avx512dq,avx512vl"
#else
#define POMONA_EIGHT "avx512f,avx512dq,avx512vl,prefer-vector-width=512"
#endif
__attribute__((target(POMONA_EIGHT))) void add_noise_by_eight(const NoisePlaces& places, std::vector<double>& value) {
  add_noise(places, value);
}

__attribute__((target("avx2"))) void add_noise_by_four(const NoisePlaces& places, std::vector<double>& value) {
  add_noise(places, value);
}
#endif

bool is_moderate(const std::vector<double>& coordinates) {
  return std::all_of(coordinates.begin(), coordinates.end(), [](double x) { return std::fabs(x) < largest_cell; });
}

}  // namespace

std::uint32_t lattice_hash(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) {
  return hash_of(x, y, z, seed);
}

std::int32_t lattice_cell(double floored) { return static_cast<std::int32_t>(std::clamp(floored, -2.0e9, 2.0e9)); }

double gradient_noise(const glm::dvec3& point, std::uint32_t seed) { return lattice_noise(point, seed, ~0); }

double gradient_noise_around(const glm::dvec3& point, std::uint32_t seed, std::int32_t period) {
  return lattice_noise(point, seed, period - 1);
}

void NoisePlaces::reserve(std::size_t count) {
  for (std::vector<double>* const coordinate : {&x, &y, &z}) coordinate->reserve(count);
  seed.reserve(count), mask.reserve(count);
}

void NoisePlaces::add(const glm::dvec3& point, std::uint32_t of_lattice, std::int32_t of_z) {
  x.push_back(point.x), y.push_back(point.y), z.push_back(point.z);
  seed.push_back(of_lattice), mask.push_back(of_z);
}

std::vector<double> gradient_noise(const NoisePlaces& places, [[maybe_unused]] VectorWidth width) {
  std::vector<double> value(places.size());
  if (!is_moderate(places.x) || !is_moderate(places.y) || !is_moderate(places.z)) {
    for (std::size_t i = 0; i < value.size(); ++i)
      value[i] = lattice_noise({places.x[i], places.y[i], places.z[i]}, places.seed[i], places.mask[i]);
    return value;
  }
#ifdef __SSE2__
  if (width == VectorWidth::eight) return add_noise_by_eight(places, value), value;
  if (width == VectorWidth::four) return add_noise_by_four(places, value), value;
#endif
  add_noise(places, value);
  return value;
}

}  // namespace pomona
