#include "generator/template/read/read_ripeness.h"

#include <algorithm>
#include <string>
#include <vector>

#include "generator/template/read/read_depth.h"
#include "generator/template/read/read_paint.h"
#include "generator/template/read/surface_names.h"

namespace pomona {

namespace {

constexpr std::size_t max_stops = 64;
constexpr Within patch_size{5e-4, 1};  // metres
constexpr double max_color_variation = 0.2;

/// The table of one part; `known` are the parts that have one already.
int read_part(const TomlTable& table, const Template& fruit, std::vector<int>& known) {
  const TomlValue value = table.need("part");
  if (fruit.parts.empty() || !value.given()) return 0;
  const int part = value.choice(fruit.parts);
  if (std::find(known.begin(), known.end(), part) != known.end())
    value.error("\"" + value.text() + "\" is there already", "keep one table for each part");
  known.push_back(part);
  return part;
}

/// Stops [[0.0, "#5f8f3a"], [0.6, "#d58a3c"], [2.0, "#9c1010"]]; 1 is the drawn colour and not to be given.
std::vector<Ramp<Color>::Stop> read_ripe_colors(const TomlValue& value) {
  const auto ripeness = [](const TomlValue& given) {
    const double at = given.number(0, {0, 2});
    if (at == 1) given.error("is the drawn colour", "leave it out: at ripeness 1 the fruit is as drawn");
    return at;
  };
  const auto color = [](const TomlValue& stop) { return stop.color(); };
  const std::vector<Ramp<Color>::Stop> stops = read_stops<Color>(
      value, ripeness, color,
      {.one = "write [ripeness, \"#rrggbb\"] with a ripeness from 0 to 2", .all = "write at least one"});
  if (stops.size() > max_stops) value.error("has more than " + std::to_string(max_stops) + " stops");
  return stops;
}

RipenessSketch::Part read_ripening_part(const TomlTable& table, const Template& fruit, std::vector<int>& known) {
  RipenessSketch::Part part;
  part.part = read_part(table, fruit, known);
  part.stops = read_ripe_colors(table.need("colors"));
  part.keep = table.get("keep").number(part.keep, {0, 1});
  part.late = table.get("late").number(part.late, {-1, 1});
  return part;
}

BrowningSketch::Part read_browning_part(const TomlTable& table, const Template& fruit, std::vector<int>& known) {
  BrowningSketch::Part part;
  part.part = read_part(table, fruit, known);
  part.color = table.need("color").color();
  part.rate = table.get("rate").number(part.rate, {0, 10});
  part.max = table.get("most").number(part.max, {0, 1});
  return part;
}

BrowningSketch::Near read_near(const TomlTable& table, const Template& fruit) {
  const std::vector<std::string> names = surface_names(fruit);
  BrowningSketch::Near near;
  near.surface = table.need("surface").choice(names);
  near.within = table.need("within").length(1e-3, {1e-5, 1});
  near.faster = table.need("faster").number(1, {0, 10});
  return near;
}

/// [["flesh", "heart"], ...]: known parts, each in one list.
std::vector<std::vector<int>> read_tissues(const TomlValue& value, const Template& fruit) {
  std::vector<std::vector<int>> tissues;
  if (!value.given()) return tissues;
  std::vector<int> known;
  for (const TomlValue& entry : value.values()) {
    const std::vector<TomlValue> names = entry.values();
    if (names.size() < 2 || names.size() > fruit.parts.size()) {
      entry.error("must name two parts or more that are one tissue",
                  "write [\"flesh\", \"heart\"], the leading part first");
      return tissues;
    }
    std::vector<int>& tissue = tissues.emplace_back();
    for (const TomlValue& name : names) {
      const int part = name.choice(fruit.parts);
      if (std::find(known.begin(), known.end(), part) != known.end())
        name.error("\"" + name.text() + "\" is there already", "name each part once");
      known.push_back(part);
      tissue.push_back(part);
    }
  }
  return tissues;
}

}  // namespace

RipenessSketch read_ripeness(const TomlTable& table, const Template& fruit) {
  RipenessSketch ripeness;
  const Within lateness{-1, 1};
  std::vector<int> known;
  for (const TomlTable& part : table.need("part").tables(fruit.parts.size()))
    ripeness.parts.push_back(read_ripening_part(part, fruit, known));
  ripeness.spread = table.get("spread").number(ripeness.spread, {0, 10});
  ripeness.height =
      read_ramp<double>(table.get("height"), 0.0, [&](const TomlValue& value) { return value.number(0, lateness); });
  ripeness.depth = read_depth_ramp(table.get("depth"), 0, lateness);
  ripeness.patches = table.get("patches").number(0, {0, 1});
  ripeness.patch_size = table.get("patch_size").length(ripeness.patch_size, patch_size);
  return ripeness;
}

BrowningSketch read_browning(const TomlTable& table, const Template& fruit) {
  BrowningSketch browning;
  std::vector<int> known;
  for (const TomlTable& part : table.need("part").tables(fruit.parts.size()))
    browning.parts.push_back(read_browning_part(part, fruit, known));
  browning.depth = read_depth_ramp(table.get("depth"), 1, {0, 10});
  if (table.has("near")) browning.near = read_near(table.get("near").table(), fruit);
  browning.patches = table.get("patches").number(0, {0, 1});
  browning.patch_size = table.get("patch_size").length(browning.patch_size, patch_size);
  return browning;
}

ColorVariation read_color_variation(const TomlTable& table, const Template& fruit) {
  const Within within{0, max_color_variation};
  ColorVariation variation;
  variation.ripeness = table.get("ripeness").number(0, {0, 0.5});
  variation.tissues = read_tissues(table.get("tissues"), fruit);
  const TomlValue color = table.get("color");
  if (!color.is(TomlNode::Kind::table)) {
    variation.all = color.number(0, within);
    return variation;
  }
  const TomlTable parts = color.table();
  variation.parts.assign(fruit.parts.size(), 0.0);
  for (std::size_t i = 0; i < fruit.parts.size(); ++i) {
    const TomlValue value = parts.get(fruit.parts[i]);
    variation.parts[i] = value.number(0, within);
    for (const std::vector<int>& tissue : variation.tissues) {
      const bool follows = std::find(tissue.begin() + 1, tissue.end(), static_cast<int>(i)) != tissue.end();
      if (value.given() && follows)
        value.error("follows \"" + fruit.parts[static_cast<std::size_t>(tissue.front())] + "\" in `tissues`",
                    "leave it out");
    }
  }
  return variation;
}

}  // namespace pomona
