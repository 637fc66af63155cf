// What a heap is made of and where its pieces may begin, before anything moves.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/base/random.h"
#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/height_map.h"
#include "generator/scene/settle/piece_shape.h"
#include "generator/scene/settle/rigid_body.h"
#include "generator/scene/settle/settle.h"

namespace pomona {

/// The pieces of one dish and what is known of them; an item is told by its index. What it is given lives longer.
class HeapPlan {
 public:
  HeapPlan(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
           const SettleOptions& options);

  std::span<const SettleItem> items() const { return items_; }
  const SettleOptions& options() const { return options_; }
  const Dish& dish() const { return dish_; }
  const std::string& dish_name() const { return name_; }
  double unit() const { return sizes_.unit; }      ///< metres: the mean size of the pieces
  double widest() const { return sizes_.widest; }  ///< metres: the radius of the widest

  /// Draws that no other heap makes. \param what they are for: "/arrange"; empty: dropping
  RandomStream draws(const std::string& what = {}) const { return {{options_.seed, 0}, purpose_ + what}; }

  const Solid& solid(std::size_t item) const { return solids_[static_cast<std::size_t>(items_[item].solid)]; }
  const PieceShape& shape(std::size_t item) const { return shapes_[static_cast<std::size_t>(items_[item].solid)]; }
  std::vector<std::size_t> solid_numbers() const;

  bool in_bowl(std::size_t item) const { return dish_.has_bowl() && !items_[item].beside; }
  /// How the scene says it lies, or null.
  const PieceArrangement* arrangement(std::size_t item) const;
  /// Whether it does not fall: it is set to its place.
  bool is_set(std::size_t item) const;

  /// Where an item is dropped.
  DropArea area_of(std::size_t item) const;
  /// The dish from above, wide enough for all areas, with nothing in it.
  HeightMap empty_map() const;
  /// So many pieces, of which this is the first, cover their area once.
  std::size_t pieces_in_wave(std::size_t first) const;
  /// The wall over the rim that keeps falling pieces together.
  Funnel funnel() const;
  /// Whether it lies beyond the rim, or under the dish.
  bool is_outside(std::size_t item, const Pose& pose) const;

 private:
  struct Sizes {
    double unit = 0, widest = 0;
  };
  std::vector<PieceShape> prepared();
  double spread() const { return options_.spread > 0 ? options_.spread : 4 * sizes_.widest; }
  DropCells cells_for(double radius, const PieceArrangement* how) const;
  DropRing ring_of(std::size_t item) const;
  double mean_footprint() const;

  std::span<const Solid> solids_;
  std::span<const SettleItem> items_;
  SettleOptions options_;
  std::string name_;     ///< of the dish
  std::string purpose_;  ///< what draws of this heap are made for
  Sizes sizes_;
  std::vector<PieceShape> shapes_;  ///< of the solids that are placed
  Dish dish_;
  double footprint_ = 0;  ///< square metres: the mean of the pieces, as they lie flat
};

}  // namespace pomona
