#include "render/style/noise.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/many_values.h"
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

/// No footprint in use needs more cells around the axis.
constexpr int finest_ring = 16;

bool is_isotropic(const glm::dvec3& stretch) { return stretch.x == 1 && stretch.y == 1 && stretch.z == 1; }

double frequency_of(const NoiseStyle& style, int band) { return style.base_frequency * (1 << band); }

/// The azimuths of positions, in turns; none where no lattice lies around the axis.
std::vector<double> turns_of(const NoiseStyle& style, std::span<const glm::dvec3> positions) {
  if (is_isotropic(style.stretch)) return std::vector<double>(positions.size(), 0);
  std::vector<double> y, x;
  for (const glm::dvec3& position : positions) y.push_back(-position.z), x.push_back(position.x);
  std::vector<double> turn = reproducible::azimuths(y, x);
  for (double& t : turn) t /= 2.0 * pi;
  return turn;
}

/// The noise of one band at the places that are added.
class BandNoise {
 public:
  BandNoise(const NoiseStyle& style, int band)
      : stretch_(style.stretch),
        frequency_(frequency_of(style, band)),
        offset_(band_offset * (band + 1)),
        seed_(style.pattern + static_cast<std::uint32_t>(band)),
        is_isotropic_(is_isotropic(style.stretch)) {}

  void reserve(std::size_t count) {
    inner_.reserve(count);
    if (!is_isotropic_) outer_.reserve(count), share_.reserve(count);
  }

  /// \param turn the position's azimuth, in turns
  void add(const glm::dvec3& position, double turn) {
    if (is_isotropic_) {
      inner_.add(position * frequency_ + offset_, seed_);
    } else {
      add_around(position, turn);
    }
  }

  std::vector<double> values() const {
    std::vector<double> value = gradient_noise(inner_);
    if (is_isotropic_) return value;
    // The two noises are not correlated; scale them so that the variance stays through the cross-fade.
    const std::vector<double> outer = gradient_noise(outer_);
    for (std::size_t i = 0; i < value.size(); ++i) {
      const double share = share_[i], norm = std::sqrt(share * share + (1.0 - share) * (1.0 - share));
      value[i] = std::clamp(mix(value[i], outer[i], share) / norm, -1.0, 1.0);
    }
    return value;
  }

 private:
  void add_around(const glm::dvec3& position, double turn) {
    const double radius = std::sqrt(position.x * position.x + position.z * position.z);
    const glm::dvec2 radius_height(radius * frequency_ * stretch_.x + band_offset,
                                   position.y * frequency_ * stretch_.y + band_offset);

    // Finds the two rings: level is log2 of the wanted number of cells, linear between powers of two.
    const double cells = std::clamp(2.0 * pi * radius * frequency_ * stretch_.z, 2.0, std::ldexp(1.0, finest_ring - 1));
    int exponent = 0;
    const double mantissa = std::frexp(cells, &exponent);  // cells = mantissa 2^exponent, mantissa in [1/2, 1)
    add_ring(radius_height, turn, exponent - 1, inner_);
    add_ring(radius_height, turn, exponent, outer_);
    share_.push_back(smoothstep(0.0, 1.0, 2.0 * mantissa - 1.0));
  }

  /// One ring of 2^level cells around the axis; below level 2 the noise does not turn with the azimuth.
  void add_ring(const glm::dvec2& radius_height, double turn, int level, NoisePlaces& ring) const {
    const std::uint32_t seed = seed_ + ring_seed * static_cast<std::uint32_t>(std::max(level, 1));
    if (level < 2) return ring.add({radius_height, band_offset}, seed);
    const std::int32_t cells = 1 << level;
    ring.add({radius_height, turn * cells}, seed, cells - 1);
  }

  glm::dvec3 stretch_;
  double frequency_, offset_;
  std::uint32_t seed_;
  bool is_isotropic_;
  NoisePlaces inner_, outer_;  // around the axis, two rings; else one lattice
  std::vector<double> share_;  // of the outer ring
};

}  // namespace

double band_noise(const NoiseStyle& style, const glm::dvec3& position, int band) {
  BandNoise noise(style, band);
  noise.add(position, turns_of(style, {&position, 1}).front());
  return noise.values().front();
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
  return (*this)({&color, 1}, {&position, 1}, {&footprint, 1}).front();
}

Modulation::KeyShares Modulation::key_shares(std::span<const glm::vec3> lab) const {
  KeyShares shares{.of_key = {}, .total = std::vector<double>(lab.size(), 0)};
  std::vector<double> exponent(lab.size());
  for (const Key& key : keys_) {
    for (std::size_t i = 0; i < lab.size(); ++i) {
      const glm::dvec3 d = glm::dvec3(lab[i]) - key.lab;
      exponent[i] = -glm::dot(d, d) / (2.0 * style_.sigma * style_.sigma);
    }
    std::vector<double>& share = shares.of_key.emplace_back(reproducible::exponentials(exponent));
    for (std::size_t i = 0; i < lab.size(); ++i) shares.total[i] += share[i] += 1e-6;
  }
  return shares;
}

std::vector<Color> Modulation::operator()(std::span<const Color> colors, std::span<const glm::dvec3> positions,
                                          std::span<const double> footprints) const {
  std::vector<Color> result(colors.begin(), colors.end());
  if (bands_ == 0) return result;
  const std::vector<glm::vec3> lab = to_oklab(colors);
  const KeyShares shares = key_shares(lab);

  // Sum the bands that the footprints can show, each with the weight that the colour gives it.
  const double steepest = std::max({style_.stretch.x, style_.stretch.y, style_.stretch.z});
  const std::vector<double> turns = turns_of(style_, positions);
  std::vector<double> amount(colors.size(), 0), given;
  std::vector<std::size_t> shown_at;
  for (int b = 0; b < bands_; ++b) {
    BandNoise noise(style_, b);
    noise.reserve(colors.size());
    shown_at.clear(), given.clear();
    for (std::size_t i = 0; i < colors.size(); ++i) {
      double weight = 0;
      for (std::size_t k = 0; k < keys_.size(); ++k) weight += shares.of_key[k][i] * keys_[k].weights[b];
      const double shown = 1.0 - smoothstep(0.25, 0.5, frequency_of(style_, b) * steepest * footprints[i]);
      if (weight == 0 || shown == 0) continue;
      shown_at.push_back(i), given.push_back(weight / shares.total[i] * shown);
      noise.add(positions[i], turns[i]);
    }
    const std::vector<double> value = noise.values();
    for (std::size_t i = 0; i < value.size(); ++i) amount[shown_at[i]] += given[i] * value[i];
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    if (amount[i] != 0) result[i] = moved(lab[i], shares, i, amount[i]);
  return result;
}

Color Modulation::moved(const glm::vec3& lab, const KeyShares& shares, std::size_t place, double amount) const {
  glm::dvec3 axis(0);
  for (std::size_t k = 0; k < keys_.size(); ++k) axis += shares.of_key[k][place] / shares.total[place] * keys_[k].axis;
  return from_oklab_within_gamut(glm::vec3(glm::dvec3(lab) + amount * axis));
}

Color modulated(const NoiseStyle& style, const Color& unmodulated, const glm::dvec3& fruit_position, double footprint) {
  return Modulation(style)(unmodulated, fruit_position, footprint);
}

}  // namespace pomona
