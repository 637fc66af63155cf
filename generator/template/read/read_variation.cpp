#include "generator/template/read/read_variation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "generator/base/nearest_name.h"
#include "generator/template/read/surface_names.h"

namespace pomona {

namespace {

BendVariation read_bend_variation(const TomlTable& table, bool has_line) {
  BendVariation bend;
  bend.angle = table.get("angle").angle(0, {0, 45});
  bend.swing = table.get("swing").angle(0, {0, 45});
  bend.around = table.get("around").boolean(false);
  if (bend.around && has_line) {
    table.get("around").error("is given, but the axis is drawn", "leave it out: it bends in the plane of its line");
  }
  return bend;
}

/// One [number, share] of the folds. Anything else gets NaN as its share.
CountVariation::Folds read_folds(const TomlValue& value) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto pair = value.values(2, "must be a number of folds and its share of the fruits", "write [5, 0.9]");
  if (pair.empty()) return {1, none};
  return {pair[0].integer(1, 1, max_folds), pair[1].number(none, {0, 1})};
}

/// Reads how often each number of folds occurs: [[4, 0.1], [5, 0.9]].
std::vector<CountVariation::Folds> read_fold_counts(const TomlValue& value, const Template& fruit) {
  std::vector<CountVariation::Folds> counts;
  if (!std::holds_alternative<FoldSymmetry>(fruit.symmetry)) {
    value.error("is given, but the fruit has no folds", "leave it out");
    return {};
  }
  double total = 0;
  for (const TomlValue& entry : value.values()) {
    counts.push_back(read_folds(entry));
    total += counts.back().share;
    if (counts.size() > max_folds) {
      value.error("has more than " + std::to_string(max_folds) + " numbers of folds");
      return {};
    }
  }
  const bool is_told_already = std::isnan(total);
  if (!is_told_already && std::abs(total - 1) > 1e-6) value.error("has shares that do not add up to 1");
  return counts;
}

/// Reads the share of the folds, or of the fruits, that have a surface: { seed = 0.8 }.
std::vector<CountVariation::Presence> read_presence(const TomlTable& table, const Template& fruit) {
  constexpr std::size_t max_names = 1000;  // each is compared with all others
  std::vector<CountVariation::Presence> present;
  for (const std::string& name : table.keys()) {
    const TomlValue value = table.get(name);
    if (present.size() == max_names) {
      value.error("is one of more than " + std::to_string(max_names) + " names", "name surfaces of this template");
      break;
    }
    const auto known = std::find_if(fruit.surfaces.begin(), fruit.surfaces.end(),
                                    [&](const SurfaceSketch& surface) { return surface.name == name; });
    if (known == fruit.surfaces.end())
      value.error("is not the name of a surface", name_hint(name, surface_names(fruit)));
    present.push_back({static_cast<int>(known - fruit.surfaces.begin()), value.number(1, {0, 1})});
  }
  return present;
}

VariationSketch without_counts(const TomlTable& table, bool has_line) {
  VariationSketch variation;
  variation.size = table.get("size").number(0, {0, 0.25});
  variation.profile = table.get("profile").number(0, {0, 0.25});
  if (table.has("bend")) variation.bend = read_bend_variation(table.get("bend").table(), has_line);
  return variation;
}

}  // namespace

VariationSketch read_variation(const TomlTable& table, const Template& fruit) {
  VariationSketch variation = without_counts(table, !fruit.bend.line.empty());
  if (table.has("folds")) variation.counts.folds = read_fold_counts(table.get("folds"), fruit);
  if (table.has("present")) variation.counts.present = read_presence(table.get("present").table(), fruit);
  return variation;
}

}  // namespace pomona
