#include "render/style/noise.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

double mix(double a, double b, double t) { return a + (b - a) * t; }

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Shifts the lattice of each band, so that their zeros do not meet at the origin.
constexpr double band_offset = 0.37;
/// Rings use lattices of their own, one for each count of cells.
constexpr std::uint32_t ring_seed = 64;

/// One ring of 2^level cells around the axis; below level 2 the noise does not turn with the azimuth.
double ring_noise(const glm::dvec2& radius_height, double turn, int level, std::uint32_t band_seed) {
  const std::uint32_t seed = band_seed + ring_seed * static_cast<std::uint32_t>(std::max(level, 1));
  if (level < 2) return gradient_noise({radius_height, band_offset}, seed);
  const std::int32_t cells = 1 << level;
  return gradient_noise_around({radius_height, turn * cells}, seed, cells);
}

/// No footprint in use needs more cells around the axis.
constexpr int finest_ring = 16;

/// A position in the cylinder's coordinates.
struct CylinderPlace {
  double radius = 0, height = 0;  ///< metres
  double turn = 0;                ///< azimuth, in turns
};

CylinderPlace cylinder_place(const glm::dvec3& position) {
  return {std::sqrt(position.x * position.x + position.z * position.z), position.y,
          reproducible::atan2(-position.z, position.x) / (2.0 * pi)};
}

double cylinder_noise(const glm::dvec3& stretch, const CylinderPlace& at, double frequency, std::uint32_t seed) {
  const glm::dvec2 radius_height(at.radius * frequency * stretch.x + band_offset,
                                 at.height * frequency * stretch.y + band_offset);

  // Finds the two rings: level is log2 of the wanted number of cells, linear between powers of two.
  const double cells = std::clamp(2.0 * pi * at.radius * frequency * stretch.z, 2.0, std::ldexp(1.0, finest_ring - 1));
  int exponent = 0;
  const double mantissa = std::frexp(cells, &exponent);  // cells = mantissa 2^exponent, mantissa in [1/2, 1)
  const int level = exponent - 1;
  const double share = smoothstep(0.0, 1.0, 2.0 * mantissa - 1.0);

  // The two noises are not correlated; scale them so that the variance stays through the cross-fade.
  const double inner = ring_noise(radius_height, at.turn, level, seed);
  const double outer = ring_noise(radius_height, at.turn, level + 1, seed);
  const double norm = std::sqrt(share * share + (1.0 - share) * (1.0 - share));
  return std::clamp(mix(inner, outer, share) / norm, -1.0, 1.0);
}

bool is_isotropic(const glm::dvec3& stretch) { return stretch.x == 1 && stretch.y == 1 && stretch.z == 1; }

double frequency_of(const NoiseStyle& style, int band) { return style.base_frequency * (1 << band); }

/// The noise of all bands at one position. The azimuth is worked out once, when the first band needs it.
class NoiseAt {
 public:
  NoiseAt(const NoiseStyle& style, const glm::dvec3& position) : style_(style), position_(position) {}

  double operator()(int band) {
    const double frequency = frequency_of(style_, band);
    const std::uint32_t seed = style_.pattern + static_cast<std::uint32_t>(band);
    if (is_isotropic(style_.stretch)) return gradient_noise(position_ * frequency + band_offset * (band + 1), seed);
    if (!around_) around_ = cylinder_place(position_);
    return cylinder_noise(style_.stretch, *around_, frequency, seed);
  }

 private:
  const NoiseStyle& style_;
  glm::dvec3 position_;
  std::optional<CylinderPlace> around_;
};

}  // namespace

double band_noise(const NoiseStyle& style, const glm::dvec3& position, int band) {
  return NoiseAt(style, position)(band);
}

Modulation::Modulation(const NoiseStyle& style) : style_(style) {
  for (const NoiseKey& key : style.keys) {
    if (keys_.size() == static_cast<std::size_t>(max_noise_keys)) break;
    Key ready{.lab = to_oklab(key.color), .axis = key.axis, .weights = {}};
    for (std::size_t b = 0; b < std::min(key.weights.size(), ready.weights.size()); ++b) {
      ready.weights[b] = key.weights[b];
      if (key.weights[b] != 0) bands_ = std::max(bands_, static_cast<int>(b) + 1);
    }
    keys_.push_back(ready);
  }
  if (style.base_frequency <= 0) bands_ = 0;
}

Color Modulation::operator()(const Color& color, const glm::dvec3& position, double footprint) const {
  if (bands_ == 0) return color;

  // The weight of each key for this colour.
  const glm::dvec3 lab = to_oklab(color);
  std::array<double, max_noise_keys> share{};
  double total = 0;
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    const glm::dvec3 d = lab - keys_[k].lab;
    share[k] = reproducible::exp(-glm::dot(d, d) / (2.0 * style_.sigma * style_.sigma)) + 1e-6;
    total += share[k];
  }

  // Sum the bands that the footprint can show, each with the weight this colour gives it.
  const double steepest = std::max({style_.stretch.x, style_.stretch.y, style_.stretch.z});
  NoiseAt noise(style_, position);
  double amount = 0;
  for (int b = 0; b < bands_; ++b) {
    double weight = 0;
    for (std::size_t k = 0; k < keys_.size(); ++k) weight += share[k] * keys_[k].weights[b];
    const double shown = 1.0 - smoothstep(0.25, 0.5, frequency_of(style_, b) * steepest * footprint);
    if (weight == 0 || shown == 0) continue;
    amount += weight / total * shown * noise(b);
  }
  if (amount == 0) return color;

  glm::dvec3 axis(0);
  for (std::size_t k = 0; k < keys_.size(); ++k) axis += share[k] / total * keys_[k].axis;
  const Color result = from_oklab(glm::vec3(lab + amount * axis));
  return {std::clamp(result.r, 0.0f, 1.0f), std::clamp(result.g, 0.0f, 1.0f), std::clamp(result.b, 0.0f, 1.0f)};
}

Color modulated(const NoiseStyle& style, const Color& unmodulated, const glm::dvec3& fruit_position, double footprint) {
  return Modulation(style)(unmodulated, fruit_position, footprint);
}

}  // namespace pomona
