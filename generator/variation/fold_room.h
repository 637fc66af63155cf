// What must hold in every fold of a variant because it holds in the drawing: nothing crosses anything.
#pragma once

#include <vector>

#include "generator/surface/sweep/profile.h"
#include "generator/variation/layers.h"

namespace pomona {

/// Looks at a variant as it will be swept: layers around the axis keep apart, and what lies in a fold stays on the
/// side of every layer, and of every other loop of its fold, on which it was drawn. Whatever crosses as drawn may.
class FoldRoom {
 public:
  explicit FoldRoom(const Template& drawn);

  /// One answer per fold of the variant.
  std::vector<bool> is_sound(const Template& variant) const;

 private:
  struct Chamber {
    std::size_t surface = 0;  ///< index into Template::surfaces
    ProfileArcs arcs;
  };
  /// On which side of a layer all of a chamber lies, and how much of the radius stays free between.
  struct ChamberSide {
    std::size_t chamber = 0;  ///< index into chambers_
    std::size_t layer = 0;    ///< index into Template::surfaces
    bool inside = false;
    double margin = 0;
  };
  /// How two loops of a fold lie: apart, or the first within the second.
  struct Neighbours {
    std::size_t first = 0, second = 0;  ///< indices into Template::surfaces
    bool nested = false;
  };

  bool sides_kept(const Template& variant, std::size_t fold, const ChamberSide& side) const;

  Layers layers_;
  std::vector<Chamber> chambers_;
  std::vector<ChamberSide> sides_;
  std::vector<Neighbours> neighbours_;
};

}  // namespace pomona
