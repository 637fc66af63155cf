// What pieces fall into: a round bowl on the ground, a dish of any shape, or the ground alone, as a field of distances.
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

/// What a heap lies in: a solid that stands on the ground, y = 0, and does not move.
struct DishForm {
  DishForm(const Solid* bowl = nullptr) : solid(bowl) {}  // NOLINT(google-explicit-constructor): a bowl is a dish

  const Solid* solid;         ///< null for the ground alone
  bool turned = true;         ///< on the potter's wheel, about the y axis; else of any shape
  bool on_top = false;        ///< pieces lie on it, not in its hollow; for what is not turned
  std::string name = "bowl";  ///< for messages; what is drawn for one heap is its own
};

struct DishOptions {
  double cell = 0.002;  ///< metres: width of the field's cells
  double around = 0.1;  ///< metres beside and above the bowl that the field has to cover
  double ground = 1;    ///< metres: the ground's mesh reaches at least so far
};

/// The ground is y = 0. A bowl turned about the y axis is known by its upper side: below that all is solid. A dish of
/// another shape has a `form()` of its own.
class Dish {
 public:
  Dish(const DishForm& dish, const DishOptions& options);

  /// A bowl, or a dish of any shape.
  bool has_bowl() const { return rim_height_ > 0; }

  /// Whether pieces find a place in it, or on it. The ground has room everywhere.
  bool holds() const;

  /// Of a dish that is not turned; else null.
  const MeshDish* form() const { return form_.get(); }

  /// Whether a place lies within its rim, or outline. Always on the ground.
  bool covers(const glm::dvec3& point) const;
  double rim_radius() const { return rim_radius_; }
  double rim_height() const { return rim_height_; }

  /// Bowl and ground as one mesh, for exact questions.
  const PlacedMesh& mesh() const { return mesh_; }

  /// Metres from the upper side, negative below it. Far above the bowl at most that.
  float distance(const glm::vec3& point) const;

  /// Where the distance grows, of length 1.
  glm::vec3 direction(const glm::vec3& point) const;

  /// Of the upper side.
  double height(double x, double z) const;

 private:
  void lay_ground(const Solid* bowl, double least);
  void bake(const DishOptions& options);
  double turned_height(double radius) const;
  float field(float radius, float height) const;

  PlacedMesh mesh_;
  std::shared_ptr<const MeshDish> form_;
  std::vector<glm::dvec2> profile_;
  double rim_radius_ = 0, rim_height_ = 0, widest_ = 0;

  // The field's nodes, by radius and then by height.
  int columns_ = 0, rows_ = 0;
  float cell_ = 1, lowest_ = 0;
  std::vector<float> values_;
};

}  // namespace pomona
