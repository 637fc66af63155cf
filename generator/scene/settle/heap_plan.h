// The plan of a heap: its pieces, and where each may start, before anything moves.
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
#include "generator/scene/settle/settle_options.h"

namespace pomona {

/// The pieces of one dish. Items are named by their index. The arguments of the constructor must outlive the plan.
class HeapPlan {
 public:
  HeapPlan(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
           const SettleOptions& options);

  std::span<const SettleItem> items() const { return items_; }
  const SettleOptions& options() const { return options_; }
  const Dish& dish() const { return dish_; }
  const std::string& dish_name() const { return name_; }
  double unit() const { return sizes_.unit; }      ///< mean size of the pieces, metres
  double widest() const { return sizes_.widest; }  ///< largest radius of a piece, metres

  /// Random numbers that no other heap uses.
  /// \param what their purpose: "/arrange"; empty = dropping
  RandomStream draws(const std::string& what = {}) const { return {{options_.seed, 0}, purpose_ + what}; }

  const Solid& solid(std::size_t item) const { return solids_[static_cast<std::size_t>(items_[item].solid)]; }
  const PieceShape& shape(std::size_t item) const { return shapes_[static_cast<std::size_t>(items_[item].solid)]; }
  std::vector<std::size_t> solid_numbers() const;

  bool in_bowl(std::size_t item) const { return dish_.has_bowl() && !items_[item].beside; }
  /// The arrangement that the scene gives the item, or null.
  const PieceArrangement* arrangement(std::size_t item) const;
  /// Whether the item is placed directly and does not fall.
  bool is_placed(std::size_t item) const;

  /// The area into which an item is dropped.
  DropArea area_of(std::size_t item) const;
  /// The height map of the empty dish, wide enough for all areas.
  HeightMap empty_map() const;
  /// The number of pieces, beginning with this one, that cover the drop area once.
  std::size_t pieces_in_wave(std::size_t first) const;
  /// The wall above the rim that keeps falling pieces together.
  Funnel funnel() const;
  /// Whether the item lies beyond the rim, or under the dish.
  bool is_outside(std::size_t item, const Pose& pose) const;

 private:
  struct Sizes {
    double unit = 0;    ///< mean size of the pieces, metres
    double widest = 0;  ///< largest radius of a piece, metres
  };
  std::vector<PieceShape> prepared();
  double spread() const { return options_.spread > 0 ? options_.spread : 4 * sizes_.widest; }
  DropCells cells_for(double radius, const PieceArrangement* how) const;
  DropRing ring_of(std::size_t item) const;
  double mean_footprint() const;

  std::span<const Solid> solids_;
  std::span<const SettleItem> items_;
  SettleOptions options_;
  std::string name_;     ///< name of the dish
  std::string purpose_;  ///< name of this heap's random streams
  Sizes sizes_;
  std::vector<PieceShape> shapes_;  ///< one per solid; empty for solids that are not used
  Dish dish_;
  double footprint_ = 0;  ///< mean area that a piece covers when it lies flat, square metres
};

}  // namespace pomona
