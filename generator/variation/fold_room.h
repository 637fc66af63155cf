// Checks that in every fold of a variant nothing crosses that does not cross in the drawing.
#pragma once

#include <map>
#include <vector>

#include "generator/surface/sweep/profile.h"
#include "generator/variation/layers.h"

namespace pomona {

class LayerInPlane;

/// Checks a variant as it will be swept. Layers around the axis must not cross. A loop in a fold must stay on the side
/// of every layer, and of every other loop of its fold, on which it was drawn. What crosses in the drawing may cross.
class FoldRoom {
 public:
  explicit FoldRoom(const Template& drawn);

  /// One answer per fold of the variant.
  std::vector<bool> is_sound(const Template& variant) const;

 private:
  /// By their indices into Template::surfaces.
  using LayerPlanes = std::map<std::size_t, LayerInPlane>;

  struct Chamber {
    std::size_t surface = 0;  ///< index into Template::surfaces
    ProfileArcs arcs;
  };
  /// The side of a layer on which a whole chamber lies.
  struct ChamberSide {
    std::size_t chamber = 0;  ///< index into chambers_
    std::size_t layer = 0;    ///< index into Template::surfaces
    bool inside = false;      ///< the chamber is on the inner side
    double margin = 0;        ///< smallest gap that must remain, as a share of the radius
  };
  /// Two loops of a fold: either outside each other, or the first inside the second.
  struct Neighbours {
    std::size_t first = 0, second = 0;  ///< indices into Template::surfaces
    bool nested = false;
  };

  bool are_sides_kept(const Template& variant, std::size_t fold, const LayerPlanes& planes) const;

  Layers layers_;
  std::vector<Chamber> chambers_;
  std::vector<ChamberSide> sides_;
  std::vector<Neighbours> neighbours_;
};

}  // namespace pomona
