#include "generator/variation/vary_body.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/bend_strain.h"
#include "generator/variation/scaled.h"

namespace pomona {

namespace {

/// Normal numbers, none beyond 2.
class Draws {
 public:
  Draws(VariantKey key, std::string_view purpose) : stream_(key, purpose) {}
  double operator()(std::uint64_t n) const { return std::clamp(stream_.normal(n), -2.0, 2.0); }

 private:
  RandomStream stream_;
};

Proportions drawn_proportions(double deviation, VariantKey key) {
  const Draws draw(key, "vary/profile");
  Proportions proportions;
  proportions.slenderness = deviation * draw(0);
  proportions.pear = 0.5 * deviation * draw(1);
  proportions.barrel = 0.5 * deviation * draw(2);
  proportions.shoulders = 0.35 * deviation * draw(3);
  proportions.stretch = std::clamp(deviation * draw(4), -0.8, 0.8);
  return proportions;
}

AxisBend drawn_bend(AxisBend bend, const BendVariation& variation, VariantKey key, double amount) {
  const Draws draw(key, "vary/bend");
  bend.angle += amount * variation.angle * draw(0);
  bend.swing += amount * variation.swing * draw(1);
  if (variation.around) {
    // As much again towards the side turns the direction.
    const double sideways = amount * variation.angle * draw(2);
    const double angle = std::sqrt(bend.angle * bend.angle + sideways * sideways);
    if (angle > 0) bend.direction += reproducible::atan2(sideways, bend.angle);
    bend.angle = angle;
  }
  return bend;
}

}  // namespace

Template vary_body(const Template& fruit, VariantKey key, double amount) {
  const VariationSketch& variation = fruit.variation;
  Template variant = fruit;
  if (variation.profile > 0) variant.proportions = drawn_proportions(amount * variation.profile, key);
  if (variation.bend.angle > 0 || variation.bend.swing > 0) {
    variant.bend = drawn_bend(fruit.bend, variation.bend, key, amount);
  }
  if (variation.size > 0) {
    const double deviation = amount * variation.size * Draws(key, "vary/size")(0);
    variant = scaled(std::move(variant), reproducible::exp(deviation));
  }
  return variant;
}

Template gently_bent(Template fruit, const Template& drawn) {
  const BendStrain strain = bend_strain(fruit), borne = bend_strain(drawn);
  const double pressing = std::max(0.6, borne.pressing), lean = std::max(radians(60), borne.lean);
  double share = 1;
  if (strain.pressing > pressing) share = pressing / strain.pressing;
  if (strain.lean > lean) share = std::min(share, lean / strain.lean);
  if (share < 1) {
    fruit.bend.angle *= share;
    fruit.bend.swing *= share;
  }
  return fruit;
}

}  // namespace pomona
