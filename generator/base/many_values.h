// Functions of many values at once, in vectors, several times as fast as one by one: each result has the bits that the
// function of one value gives, on every processor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// The number of doubles that the processor's vectors hold. `plain` is what every processor of the kind has.
enum class VectorWidth { plain, four, eight };
VectorWidth widest_vectors();

/// Like exp(), cbrt() and atan2() of reproducible.h.
namespace reproducible {
std::vector<double> exponentials(std::span<const double> x, VectorWidth width = widest_vectors());
std::vector<double> cube_roots(std::span<const double> x, VectorWidth width = widest_vectors());
std::vector<double> azimuths(std::span<const double> y, std::span<const double> x,
                             VectorWidth width = widest_vectors());
}  // namespace reproducible

/// Places whose noise is wanted, coordinate by coordinate, each in a lattice of its own.
struct NoisePlaces {
  std::vector<double> x, y, z;
  std::vector<std::uint32_t> seed;
  std::vector<std::int32_t> mask;  ///< which bits of the lattice's z count: period - 1, or ~0 without a period

  std::size_t size() const { return x.size(); }
  void reserve(std::size_t count);
  void add(const glm::dvec3& point, std::uint32_t of_lattice, std::int32_t of_z = ~0);
};

/// Like gradient_noise() and gradient_noise_around() (gradient_noise.h).
std::vector<double> gradient_noise(const NoisePlaces& places, VectorWidth width = widest_vectors());

/// Like its namesake in color.h.
/// \param colors linear
std::vector<glm::vec3> to_oklab(std::span<const glm::vec3> colors);

}  // namespace pomona
