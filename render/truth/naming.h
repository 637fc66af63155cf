// Numbers of the species, fruits, parts and instances of a scene, for its ground truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/scene/scene.h"

namespace pomona {

/// All numbers begin at 1; 0 is where nothing is. Each list is in the order in which a scene's solids name them first.
struct TruthNaming {
  struct Species {
    std::string name;  ///< name of the template
  };
  struct Fruit {
    std::string name;           ///< unique within the scene
    std::uint16_t species = 0;  ///< number of its Species
  };
  struct Part {
    std::string name;           ///< "flesh"
    std::uint16_t species = 0;  ///< parts of two species are two, whatever their names
  };
  std::vector<Species> species;
  std::vector<Fruit> fruits;
  std::vector<Part> parts;

  std::vector<std::uint16_t> fruit_of_solid;               ///< per solid
  std::vector<std::vector<std::uint16_t>> parts_of_solid;  ///< per solid, per index into its part_names

  const Fruit& fruit(std::uint16_t number) const { return fruits[number - 1u]; }
  const Species& kind(std::uint16_t number) const { return species[number - 1u]; }
};

/// Instances are numbered in the scene's order, from 1.
/// \throws Error (usage) for more than 65 535 instances, or organs of one fruit: their numbers have 16 bits.
TruthNaming truth_naming(const Scene& scene);

}  // namespace pomona
