#include "generator/template/read/read_grains.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "generator/base/units.h"
#include "generator/template/read/read_grain_volume.h"
#include "generator/template/read/read_law.h"
#include "generator/template/read/read_paint.h"
#include "generator/template/read/surface_names.h"

namespace pomona {

namespace {

constexpr std::size_t max_looks = 8, max_cores = 4;

/// Reads two numbers of 0..1, by default all of it; `wraps` allows a second number below the first.
std::pair<double, double> read_stretch(const TomlValue& value, bool wraps = false) {
  const std::vector<TomlValue> ends = value.values(2, "must be two places along the curve, as in [0.2, 0.8]");
  if (ends.empty()) return {0, 1};
  const double from = ends[0].number(0, {0, 1}), to = ends[1].number(1, {0, 1});
  if (from == to || (!wraps && from > to)) value.error("is empty", "write the lower end first");
  return {from, to};
}

void read_density(const TomlValue& value, GrainGround& ground) {
  const auto read = [](const TomlValue& stop) { return stop.number(1, {0, 1}); };
  if (!value.is(TomlNode::Kind::table)) {
    ground.density_along = read_ramp<double>(value, 1.0, read);
    return;
  }
  const TomlTable table = value.table();
  ground.density_along = read_ramp<double>(table.get("along"), 1.0, read);
  ground.density_around = read_ramp<double>(table.get("around"), 1.0, read);
}

void read_folds(const TomlValue& value, const Template& fruit, GrainGround& ground) {
  if (!value.given()) return;
  for (const TomlValue& fold : value.values()) ground.folds.push_back(fold.integer(1, 1, fold_count(fruit)) - 1);
  if (ground.folds.empty() && value.is(TomlNode::Kind::array)) value.error("is empty", "name folds, from 1");
}

GrainGround read_ground(const TomlTable& table, const Template& fruit, const SurfaceSketch* surface) {
  GrainGround ground;
  std::tie(ground.along_from, ground.along_to) = read_stretch(table.get("band"));
  std::tie(ground.around_from, ground.around_to) = read_stretch(table.get("sector"), true);
  const TomlValue depth = table.get("depth");
  std::tie(ground.depth_from, ground.depth_to) = read_stretch(depth);
  if (depth.given() && surface && surface->type != SurfaceType::in_fold) {
    depth.error("is for surfaces in folds", "around the axis, choose a surface further in or out");
  }
  read_folds(table.get("folds"), fruit, ground);
  ground.facing = static_cast<GrainGround::Facing>(table.get("faces").choice({"any", "axis", "out"}));
  read_density(table.get("density"), ground);
  ground.share = table.get("share").number(1, {0, 1});
  ground.fold_share = table.get("fold_share").number(1, {0, 1});
  return ground;
}

std::vector<int> read_clear_of(const TomlValue& value, const Template& fruit) {
  std::vector<int> surfaces;
  if (!value.given()) return surfaces;
  const std::vector<std::string> names = surface_names(fruit);
  for (const TomlValue& name : value.values()) {
    if (surfaces.size() == names.size()) break;
    surfaces.push_back(name.choice(names));
  }
  return surfaces;
}

/// What does not go with a law: it says where grains are, and around the axis there is no depth.
void refuse_beside_law(const TomlTable& table) {
  for (const char* key : {"sector", "folds", "fold_share", "apart", "solid", "apart_from"}) {
    if (table.has(key))
      table.get(key).error("is given beside a law, which says where they sit", "leave one of the two out");
  }
  const TomlValue density = table.get("density");
  if (density.is(TomlNode::Kind::table)) density.error("has a place around beside a law", "write a ramp along");
}

GrainSpacing read_spacing(const TomlTable& table, const Template& fruit, const SurfaceSketch* surface) {
  GrainSpacing spacing;
  if (table.has("law")) {
    spacing.law = read_law_name(table, fruit.laws, surface ? surface->type : SurfaceType::around_axis);
    refuse_beside_law(table);
    spacing.clear_of = read_clear_of(table.get("clear_of"), fruit);
    return spacing;
  }
  spacing.poisson_radius = table.need("spacing").length(1e-3, {1e-5, 0.2});
  spacing.any_facing = table.get("apart").choice({"facing", "all"}) == 1;
  spacing.solid = table.get("solid").boolean(false);
  spacing.clear_of = read_clear_of(table.get("clear_of"), fruit);
  const TomlValue others = table.get("apart_from");
  if (!others.given()) return spacing;
  std::vector<std::string> names;
  for (const GrainSketch& known : fruit.grains) names.push_back(known.name);
  for (const TomlValue& other : others.values()) {
    const std::string name = other.text();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      other.error("\"" + name + "\" are no grains written before these", "write those first that others give way to");
    } else {
      spacing.apart_from.push_back(static_cast<int>(found - names.begin()));
    }
  }
  return spacing;
}

void read_shape(const TomlTable& table, GrainForm& form) {
  const std::vector<std::string> shapes{"ellipsoid", "lens", "disc", "rod", "spindle", "bean", "cushion", "drop"};
  const int shape = table.get("shape").choice(shapes);
  const bool drop = shape == 7;
  form.shape = drop ? GrainShape::ellipsoid : static_cast<GrainShape>(shape);
  form.pointedness = table.get("pointedness").number(drop ? 1 : 0, {0, 1});
  form.around = table.get("around").integer(form.around, 3, 64);
  form.along = table.get("along").integer(form.along, 2, 64);
}

GrainForm read_form(const TomlTable& table) {
  const Within size{1e-5, 0.2};
  GrainForm form;
  form.length = table.need("length").length(1e-3, size);
  form.width = table.need("width").length(1e-3, size);
  form.thickness = table.need("thickness").length(1e-3, size);
  form.size = read_ramp<double>(table.get("size"), 1.0, [](const TomlValue& stop) {
    return stop.number(1, {0.05, 4});
  });
  form.size_jitter = table.get("size_jitter").number(0, {0, 0.9});
  form.length_jitter = table.get("length_jitter").number(0, {0, 0.9});
  form.width_jitter = table.get("width_jitter").number(0, {0, 0.9});
  return form;
}

GrainStance read_stance(const TomlTable& table) {
  GrainStance stance;
  stance.sink = table.get("sink").length(0, {-0.1, 0.1});
  stance.heading =
      static_cast<GrainStance::Heading>(table.get("heading").choice({"along", "axis", "out", "up", "down"}));
  stance.flat = static_cast<GrainStance::Flat>(table.get("flat").choice({"surface", "around", "up"}));
  stance.angle = table.get("angle").angle(0, {-360, 360});
  stance.angle_jitter = table.get("angle_jitter").angle(0, {0, 180});
  stance.tilt = table.get("tilt").angle(0, {-90, 90});
  stance.tilt_jitter = table.get("tilt_jitter").angle(0, {0, 90});
  return stance;
}

Side read_grain_side(const TomlTable& table, const char* key, const std::vector<std::string>& parts) {
  return read_side(table.need(key).table(), parts);
}

void refuse_both_hidden(const TomlTable& table, const Side& front, const Side& back) {
  if (front.hidden && back.hidden) table.error("have both sides hidden", "hide only the side that faces air");
}

/// Sides that are not given stay those of the grain.
std::vector<GrainLook> read_looks(const TomlTable& table, const GrainSketch& grain) {
  std::vector<GrainLook> looks;
  double sum = 0;
  for (const TomlTable& entry : table.get("looks").tables(max_looks)) {
    GrainLook look{0, 1, grain.front.color, grain.back.color};
    look.share = entry.need("share").number(0, {0, 1});
    look.scale = entry.get("scale").number(1, {0.05, 2});
    if (entry.has("front")) look.front = read_painted_color(entry.get("front"));
    if (entry.has("back")) look.back = read_painted_color(entry.get("back"));
    looks.push_back(look);
    sum += look.share;
  }
  if (sum > 1 + 1e-9) table.get("looks").error("have shares of more than 1 together");
  return looks;
}

GrainCore read_core(const TomlTable& table, const std::vector<std::string>& parts) {
  // The core's sizes are shares of the grain's: one for all three, or one for each.
  GrainCore core;
  const TomlValue scale = table.need("scale");
  const Within within{0.01, 1};
  if (scale.is(TomlNode::Kind::array)) {
    const auto scales =
        scale.values(3, "must be one share, or three for length, width and thickness, as in [0.7, 0.5, 0.5]");
    if (!scales.empty()) {
      core.form.length = scales[0].number(0.5, within);
      core.form.width = scales[1].number(0.5, within);
      core.form.thickness = scales[2].number(0.5, within);
    }
  } else {
    core.form.length = core.form.width = core.form.thickness = scale.number(0.5, within);
  }

  // Shifted along the grain, the core must stay within it.
  core.shift = table.get("shift").number(0, {-0.5, 0.5});
  if (core.form.length + 2 * std::fabs(core.shift) > 1 + 1e-9) {
    table.error("sticks out of its grain", "make it shorter, or shift it less");
  }

  // The core's form and sides are written like those of the grain itself.
  read_shape(table, core.form);
  core.front = read_grain_side(table, "front", parts);
  core.back = read_grain_side(table, "back", parts);
  refuse_both_hidden(table, core.front, core.back);
  core.blur = table.get("blur").length(0, {0, 0.1});
  return core;
}

std::vector<GrainCore> read_cores(const TomlTable& table, const Template& fruit) {
  const TomlValue value = table.get("core");
  std::vector<GrainCore> cores;
  if (value.is(TomlNode::Kind::array)) {
    for (const TomlTable& core : value.tables(max_cores)) cores.push_back(read_core(core, fruit.parts));
  } else if (value.given()) {
    cores.push_back(read_core(value.table(), fruit.parts));
  }
  return cores;
}

/// Solid grains keep their thickness apart, whatever their spacing; with a much smaller spacing millions of places
/// would be tried in vain.
void refuse_crowd(const TomlTable& table, const GrainSketch& grain) {
  constexpr double max = 8;
  const double thick = std::min({grain.form.length, grain.form.width, grain.form.thickness});
  if (!grain.spacing.solid || thick <= max * grain.spacing.poisson_radius) return;
  table.get("spacing").error("is less than an eighth of what these solid grains are thick",
                             "make it about as large as the grains");
}

/// What grains over a surface say.
void read_strewn(const TomlTable& table, const Template& fruit, GrainSketch& grain) {
  const std::vector<std::string> names = surface_names(fruit);
  grain.surface = table.need("surface").choice(names);
  const auto at = static_cast<std::size_t>(grain.surface);
  grain.on_front = table.get("side").choice({"front", "back"}) == 0;
  const SurfaceSketch* surface = at < fruit.surfaces.size() ? &fruit.surfaces[at] : nullptr;
  grain.ground = read_ground(table, fruit, surface);
  grain.spacing = read_spacing(table, fruit, surface);
  grain.form = read_form(table);
  refuse_crowd(table, grain);
  grain.stance = read_stance(table);
}

}  // namespace

GrainSketch read_grains(const TomlTable& table, const Template& fruit) {
  GrainSketch grain;
  if (table.has("inside")) {
    read_grain_volume(table, fruit, grain);
  } else {
    read_strewn(table, fruit, grain);
  }
  read_shape(table, grain.form);
  grain.front = read_grain_side(table, "front", fruit.parts);
  grain.back = read_grain_side(table, "back", fruit.parts);
  refuse_both_hidden(table, grain.front, grain.back);
  grain.blur = table.get("blur").length(0, {0, 0.1});
  grain.lightness_jitter = table.get("color_jitter").number(0, {0, 0.5});
  grain.hue_jitter = table.get("hue_jitter").angle(0, {0, 180});
  grain.looks = read_looks(table, grain);
  grain.cores = read_cores(table, fruit);
  return grain;
}

}  // namespace pomona
