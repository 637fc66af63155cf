#include "generator/variation/vary_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/base/clipped_normal.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/bend_strain.h"
#include "generator/variation/scaled.h"

namespace pomona {

namespace {

Proportions drawn_proportions(double deviation, VariantKey key) {
  const RandomStream random(key, "vary/profile");
  Proportions proportions;
  proportions.slenderness = deviation * clipped_normal(random, 0);
  proportions.pear = 0.5 * deviation * clipped_normal(random, 1);
  proportions.barrel = 0.5 * deviation * clipped_normal(random, 2);
  proportions.shoulders = 0.35 * deviation * clipped_normal(random, 3);
  proportions.stretch = std::clamp(deviation * clipped_normal(random, 4), -0.8, 0.8);
  return proportions;
}

AxisBend drawn_bend(AxisBend bend, const BendVariation& variation, VariantKey key, double amount) {
  const RandomStream random(key, "vary/bend");
  bend.angle += amount * variation.angle * clipped_normal(random, 0);
  bend.swing += amount * variation.swing * clipped_normal(random, 1);
  if (variation.around) {
    // The same deviation sideways turns the direction of the bend.
    const double sideways = amount * variation.angle * clipped_normal(random, 2);
    const double angle = std::sqrt(bend.angle * bend.angle + sideways * sideways);
    if (angle > 0) bend.direction += reproducible::atan2(sideways, bend.angle);
    bend.angle = angle;
  }
  return bend;
}

}  // namespace

namespace {

/// The strain of a drawn axis is not proportional to its bend, which goes back step by step.
Template gently_bent_line(Template fruit, double pressing, double lean) {
  for (int step = 0; step < 8; ++step) {
    const BendStrain strain = bend_strain(fruit);
    if (strain.pressing <= pressing && strain.lean <= lean) return fruit;
    fruit.bend.angle *= 0.7;
    fruit.bend.swing *= 0.7;
  }
  fruit.bend = fruit.bend.as_line();
  return fruit;
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
    const double deviation = amount * variation.size * clipped_normal(RandomStream(key, "vary/size"), 0);
    variant = scaled(std::move(variant), reproducible::exp(deviation));
  }
  return variant;
}

Template gently_bent(Template fruit, const Template& drawn) {
  const BendStrain strain = bend_strain(fruit), borne = bend_strain(drawn);
  const double pressing = std::max(0.6, borne.pressing), lean = std::max(radians(60), borne.lean);
  if (!fruit.bend.line.empty()) return gently_bent_line(std::move(fruit), pressing, lean);
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
