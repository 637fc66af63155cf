// Perlin modulation of colours (paper, section 5): solid noise on several frequency bands, weighted by the colour it
// modulates. shaders/noise.glsl has the same formula; a test compares them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/gradient_noise.h"
#include "generator/template/template.h"

namespace pomona {

/// The noise of band `band` at a fruit's position, in [-1, 1], before weights and band limit.
///
/// With stretch (1, 1, 1): gradient_noise(f p + offset), f = base_frequency 2^band. Otherwise the lattice lies
/// along the cylinder's coordinates: radius r (distance from the axis) times f stretch.x, height y times
/// f stretch.y, and rings of 2^k cells around the axis whose count doubles as r grows, so that cells stay about
/// 1 / (f stretch.z) wide; neighbouring rings are cross-faded, and near the axis the noise no longer turns with
/// the azimuth. Small stretch.y: streaks from pole to pole. Small stretch.x: rays, fibres to the skin.
double band_noise(const NoiseStyle& style, const glm::dvec3& position, int band);

/// A noise style, prepared for many colours.
class Modulation {
 public:
  explicit Modulation(const NoiseStyle& style);

  /// The colour with noise on it. With L = OKLab(color):
  ///   lambda_k = exp(-|L - L_k|^2 / 2 sigma^2) + 1e-6, normalised;
  ///   a_b = sum lambda_k weights_kb; D = sum lambda_k axis_k;
  /// m = sum a_b fade_b n_b(position); result = clamp(RGB(L + m D)), where fade_b = 1 - smoothstep(1/4, 1/2, f_b
  /// footprint) removes bands that pixels cannot show. Where m is zero the colour returns bit for bit.
  /// \param position in the fruit's own frame, metres: two cuts of a fruit agree where they meet.
  /// \param footprint size of a pixel or texel there, metres; 0 for a point.
  Color operator()(const Color& color, const glm::dvec3& position, double footprint) const;

  /// The same at many places, several times as fast. All spans are equally long.
  std::vector<Color> operator()(std::span<const Color> colors, std::span<const glm::dvec3> positions,
                                std::span<const double> footprints) const;

  /// One key as the formula and the GPU need it.
  struct Key {
    glm::dvec3 lab{0};
    glm::dvec3 axis{0};
    std::array<double, max_noise_bands> weights{};
  };
  const std::vector<Key>& keys() const { return keys_; }
  const NoiseStyle& style() const { return style_; }
  int bands() const { return bands_; }  ///< 0 if the style has no noise

 private:
  /// How much of each key colours are; the shares add up to `total`.
  struct KeyShares {
    std::vector<std::vector<double>> of_key;
    std::vector<double> total;
  };
  KeyShares key_shares(std::span<const glm::vec3> lab) const;
  Color moved(const glm::vec3& lab, const KeyShares& shares, std::size_t place, double amount) const;

  NoiseStyle style_;
  std::vector<Key> keys_;
  int bands_ = 0;
};

/// Modulation of a single colour.
Color modulated(const NoiseStyle& style, const Color& unmodulated, const glm::dvec3& fruit_position,
                double footprint = 0);

}  // namespace pomona
