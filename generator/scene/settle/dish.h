// What pieces fall into: a round bowl on the ground, or the ground alone, as a field of distances.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/piece/solid.h"
#include "generator/scene/settle/real_contact.h"

namespace pomona {

struct DishOptions {
  double cell = 0.002;  ///< metres: width of the field's cells
  double around = 0.1;  ///< metres beside and above the bowl that the field has to cover
  double ground = 1;    ///< metres: the ground's mesh reaches at least so far
};

/// Turned about the y axis; the ground is y = 0. It is known by its upper side: below that all is solid.
class Dish {
 public:
  /// \param bowl null for the ground alone.
  Dish(const Solid* bowl, const DishOptions& options);

  bool has_bowl() const { return rim_height_ > 0; }
  double rim_radius() const { return rim_radius_; }
  double rim_height() const { return rim_height_; }

  /// Bowl and ground as one mesh, for exact questions.
  const PlacedMesh& mesh() const { return mesh_; }

  /// Metres from the upper side, negative below it. Far above the bowl at most that.
  float distance(const glm::vec3& point) const;

  /// Where the distance grows, of length 1.
  glm::vec3 direction(const glm::vec3& point) const;

  /// Of the upper side, so far from the axis.
  double height(double radius) const;

 private:
  void lay_ground(const Solid* bowl, double least);
  void bake(const DishOptions& options);
  float field(float radius, float height) const;

  PlacedMesh mesh_;
  std::vector<glm::dvec2> profile_;
  double rim_radius_ = 0, rim_height_ = 0, widest_ = 0;

  // The field's nodes, by radius and then by height.
  int columns_ = 0, rows_ = 0;
  float cell_ = 1, lowest_ = 0;
  std::vector<float> values_;
};

}  // namespace pomona
