#include "generator/template/read/read_sheets.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/units.h"
#include "generator/template/read/read_paint.h"
#include "generator/template/read/read_stops.h"
#include "generator/template/read/surface_names.h"
#include "generator/text/read_name.h"

namespace pomona {

namespace {

constexpr std::size_t max_sheet_kinds = 8;
constexpr int max_sheets = 400;
constexpr double max_sheet_triangles = 1e6;  // of all sheets at detail 1
constexpr Within thick{5e-5, 0.05}, small{0, 0.05};

/// A ramp whose places go on to 2, beyond the end of the axis.
template <typename Read>
Ramp<double> read_long_ramp(const TomlValue& value, double fallback, Read read) {
  if (!value.is(TomlNode::Kind::array)) return Ramp<double>::constant(value.given() ? read(value) : fallback);
  const auto place = [](const TomlValue& at) { return at.number(0, {0, 2}); };
  const Ramp<double> ramp{read_stops<double>(value, place, read,
                                             {.one = "write [place, value] with a place from 0 to 2, as in [0.4, ...]",
                                              .all = "write at least one, as in [[0.0, ...]]"})};
  return ramp.stops.empty() ? Ramp<double>::constant(fallback) : ramp;
}

Ramp<double> read_lengths(const TomlValue& value, double fallback, Within within) {
  return read_long_ramp(value, fallback, [&](const TomlValue& stop) { return stop.length(fallback, within); });
}

Ramp<double> read_numbers(const TomlValue& value, double fallback, Within within) {
  return read_long_ramp(value, fallback, [&](const TomlValue& stop) { return stop.number(fallback, within); });
}

/// An open curve of the side view beside the axis.
Curve read_edge(const TomlValue& value, CurveReader& curves) {
  const std::optional<DrawnCurve> drawn = curves.read(value, SketchView::side);
  if (!drawn) return {};
  const Curve curve = ended_on_axis(drawn->curve);
  if (curve.closed || curve.points.size() < 2 || !(length(curve) > 0)) {
    value.error(drawn->title + " is no open curve", "draw it from the base of the sheets to their tip");
  } else if (std::any_of(curve.points.begin(), curve.points.end(), [](const glm::dvec2& p) { return p.x < 0; })) {
    value.error(drawn->title + " goes left of the axis", "keep it at x >= 0");
  }
  return curve;
}

void read_sheet_law(const TomlTable& table, SheetSketch& sheet) {
  sheet.divergence = table.get("divergence").angle(sheet.divergence, {1, 359});
  sheet.turn_jitter = table.get("jitter").angle(0, {0, 90});
}

SheetRib read_rib(const TomlTable& table) {
  SheetRib rib;
  rib.width = table.need("width").number(rib.width, {0.01, 1});
  rib.height = read_lengths(table.need("height"), 0, small);
  return rib;
}

SheetVeins read_veins(const TomlTable& table) {
  SheetVeins veins;
  veins.color = table.need("color").color();
  veins.pairs = table.get("pairs").integer(8, 0, 40);
  veins.strength = table.get("strength").number(0.6, {0, 1});
  return veins;
}

SheetRuffle read_ruffle(const TomlTable& table) {
  SheetRuffle ruffle;
  ruffle.height = table.need("height").length(0, small);
  ruffle.waves = table.get("waves").integer(ruffle.waves, 0, 40);
  return ruffle;
}

/// The leaves of a head close over the axis.
void check_ends_on_axis(const TomlValue& value, const Curve& curve) {
  if (!curve.points.empty() && curve.points.back().x > 0)
    value.error("does not end on the axis", "draw its upper end to x = 0, or take a rosette, whose leaves stay open");
}

/// What leaves say, and other sheets do not.
void read_leaf(const TomlTable& table, SheetSketch& sheet) {
  read_sheet_law(table.get("law").table(), sheet);
  sheet.outline = read_numbers(table.need("outline"), 0.6, {0.02, 1.2});
  sheet.outline_jitter = table.get("outline_jitter").number(0, {0, 0.3});
  const bool over = sheet.kind == SheetSketch::Kind::head;
  if (over) {
    check_ends_on_axis(table.get("inner"), sheet.inner);
    check_ends_on_axis(table.get("outer"), sheet.outer);
  }
  sheet.reach = read_numbers(table.get("reach"), over ? 1.15 : 0.85, {0.1, over ? 1.6 : rosette_end});
  sheet.reach_jitter = table.get("reach_jitter").number(0, {0, 0.2});
  sheet.by_age = read_numbers(table.get("by_age"), 1, {0.1, 4});
  if (table.has("rib")) sheet.rib = read_rib(table.get("rib").table());
  if (table.has("ruffle")) sheet.ruffle = read_ruffle(table.get("ruffle").table());
  sheet.stand_off = table.get("stand_off").length(0, {0, 0.2});
  if (table.has("veins")) sheet.veins = read_veins(table.get("veins").table());
}

void read_blade(const TomlTable& table, SheetSketch& sheet) {
  if (table.has("lengths")) {
    sheet.lengths.clear();
    for (const TomlValue& one : table.get("lengths").values()) sheet.lengths.push_back(one.number(1, {0.05, 1}));
    if (sheet.lengths.empty()) sheet.lengths = {1.0};
  }
  sheet.sway = table.get("sway").length(0, small);
}

void read_roll(const TomlTable& table, SheetSketch& sheet) {
  sheet.turns = table.need("turns").number(sheet.turns, {0.5, 60});
  sheet.sway = table.get("sway").length(0, small);
  sheet.by_age = read_numbers(table.get("by_age"), 1, {0.1, 4});
}

/// The heights of a stack are asked for at every distance from the axis.
void check_runs_outwards(const TomlValue& value, const Curve& curve) {
  const std::vector<glm::dvec2>& points = curve.points;
  if (points.empty()) return;
  const auto turns_back = [](const glm::dvec2& a, const glm::dvec2& b) { return b.x <= a.x; };
  if (points.front().x > 0 || std::adjacent_find(points.begin(), points.end(), turns_back) != points.end())
    value.error("does not run from the axis outwards", "draw it from x = 0 on, ever further from the axis");
}

void read_stack(const TomlTable& table, CurveReader& curves, SheetSketch& sheet) {
  const TomlTable law = table.get("law").table();
  sheet.divergence = law.get("divergence").angle(0, {0, 359});
  sheet.turn_jitter = law.get("jitter").angle(0, {0, 90});
  check_runs_outwards(table.get("inner"), sheet.inner);
  check_runs_outwards(table.get("outer"), sheet.outer);
  if (table.has("horizontal")) {
    const std::optional<DrawnCurve> loop = curves.read(table.get("horizontal"), SketchView::top);
    if (loop) note(table.get("horizontal"), *loop, fault_of_loop_around_axis(loop->curve, CylindricalSymmetry{}));
    if (loop) sheet.loop = counter_clockwise(loop->curve);
  }
  sheet.outline_jitter = table.get("outline_jitter").number(0, {0, 0.3});
  sheet.stray = table.get("stray").length(0, small);
  sheet.by_age = read_numbers(table.get("by_age"), 1, {0.1, 4});
  if (table.has("ruffle")) sheet.ruffle = read_ruffle(table.get("ruffle").table());
}

/// What only this kind says.
void read_kind(const TomlTable& table, CurveReader& curves, SheetSketch& sheet) {
  switch (sheet.kind) {
    case SheetSketch::Kind::head:
    case SheetSketch::Kind::rosette:
      return read_leaf(table, sheet);
    case SheetSketch::Kind::blades:
      return read_blade(table, sheet);
    case SheetSketch::Kind::roll:
      return read_roll(table, sheet);
    case SheetSketch::Kind::stack:
      return read_stack(table, curves, sheet);
  }
}

/// Vertices across and along, unless the template says.
struct UsualGrid {
  int around = 40, along = 32;
};

UsualGrid usual_grid(SheetSketch::Kind kind) {
  switch (kind) {
    case SheetSketch::Kind::blades:
      return {6, 16};
    case SheetSketch::Kind::roll:
    case SheetSketch::Kind::stack:
      return {72, 12};
    case SheetSketch::Kind::head:
    case SheetSketch::Kind::rosette:
      break;
  }
  return {};
}

/// Two faces of all sheets, two triangles to each of their cells; a roll has `around` of them on every turn.
double triangles_of(const SheetSketch& sheet) {
  const double turns = sheet.kind == SheetSketch::Kind::roll ? std::max(1.0, sheet.turns) : 1;
  return 4.0 * sheet.count * turns * sheet.around * sheet.along;
}

Side read_sheet_side(const TomlTable& table, const char* key, const Template& fruit) {
  const TomlTable side = table.need(key).table();
  for (const char* only : {"cells", "spots"})
    if (side.has(only)) side.get(only).error("are for surfaces", "paint a coat");
  return read_surface_side(side, fruit.parts, {.type = SurfaceType::around_axis, .folds = 0});
}

SheetSketch read_sheet(const TomlTable& table, CurveReader& curves, const Template& fruit) {
  SheetSketch sheet;
  sheet.kind =
      static_cast<SheetSketch::Kind>(table.need("kind").choice({"head", "rosette", "blades", "roll", "stack"}));
  sheet.count = table.need("count").integer(1, 1, max_sheets);
  sheet.inner = read_edge(table.need("inner"), curves);
  sheet.outer = read_edge(table.need("outer"), curves);
  read_kind(table, curves, sheet);
  sheet.thickness = read_lengths(table.need("thickness"), 1e-3, thick);
  sheet.gap = table.get("gap").length(sheet.gap, {1e-5, 0.05});
  sheet.front = read_sheet_side(table, "front", fruit);
  sheet.back = read_sheet_side(table, "back", fruit);
  if (sheet.front.hidden && sheet.back.hidden)
    table.error("have both sides hidden", "hide only the side that faces air");
  sheet.blur = table.get("blur").length(0, {0, 0.01});
  const UsualGrid usual = usual_grid(sheet.kind);
  sheet.around = table.get("around").integer(usual.around, 3, 200);
  sheet.along = table.get("along").integer(usual.along, 3, 200);
  return sheet;
}

}  // namespace

std::vector<SheetSketch> read_sheets(const TomlTable& root, CurveReader& curves, const Template& fruit) {
  std::vector<SheetSketch> sheets;
  if (!root.has("sheets")) return sheets;
  std::vector<std::string> names = surface_names(fruit);
  double triangles = 0;
  for (const TomlTable& entry : root.get("sheets").tables(max_sheet_kinds)) {
    const TomlTable table = entry.called("sheets \"" + entry.get("name").text() + "\"");
    names.push_back(read_name(table.need("name"), names));
    sheets.push_back(read_sheet(table, curves, fruit));
    sheets.back().name = names.back();
    triangles += triangles_of(sheets.back());
    if (triangles > max_sheet_triangles) {
      table.error("makes more than 1 000 000 triangles",
                  "lower \"count\", \"around\" or \"along\", or the turns of a roll");
      break;
    }
  }
  return sheets;
}

}  // namespace pomona
