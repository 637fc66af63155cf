#include "generator/base/gradient_noise.h"

#include <algorithm>
#include <cmath>

namespace pomona {

namespace {

/// Final mix of a 32-bit hash (Wellons' lowbias32).
std::uint32_t mixed(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}

/// Dot product with one of the twelve edge directions of a cube (four of them twice).
double edge_gradient(std::uint32_t hash, double x, double y, double z) {
  const std::uint32_t h = hash & 15u;
  const double u = h < 8 ? x : y;
  const double v = h < 4 ? y : (h == 12 || h == 14) ? x : z;
  return ((h & 1u) != 0 ? -u : u) + ((h & 2u) != 0 ? -v : v);
}

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

double mix(double a, double b, double t) { return a + (b - a) * t; }

/// std::floor, which is a call on the plainest x86-64.
double floored(double x) {
  if (!(std::fabs(x) < 1e9)) return std::floor(x);
  const auto whole = static_cast<double>(static_cast<std::int32_t>(x));
  return whole > x ? whole - 1 : whole;
}

/// `mask`: which bits of z count; all of them unless the lattice closes around an axis.
double lattice_noise(const glm::dvec3& point, std::uint32_t seed, std::int32_t mask) {
  const double fx = floored(point.x), fy = floored(point.y), fz = floored(point.z);
  const std::int32_t ix = lattice_cell(fx), iy = lattice_cell(fy), iz = lattice_cell(fz);
  const double x = point.x - fx, y = point.y - fy, z = point.z - fz;

  // The eight corners' gradients, blended along x, then y, then z.
  const auto corner = [&](std::int32_t dx, std::int32_t dy, std::int32_t dz) {
    return edge_gradient(lattice_hash(ix + dx, iy + dy, (iz + dz) & mask, seed), x - dx, y - dy, z - dz);
  };
  const double u = fade(x), v = fade(y), w = fade(z);
  const double near = mix(mix(corner(0, 0, 0), corner(1, 0, 0), u), mix(corner(0, 1, 0), corner(1, 1, 0), u), v);
  const double far = mix(mix(corner(0, 0, 1), corner(1, 0, 1), u), mix(corner(0, 1, 1), corner(1, 1, 1), u), v);

  // The largest value of this form is about 1.04.
  return std::clamp(mix(near, far, w), -1.0, 1.0);
}

}  // namespace

std::uint32_t lattice_hash(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) {
  return mixed((static_cast<std::uint32_t>(x) * 0x8da6b343u) ^ (static_cast<std::uint32_t>(y) * 0xd8163841u) ^
               (static_cast<std::uint32_t>(z) * 0xcb1ab31fu) ^ (seed * 0x9e3779b9u));
}

std::int32_t lattice_cell(double floored) { return static_cast<std::int32_t>(std::clamp(floored, -2.0e9, 2.0e9)); }

double gradient_noise(const glm::dvec3& point, std::uint32_t seed) { return lattice_noise(point, seed, ~0); }

double gradient_noise_around(const glm::dvec3& point, std::uint32_t seed, std::int32_t period) {
  return lattice_noise(point, seed, period - 1);
}

}  // namespace pomona
