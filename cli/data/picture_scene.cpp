#include "cli/data/picture_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/base/reproducible.h"
#include "generator/scene/compose.h"
#include "generator/scene/dish_solids.h"
#include "generator/scene/lay_out.h"
#include "render/picture/view_frame.h"

namespace pomona {

namespace {

bool is_fruit(const Scene& scene, const Instance& instance) {
  return !scene.solids[static_cast<std::size_t>(instance.solid)].origin.fruit.empty();
}

/// The pieces without anything else, and of these only where they are: enough to find a view.
Scene shapes_of_pieces(const Scene& scene) {
  Scene shapes;
  for (const Instance& instance : scene.instances) {
    if (!is_fruit(scene, instance)) continue;
    Solid shape;
    shape.mesh.position = scene.solids[static_cast<std::size_t>(instance.solid)].mesh.position;
    shapes.instances.push_back({static_cast<int>(shapes.solids.size()), instance.pose, instance.name});
    shapes.solids.push_back(std::move(shape));
  }
  return shapes;
}

/// How far the solid reaches in a direction, from the scene's origin.
double reach(const Solid& solid, const Pose& pose, const glm::dvec3& direction) {
  double farthest = std::numeric_limits<double>::lowest();
  for (const glm::vec3& p : solid.mesh.position)
    farthest = std::max(farthest, glm::dot(direction, pose.rotation * glm::dvec3(p) + pose.translation));
  return farthest;
}

double reach(const Scene& scene, const glm::dvec3& direction) {
  double farthest = 0;
  for (const Instance& instance : scene.instances)
    farthest =
        std::max(farthest, reach(scene.solids[static_cast<std::size_t>(instance.solid)], instance.pose, direction));
  return farthest;
}

glm::dquat turned(double angle) { return {reproducible::cos(0.5 * angle), 0, reproducible::sin(0.5 * angle), 0}; }

/// Each lies beyond all that is there already: a plane parts them, so nothing can touch.
void add_distractors(Scene& scene, const DataDescription& data, const std::vector<DrawnDistractor>& distractors) {
  DishSolids solids(std::filesystem::path(data.file).parent_path());
  for (std::size_t i = 0; i < distractors.size(); ++i) {
    const DrawnDistractor& drawn = distractors[i];
    const Solid solid = solids.solid(solids.index_of(data.dishes[drawn.dish].dish));
    const glm::dvec3 away(reproducible::sin(drawn.direction), 0, reproducible::cos(drawn.direction));
    Pose pose{turned(drawn.turn), glm::dvec3(0)};
    const double distance = reach(scene, away) + reach(solid, pose, -away) + drawn.room;
    pose.translation = distance * away;
    scene.instances.push_back({static_cast<int>(scene.solids.size()), pose, solid.name + "-" + std::to_string(i + 1)});
    scene.solids.push_back(solid);
    scene.solids.back().name = scene.instances.back().name;
  }
}

View seen(const Scene& shapes, const DrawnPicture& drawn, double aspect) {
  const double level = reproducible::cos(drawn.elevation);
  const glm::dvec3 direction(level * reproducible::sin(drawn.azimuth), reproducible::sin(drawn.elevation),
                             level * reproducible::cos(drawn.azimuth));
  Scene to_fit = shapes;
  to_fit.view.vertical_field = drawn.field;
  View view = fitted_view(to_fit, direction, aspect);
  const double distance = drawn.distance.value_or(drawn.fit * glm::length(view.eye - view.target));
  view.eye = view.target + distance * direction;
  view.fitted = false;

  // Both move within the picture's plane.
  const ViewFrame frame = view_frame(view);
  const double height = 2 * distance * reproducible::sin(0.5 * drawn.field) / reproducible::cos(0.5 * drawn.field);
  const glm::dvec3 by = height * (drawn.shift.x * aspect * frame.right + drawn.shift.y * frame.up);
  view.eye += by;
  view.target += by;
  return view;
}

Scene in_rows(const SceneDescription& description, const Diffuser* diffuser, const ComposeOptions& options,
              std::vector<std::string>& warnings) {
  SceneParts parts = make_parts(description, diffuser, options);
  warnings = parts.report.warnings;
  const std::vector<Pose> as_grown(parts.items.size() + parts.dishes.size());
  Scene scene = placed(description, std::move(parts), as_grown);
  return laid_out(scene, static_cast<double>(description.width) / description.height);
}

}  // namespace

PictureScene picture_scene(const DataDescription& data, const DrawnPicture& drawn, const Diffuser* diffuser,
                           const ComposeOptions& options) {
  PictureScene made;
  if (drawn.arrangement == DataArrangement::rows) {
    made.scene = in_rows(drawn.scene, diffuser, options, made.warnings);
  } else {
    Composition composition = compose(drawn.scene, diffuser, options);
    made.scene = std::move(composition.scene);
    made.warnings = std::move(composition.report.warnings);
  }
  const Scene shapes = shapes_of_pieces(made.scene);
  if (shapes.instances.empty()) throw Error(ExitStatus::some_items_failed, "nothing is left to be seen");
  made.scene.view = seen(shapes, drawn, static_cast<double>(data.width) / data.height);
  add_distractors(made.scene, data, drawn.distractors);
  return made;
}

}  // namespace pomona
