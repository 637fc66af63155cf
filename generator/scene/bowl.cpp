#include "generator/scene/bowl.h"

#include <utility>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/piece/slice.h"
#include "generator/surface/sweep/sweep.h"

namespace pomona {

Template bowl_template(const BowlDescription& bowl) {
  // A bowl is described as a fruit is, with parts and an axis.
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

  // Both sides have the bowl's colour; the front is hidden, for it faces air.
  wall.front = {.part = 0, .color = {.along = bowl.color}, .hidden = true};
  wall.back = {.part = 1, .color = {.along = bowl.color}};
  wall.around = bowl.around;
  wall.along = bowl.along;
  clay.surfaces = {wall};
  return clay;
}

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

}  // namespace pomona
