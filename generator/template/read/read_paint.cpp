#include "generator/template/read/read_paint.h"

#include <optional>

#include "generator/template/read/read_law.h"
#include "generator/template/spot_sketch.h"
#include "generator/template/surface_sketch.h"

namespace pomona {

namespace {

constexpr std::size_t max_kinds = 16;
constexpr Within sizes{1e-5, 1};
constexpr Within spot_height{-0.01, 0.01};  // metres

std::optional<PatchPlace> read_place(const TomlValue& value, SurfaceType type) {
  const auto pair =
      value.values(2, "is not a place", "write [share of the vertical curve, azimuth in degrees], as in [0.4, 120]");
  if (pair.empty()) return {};
  if (type == SurfaceType::in_fold) {
    value.error("is for surfaces around the axis only", "scatter spots with \"spacing\", or paint a coat");
  }
  PatchPlace place;
  place.along = pair[0].number(0, {0, 1});
  place.azimuth = pair[1].angle(0, {-360, 360});
  return place;
}

/// Reads "2mm", or the smallest and the largest: ["1mm", "3mm"].
void read_size(const TomlValue& value, SpotSketch& spots) {
  if (!value.is(TomlNode::Kind::array)) {
    spots.size_min = spots.size_max = value.length(spots.size_min, sizes);
    return;
  }
  const auto pair = value.values(2, "is not a size", "write one length, or the least and the most");
  if (pair.empty()) return;
  spots.size_min = pair[0].length(spots.size_min, sizes);
  spots.size_max = pair[1].length(spots.size_min, sizes);
  if (spots.size_max < spots.size_min) value.error("is upside down", "write the smaller length first");
}

void read_band(const TomlValue& value, SpotSketch& spots) {
  const auto ends = value.values(2, "is not a band", "write its lower and upper end, as in [0.2, 0.8]");
  if (ends.empty()) return;
  spots.along_from = ends[0].number(0, {0, 1});
  spots.along_to = ends[1].number(1, {0, 1});
  if (!(spots.along_to > spots.along_from)) value.error("is empty", "write the lower end first");
}

void read_scatter(const TomlTable& table, const PaintedSurface& surface, SpotSketch& spots) {
  if (table.has("law")) {
    spots.law = read_law_name(table, surface.laws, surface.type);
  } else if (!table.has("spacing")) {
    table.error("lacks \"place\" or \"spacing\"", "give a single patch its place, or many spots their spacing");
  }
  spots.spacing = table.get("spacing").length(1e-3, sizes);
  spots.count = table.get("count").integer(0, 1, 20000);
  read_band(table.get("band"), spots);
}

/// Only sides that face air show a height.
double read_relief(const TomlTable& table, bool faces_air) {
  const TomlValue value = table.get("relief");
  if (table.has("relief") && !faces_air)
    value.error("is for sides that face air", "leave it out, or say hidden = true of the side");
  return value.length(0, spot_height);
}

SpotSketch read_spot(const TomlTable& table, const PaintedSurface& surface, bool faces_air) {
  SpotSketch spots;
  spots.color = table.need("color").color();
  if (table.has("place")) {
    spots.place = read_place(table.get("place"), surface.type);
  } else {
    read_scatter(table, surface, spots);
  }
  read_size(table.need("size"), spots);
  spots.stretch = table.get("stretch").number(spots.stretch, {0.05, 20});
  spots.softness = table.get("softness").number(spots.softness, {0, 1});
  spots.raggedness = table.get("raggedness").number(spots.raggedness, {0, 0.9});
  spots.strength = table.get("strength").number(spots.strength, {0, 1});
  spots.relief = read_relief(table, faces_air);
  return spots;
}

/// [{ place = [0.3, 200], size = "40mm", color = "#..." }, { spacing = "4mm", size = ["1mm", "2mm"], color = ... }].
/// \param faces_air whether the side does: relief is for such sides.
std::vector<SpotSketch> read_spots(const TomlValue& value, const PaintedSurface& surface, bool faces_air) {
  std::vector<SpotSketch> spots;
  for (const TomlTable& table : value.tables(max_kinds)) spots.push_back(read_spot(table, surface, faces_air));
  return spots;
}

constexpr std::size_t max_coats = 32;
constexpr Within cell_height{-0.05, 0.05};  // metres

Color read_color(const TomlValue& value) { return value.color(); }
double read_share(const TomlValue& value) { return value.number(1, {0, 1}); }

Ramp<Color> read_color_ramp(const TomlValue& value, const Color& fallback) {
  return read_ramp<Color>(value, fallback, read_color);
}

/// Reads one value for each fold, or for the first ones; further folds take them in turn.
template <typename Value, typename Read>
std::vector<Value> read_folds(const TomlValue& value, int folds, Read read) {
  if (!value.given()) return {};
  const std::vector<TomlValue> given = value.values();
  if (folds == 0) {
    value.error("speaks of folds, but the fruit has none", "use \"turn\"");
  } else if (given.size() > static_cast<std::size_t>(folds)) {
    value.error("has " + std::to_string(given.size()) + " values for " + std::to_string(folds) + " folds",
                "write one for each fold; fewer are taken in turn");
  } else if (given.empty() && value.is(TomlNode::Kind::array)) {
    value.error("is empty", "write one value for each fold");
  }
  std::vector<Value> result;
  for (std::size_t k = 0; k < std::min<std::size_t>(given.size(), 64); ++k) result.push_back(read(given[k]));
  return result;
}

void read_sampled_along(const TomlTable& table, PaintedColor& color) {
  const TomlValue sample = table.get("sample");
  if (sample.given() && !table.has("along")) {
    sample.error("has no colours yet",
                 "`pomona sketch FILE --sample` takes them from the picture and writes them here");
  } else {
    color.along = read_color_ramp(table.need("along"), Color(0.5f));
  }
  if (sample.given() && !sample.text().starts_with("#")) sample.error("names no line", "write \"#\" and its name");
  table.get("stops").integer(9, 2, 64);
}

PaintedColor read_painted_color(const TomlValue& value, const PaintedSurface* surface) {
  PaintedColor color;
  if (!value.is(TomlNode::Kind::table)) {
    color.along = read_color_ramp(value, Color(0.5f));
    return color;
  }
  const TomlTable table = value.table();
  read_sampled_along(table, color);
  color.around = read_color_ramp(table.get("around"), Color(1.0f));
  if (surface) {
    color.turn = read_turn<Color>(table.get("turn"), Color(1.0f), read_color);
    color.folds = read_folds<Color>(table.get("folds"), surface->folds, read_color);
  }
  return color;
}

Coat read_coat(const TomlTable& table, const PaintedSurface& surface) {
  Coat coat;
  coat.color = read_color_ramp(table.need("color"), Color(0.5f));
  coat.along = read_ramp<double>(table.get("along"), 1.0, read_share);
  coat.around = read_ramp<double>(table.get("around"), 1.0, read_share);
  coat.turn = read_turn<double>(table.get("turn"), 1.0, read_share);
  coat.folds = read_folds<double>(table.get("folds"), surface.folds, read_share);
  return coat;
}

/// Cells without a colour only raise.
CellSketch read_cells(const TomlTable& table, const PaintedSurface& surface) {
  CellSketch cells;
  table.need("law");
  cells.law = read_law_name(table, surface.laws, surface.type).value_or(0);
  cells.color = read_color_ramp(table.get("color"), Color(0.5f));
  cells.cover = read_ramp<double>(table.get("cover"), table.has("color") ? 1.0 : 0.0, read_share);
  if (table.has("cover")) table.need("color");
  cells.raise =
      read_ramp<double>(table.get("raise"), 0.0, [](const TomlValue& stop) { return stop.length(0, cell_height); });
  cells.along = read_ramp<double>(table.get("along"), 1.0, read_share);
  return cells;
}

Side read_any_side(const TomlTable& table, const std::vector<std::string>& parts, const PaintedSurface* surface) {
  Side side = read_uncolored_side(table, parts);
  side.color = read_painted_color(table.need("color"), surface);
  return side;
}

}  // namespace

PaintedBlur read_painted_blur(const TomlValue& value) {
  const auto length = [](const TomlValue& stop) { return stop.length(0, {0, 0.1}); };
  if (!value.is(TomlNode::Kind::table)) return read_ramp<double>(value, 0.0, length);
  const TomlTable table = value.table();
  PaintedBlur blur;
  blur.along = read_ramp<double>(table.need("along"), 0.0, length);
  blur.around = read_ramp<double>(table.get("around"), 1.0, read_share);
  blur.turn = read_turn<double>(table.get("turn"), 1.0, read_share);
  return blur;
}

Side read_uncolored_side(const TomlTable& table, const std::vector<std::string>& parts) {
  Side side;
  const TomlValue part = table.need("part");
  if (!parts.empty()) side.part = part.choice(parts);  // without parts, that one mistake is enough to report
  side.hidden = table.get("hidden").boolean(false);
  return side;
}

Side read_side(const TomlTable& table, const std::vector<std::string>& parts) {
  return read_any_side(table, parts, nullptr);
}

PaintedColor read_painted_color(const TomlValue& value) { return read_painted_color(value, nullptr); }

Side read_surface_side(const TomlTable& table, const std::vector<std::string>& parts, const PaintedSurface& surface) {
  Side side = read_any_side(table, parts, &surface);
  for (const TomlTable& coat : table.get("coats").tables(max_coats)) side.coats.push_back(read_coat(coat, surface));
  if (table.has("cells")) side.cells = read_cells(table.get("cells").table().called("cells"), surface);
  side.spots = read_spots(table.get("spots"), surface, side.hidden);
  return side;
}

}  // namespace pomona
