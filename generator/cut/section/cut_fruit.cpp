#include "generator/cut/section/cut_fruit.h"

#include <utility>

#include "generator/cut/section/face_part.h"

namespace pomona {

CutFruit with_faces(Cutting cutting, const DiffusionSurfaces& surfaces, Threads threads) {
  CutFruit fruit = std::move(cutting.fruit);
  std::vector<FacePart> parts(cutting.faces.size());
  parallel_for(parts.size(), threads,
               [&](std::size_t f) { parts[f] = part_of(cutting.faces[f], cutting.regions[f], fruit.mesh, surfaces); });
  fruit.section = with_parts(std::move(fruit.section), std::move(parts), fruit.mesh, std::move(cutting.shared));
  return fruit;
}

}  // namespace pomona
