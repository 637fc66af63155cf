#include "render/export/pov_light.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "generator/base/units.h"
#include "render/export/pov_text.h"
#include "render/picture/light_direction.h"

namespace pomona::pov {

namespace {

/// Warm light, cool sky, as in shaders/lit.glsl; together they are white. With the finishes' shares a white thing that
/// faces the light comes out white.
const glm::dvec3 sun = 0.8 / 0.70 * glm::dvec3(0.74, 0.70, 0.62);
const glm::dvec3 sky = 1 / 0.50 * glm::dvec3(0.47, 0.50, 0.54);

/// Sources stand so far off, times the eye's distance, that they come from nearly one direction everywhere.
constexpr double far_off = 16;
/// A source's width per unit of distance and of softness.
constexpr double width_of_softness = 0.7;
constexpr double fill_elevation = 30;  // degrees

std::string four_digits(const glm::dvec3& v) { return vector_text(glm::round(v * 1e4) / 1e4); }

std::string rgb(const glm::dvec3& color) { return "rgb " + four_digits(color); }

std::string source(const glm::dvec3& place, const glm::dvec3& color, const std::string& more) {
  return "light_source {\n  " + vector_text(place) + ", " + rgb(color) + more + "\n}\n";
}

}  // namespace

Lighting::Lighting(const View& view, const Style& style, double unit)
    : target_(view.target / unit),
      to_key_(light_direction(view, style.light)),
      to_fill_(light_direction(view_frame(view), -style.light.azimuth, radians(fill_elevation))),
      distance_(far_off * view_frame(view).distance / unit),
      key_(style.light.strength * sun),
      fill_(0.25 * style.light.ambient),
      width_(width_of_softness * style.light.softness * distance_),
      shadow_(style.shadow.strength),
      wash_(glm::mix(glm::dvec3(1), glm::dvec3(style.shadow.color), style.shadow.strength)),
      from_all_sides_(style.light.ambient) {}

std::string Lighting::sources() const {
  const glm::dvec3 key = target_ + distance_ * to_key_;
  const std::string side = number_text(std::round(1000 * width_) / 1000);
  const std::string wide = "\n  area_light x * " + side + ", z * " + side + ", 7, 7 adaptive 1 circular orient";
  std::string text;
  if (shadow_ > 0) text += source(key, shadow_ * key_, width_ > 0 ? wide : "");
  if (shadow_ < 1) text += source(key, (1 - shadow_) * key_, " shadowless");
  return text + source(target_ + distance_ * to_fill_, fill_, " shadowless");
}

std::string Lighting::ambient() const { return "ambient_light " + rgb(from_all_sides_ * sky); }

std::string Lighting::ground() const {
  // Per channel: pigment p, diffuse share d, emission e, with k and f the light that falls in from key and fill. Lit it
  // is to be paper, p (d (k + f) + e) = paper; what shadow takes is to leave the wash, p d k shadow = paper (1 - wash).
  const glm::dvec3 k = to_key_.y * key_, f = to_fill_.y * fill_;
  const double most = std::max({k.r, k.g, k.b});
  const bool dark = !(shadow_ * most > 1e-3);
  const double d = dark ? 0 : 1 / most;
  glm::dvec3 pigment(1), emission(1);  // times the paper
  for (int c = 0; !dark && c < 3; ++c) {
    pigment[c] = std::max(1 - wash_[c], 0.02) / (d * k[c] * shadow_);
    emission[c] = 1 / pigment[c] - d * (k[c] + f[c]);
    // A wash darker than what the fill leaves of the ground cannot be had.
    if (emission[c] < 0) pigment[c] = 1 / (d * (k[c] + f[c])), emission[c] = 0;
  }
  return "texture { pigment { color Paper * " + four_digits(pigment) + " } finish { ambient 0 diffuse " +
         number_text(std::round(d * 1e4) / 1e4) + " emission " + rgb(emission) + " } }";
}

}  // namespace pomona::pov
