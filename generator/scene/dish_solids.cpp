#include "generator/scene/dish_solids.h"

#include <utility>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/piece/slice.h"
#include "generator/scene/scene_file.h"
#include "generator/surface/file/far_from_origin.h"
#include "generator/surface/file/placing.h"
#include "generator/surface/file/plain_mesh_file.h"
#include "generator/surface/sweep/sweep.h"

namespace pomona {

namespace {

/// One surface around the axis with the front to the air; it closes on the axis.
Template bowl_template(const BowlDescription& bowl) {
  // Describes the bowl as a fruit, with parts and an axis.
  Template clay;
  clay.name = "bowl";
  clay.title = "Bowl";
  clay.symmetry = CylindricalSymmetry{};
  clay.parts = {"glaze", "clay"};

  // The only surface is the profile, swept along a circle.
  SurfaceSketch wall;
  wall.name = "wall";
  wall.vertical = bowl.profile;
  Curve circle{{}, true};
  for (int i = 0; i < bowl.around; ++i) {
    const double angle = 2 * pi * i / bowl.around;
    circle.points.emplace_back(reproducible::cos(angle), reproducible::sin(angle));
  }
  wall.horizontal = {circle};
  wall.roundness = Ramp<double>::constant(1);

  // Both sides have the bowl's colour; the front is hidden, because it faces air.
  wall.front = {.part = 0, .color = {.along = bowl.color}, .hidden = true};
  wall.back = {.part = 1, .color = {.along = bowl.color}};
  wall.around = bowl.around;
  wall.along = bowl.along;
  clay.surfaces = {wall};
  return clay;
}

bool made_alike(const DishDescription& a, const DishDescription& b) {
  const MeshSolidOptions &x = a.as_solid, &y = b.as_solid;
  return !a.turned && !b.turned && a.mesh == b.mesh && x.unit == y.unit && x.z_up == y.z_up && x.color == y.color &&
         x.material.gloss == y.material.gloss && x.material.roughness == y.material.roughness;
}

/// "crate.obj:12:3: ..." if the place is known.
std::string told(const Diagnostic& what) {
  std::string text = to_string({what.place, what.message, {}});
  const std::string error = "error: ";
  const auto at = text.find(error);
  return at == std::string::npos ? text : text.erase(at, error.size());
}

/// A dish stays upright.
void check_distance(const PlainMesh& mesh, const MeshSolidOptions& options) {
  const Placing placing{.unit = options.unit, .z_up = options.z_up};
  Box<double> box;
  for (const glm::dvec3& p : mesh.position) box.add(placing(p));
  box = box.moved({0, -box.low.y, 0});
  if (is_too_far(box))
    throw Error(ExitStatus::bad_data, why_too_far(box), "move it to the origin, and export it again");
}

/// Reports faults of the file with the place in the scene that names it.
Solid solid_of_mesh(const DishDescription& dish, const std::filesystem::path& folder, std::vector<std::string>& notes) {
  try {
    const PlainMesh mesh = read_plain_mesh(folder / dish.mesh);
    check_distance(mesh, dish.as_solid);
    for (const std::string& note : mesh.notes) notes.push_back("dish \"" + dish.name + "\": " + note);
    Solid solid = mesh_solid(mesh, dish.name, dish.as_solid);
    if (!solid.mesh.triangle.empty()) return solid;
    throw Error(ExitStatus::bad_data, "the mesh has no area", "export a mesh with triangles");
  } catch (const Error& error) {
    const Diagnostic& what = error.diagnostics().front();
    throw Error(error.status(), {{dish.mesh_place, "dish \"" + dish.name + "\": " + told(what), what.hint}});
  }
}

}  // namespace

Solid bowl_solid(const BowlDescription& bowl) {
  const Template clay = bowl_template(bowl);
  GrownFruit thrown;
  thrown.sheets = sweep(clay);
  std::vector<Solid> made = slice({thrown, clay, {}, "bowl"}, nullptr).pieces;
  if (made.size() != 1) throw Error(ExitStatus::bug, "the bowl is not one solid");
  made[0].name = "bowl";
  made[0].origin = {};  // a dish is no piece of fruit
  return std::move(made[0]);
}

std::size_t DishSolids::index_of(const DishDescription& dish) {
  for (std::size_t k = 0; k < known_.size(); ++k)
    if (made_alike(known_[k], dish)) return k;
  Solid solid = dish.turned ? bowl_solid(*dish.turned) : solid_of_mesh(dish, folder_, notes_);
  solid.name = dish.name;
  if (dish.turned) solid.own_look().materials.assign(solid.look->part_names.size(), dish.as_solid.material);
  known_.push_back(dish);
  solids_.push_back(std::move(solid));
  return solids_.size() - 1;
}

}  // namespace pomona
