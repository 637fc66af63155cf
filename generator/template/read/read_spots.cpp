#include "generator/template/read/read_spots.h"

#include <optional>

namespace pomona {

namespace {

constexpr std::size_t most_kinds = 16;
constexpr Within sizes{1e-5, 1};
constexpr Within spot_height{-0.01, 0.01};  // metres

std::optional<PatchPlace> read_place(const TomlValue& value, SurfaceType type) {
  const std::vector<TomlValue> pair = value.values();
  if (pair.size() != 2) {
    if (value.is(TomlNode::Kind::array)) {
      value.error("is not a place", "write [share of the vertical curve, azimuth in degrees], as in [0.4, 120]");
    }
    return {};
  }
  if (type == SurfaceType::in_fold) {
    value.error("is for surfaces around the axis only", "scatter spots with \"spacing\", or paint a coat");
  }
  PatchPlace place;
  place.along = pair[0].number(0, {0, 1});
  place.azimuth = pair[1].angle(0, {-360, 360});
  return place;
}

/// "2mm", or the least and the most: ["1mm", "3mm"].
void read_size(const TomlValue& value, SpotSketch& spots) {
  if (!value.is(TomlNode::Kind::array)) {
    spots.size_least = spots.size_most = value.length(spots.size_least, sizes);
    return;
  }
  const std::vector<TomlValue> pair = value.values();
  if (pair.size() != 2) return value.error("is not a size", "write one length, or the least and the most");
  spots.size_least = pair[0].length(spots.size_least, sizes);
  spots.size_most = pair[1].length(spots.size_least, sizes);
  if (spots.size_most < spots.size_least) value.error("is upside down", "write the smaller length first");
}

void read_band(const TomlValue& value, SpotSketch& spots) {
  if (!value.given()) return;
  const std::vector<TomlValue> ends = value.values();
  if (ends.size() != 2) return value.error("is not a band", "write its lower and upper end, as in [0.2, 0.8]");
  spots.along_from = ends[0].number(0, {0, 1});
  spots.along_to = ends[1].number(1, {0, 1});
  if (!(spots.along_to > spots.along_from)) value.error("is empty", "write the lower end first");
}

void read_scatter(const TomlTable& table, SpotSketch& spots) {
  if (!table.has("spacing")) {
    table.error("lacks \"place\" or \"spacing\"", "give a single patch its place, or many spots their spacing");
  }
  spots.spacing = table.get("spacing").length(1e-3, sizes);
  spots.count = table.get("count").integer(0, 1, 20000);
  read_band(table.get("band"), spots);
}

/// Between two colours nobody sees a height.
double read_relief(const TomlTable& table, bool faces_air) {
  const TomlValue value = table.get("relief");
  if (table.has("relief") && !faces_air)
    value.error("is for sides that face air", "leave it out, or say hidden = true of the side");
  return value.length(0, spot_height);
}

SpotSketch read_spot(const TomlTable& table, SurfaceType type, bool faces_air) {
  SpotSketch spots;
  spots.color = table.need("color").color();
  if (table.has("place")) {
    spots.place = read_place(table.get("place"), type);
  } else {
    read_scatter(table, spots);
  }
  read_size(table.need("size"), spots);
  spots.stretch = table.get("stretch").number(spots.stretch, {0.05, 20});
  spots.softness = table.get("softness").number(spots.softness, {0, 1});
  spots.raggedness = table.get("raggedness").number(spots.raggedness, {0, 0.9});
  spots.strength = table.get("strength").number(spots.strength, {0, 1});
  spots.relief = read_relief(table, faces_air);
  return spots;
}

}  // namespace

std::vector<SpotSketch> read_spots(const TomlValue& value, SurfaceType type, bool faces_air) {
  std::vector<SpotSketch> spots;
  for (const TomlTable& table : value.tables(most_kinds)) spots.push_back(read_spot(table, type, faces_air));
  return spots;
}

}  // namespace pomona
