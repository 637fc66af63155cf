#include "generator/variation/individual_colors.h"

#include <algorithm>
#include <string>

#include "generator/base/clipped_normal.h"
#include "generator/base/error.h"

namespace pomona {

namespace {

/// The change from three draws. For a colour of chroma 0.25 all three have the same length.
ColorShift drawn_shift(const RandomStream& random, double deviation) {
  constexpr double typical_chroma = 0.25;
  return {.lightness = deviation * clipped_normal(random, 0),
          .chroma = 1 + deviation / typical_chroma * clipped_normal(random, 1),
          .hue = deviation / typical_chroma * clipped_normal(random, 2)};
}

ColorShift combined(const ColorShift& a, const ColorShift& b) {
  return {a.lightness + b.lightness, a.chroma * b.chroma, a.hue + b.hue};
}

std::vector<ColorShift> drawn_shifts(const Template& fruit, VariantKey key, double amount) {
  const ColorVariation& variation = fruit.variation.color;
  if (amount == 0 || (variation.all == 0 && variation.parts.empty())) return {};
  const ColorShift all = drawn_shift(RandomStream(key, "color"), amount * variation.all);
  std::vector<ColorShift> shifts(fruit.parts.size(), all);
  for (std::size_t i = 0; i < variation.parts.size(); ++i) {
    const RandomStream random(key, "color/" + fruit.parts[i]);
    shifts[i] = combined(all, drawn_shift(random, amount * variation.parts[i]));
  }
  return shifts;
}

void check(const Template& fruit, const ColorOptions& options) {
  if (options.ripeness && !(*options.ripeness >= 0 && *options.ripeness <= 2))
    throw Error(ExitStatus::usage, "ripeness must lie between 0 and 2");
  if (!(options.browning >= 0 && options.browning <= 1))
    throw Error(ExitStatus::usage, "browning must lie between 0 and 1");
  if (options.ripeness && !fruit.ripeness.declared())
    throw Error(ExitStatus::usage, "template \"" + fruit.name + "\" does not say how it ripens",
                "leave out the ripeness, or write a [ripeness] into the template");
  if (options.browning > 0 && !fruit.browning.declared())
    throw Error(ExitStatus::usage, "template \"" + fruit.name + "\" does not say how it turns brown",
                "leave out the browning, or write a [browning] into the template");
}

}  // namespace

Individual drawn_individual(const Template& fruit, VariantKey key, const ColorOptions& options) {
  check(fruit, options);
  Individual individual;
  individual.browning = options.browning;
  individual.patches = static_cast<std::uint32_t>(RandomStream(key, "ripeness/patches").bits(0) >> 32);
  individual.shifts = drawn_shifts(fruit, key, options.amount);
  const double strayed = options.amount * fruit.variation.color.ripeness;
  individual.ripeness = std::clamp(1 + strayed * clipped_normal(RandomStream(key, "ripeness"), 0), 0.0, 2.0);
  if (options.ripeness) individual.ripeness = *options.ripeness;
  return individual;
}

}  // namespace pomona
