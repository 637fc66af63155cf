#include "generator/scene/in_a_row.h"

#include <algorithm>
#include <utility>

#include "generator/mesh/box.h"
#include "generator/scene/lay_out.h"
#include "generator/scene/table_pose.h"

namespace pomona {

namespace {

constexpr double share_between = 0.1;  // gap, as a share of the widest solid
const glm::dvec3 from_the_front(0, 0.6, 1);

Box<double> posed_bounds(const Solid& solid, const Pose& pose) {
  Box<double> bounds;
  for (const glm::vec3& p : solid.mesh.position) bounds.add(pose.rotation * glm::dvec3(p) + pose.translation);
  return bounds;
}

}  // namespace

Scene in_a_row(std::vector<Solid> solids) {
  // The pose of each by itself.
  std::vector<Box<double>> bounds;
  std::vector<Pose> poses;
  double widest = 0;
  for (Solid& solid : solids) {
    Scene laid = laid_out(gathered({solid}));
    poses.push_back(laid.instances.front().pose);
    solid = std::move(laid.solids.front());
    bounds.push_back(posed_bounds(solid, poses.back()));
    widest = std::max(widest, bounds.back().size().x);
  }

  // Puts one beside the other, their middles in one line.
  Scene row = gathered(std::move(solids));
  double x = 0;
  for (std::size_t i = 0; i < row.instances.size(); ++i) {
    const glm::dvec3 middle = 0.5 * (bounds[i].low + bounds[i].high);
    row.instances[i].pose = poses[i];
    row.instances[i].pose.translation += glm::dvec3(x - bounds[i].low.x, -bounds[i].low.y, -middle.z);
    x += bounds[i].size().x + share_between * widest;
  }
  row.ground = true;
  row.view.vertical_field = narrow_field;
  row.view = fitted_view(row, from_the_front);
  return row;
}

}  // namespace pomona
