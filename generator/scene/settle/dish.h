// The dish that pieces fall into, as a field of distances: a round bowl, a dish of any shape, or the ground alone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/piece/solid.h"
#include "generator/scene/settle/mesh_dish.h"
#include "generator/scene/settle/real_contact.h"

namespace pomona {

/// The dish of a heap: a solid that stands on the ground (y = 0) and does not move.
struct DishForm {
  DishForm(const Solid* bowl = nullptr) : solid(bowl) {}  // NOLINT(google-explicit-constructor): a bowl is a dish

  const Solid* solid;         ///< null for the ground alone
  bool turned = true;         ///< it is a solid of revolution about the y axis; else it has any shape
  bool on_top = false;        ///< pieces lie on it, not in its hollow; only for a dish that is not turned
  std::string name = "bowl";  ///< for messages; it also selects the random numbers of a dish that is not turned
};

struct DishOptions {
  double cell = 0.002;  ///< width of the field's cells, metres
  double around = 0.1;  ///< the field covers this much beside and above the bowl, metres
  double ground = 1;    ///< the mesh of the ground reaches at least this far from the axis, metres
};

/// The ground is y = 0. A turned bowl is described by its upper side: everything below it is solid. A dish of any other
/// shape is described by a MeshDish.
class Dish {
 public:
  Dish(const DishForm& dish, const DishOptions& options);

  /// Whether there is a bowl or a dish of any shape, not the ground alone.
  bool has_bowl() const { return rim_height_ > 0; }

  /// Whether pieces can lie in it, or on it. Always true for the ground.
  bool holds() const;

  /// The description of a dish that is not turned; else null.
  const MeshDish* form() const { return form_.get(); }

  /// Whether a point lies within the rim or the outline, seen from above. Always true for the ground.
  bool covers(const glm::dvec3& point) const;
  double rim_radius() const { return rim_radius_; }  ///< metres
  double rim_height() const { return rim_height_; }  ///< metres above the ground

  /// Bowl and ground as one mesh, for exact measurements.
  const PlacedMesh& mesh() const { return mesh_; }

  /// The distance from the upper side in metres, negative below it. Far above the bowl it is a lower bound.
  float distance(const glm::vec3& point) const;

  /// The direction in which the distance grows, of length 1.
  glm::vec3 direction(const glm::vec3& point) const;

  /// The height of the upper side, metres.
  double height(double x, double z) const;

 private:
  void lay_ground(const Solid* bowl, double min);
  void bake(const DishOptions& options);
  double turned_height(double radius) const;
  float field(float radius, float height) const;

  PlacedMesh mesh_;
  std::shared_ptr<const MeshDish> form_;
  std::vector<glm::dvec2> profile_;
  double rim_radius_ = 0, rim_height_ = 0, widest_ = 0;

  int columns_ = 0, rows_ = 0;  ///< number of the field's nodes along the radius, and along the height
  float cell_ = 1;              ///< distance between two nodes, metres
  float lowest_ = 0;            ///< height of the lowest nodes, metres
  std::vector<float> values_;   ///< distances at the nodes, metres
};

}  // namespace pomona
