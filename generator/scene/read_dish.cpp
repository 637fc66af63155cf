#include "generator/scene/read_dish.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/base/nearest_name.h"
#include "generator/base/path_within.h"
#include "generator/base/small_ending.h"
#include "generator/template/read/read_paint.h"
#include "generator/text/read_name.h"
#include "generator/text/svg_path.h"

namespace pomona {

namespace {

constexpr std::size_t max_dishes = 256;

/// Reads a profile: one open simple line from the axis to the axis, in the right half plane.
std::string fault_of_profile(const std::vector<Curve>& curves) {
  if (curves.size() != 1) return "must be one line";
  const Curve& curve = curves[0];
  if (curve.closed || curve.points.size() < 4) return "must be an open line of some length";
  if (curve.points.front().x != 0 || curve.points.back().x != 0) return "must begin and end on the axis, x = 0";
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i)
    if (!(curve.points[i].x > 0)) return "must lie right of the axis, x > 0, between its ends";
  if (!is_simple(curve)) return "crosses itself";
  double area = 0;  // counter-clockwise: up the outside, down the inside
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    area += curve.points[i - 1].x * curve.points[i].y - curve.points[i].x * curve.points[i - 1].y;
  if (!(area > 0)) return "must go up along the outside and come down along the inside";
  for (const glm::dvec2& p : curve.points)
    if (std::max(p.x, std::fabs(p.y)) > 10) return "lies more than 10 m from the axis";
  return {};
}

Curve read_profile(const TomlValue& value, double unit) {
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes a fault if it is not a text
    return {};
  }
  try {
    std::vector<Curve> curves = parse_svg_path(value.text(), {.unit = unit});
    const std::string fault = fault_of_profile(curves);
    if (!fault.empty()) {
      value.error(fault, "draw the clay from the axis below, up the outside, over the rim and down the inside");
      return {};
    }
    double lowest = curves[0].points[0].y;
    for (const glm::dvec2& p : curves[0].points) lowest = std::min(lowest, p.y);
    for (glm::dvec2& p : curves[0].points) p.y -= lowest;
    return std::move(curves[0]);
  } catch (const BadPath& bad) {
    value.error(bad.what(), bad.hint);
    return {};
  }
}

glm::dvec3 read_place(const TomlValue& value) {
  constexpr Within anywhere{-100, 100};  // metres
  const auto parts = value.values(3, "needs three lengths", "write [\"10cm\", \"0cm\", \"-5cm\"]");
  if (parts.empty()) return glm::dvec3(0);
  return {parts[0].length(0, anywhere), parts[1].length(0, anywhere), parts[2].length(0, anywhere)};
}

/// Reads only meshes, and only from the scene's folder.
void check_mesh(const TomlValue& value, const std::filesystem::path& folder) {
  const std::filesystem::path file(value.text());
  const std::string ending = small_ending(file);
  if (ending != ".ply" && ending != ".obj" && ending != ".glb") {
    value.error("is no mesh that can be read", "export it as .ply, .obj or .glb");
  } else if (file.is_absolute() || !path_within(folder, folder / file)) {
    value.error("leads out of the scene's folder", "put the file beside the scene");
  }
}

MaterialSketch read_material(const TomlTable& table) {
  MaterialSketch material;
  material.gloss = table.get("gloss").number(0.5, {0, 4});
  material.roughness = table.get("roughness").number(0.6, {0, 1});
  return material;
}

DishDescription read_dish(const TomlTable& unnamed, const std::filesystem::path& folder,
                          const std::vector<std::string>& taken, const std::vector<DishDescription>& before) {
  const TomlTable table = unnamed.called("dishes \"" + unnamed.get("name").text() + "\"");
  DishDescription dish;
  dish.name = read_name(table.need("name"), taken);
  dish.place = table.get("name").place();
  dish.at = read_place(table.get("at"));
  dish.turn = table.get("turn").angle(0, {-360, 360});

  // Reads its shape: a profile, or a mesh.
  dish.as_solid.material = read_material(table);
  if (table.has("profile")) {
    dish.turned = read_bowl(table);
    if (table.has("mesh")) table.get("mesh").error("and profile exclude each other", "keep one of them");
  } else {
    const TomlValue mesh = table.need("mesh");
    dish.mesh = mesh.text();
    dish.mesh_place = mesh.place();
    if (mesh.is(TomlNode::Kind::string)) check_mesh(mesh, folder);
    dish.as_solid.unit = table.get("unit").length(1, {1e-6, 1});
    dish.as_solid.z_up = table.get("z_up").boolean(false);
    if (table.has("color")) dish.as_solid.color = table.get("color").color();
  }

  // A dish may stand in or on an earlier one that stands alone.
  const TomlValue whole = table.get("part_of");
  dish.part_of = whole.text();
  const auto same = [&](const DishDescription& other) { return other.name == dish.part_of && other.part_of.empty(); };
  if (!dish.part_of.empty() && std::none_of(before.begin(), before.end(), same)) {
    std::vector<std::string> known;
    for (const DishDescription& other : before)
      if (other.part_of.empty()) known.push_back(other.name);
    const auto near = nearest_name(dish.part_of, known);
    whole.error("names no dish before this one that stands alone",
                near ? "did you mean \"" + *near + "\"?" : "name it further up, or leave \"part_of\" out");
  }
  return dish;
}

}  // namespace

BowlDescription read_bowl(const TomlTable& table) {
  BowlDescription bowl;
  const double unit = table.get("unit").length(1e-3, {1e-6, 1});
  bowl.profile = read_profile(table.need("profile"), unit);
  bowl.color = read_ramp<Color>(table.get("color"), Color(0.8f), [](const TomlValue& v) { return v.color(); });
  bowl.around = table.get("around").integer(bowl.around, 16, 512);
  bowl.along = table.get("along").integer(bowl.along, 16, 512);
  return bowl;
}

std::vector<DishDescription> read_dishes(const TomlValue& value, const std::filesystem::path& folder,
                                         std::vector<std::string> taken) {
  std::vector<DishDescription> dishes;
  for (const TomlTable& table : value.tables(max_dishes)) {
    dishes.push_back(read_dish(table, folder, taken, dishes));
    taken.push_back(dishes.back().name);
  }
  return dishes;
}

}  // namespace pomona
