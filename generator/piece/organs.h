// What pieces have of each organ of a fruit: berry by berry, kernel by kernel.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/compose/grow.h"
#include "generator/mesh/enclosures.h"
#include "generator/piece/solid.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The organs of a fruit: the instances of placed templates by their numbers, then the grains at seats of laws that are
/// bodies of their own, such as kernels, in their order. 0 is the fruit itself.
class FruitOrgans {
 public:
  /// \param surfaces what the diffuser sees
  FruitOrgans(const DiffusionSurfaces& surfaces, const Template& fruit);

  bool empty() const { return names_.size() < 2; }

  /// By number: the name of the place, "berry"; of one within another "branch.floret"; of the grains; of the fruit.
  const std::vector<std::string>& names() const { return names_; }

  /// The last organ around a place; 0 where the fruit itself is around it, too: what is sunk in it is its own.
  std::int32_t at(const glm::dvec3& place) const;

  /// The organs of a piece's triangles.
  std::vector<std::int32_t> of_triangles(const SolidMesh& mesh) const;

  /// All that faces air, with the numbers of organs.
  std::span<const Enclosures::Triangle> skins() const { return skins_; }

 private:
  std::vector<std::string> names_;
  std::vector<std::uint8_t> is_grain_;  // per surface
  std::vector<Enclosures::Triangle> skins_;
  Enclosures around_;
};

/// Pieces with SolidMesh::instance and Solid::organs, if the fruit has organs.
///
/// An organ's volume is that between its share of the piece's triangles, exactly. Where much of it is open, because it
/// is sunk in the fruit or pressed into its neighbours, it is measured along rays instead (region_rays.h); the error is
/// then some hundredths. The fruit itself has the rest, so that volumes add up to the piece's; and so do masses, by the
/// mean densities of organs.
std::vector<Solid> with_organs(std::vector<Solid> pieces, const GrownFruit& grown, const Template& fruit);

}  // namespace pomona
