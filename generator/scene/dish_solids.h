// Dishes as solids: turned ones, or from a mesh file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/piece/solid.h"
#include "generator/scene/dish_description.h"

namespace pomona {

/// The bowl as a solid, in its place.
Solid bowl_solid(const BowlDescription& bowl);

/// Makes each kind of dish once.
class DishSolids {
 public:
  /// \param folder of the scene, which holds the meshes.
  explicit DishSolids(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The index of the solid of this dish. The solid is made, with the dish's name, unless an equal one exists.
  /// \throws Error (bad_data), (input_missing) at the place where the scene names the mesh.
  std::size_t index_of(const DishDescription& dish);

  const Solid& solid(std::size_t index) const { return solids_[index]; }

  /// What the files of its meshes leave open, and how it was taken, with the names of the dishes.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::filesystem::path folder_;
  std::vector<DishDescription> known_;  ///< one a solid
  std::vector<Solid> solids_;
  std::vector<std::string> notes_;
};

}  // namespace pomona
